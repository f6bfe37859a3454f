// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "derive/inverse/inverse.h"
#include "emit/ast/printer.h"

namespace qvgen::emit {

/// The arm's screws at zero, for functions that look at rows, turn a tool, or move the whole arm.
nlohmann::json arm_values(const model::Robot& described, const ast::Printer& language);

/// A constant direction's numbers, with commas.
std::string numbers_of(const model::Vector3& axis);
/// The text of a row's arm with all joints at zero: of a task that leaves the position it turns only, and the
/// turn of the tool that a direction leaves stands behind. `scope`, `tool_axis`: as the language has them.
std::string row_arm(const derive::inverse::Problem& problem, bool has_tool_turn, const std::string& scope,
                    const std::string& tool_axis);
/// Returns what is checked of rows where a whole pose is given.
derive::inverse::Filter filter_of_poses(const derive::inverse::Problem& problem);

/// The joint that turns the whole arm and the first of those that a pitch is counted about, by their places
/// in a row.
struct PitchPlaces {
  int base, first;
};
PitchPlaces pitch_places(const derive::inverse::Problem& problem);

/// The arm's first revolute joint.
int first_turn(const model::Robot& robot);

}  // namespace qvgen::emit
