// SPDX-License-Identifier: MIT
// Inverse kinematics of arms with motors: derived in joints, written in joints and, on top of that, in
// motors.
#pragma once

#include <nlohmann/json.hpp>

#include "model/robot.h"

namespace qvgen::pipeline {

/// Returns why an arm with followers has no inverse kinematics; empty if it has the one of its joints.
std::string obstacle_of_motors(const model::Robot& described);

/// Adds the namespace of what is derived in joints, and the relation of joints and motors (false without
/// followers), to the values of the templates of inverse kinematics in C++.
void add_motors(const model::Robot& described, nlohmann::json& values);

/// Returns that relation for the templates of C. It has an inverse.
nlohmann::json relation_in_c(const model::Robot& described);

}  // namespace qvgen::pipeline
