// SPDX-License-Identifier: MIT
// Arms in which joints follow others, or motors: joints = A motors + b, exactly.
//
// The caller gives values for the motors: joints that follow none, and motors that are no joints. The offsets
// b stand in the joints' frames, so that only the matrix A is left. Jacobians of the arm are J A, generalised
// forces A^T tau, mass matrices A^T M A. A wrist with bevel gears has tilt = (ml + mr)/2 and roll = (ml -
// mr)/2.
#pragma once

#include <vector>

#include "model/robot.h"

namespace qvgen::model {

bool has_followers(const Robot& robot);

/// Returns what the caller gives values for, as joints of which only names, types, limits and drives are
/// there. A motor stands where the first joint that it moves does, motors behind the joint's own variable.
std::vector<Joint> driven_joints(const Robot& robot);

/// How many those are, and their variables.
std::size_t driven_count(const Robot& robot);
std::vector<std::string> variables(const Robot& robot);

/// Share of a motor in the motion of a joint: the motor's index among `variables`, and how much.
struct Share {
  std::size_t driven = 0;
  cln::cl_RA ratio = 1;
};
/// Returns the rows of A, one for each joint of the chain; a row's shares in the order of the motors.
std::vector<std::vector<Share>> shares(const Robot& robot);

/// True if the joints' values say the motors': the rank of A is the number of motors.
bool has_independent_motors(const Robot& robot);

/// Returns the inverse of A row by row, motors in terms of joints; nothing if joints do not say the motors'
/// values. Where joints are more than motors it is one of A's left inverses, by joints that few motors move.
std::optional<std::vector<std::vector<cln::cl_RA>>> inverse_shares(const Robot& robot);

/// Returns a relation as a description has it: "1/2 ml - 1/2 mr", "1/2 ml + 1/5*(ml - 1/10)^2".
std::string relation_text(const Follows& follows, const Powers& powers = {});

/// Returns the robot with a motor for each joint: none follows another.
Robot in_joints(const Robot& robot);

/// Returns A^T x for a value of each joint of the chain; `add(sum, ratio, value)` gives sum + ratio * value.
template <class Value, class Add>
std::vector<Value> gathered(const Robot& robot, const std::vector<Value>& of_chain, const Add& add) {
  if (!has_followers(robot)) return of_chain;
  std::vector<Value> result(driven_count(robot));
  const std::vector<std::vector<Share>> all = shares(robot);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Share& share : all[i])
      result[share.driven] = add(result[share.driven], share.ratio, of_chain[i]);
  return result;
}

}  // namespace qvgen::model
