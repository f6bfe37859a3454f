// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dag/graph.h"
#include "emit/math/notation.h"
#include "model/robot.h"

namespace qvgen::report {

/// The section of a workspace by half planes through the axis of a first joint that turns: what joints 2 and
/// 3 make of the point that they position, which joint 1 then turns about its axis.
struct WorkspaceSection {
  std::string point;  ///< "tool point" or "wrist centre"
  dag::Function
      place;  ///< u, v, h of joints 2 and 3: across the axis and along it, from the origin of joint 1
  dag::Function factors;  ///< of 1/2 d(u^2 + v^2, h)/d(q2, q3), each once: the boundary lies where one is 0
  std::string missing;    ///< why there is none
};
/// For three joints, and for six whose last three axes meet. The factors are certified; up to sign their
/// product with powers is the determinant of the Jacobian of the point.
WorkspaceSection workspace_section(const model::Robot& described);

/// With the description's numbers and limits; joints that turn without limits turn once.
struct WorkspaceNumbers {
  double farthest = 0, nearest = 0;  ///< from the origin of joint 1 (m)
  double widest = 0, narrowest = 0;  ///< from its axis
  double lowest = 0, highest = 0;    ///< along it
  double volume = 0;                 ///< m^3
};
/// Nothing where a symbol has no value or a slide no limits.
std::optional<WorkspaceNumbers> workspace_numbers(const model::Robot& described,
                                                  const WorkspaceSection& section);

/// All of it for people: lines of words, and the formulas that they end in. Nothing where there is none.
struct WorkspacePassage {
  std::vector<std::string> words;
  std::vector<std::string> formulas;
};
std::vector<WorkspacePassage> workspace_passages(const model::Robot& described, emit::Notation notation);

/// Returns the workspace as lines.
std::vector<std::string> workspace_lines(const model::Robot& described, emit::Notation notation);

}  // namespace qvgen::report
