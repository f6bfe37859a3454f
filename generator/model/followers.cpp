// SPDX-License-Identifier: MIT
#include "model/followers.h"

#include <algorithm>
#include <optional>

namespace qvgen::model {
namespace {

using Row = std::vector<cln::cl_RA>;

/// A motor as the caller sees it, among joints.
Joint as_joint(const Motor& motor) {
  Joint joint;
  joint.type = motor.type;
  joint.variable = motor.variable;
  joint.limits = motor.limits;
  joint.drive = motor.drive;
  joint.greatest_velocity = motor.greatest_velocity;
  joint.greatest_effort = motor.greatest_effort;
  return joint;
}

bool leads(const std::string& variable, const Joint& joint) {
  return std::any_of(joint.follows.begin(), joint.follows.end(),
                     [&](const Lead& lead) { return lead.variable == variable; });
}

/// The motors whose first follower is a joint.
std::vector<Joint> motors_of(const Robot& robot, std::size_t joint) {
  const auto before = robot.joints.begin() + static_cast<std::ptrdiff_t>(joint);
  std::vector<Joint> motors;
  for (const Motor& motor : robot.motors) {
    const auto follows = [&](const Joint& each) { return leads(motor.variable, each); };
    if (follows(*before) && std::none_of(robot.joints.begin(), before, follows))
      motors.push_back(as_joint(motor));
  }
  return motors;
}

/// The matrix A with the unit matrix behind it.
std::vector<Row> with_unit(const Robot& robot) {
  const std::vector<std::vector<Share>> all = shares(robot);
  const std::size_t motors = driven_count(robot);
  std::vector<Row> rows(all.size(), Row(motors + all.size(), 0));
  for (std::size_t i = 0; i < all.size(); ++i) {
    rows[i][motors + i] = 1;
    for (const Share& share : all[i]) rows[i][share.driven] = share.ratio;
  }
  return rows;
}

/// How many motors move the joint of a row; the unit matrix adds the same to all rows.
std::ptrdiff_t motors_in(const Row& row) {
  return std::count_if(row.begin(), row.end(), [](const cln::cl_RA& entry) { return entry != 0; });
}

void subtract_multiple(Row& row, const cln::cl_RA& factor, const Row& other) {
  for (std::size_t k = 0; k < row.size(); ++k) row[k] = row[k] - factor * other[k];
}

/// Makes the first columns those of a unit matrix, by operations on rows. Returns false if they depend on one
/// another.
bool reduce(std::vector<Row>& rows, std::size_t columns) {
  for (std::size_t column = 0; column < columns; ++column) {
    if (column >= rows.size()) return false;
    const auto first = rows.begin() + static_cast<std::ptrdiff_t>(column);
    const auto pivot = std::find_if(first, rows.end(), [&](const Row& row) { return row[column] != 0; });
    if (pivot == rows.end()) return false;
    std::iter_swap(first, pivot);
    const cln::cl_RA scale = cln::recip((*first)[column]);
    for (cln::cl_RA& entry : *first) entry = entry * scale;
    for (Row& row : rows)
      if (&row != &*first && row[column] != 0) subtract_multiple(row, cln::cl_RA(row[column]), *first);
  }
  return true;
}

}  // namespace

bool has_followers(const Robot& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [](const Joint& joint) { return !joint.follows.empty(); });
}

std::vector<Joint> driven_joints(const Robot& robot) {
  std::vector<Joint> result;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (robot.joints[i].follows.empty()) result.push_back(robot.joints[i]);
    for (Joint& motor : motors_of(robot, i)) result.push_back(std::move(motor));
  }
  return result;
}

std::size_t driven_count(const Robot& robot) {
  return robot.motors.size() +
         static_cast<std::size_t>(std::count_if(robot.joints.begin(), robot.joints.end(),
                                                [](const Joint& joint) { return joint.follows.empty(); }));
}

std::vector<std::string> variables(const Robot& robot) {
  std::vector<std::string> result;
  for (const Joint& joint : driven_joints(robot)) result.push_back(joint.variable);
  return result;
}

std::vector<std::vector<Share>> shares(const Robot& robot) {
  const std::vector<std::string> driven = variables(robot);
  const auto place_of = [&](const std::string& variable) {
    return static_cast<std::size_t>(std::find(driven.begin(), driven.end(), variable) - driven.begin());
  };
  std::vector<std::vector<Share>> result;
  for (const Joint& joint : robot.joints) {
    std::vector<Share> row;
    for (const Lead& lead : joint.follows) row.push_back({place_of(lead.variable), lead.ratio});
    if (row.empty()) row.push_back({place_of(joint.variable), 1});
    std::sort(row.begin(), row.end(), [](const Share& a, const Share& b) { return a.driven < b.driven; });
    result.push_back(std::move(row));
  }
  return result;
}

bool has_independent_motors(const Robot& robot) {
  std::vector<Row> rows = with_unit(robot);
  return reduce(rows, driven_count(robot));
}

std::optional<std::vector<std::vector<cln::cl_RA>>> inverse_shares(const Robot& robot) {
  const std::size_t motors = driven_count(robot);
  std::vector<Row> rows = with_unit(robot);
  const auto fewer_motors = [](const Row& a, const Row& b) { return motors_in(a) < motors_in(b); };
  std::stable_sort(rows.begin(), rows.end(), fewer_motors);
  if (!reduce(rows, motors)) return std::nullopt;
  rows.resize(motors);
  for (Row& row : rows) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(motors));
  return rows;
}

namespace {

/// The sign before a term of a sum, of which there may be terms already.
std::string sign_of(const cln::cl_RA& factor, bool is_first) {
  return cln::minusp(factor) ? (is_first ? "-" : " - ") : (is_first ? "" : " + ");
}

/// The factor before a term, and what ties it to that; nothing for 1.
std::string size_of(const cln::cl_RA& factor, const std::string& tie) {
  const cln::cl_RA size = cln::abs(factor);
  return size == 1 ? "" : to_string(Expression(size)) + tie;
}

}  // namespace

std::string relation_text(const Follows& follows, const Powers& powers) {
  std::string text;
  for (const auto& [variable, ratio] : follows)
    if (!cln::zerop(ratio)) text += sign_of(ratio, text.empty()) + size_of(ratio, " ") + variable;
  for (std::size_t i = 0; i < powers.factors.size(); ++i) {
    const cln::cl_RA& factor = powers.factors[i];
    if (cln::zerop(factor)) continue;
    const std::string& leader = follows.front().variable;
    text += sign_of(factor, text.empty()) + size_of(factor, "*") +
            (powers.from.is_literal_zero() ? leader : "(" + leader + " - (" + to_string(powers.from) + "))") +
            "^" + std::to_string(i + 2);
  }
  return text;
}

Robot in_joints(const Robot& robot) {
  Robot result = robot;
  for (Joint& joint : result.joints) joint.follows.clear();
  result.motors.clear();
  return result;
}

}  // namespace qvgen::model
