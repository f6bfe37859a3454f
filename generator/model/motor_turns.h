// SPDX-License-Identifier: MIT
// Whole turns of joints as motions of the motors that move them.
//
// A turn of joint j moves the motors by 2 pi times column j of A^-1 (followers.h). All such motions form a
// lattice. Its basis here is in echelon form: each motion leaves the motors before its pivot where they are,
// so that limits of motors can be looked at one after the other. For tilt = (ml + mr)/2, roll = (ml - mr)/2
// the basis is (1, 1) and (0, 2).
#pragma once

#include <vector>

#include <cln/rational.h>

#include "model/robot.h"

namespace qvgen::model {

/// A motion of the motors, in whole turns of each.
struct MotorTurn {
  std::size_t pivot = 0;  ///< the first motor that moves, by a positive amount
  std::vector<cln::cl_RA> motion;
};

/// Returns a basis, the pivots ascending, for an arm whose motors determine its joints and vice versa.
std::vector<MotorTurn> motor_turns(const Robot& robot, const std::vector<std::vector<cln::cl_RA>>& inverse);

}  // namespace qvgen::model
