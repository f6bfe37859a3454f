// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "dag/graph.h"
#include "emit/cpp/code.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The angles whose sines and cosines a function uses, in a fixed order: what its Angles struct holds.
std::vector<dag::Angle> angles_of(const dag::Function& function);

/// How generated functions write their leaves: joint variables are q[i], geometric constants g.name, sines
/// and cosines s[k] and c[k] with k the angle's place in `angles`. `others` maps further symbols.
Names leaf_names(const model::Robot& robot, const std::vector<dag::Angle>& angles,
                 const std::function<std::string(const std::string&)>& others = {});

/// An angle as C++: "Scalar(0.5) * (q[3] + q[5])".
std::string angle_code(const dag::Angle& angle, const Names& names);

/// Template values for a list of angles: text, code, index, last.
nlohmann::json angle_values(const std::vector<dag::Angle>& angles, const Names& names);

/// Code that computes the sines and cosines of the angles: a call of the runtime, or an empty struct of that
/// type.
std::string sines_cosines_code(const std::vector<dag::Angle>& angles, const Names& names,
                               const std::string& empty);

}  // namespace qvgen::emit
