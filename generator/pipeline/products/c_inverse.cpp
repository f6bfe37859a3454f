// SPDX-License-Identifier: MIT
#include "pipeline/products/c_inverse.h"

#include "emit/render.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// A function for all solutions by what its name ends with: "_given_theta3", or nothing.
/// `count`: how many joints are given, if any.
json variant(const std::string& suffix, std::size_t count) {
  const std::string mark = "_given_";
  const bool locked = suffix.rfind(mark, 0) == 0;
  const std::string given = locked ? suffix.substr(mark.size()) : "";
  std::string arguments;
  for (std::size_t i = 0; i < count; ++i) arguments += "given[" + std::to_string(i) + "], ";
  const std::string parameter = count > 1 ? "const double* given, " : "double given, ";
  return {{"suffix", suffix},
          {"given_parameter", locked ? parameter : ""},
          {"given_argument", !locked     ? ""
                             : count > 1 ? arguments
                                         : "given, "},
          {"given_meaning",
           !locked ? "" : " with " + given + (count > 1 ? " as they are given" : " as it is given")}};
}

json variants_of(const ordered_json& targets, std::size_t joints) {
  constexpr std::size_t of_a_pose = 6;
  const std::string all = "inverse_kinematics", near = all + "_near";
  json variants = json::array();
  for (const auto& [function, taken] : targets.items())
    if (function.rfind(near, 0) != 0)
      variants.push_back(variant(function.substr(all.size()), joints > of_a_pose ? joints - of_a_pose : 1));
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
  const json values{{"name", robot.name},
                    {"dof", robot.joints.size()},
                    {"variants", variants_of(targets, robot.joints.size())}};
  output.files.push_back({"c/qvgen_" + robot.name + "_inverse.h", emit::render("c/inverse.h", values)});
  output.files.push_back({"source/" + robot.name + "/c_inverse.cpp", emit::render("c/inverse.cpp", values)});
}

}  // namespace qvgen::pipeline
