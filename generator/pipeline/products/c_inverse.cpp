// SPDX-License-Identifier: MIT
#include "pipeline/products/c_inverse.h"

#include "emit/render.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// A function for all solutions by what its name ends with: "_given_theta3", or nothing.
json variant(const std::string& suffix) {
  const std::string mark = "_given_";
  const bool locked = suffix.rfind(mark, 0) == 0;
  const std::string given = locked ? suffix.substr(mark.size()) : "";
  return {{"suffix", suffix},
          {"given_parameter", locked ? "double given, " : ""},
          {"given_argument", locked ? "given, " : ""},
          {"given_meaning", locked ? " with " + given + " as it is given" : ""}};
}

json variants_of(const ordered_json& targets) {
  const std::string all = "inverse_kinematics", near = all + "_near";
  json variants = json::array();
  for (const auto& [function, taken] : targets.items())
    if (function.rfind(near, 0) != 0) variants.push_back(variant(function.substr(all.size())));
  return variants;
}

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
  const json values{{"name", robot.name}, {"dof", robot.joints.size()}, {"variants", variants_of(targets)}};
  output.files.push_back({"c/qvgen_" + robot.name + "_inverse.h", emit::render("c/inverse.h", values)});
  output.files.push_back({"source/" + robot.name + "/c_inverse.cpp", emit::render("c/inverse.cpp", values)});
}

}  // namespace qvgen::pipeline
