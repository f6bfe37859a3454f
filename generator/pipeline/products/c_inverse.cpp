// SPDX-License-Identifier: MIT
#include "pipeline/products/c_inverse.h"

#include "emit/render.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

const std::string all = "inverse_kinematics";

void leave_out(const std::string& reason, RobotOutput& output) {
  output.missing.push_back({"c_inverse", Missing::Kind::not_derived, reason});
}

}  // namespace

void add_c_inverse(const model::Robot& robot, RobotOutput& output) {
  const ordered_json targets = output.counts.value("targets", ordered_json::object());
  if (targets.empty()) return leave_out("there is no inverse kinematics", output);
  // Only closed forms are counted.
  for (const auto& [function, taken] : targets.items())
    if (output.counts.contains(function))
      return leave_out("it is a closed form, which --language c writes in C99", output);
  const json values{
      {"name", robot.name}, {"dof", robot.joints.size()}, {"near", targets.contains(all + "_near")}};
  output.files.push_back({"c/qvgen_" + robot.name + "_inverse.h", emit::render("c_inverse.h", values)});
  output.files.push_back({"source/" + robot.name + "/c_inverse.cpp", emit::render("c_inverse.cpp", values)});
}

}  // namespace qvgen::pipeline
