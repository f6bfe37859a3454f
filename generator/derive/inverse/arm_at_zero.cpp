// SPDX-License-Identifier: MIT
#include "derive/inverse/arm_at_zero.h"

#include "derive/inverse/screw.h"

namespace qvgen::derive::inverse {

symbolic::Program arm_at_zero(const model::Robot& robot) {
  Scope scope(robot);
  symbolic::Program program;
  const Chain chain = chain_of(robot, scope, program);
  const auto output = [&](const std::string& name, const symbolic::Vector& v) {
    program.output(name + "_x", v.x);
    program.output(name + "_y", v.y);
    program.output(name + "_z", v.z);
  };
  for (std::size_t i = 0; i < chain.screws.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    output("axis" + number, chain.screws[i].axis);
    output("point" + number, chain.screws[i].revolute ? chain.screws[i].point : symbolic::Vector{0, 0, 0});
  }
  program.output("turn_w", chain.home.q.w);
  output("turn", {chain.home.q.x, chain.home.q.y, chain.home.q.z});
  output("place", chain.home.p);
  return program;
}

}  // namespace qvgen::derive::inverse
