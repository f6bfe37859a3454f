// SPDX-License-Identifier: MIT
#include "cli/path_forces.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/suggestion.h"
#include "model/evaluate.h"
#include "model/followers.h"

namespace qvgen::cli {
namespace {

constexpr const char* option = "--joint-torques";

bool is_number(const std::string& word, double& value) {
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return !word.empty() && *end == '\0' && value > 0;
}

std::vector<double> numbers_of(const std::vector<std::string>& words) {
  std::vector<double> numbers;
  for (const std::string& word : words) {
    double value = 0;
    if (!is_number(word, value))
      throw UsageError(
          fmt::format("{}: '{}' is neither a number above zero nor 'description'", option, word));
    numbers.push_back(value);
  }
  return numbers;
}

void check_masses(const model::Robot& robot) {
  for (const model::Parameter& parameter : robot.inertia_parameters)
    if (!parameter.default_value)
      throw std::runtime_error(fmt::format(
          "{} has no value for {}: torques along a path are computed in numbers; write them under [defaults]",
          robot.name, parameter.name));
  const bool has_mass = std::any_of(robot.joints.begin(), robot.joints.end(), [](const model::Joint& joint) {
    return !joint.inertia.mass.is_literal_zero() || !joint.drive.rotor_inertia.is_literal_zero();
  });
  if (!has_mass)
    throw std::runtime_error(
        fmt::format("{} has no masses: its torques are unknown, {} needs them", robot.name, option));
}

void set_by_description(const model::Robot& robot, std::vector<path::MovingJoint>& joints) {
  const model::Bindings values = model::default_bindings(robot);
  bool any = false;
  for (const model::Joint& joint : model::driven_joints(robot)) {
    const auto moving = std::find_if(joints.begin(), joints.end(),
                                     [&](const auto& each) { return each.name == joint.variable; });
    if (moving == joints.end() || !joint.greatest_effort) continue;
    moving->force = model::to_double(model::evaluate(*joint.greatest_effort, values));
    any = true;
  }
  if (!any)
    throw std::runtime_error(
        fmt::format("{} states no effort limits: give numbers, {} 100,100,50,...", robot.name, option));
}

}  // namespace

std::vector<double> for_each_joint(const std::string& name, const std::vector<double>& numbers,
                                   std::size_t count) {
  if (numbers.size() == 1) return std::vector<double>(count, numbers.front());
  if (numbers.size() != count)
    throw UsageError(
        fmt::format("{} has {} numbers: one, or one for each of {} joints", name, numbers.size(), count));
  return numbers;
}

void set_forces(const PathArguments& arguments, const model::Robot& robot,
                std::vector<path::MovingJoint>& joints) {
  if (arguments.joint_torques == std::vector<std::string>{"description"}) {
    check_masses(robot);
    return set_by_description(robot, joints);
  }
  const auto forces = for_each_joint(option, numbers_of(arguments.joint_torques), joints.size());
  check_masses(robot);
  for (std::size_t k = 0; k < joints.size(); ++k) joints[k].force = forces[k];
}

}  // namespace qvgen::cli
