// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/elimination.h"

/// Which eliminations serve an arm is tried out, on sampled poses. An arm that is set up at run time is tried
/// in several shapes: with values of its given joint; with the headings that inclinations ask for, each at
/// the pose that it belongs to, for there the heading's axis is along one of the arm's own.
namespace qvgen::derive::inverse {

/// Fills in the choices of a derivation, which has its arm, and a setup by them for people; no choices if no
/// elimination serves.
void choose_eliminations(EliminationDerivation& derivation);

}  // namespace qvgen::derive::inverse
