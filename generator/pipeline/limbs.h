// SPDX-License-Identifier: MIT
#pragma once

#include "model/mechanism.h"
#include "pipeline/robot_output.h"

/// Limbs of a robot whose joints branch: robots of their own with all that chains have but dynamics, which
/// are the whole robot's.
namespace qvgen::pipeline {

/// Returns the chains from the base to every tip, without inertias.
std::vector<model::Robot> limbs_of(const model::Mechanism& mechanism);

/// Adds limbs.h: the limbs' functions by their tips' names, and which of the robot's joints each has.
void add_limbs(const model::Mechanism& mechanism, RobotOutput& output);

}  // namespace qvgen::pipeline
