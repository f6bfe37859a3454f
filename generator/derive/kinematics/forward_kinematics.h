// SPDX-License-Identifier: MIT
#pragma once

#include "derive/form.h"
#include "model/robot.h"

namespace qvgen::derive {

/// base * Q_1 ... Q_n * tool, multiplied as it stands (thesis 1.12, section 1.3.2.2).
symbolic::Pair pair_product(const model::Robot& robot, symbolic::Program& program);

/// Orientation as a unit quaternion and position of the tool: outputs w, x, y, z, px, py, pz.
Quantity forward_kinematics(const model::Robot& robot);

/// Rotation matrix and position of the tool: outputs r11 .. r33 (row, column), px, py, pz.
Quantity homogeneous_transform(const model::Robot& robot);

/// The definition of the latter: the pair product, its quaternion as a matrix.
symbolic::Program plain_transform(const model::Robot& robot);

/// The orientation written out as the thesis does (3.1-3.128): sums of products of half-angle sines and
/// cosines with Euler triples merged, cos((theta4 + theta6)/2). One value per component, not simplified any
/// further; and the position in full angles. Empty where the robot has no right-angled zero-reference chain.
std::optional<symbolic::Program> closed_form(const model::Robot& robot);

}  // namespace qvgen::derive
