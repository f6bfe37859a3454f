// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "transcription.h"
#include "value.h"

namespace qvgen::test::sources {

/// Returns the names that a section's equations may use, with values at random configurations of arms of
/// random lengths: the same ones at every run.
std::vector<Known> configurations(const Section& section);

/// The variables of the arm's joints, in their order.
std::vector<std::string> joint_variables(const Section& section);

/// Chapter 1: a rotation by theta about k as q = [s, v] and as the matrix R; two displacements Q_1, Q_2.
Known rotation_values(unsigned number);

}  // namespace qvgen::test::sources
