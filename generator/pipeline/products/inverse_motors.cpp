// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_motors.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/evaluate.h"
#include "model/followers.h"
#include "model/motor_turns.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using Row = std::vector<cln::cl_RA>;

std::string number(const cln::cl_RA& value) { return fmt::format("{}", cln::double_approx(value)); }

/// A sum of multiples of the entries of `of`.
std::string sum_text(const Row& row) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (cln::zerop(row[i])) continue;
    const cln::cl_RA size = cln::abs(row[i]);
    text += cln::minusp(row[i]) ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    text += (size == 1 ? "" : number(size) + " * ") + "of[" + std::to_string(i) + "]";
  }
  return text;
}

std::vector<Row> matrix_of(const model::Robot& robot) {
  std::vector<Row> rows;
  for (const std::vector<model::Share>& shares : model::shares(robot)) {
    rows.emplace_back(model::driven_count(robot), 0);
    for (const model::Share& share : shares) rows.back()[share.driven] = share.ratio;
  }
  return rows;
}

/// The entries of a square matrix row by row, or 1 of each joint that turns and 0 of one that slides.
std::string entries_of(const std::vector<Row>& rows) {
  std::vector<std::string> entries;
  for (const Row& row : rows)
    for (const cln::cl_RA& entry : row) entries.push_back(number(entry));
  return fmt::format("{}", fmt::join(entries, ", "));
}
std::string kinds_of(const model::Robot& robot) {
  std::vector<int> kinds;
  for (const model::Joint& joint : robot.joints)
    kinds.push_back(joint.type == model::JointType::revolute ? 1 : 0);
  return fmt::format("{}", fmt::join(kinds, ", "));
}

/// Names of constants in a language.
struct Words {
  std::string unlimited, whole_turn;
};

const Words in_cxx{"unlimited", "inverse::whole_turn"}, in_c{"HUGE_VAL", "6.283185307179586476925"};

std::string bound(const std::optional<model::Limits>& limits, bool is_lower, const model::Robot& robot,
                  const Words& words) {
  const std::string sign = is_lower ? "-" : "";
  if (!limits) return sign + words.unlimited;
  const model::Expression& expression = is_lower ? limits->lower : limits->upper;
  return fmt::format("{}", model::to_double(model::evaluate(expression, model::default_bindings(robot))));
}

json joints_of(const model::Robot& robot, const std::vector<Row>& rows, const Words& words) {
  json list = json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const model::Joint& joint = robot.joints[i];
    list.push_back({{"place", i},
                    {"variable", joint.variable},
                    {"revolute", joint.type == model::JointType::revolute ? "true" : "false"},
                    {"lower", bound(joint.limits, true, robot, words)},
                    {"upper", bound(joint.limits, false, robot, words)},
                    {"of_motors", sum_text(rows[i])},
                    {"last", i + 1 == rows.size()}});
  }
  return list;
}

json motors_of(const std::vector<Row>& inverse) {
  json list = json::array();
  for (const Row& row : inverse)
    list.push_back({{"place", list.size()}, {"of_joints", sum_text(row)}, {"last", &row == &inverse.back()}});
  return list;
}

/// Values with limits, in the order in which they are searched.
json values_of(const model::Robot& robot, const std::vector<Row>& rows, const model::MotorTurns& turns,
               const Words& words) {
  json list = json::array();
  for (const model::LimitedValue& value : turns.values) {
    const auto own = value.is_motor ? std::nullopt : robot.joints[value.index].limits;
    const std::string index = std::to_string(value.index);
    list.push_back({{"place", list.size()},
                    {"of_motors", value.is_motor ? "of[" + index + "]" : sum_text(rows[value.index])},
                    {"motor", value.is_motor ? index : "-1"},
                    {"own_lower", bound(own, true, robot, words)},
                    {"own_upper", bound(own, false, robot, words)},
                    {"last", &value == &turns.values.back()}});
  }
  return list;
}

