// SPDX-License-Identifier: MIT
#pragma once

#include "model/mechanism.h"
#include "pipeline/robot_output.h"

/// Limbs of a robot whose joints branch: robots of their own with all that chains have but dynamics, which
/// are the whole robot's.
namespace qvgen::pipeline {

/// Returns the chains from the base to every tip, without inertias.
std::vector<model::Robot> limbs_of(const model::Mechanism& mechanism);

/// Returns the variables of a limb by their `place`, each with the `joint` or motor of the whole robot that
/// gives its value, times `ratio`; `last` is true of the last. A variable has several entries if its value is
/// a sum: the limb has not all joints of its motors.
nlohmann::json joints_of_limb(const model::Robot& robot, const model::Robot& limb);

/// Adds limbs.h: the limbs' functions by their tips' names, and which of the robot's joints each has.
void add_limbs(const model::Mechanism& mechanism, RobotOutput& output);

}  // namespace qvgen::pipeline
