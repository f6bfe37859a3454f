// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/elimination/setup.h>
#include <qvgen/inverse/requested_pose.h>
#include <qvgen/inverse/seed.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/simd/instruction_sets.h>

namespace qvgen::inverse::elimination {

using Found = Solutions<joints, most_solutions>;

/// All solutions of a pose, in the order of joint 1, where that is the same of joint 2, and so on; a row's
/// branch is its place. Status: solved, singular, unreachable, invalid as everywhere, and incomplete where
/// there is reason to believe that a solution may be missing. No heap, no exceptions; at most
/// `most_eliminations` eliminations and a bounded number of Newton steps.
/// `tolerance`: see `default_tolerance`. `preference`: what free joints are where they can be chosen.
void solve(const Setup& setup, const Pose<double>& pose, double tolerance,
           const Preference<joints>& preference, Form form, Found& found);
/// Solves in registers of an instruction set, or of the next narrower one if the machine or the compiler
/// lacks it.
void solve(const Setup& setup, const Pose<double>& pose, double tolerance,
           const Preference<joints>& preference, InstructionSet set, Found& found);

}  // namespace qvgen::inverse::elimination
