// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "derive/inverse/inverse.h"
#include "emit/ast/printer.h"

namespace qvgen::pipeline {

/// A field an entry.
nlohmann::json fields_of(const std::vector<std::string>& names);

/// Returns a bound of the tool's distance from the origin, as text: the sum of all lengths, if they are
/// numbers and no joint of the arm's own slides; else empty. A virtual joint at the tool has to end at zero.
std::string reach(const derive::inverse::Problem& problem);
/// Returns such a bound with the given joint at zero: how far that slides has to be added to it.
std::string reach_beside_given(const derive::inverse::Problem& problem);

/// Fields of the target's geometry with what the caller's geometry, or the given joint's value, says of them.
nlohmann::json geometry_values(const derive::inverse::Problem& problem, const std::string& given,
                               const emit::ast::Printer& language);

/// Adds what the solver hands to the derivation's arm in place of what it is given.
void add_change_of_arm(const derive::inverse::Problem& problem, const std::string& given,
                       const emit::ast::Printer& language, nlohmann::json& values);

}  // namespace qvgen::pipeline