json turns_of(const model::MotorTurns& turns, const Words& words) {
  json list = json::array();
  for (const model::MotorTurn& turn : turns.turns) {
    json motion = json::array();
    for (const cln::cl_RA& part : turn.motion)
      motion.push_back({{"value", cln::zerop(part) ? "0" : number(part) + " * " + words.whole_turn},
                        {"last", &part == &turn.motion.back()}});
    list.push_back({{"pivot", turn.pivot},
                    {"ends_block", turn.ends_block ? "true" : "false"},
                    {"motion", motion},
                    {"last", &turn == &turns.turns.back()}});
  }
  return list;
}

json relations_of(const model::Robot& robot) {
  json list = json::array();
  for (const model::Joint& joint : robot.joints)
    if (!joint.follows.empty())
      list.push_back({{"text", joint.variable + " = " + model::relation_text(joint.follows)}});
  return list;
}

bool has_joint_limits(const model::Robot& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(), [](const model::Joint& joint) {
    return !joint.follows.empty() && joint.limits.has_value();
  });
}

/// The relation of joints and motors, with limits and whole turns, in the words of a language.
json relation(const model::Robot& described, const Words& words) {
  const std::vector<Row> inverse = *model::inverse_shares(described);
  const std::vector<Row> matrix = matrix_of(described);
  const model::MotorTurns turns = model::motor_turns(described, inverse);
  const std::size_t values = turns.values.size(), count = turns.turns.size();
  return {{"relations", relations_of(described)},
          {"of_joints", joints_of(described, matrix, words)},
          {"of_motors", motors_of(inverse)},
          {"joints_by_motors", entries_of(matrix)},
          {"motors_by_joints", entries_of(inverse)},
          {"joint_kinds", kinds_of(described)},
          {"joint_count", matrix.size()},
          {"has_joint_over", matrix.size() > inverse.size()},
          {"entry_count", matrix.size() * inverse.size()},
          {"values", values_of(described, matrix, turns, words)},
          {"value_count", values},
          {"turns", turns_of(turns, words)},
          {"turn_count", count},
          {"level_count", count + 1},
          {"motion_count", count * values + 1},
          {"has_joint_limits", has_joint_limits(described)}};
}

/// The place of a given joint among the motors; it is one itself.
int motor_of(const model::Robot& robot, int joint) {
  if (joint < 0) return joint;
  return static_cast<int>(model::shares(robot)[static_cast<std::size_t>(joint)].front().driven);
}

}  // namespace

std::string obstacle_of_motors(const model::Robot& coupled) {
  const std::size_t joints = coupled.joints.size(), motors = model::driven_count(coupled);
  const bool may_have_one = model::inverse_shares(coupled) && (joints == motors || has_a_joint_over(coupled));
  if (!model::has_followers(coupled) || may_have_one) return "";
  return fmt::format(
      "{} {} move {} joints, and each joint needs its own, except one of five that keeps the tool level; "
      "a bar that moves a joint may be written as a [[loop]]",
      motors, coupled.motors.empty() ? "joints that follow none" : "motors", joints);
}

bool has_a_joint_over(const model::Robot& coupled) {
  return coupled.joints.size() == 5 && model::driven_count(coupled) == 4;
}

bool keeps_balance(const model::Robot& coupled, const derive::inverse::Balance& balance) {
  Row sum(model::driven_count(coupled), 0);
  const std::vector<Row> rows = matrix_of(coupled);
  for (const auto& [joint, sense] : balance.turns)
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] = sum[k] + sense * rows[static_cast<std::size_t>(joint)][k];
  return !balance.empty() &&
         std::all_of(sum.begin(), sum.end(), [](const cln::cl_RA& x) { return cln::zerop(x); });
}

void add_motors(const model::Robot& described, json& values) {
  values["motors"] = false;
  values["robot_space"] = described.name;
  values["scope"] = "";  // of calls in that namespace
  if (!model::has_followers(described)) return;
  values["robot_space"] = described.name + "::joints";
  values["scope"] = "joints::";
  values["motors"] = relation(described, in_cxx);
  for (json& variant : values["variants"]) variant["given_motor"] = motor_of(described, variant["given"]);
}

json relation_in_c(const model::Robot& described) { return relation(described, in_c); }

}  // namespace qvgen::pipeline
