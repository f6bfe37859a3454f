// SPDX-License-Identifier: MIT
#include "cli/path_joints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cli/path_numbers.h"
#include "cli/suggestion.h"
#include "model/evaluate.h"
#include "model/followers.h"
#include "model/merged_joints.h"
#include "report/chain.h"

namespace qvgen::cli {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<path::MovingJoint> joints_of(const report::Chain& chain, bool with_limits) {
  std::vector<path::MovingJoint> joints;
  for (const report::ChainJoint& joint : chain.joints)
    if (!joint.follows)
      joints.push_back({joint.variable, joint.revolute,
                        with_limits ? joint.limits.value_or(std::pair(-infinity, infinity))
                                    : std::pair(-infinity, infinity),
                        joint.speed.value_or(infinity)});
  return joints;
}

/// Numbers of a description.
class Numbers {
 public:
  explicit Numbers(const model::Robot& robot) : values_(model::default_bindings(robot)) {}
  [[nodiscard]] double of(const model::Expression& expression) const {
    return model::to_double(model::evaluate(expression, values_));
  }
  [[nodiscard]] path::MovingJoint mover(const model::Joint& joint, bool with_limits) const {
    path::MovingJoint mover{joint.variable,
                            joint.type == model::JointType::revolute,
                            {-infinity, infinity},
                            joint.greatest_velocity ? of(*joint.greatest_velocity) : infinity};
    if (with_limits && joint.limits) mover.limits = {of(joint.limits->lower), of(joint.limits->upper)};
    return mover;
  }

 private:
  model::Bindings values_;
};

/// Narrows a motor's speed to that of joints which follow it alone.
void narrow_speed(const model::Robot& robot, const Numbers& numbers, path::MovingJoint& motor) {
  for (const model::Joint& joint : robot.joints) {
    if (joint.follows.size() != 1 || joint.follows.front().variable != motor.name || !joint.greatest_velocity)
      continue;
    const double ratio = std::abs(cln::double_approx(joint.follows.front().ratio));
    motor.speed = std::min(motor.speed, numbers.of(*joint.greatest_velocity) / ratio);
  }
}

Movers motors_of(const model::Robot& robot, bool with_limits) {
  const Numbers numbers(robot);
  Movers movers;
  for (const model::Joint& motor : model::driven_joints(robot)) {
    movers.joints.push_back(numbers.mover(motor, with_limits));
    narrow_speed(robot, numbers, movers.joints.back());
  }
  for (const model::Joint& joint : model::with_merged_joints(robot).joints) {
    movers.axes.push_back(joint.variable);
    if (!joint.follows.empty() && joint.limits) movers.coupled.push_back(numbers.mover(joint, with_limits));
  }
  return movers;
}

void set_limits(const PathArguments& arguments, Movers& movers) {
  for (const std::string& limit : arguments.limits) {
    const auto [name, range] = named("--limit", limit);
    const std::string& wanted = name;
    const auto own = std::find_if(movers.coupled.begin(), movers.coupled.end(),
                                  [&](const path::MovingJoint& joint) { return joint.name == wanted; });
    path::MovingJoint& joint =
        own != movers.coupled.end() ? *own : joint_called(movers.joints, "--limit", name);
    joint.limits = range_of("--limit", range);
  }
}

}  // namespace

path::MovingJoint& joint_called(std::vector<path::MovingJoint>& joints, const std::string& option,
                                const std::string& name) {
  std::vector<std::string> names;
  for (path::MovingJoint& joint : joints) {
    if (joint.name == name) return joint;
    names.push_back(joint.name);
  }
  check_names(option + ": there is no joint", {name}, names);
  return joints.front();
}

Movers movers_of(const PathArguments& arguments, const model::Robot& robot) {
  const report::Chain chain = report::chain_of(robot);
  if (!chain.assumed.empty())
    throw std::runtime_error(chain.assumed.front() +
                             " has no value: a path is followed in numbers; write one under [defaults]");
  Movers movers;
  if (model::has_followers(robot))
    movers = motors_of(robot, !arguments.without_limits);
  else
    movers.joints = joints_of(chain, !arguments.without_limits);
  set_limits(arguments, movers);
  return movers;
}

}  // namespace qvgen::cli
