// SPDX-License-Identifier: MIT
#include "report/live_section.h"

#include <algorithm>

#include "emit/math/singularities.h"
#include "emit/render.h"
#include "model/followers.h"
#include "pipeline/pipeline.h"
#include "report/chain.h"
#include "report/webassembly.h"

namespace qvgen::report {
namespace {

using nlohmann::json;

/// The robot's C files by name, without their folder.
std::map<std::string, std::string> files_of(const pipeline::RobotOutput& output) {
  std::map<std::string, std::string> files;
  for (const pipeline::OutputFile& file : output.files)
    files[file.path.substr(file.path.rfind('/') + 1)] = file.content;
  return files;
}

/// The inverse kinematics of poses, and the joint whose value it is given; empty where there is none.
struct InverseCall {
  std::string function;
  std::string given;
};

InverseCall inverse_call(const pipeline::RobotOutput& output) {
  const std::string near = "inverse_kinematics_near";
  const auto targets = output.counts.value("targets", nlohmann::ordered_json::object());
  for (const auto& [function, tasks] : targets.items()) {
    if (function.rfind(near, 0) == 0) continue;
    const std::string before = "_given_";
    const std::size_t given = function.find(before);
    return {function, given == std::string::npos ? "" : function.substr(given + before.size())};
  }
  return {};
}

json numbers(const Vector& v) { return {v[0], v[1], v[2]}; }
json to_json(const Motion& m) {
  return {{"r", {numbers(m.linear().row(0)), numbers(m.linear().row(1)), numbers(m.linear().row(2))}},
          {"p", numbers(m.translation())}};
}

json chain_json(const Chain& chain) {
  json joints = json::array();
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const ChainJoint& joint = chain.joints[i];
    const auto [lower, upper] = range_of(chain, i);
    joints.push_back({{"name", typeset(joint.variable)},
                      {"revolute", joint.revolute},
                      {"axis", numbers(joint.axis)},
                      {"before", to_json(joint.before.motion)},
                      {"after", to_json(joint.after.motion)},
                      {"lower", lower},
                      {"upper", upper},
                      {"limited", joint.limits.has_value()}});
  }
  return {
      {"base", to_json(chain.base.motion)}, {"joints", joints},       {"tool", to_json(chain.tool.motion)},
      {"geometry", chain.geometry},         {"size", size_of(chain)}, {"start", bent_pose(chain)}};
}

std::vector<std::string> measure_names(const model::Robot& robot) {
  std::vector<std::string> names;
  for (const auto& factor : emit::singularity_formulas(robot, emit::Notation::text).factors)
    names.push_back(factor.kind);
  if (names.empty()) names = {"determinant"};
  return names;
}

Section without(const std::string& reason) {
  return {"interactive", "Interactive view",
          "<p class=\"note\">This page is still: " + escaped(reason) + ".</p>\n"};
}

}  // namespace

Section live_section(const model::Robot& robot) {
  if (model::has_followers(robot)) return without("a joint follows another");
  if (const std::string missing = missing_compiler(); !missing.empty()) return without(missing);
  const pipeline::RobotOutput output = pipeline::generate({robot}, {"kinematics", "jacobian", "inverse"},
                                                          pipeline::own_budget(), {}, pipeline::Language::c)
                                           .front();
  std::map<std::string, std::string> files = files_of(output);
  const std::string& header = files["qvgen_" + robot.name + ".h"];
  const auto declares = [&](const char* function) {
    return header.find(robot.name + "_" + function + "(") != std::string::npos;
  };
  if (!declares("jacobian")) return without("the robot has no C functions");
  const bool has_inverse = files.count("qvgen_" + robot.name + "_inverse.h") > 0;
  const InverseCall inverse = has_inverse ? inverse_call(output) : InverseCall{};
  const bool has_measures = declares("singularity_measures");
  files["calls.c"] = emit::render("report/live_calls.c", {{"name", robot.name},
                                                          {"has_inverse", !inverse.function.empty()},
                                                          {"function", inverse.function},
                                                          {"given", !inverse.given.empty()},
                                                          {"has_measures", has_measures},
                                                          {"geometry_size", robot.geometry.size() + 1}});
  const Compiled compiled = to_webassembly(files);
  if (!compiled.done) return without(compiled.reason);
  json data = chain_json(chain_of(robot));
  data["inverse"] = !inverse.function.empty();
  data["measures"] = has_measures ? json(measure_names(robot)) : json::array();
  data["given"] = -1;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (robot.joints[i].variable == inverse.given) data["given"] = i;
  data["module"] = base64(compiled.bytes);
  return {"interactive", "Interactive view",
          emit::render("report/live.html", {{"data", data.dump()},
                                            {"name", escaped(robot.name)},
                                            {"has_inverse", !inverse.function.empty()},
                                            {"has_given", !inverse.given.empty()},
                                            {"given", escaped(typeset(inverse.given))}})};
}

std::string live_script() {
  std::string all;
  for (const char* name : {"live_motion.js", "live_arm.js", "live_view.js", "live_panel.js", "live.js"})
    all += asset(name);
  return all;
}

}  // namespace qvgen::report
