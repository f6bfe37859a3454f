// SPDX-License-Identifier: MIT
// Several given joints: a gantry under an arm, a rail under seven joints, a torso, a wrist that is held.
//
// Those in front of the inner arm move the pose, or the part of it, that the inner arm has to reach; of a
// whole pose those behind it do so, too (qvgen/inverse/outer_joints.h). The inner arm has as many joints as
// the task determines, or one more, which is given.
//
// Any others are constants of the inner arm's geometry: a joint that is held is a displacement between its
// neighbours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "emit/ast/printer.h"
#include "model/robot.h"

namespace qvgen::pipeline {

/// An arm in parts.
struct OuterJoints {
  std::vector<std::size_t> places;  ///< of the inner arm's joints in the arm
  std::size_t first = 0;            ///< how many of the others move what is asked for from in front
  std::size_t behind = 0;           ///< how many from behind
  std::vector<std::size_t> held;    ///< all others, by their places: constants of the inner arm
  model::Robot inner;               ///< the arm with the outer joints at zero
};

/// True if an arm has more joints than its task, and one given joint, determine.
bool gives_several(const model::Robot& robot);

/// Returns the ways to give as many joints as the task leaves over, of those that the description names; the
/// way that needs no given joint of the inner arm first, if it gives all that are named.
std::vector<OuterJoints> ways_to_give(const model::Robot& robot);

/// Returns why there is no such way.
std::string reason_against_giving(const model::Robot& robot);

/// Adds the outer joints (false without) and the names of functions to the values of templates of inverse
/// kinematics of the inner arm, in one of the languages.
void add_outer_joints(const model::Robot& described, const std::optional<OuterJoints>& outer,
                      const emit::ast::Printer& language, nlohmann::json& values);

/// Puts the functions of the whole arm in place of the inner arm's in the counts.
void take_outer_names(const nlohmann::json& values, nlohmann::ordered_json& counts);

}  // namespace qvgen::pipeline
