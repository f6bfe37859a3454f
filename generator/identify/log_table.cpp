// SPDX-License-Identifier: MIT
#include "identify/log_table.h"

#include <algorithm>

#include "identify/log_checks.h"
#include "model/followers.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using measured::Quantity;
using measured::Wanted;

/// Names that headers of logs use, each followed by the joint's number.
struct Kind {
  std::string name;
  std::vector<std::string> others;
  Quantity turning, sliding;
  bool required;
};

std::vector<Kind> kinds_of(const LogOptions& options) {
  std::vector<Kind> kinds{
      {"q", {"position", "pos", "joint"}, Quantity::angle, Quantity::length, true},
      {"qd", {"dq", "velocity", "vel"}, Quantity::angular_velocity, Quantity::velocity, false},
      {"qdd", {"ddq", "acceleration", "acc"}, Quantity::angular_acceleration, Quantity::acceleration, false}};
  if (options.temperature)
    kinds.push_back({"temperature", {"temp"}, Quantity::temperature, Quantity::temperature, false});
  if (!options.torques) return kinds;
  if (options.torque_constants.empty())
    kinds.push_back({"torque", {"tau", "effort", "force"}, Quantity::torque, Quantity::force, true});
  else
    kinds.push_back({"current", {"i", "amp"}, Quantity::current, Quantity::current, true});
  return kinds;
}

Wanted column(const Kind& kind, const model::Joint& joint, std::size_t number) {
  Wanted wanted;
  wanted.name = kind.name + std::to_string(number);
  wanted.quantity = joint.type == model::JointType::revolute ? kind.turning : kind.sliding;
  wanted.required = kind.required;
  for (const std::string& other : kind.others) {
    wanted.others.push_back(other + std::to_string(number));
    wanted.others.push_back(other + "_" + std::to_string(number));
  }
  wanted.others.push_back(kind.name + "_" + std::to_string(number));
  wanted.others.push_back(kind.name == "q" ? joint.variable : joint.variable + "_" + kind.name);
  return wanted;
}

/// The columns of a kind as a matrix; no rows where the file lacks any.
Eigen::MatrixXd matrix(const measured::Table& table, const std::string& kind, std::size_t joints) {
  Eigen::MatrixXd result(static_cast<Index>(table.rows()), static_cast<Index>(joints));
  for (std::size_t i = 0; i < joints; ++i) {
    const std::vector<double>* column = table.find(kind + std::to_string(i + 1));
    if (column == nullptr) return Eigen::MatrixXd(0, static_cast<Index>(joints));
    result.col(static_cast<Index>(i)) = Eigen::VectorXd::Map(column->data(), result.rows());
  }
  return result;
}

void add_error(LogResult& result, const std::string& message, const std::string& hint) {
  result.diagnostics.push_back({result.log.name, 1, 1, description::Diagnostic::error, message, hint});
}

/// Returns the temperatures of all joints: their own, or that of the arm.
Eigen::MatrixXd temperatures(const measured::Table& table, std::size_t joints) {
  Eigen::MatrixXd own = matrix(table, "temperature", joints);
  const auto* whole = table.find("temperature");
  if (own.rows() > 0 || whole == nullptr) return own;
  return Eigen::VectorXd::Map(whole->data(), static_cast<Index>(whole->size()))
      .replicate(1, static_cast<Index>(joints));
}

/// Rates of some joints alone are a slip: none are used by halves.
void check_complete(const measured::Table& table, std::size_t joints, LogResult& result) {
  for (const std::string kind : {"qd", "qdd"})
    for (std::size_t i = 0; i < joints; ++i) {
      const bool first = table.find(kind + "1") != nullptr;
      if ((table.find(kind + std::to_string(i + 1)) != nullptr) == first) continue;
      add_error(result, "there are columns " + kind + " of some joints only",
                "give " + kind + "1 to " + kind + std::to_string(joints) + ", or none of them");
      break;
    }
  const bool derives = table.find("qd1") == nullptr || table.find("qdd1") == nullptr;
  if (derives && table.find("time") == nullptr)
    add_error(result, "there is no column 'time', and rates or accelerations have to be derived",
              "add time [s], or qd1 ... and qdd1 ...");
}

void take_columns(const measured::Table& table, std::size_t joints, const LogOptions& options,
                  LogResult& result) {
  MotionLog& log = result.log;
  if (const auto* time = table.find("time")) log.time = *time;
  log.q = matrix(table, "q", joints);
  log.qd = matrix(table, "qd", joints);
  log.qdd = matrix(table, "qdd", joints);
  if (options.temperature) log.temperature = temperatures(table, joints);
  if (options.temperature && log.temperature.rows() == 0)
    add_error(result, "there is no column 'temperature', which --temperature asks for",
              "add temperature [degC] of the arm, or temperature1 [degC], ... of each joint");
  log.torque = matrix(table, options.torque_constants.empty() ? "torque" : "current", joints);
  for (std::size_t i = 0; i < options.torque_constants.size() && log.torque.rows() > 0; ++i)
    log.torque.col(static_cast<Index>(i)) *= options.torque_constants[i];
}

}  // namespace

bool LogResult::good() const {
  return std::none_of(diagnostics.begin(), diagnostics.end(), [](const description::Diagnostic& each) {
    return each.severity == description::Diagnostic::error;
  });
}

std::vector<Wanted> log_columns(const model::Robot& robot, const LogOptions& options) {
  std::vector<Wanted> columns{{"time", Quantity::time, false, false, {"t", "timestamp"}}};
  if (options.temperature) columns.push_back({"temperature", Quantity::temperature, false, false, {"temp"}});
  for (const Kind& kind : kinds_of(options)) {
    std::size_t number = 0;
    for (const model::Joint& joint : model::driven_joints(robot))
      columns.push_back(column(kind, joint, ++number));
  }
  return columns;
}

LogResult log_of(const measured::TableResult& read, const model::Robot& robot, const LogOptions& options) {
  LogResult result;
  result.log.name = read.table.file;
  result.diagnostics = read.diagnostics;
  if (!read.good()) return result;
  const std::size_t joints = model::driven_count(robot);
  result.lines = read.table.lines;
  check_complete(read.table, joints, result);
  if (!result.good()) return result;
  take_columns(read.table, joints, options, result);
  check_log(robot, result);
  return result;
}

LogResult read_log(const std::string& file, const model::Robot& robot, const LogOptions& options) {
  measured::TableOptions table;
  table.others_are_mistakes = false;
  table.fewest_rows = 20;
  return log_of(measured::read_table(std::filesystem::path(file), log_columns(robot, options), table), robot,
                options);
}

}  // namespace qvgen::identify
