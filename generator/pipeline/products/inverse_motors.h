// SPDX-License-Identifier: MIT
// Inverse kinematics of arms with motors: derived in joints, written in joints and, on top of that, in
// motors.
#pragma once

#include <nlohmann/json.hpp>

#include "derive/inverse/problem.h"
#include "model/robot.h"

namespace qvgen::pipeline {

/// Returns why an arm with followers, whose joints are merged, has no inverse kinematics; empty if it may
/// have that of its joints: if these are as many as motors, or one more, which then has to keep the tool
/// level.
std::string obstacle_of_motors(const model::Robot& coupled);

/// True if the arm has one joint more than motors.
bool has_a_joint_over(const model::Robot& coupled);

/// True if the motors keep joints balanced: whatever they are, the turns of these add up to nothing.
bool keeps_balance(const model::Robot& coupled, const derive::inverse::Balance& balance);

/// Adds the namespace of what is derived in joints, and the relation of joints and motors (false without
/// followers), to the values of the templates of inverse kinematics in C++.
void add_motors(const model::Robot& described, nlohmann::json& values);

/// Returns that relation for the templates of C. It has an inverse.
nlohmann::json relation_in_c(const model::Robot& described);

}  // namespace qvgen::pipeline
