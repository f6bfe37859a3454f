// SPDX-License-Identifier: MIT
#include "pipeline/products/model_header.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "emit/c/parts.h"
#include "emit/render.h"
#include "model/evaluate.h"
#include "model/followers.h"
#include "pipeline/c_files.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

/// A symbol without a default: what is computed with it says that it was forgotten.
constexpr const char* not_given = "std::numeric_limits<double>::quiet_NaN()";

/// A constant expression; parameters have their default values.
double value_of(const model::Expression& expression, const model::Robot& robot) {
  return model::to_double(model::evaluate(expression, model::default_bindings(robot)));
}

std::string number(const model::Expression& expression, const model::Robot& robot) {
  return fmt::format("{}", value_of(expression, robot));
}

using Greatest = std::optional<model::Expression> model::Joint::*;

/// The limit of a motor, infinite if it has none: where joints that follow it alone have theirs, the tighter
/// one.
double greatest(const model::Robot& robot, const model::Joint& motor, Greatest limit) {
  double least = std::numeric_limits<double>::infinity();
  if (motor.*limit) least = value_of(*(motor.*limit), robot);
  // A follower is as many times as fast as its ratio says; its force is not shared out here.
  if (limit != &model::Joint::greatest_velocity) return least;
  for (const model::Joint& joint : robot.joints) {
    if (joint.follows.size() != 1 || joint.follows.front().variable != motor.variable || !(joint.*limit))
      continue;
    const double ratio = std::abs(cln::double_approx(joint.follows.front().ratio));
    least = std::min(least, value_of(*(joint.*limit), robot) / ratio);
  }
  return least;
}

/// One entry for each motor.
std::vector<double> greatest_of_all(const model::Robot& robot, Greatest limit) {
  std::vector<double> list;
  for (const model::Joint& motor : model::driven_joints(robot)) list.push_back(greatest(robot, motor, limit));
  return list;
}

json values_of(const std::vector<double>& limits) {
  json list = json::array();
  for (const double limit : limits)
    list.push_back({{"value", std::isinf(limit) ? "unlimited" : fmt::format("{}", limit)}, {"last", false}});
  list.back().at("last") = true;
  return list;
}

json joint(const model::Joint& joint, const model::Robot& robot, bool last) {
  const std::string infinity = "unlimited";
  return {{"variable", joint.variable},
          {"revolute", joint.type == model::JointType::revolute ? "true" : "false"},
          {"lower", joint.limits ? number(joint.limits->lower, robot) : "-" + infinity},
          {"upper", joint.limits ? number(joint.limits->upper, robot) : infinity},
          {"last", last}};
}

/// Returns the lines about joints that have no variable of their own.
json follower_lines(const model::Robot& robot) {
  json lines = json::array();
  for (const model::Joint& joint : robot.joints) {
    if (joint.follows.size() == 1)
      lines.push_back(
          {{"text", joint.variable + " follows " + joint.follows.front().variable + " by the ratio " +
                        to_string(model::Expression(joint.follows.front().ratio)) + "."}});
    else if (!joint.follows.empty())
      lines.push_back({{"text", joint.variable + " follows " + model::relation_text(joint.follows) + "."}});
  }
  return lines;
}

}  // namespace

void generate_model_header(const model::Robot& robot, RobotOutput& output) {
  json values{{"name", robot.name}, {"title", robot.title}, {"dof", model::driven_count(robot)}};
  values["base_floats"] = robot.floating_base.has_value();
  values["source"] = robot.source.empty() ? json(false) : json(robot.source);
  values["followers"] = follower_lines(robot);
  values["joints"] = json::array();
  const std::vector<model::Joint> joints = model::driven_joints(robot);
  for (const model::Joint& each : joints)
    values["joints"].push_back(joint(each, robot, &each == &joints.back()));
  values["velocities"] = values_of(greatest_of_all(robot, &model::Joint::greatest_velocity));
  values["efforts"] = values_of(greatest_of_all(robot, &model::Joint::greatest_effort));
  values["parameters"] = json::array();
  bool has_defaults = false;
  bool lacks_defaults = false;
  for (const model::Parameter& parameter : robot.geometry) {
    has_defaults = has_defaults || parameter.default_value.has_value();
    lacks_defaults = lacks_defaults || !parameter.default_value.has_value();
    values["parameters"].push_back(
        {{"name", parameter.name},
         {"default", parameter.default_value ? number(*parameter.default_value, robot) : not_given},
         {"last", &parameter == &robot.geometry.back()}});
  }
  values["parameter_count"] = robot.geometry.size();
  values["has_parameters"] = !robot.geometry.empty();
  values["has_defaults"] = has_defaults;
  values["lacks_defaults"] = lacks_defaults;
  output.files.push_back(
      {"include/qvgen/robots/" + robot.name + "/model.h", emit::render("cpp/model.h", values)});
}

std::vector<emit::c::Constant> constants_of(const model::Robot& robot,
                                            const std::vector<model::Parameter>& parameters) {
  std::vector<emit::c::Constant> list;
  for (const model::Parameter& each : parameters) {
    list.push_back({each.name, std::nullopt});
    if (each.default_value) list.back().value = value_of(*each.default_value, robot);
  }
  return list;
}

void generate_model_c(const model::Robot& robot, RobotOutput& output) {
  const std::vector<double> velocities = greatest_of_all(robot, &model::Joint::greatest_velocity);
  const std::vector<double> efforts = greatest_of_all(robot, &model::Joint::greatest_effort);
  std::vector<emit::c::Joint> joints;
  for (const model::Joint& joint : model::driven_joints(robot)) {
    const std::size_t place = joints.size();
    joints.push_back({joint.variable, joint.type == model::JointType::revolute, std::nullopt,
                      velocities.at(place), efforts.at(place)});
    if (joint.limits)
      joints.back().limits = {value_of(joint.limits->lower, robot), value_of(joint.limits->upper, robot)};
  }
  add_c_part(output, emit::c::model(robot, joints, constants_of(robot, robot.geometry)));
}

}  // namespace qvgen::pipeline
