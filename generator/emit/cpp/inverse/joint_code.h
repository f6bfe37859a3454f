// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"
#include "emit/cpp/inverse/dialect.h"

namespace qvgen::emit {

/// Returns the place of a joint's value in generated code: "q[2]".
std::string joint_place(const derive::inverse::Plan& plan, int joint);

/// Assignments of the joints' values that a step leaves in `work`, angles by their arctangent.
std::vector<std::string> joint_lines(const derive::inverse::LoweredPlan& plan,
                                     const derive::inverse::Step& step, const std::string& work = "w",
                                     const Dialect& dialect = cpp_dialect());

/// Declaration of the roots of a step that is a quartic, and what makes one of them work.
std::string quartic_roots(const derive::inverse::LoweredPlan& plan, std::size_t index,
                          const Dialect& dialect);
std::string take_root(const derive::inverse::LoweredPlan& plan, std::size_t index, const std::string& root,
                      const std::string& work, const Dialect& dialect);

/// Call of a step's function; `sign` is empty for a step with one branch.
std::string step_call(const derive::inverse::LoweredPlan& plan, std::size_t index, const std::string& sign,
                      const std::string& work = "w", const std::string& target = "t",
                      const Dialect& dialect = cpp_dialect());

}  // namespace qvgen::emit
