// SPDX-License-Identifier: MIT
// Whole turns of joints as motions of the motors that move them.
//
// A turn of joint j moves the motors by 2 pi times column j of A^-1 (followers.h). All such motions form a
// lattice. Its basis here is in echelon form: each motion leaves the values before its pivot where they are,
// so that limits can be looked at one after the other. Joints that have limits of their own come first, for
// these leave few turns. Values that no turn moves together are in blocks of their own, which are searched
// one by one. For tilt = (ml + mr)/2, roll = (ml - mr)/2 the basis is (1, 1) and (0, 2), in one block.
#pragma once

#include <vector>

#include <cln/rational.h>

#include "model/robot.h"

namespace qvgen::model {

/// A value with limits: of a motor, or of a joint that has limits beside its motors'.
struct LimitedValue {
  bool is_motor = true;
  std::size_t index = 0;  ///< among the motors or the joints
};

/// A motion of the values, in whole turns of each.
struct MotorTurn {
  std::size_t pivot = 0;           ///< place of the first value that moves, by a positive amount
  bool ends_block = false;         ///< the next motion moves none of the values that this one's block moves
  std::vector<cln::cl_RA> motion;  ///< by places
};

struct MotorTurns {
  std::vector<LimitedValue> values;  ///< by places: those that never move, then block after block
  std::vector<MotorTurn> turns;      ///< a basis, the pivots ascending
};

/// Returns a basis for an arm whose motors determine its joints and vice versa.
MotorTurns motor_turns(const Robot& robot, const std::vector<std::vector<cln::cl_RA>>& inverse);

}  // namespace qvgen::model
