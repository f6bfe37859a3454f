// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/language.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// The files of a robot in Rust, JavaScript or Octave, from those in C: read as a tree, and printed. C that
/// leaves the subset of emit/blocks is a defect: the output has no files then, and says the place.
RobotOutput translated(RobotOutput output, Language language);

}  // namespace qvgen::pipeline
