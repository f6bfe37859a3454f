// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "emit/ast/straight.h"
#include "model/robot.h"

namespace qvgen::emit {

/// Declaration of the sines and cosines that a function uses, from a struct `angles` that holds those of all
/// `angles`: "const Scalar &s1 = angles.sine[0], &c1 = angles.cosine[0];". A name that does not name joints
/// gets a comment with its angle: "// s_0: of theta1/2 - pi/4".
std::vector<std::string> sine_cosine_declarations(const model::Robot& robot, const dag::Function& function,
                                                  const std::vector<dag::Angle>& angles);

/// Template values for a list of angles: text, code, index, last.
nlohmann::json angle_values(const std::vector<dag::Angle>& angles, const ast::Leaves& leaves);

/// Code that computes the sines and cosines of the angles: a call of the runtime, or an empty struct of that
/// type.
std::string sines_cosines_code(const std::vector<dag::Angle>& angles, const ast::Leaves& leaves,
                               const std::string& empty);

}  // namespace qvgen::emit
