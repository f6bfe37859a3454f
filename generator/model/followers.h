// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/robot.h"

/// Arms in which joints follow others: a chain of more joints than its caller gives values for. With q the
/// values given, the joints of the chain have C q, C the matrix of the ratios, one entry a row: Jacobians are
/// J C, generalised forces C^T tau, mass matrices C^T M C.
namespace qvgen::model {

bool has_followers(const Robot& robot);

/// The robot as its caller sees it: only the joints that follow none. What is computed from the whole chain
/// is called with their values.
Robot without_followers(const Robot& robot);

/// Share of a joint of the chain in the motion of another: the index of the joint that moves it, among those
/// that follow none, and how much.
struct Share {
  std::size_t driven = 0;
  cln::cl_RA ratio = 1;
};
/// One for each joint of the chain.
std::vector<Share> shares(const Robot& robot);
/// How many joints follow none, and their variables.
std::size_t driven_count(const Robot& robot);
std::vector<std::string> variables(const Robot& robot);

/// C^T x for a value of each joint of the chain; `add(sum, ratio, value)` gives sum + ratio * value.
template <class Value, class Add>
std::vector<Value> gathered(const Robot& robot, const std::vector<Value>& of_chain, const Add& add) {
  if (!has_followers(robot)) return of_chain;
  std::vector<Value> result(driven_count(robot));
  const std::vector<Share> all = shares(robot);
  for (std::size_t i = 0; i < all.size(); ++i)
    result[all[i].driven] = add(result[all[i].driven], all[i].ratio, of_chain[i]);
  return result;
}

}  // namespace qvgen::model
