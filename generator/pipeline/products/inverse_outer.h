// SPDX-License-Identifier: MIT
// Several given joints: a gantry under an arm, a rail under seven joints, a torso.
//
// All given joints but one have to be the first or the last of the arm. These outer joints move the pose that
// the inner arm, which has six joints, or seven with one given, has to reach (qvgen/inverse/outer_joints.h).
//
// A task that leaves a motion open has fewer joints. Then the outer joints are the first of the arm: what is
// asked for moves with them. Joints behind would move the tool point or axis that the open motion is about.
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
  std::size_t first = 0;  ///< how many stand in front of the inner arm
  model::Robot inner;     ///< the arm with the outer joints at zero
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
