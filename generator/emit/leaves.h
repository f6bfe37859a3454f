// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "dag/graph.h"
#include "emit/code.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The angles whose sines and cosines a function uses and which are not numbers: what its Angles struct
/// holds. Single joints first, then the sums.
std::vector<dag::Angle> angles_of(const dag::Function& function);
/// Those of several functions, each once, in the same order.
std::vector<dag::Angle> merged(const std::vector<std::vector<dag::Angle>>& lists);

/// Returns the name of an angle behind s for its sine and c for its cosine: the numbers of its joints, "m"
/// before one that is subtracted, "h" in front for half angles; other symbols by their names. Theta2 + theta3
/// is 23, theta4 - theta6 is 4m6, (theta4 + theta6)/2 is h46. `place` names what has other coefficients: _3.
std::string angle_name(const model::Robot& robot, const dag::Angle& angle, std::size_t place);

/// Leaves of generated functions: joint variables are q[i], geometric constants g.name, sines and cosines by
/// `angle_name`. `others` maps further symbols.
ast::Leaves robot_leaves(const model::Robot& robot, const std::vector<dag::Angle>& angles,
                         const std::function<ast::Expression(const std::string&)>& others = {});

/// The sines and cosines that a function uses, by the place of their angle.
std::set<std::pair<std::size_t, dag::Op>> sines_and_cosines_of(const dag::Function& function,
                                                               const std::vector<dag::Angle>& angles);

/// An angle as code: "Scalar(0.5) * (q[3] + q[5])".
std::string angle_code(const dag::Angle& angle, const ast::Leaves& leaves, const ast::Printer& language);

}  // namespace qvgen::emit
