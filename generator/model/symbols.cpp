// SPDX-License-Identifier: MIT
#include <set>

#include "model/robot.h"

namespace qvgen::model {
namespace {

void add(std::set<std::string>& all, const Expression& expression) {
  for (const std::string& name : symbols(expression)) all.insert(name);
}

void add(std::set<std::string>& all, const Vector3& v) {
  for (const Expression& component : v) add(all, component);
}

void add(std::set<std::string>& all, const Displacement& displacement) {
  add(all, displacement.translation);
  for (const Turn& turn : displacement.turns) {
    add(all, turn.axis);
    add(all, turn.angle);
  }
}

}  // namespace

std::vector<std::string> symbols(const Robot& robot) {
  std::set<std::string> all;
  add(all, robot.base);
  add(all, robot.tool);
  for (const Joint& joint : robot.joints) {
    add(all, joint.before);
    add(all, joint.axis);
    add(all, joint.after);
  }
  return {all.begin(), all.end()};
}

}  // namespace qvgen::model
