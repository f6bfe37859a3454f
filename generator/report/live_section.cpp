// SPDX-License-Identifier: MIT
#include "report/live_section.h"

#include <algorithm>
#include <regex>

#include "emit/math/singularities.h"
#include "emit/render.h"
#include "pipeline/pipeline.h"
#include "report/chain.h"
#include "report/webassembly.h"

namespace qvgen::report {
namespace {

using nlohmann::json;

/// The robot's C files by name, without their folder.
std::map<std::string, std::string> c_files(const model::Robot& robot) {
  std::map<std::string, std::string> files;
  const auto outputs = pipeline::generate({robot}, {"kinematics", "jacobian", "inverse"},
                                          pipeline::own_budget(), {}, pipeline::Language::c);
  for (const pipeline::OutputFile& file : outputs.front().files)
    files[file.path.substr(file.path.rfind('/') + 1)] = file.content;
  return files;
}

/// The inverse kinematics that takes a whole pose, and what it is called with.
struct InverseCall {
  std::string function;
  std::string arguments;
  std::string given;  ///< the joint whose value the caller gives; empty if none
};

/// As its header declares it: orientation and position, or the position alone.
InverseCall inverse_call(const std::string& robot, const std::string& header) {
  static const std::regex declaration("int (\\w+)\\(([^;]*)\\);");
  InverseCall best;
  for (std::sregex_iterator it(header.begin(), header.end(), declaration), end; it != end; ++it) {
    const std::string name = (*it)[1].str().substr(robot.size() + 1);
    const std::string parameters = (*it)[2];
    const bool has_pose = parameters.find("orientation[4]") != std::string::npos;
    const bool has_position = parameters.find("position[3]") != std::string::npos;
    const bool special = name.find("_within_limits") != std::string::npos ||
                         name.find("_near") != std::string::npos ||
                         parameters.find("double yaw") != std::string::npos || !has_position;
    if (special || (!best.function.empty() && !has_pose)) continue;
    best = {name, has_pose ? "arguments, arguments + 4" : "arguments + 4", ""};
    std::smatch given;
    if (std::regex_search(parameters, given, std::regex("double given_(\\w+)"))) {
      best.given = given[1];
      best.arguments += ", given";
    }
    if (has_pose) return best;
  }
  return best;
}

json numbers(const Vector& v) { return {v[0], v[1], v[2]}; }
json to_json(const Motion& m) {
  return {{"r", {numbers(m.rotation[0]), numbers(m.rotation[1]), numbers(m.rotation[2])}},
          {"p", numbers(m.translation)}};
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
  if (const std::string missing = missing_compiler(); !missing.empty()) return without(missing);
  std::map<std::string, std::string> files = c_files(robot);
  const auto& header = files["qvgen_" + robot.name + ".h"];
  if (header.find(robot.name + "_jacobian(") == std::string::npos)
    return without("the robot has no C functions");
  const InverseCall inverse = inverse_call(robot.name, files["qvgen_" + robot.name + "_inverse.h"]);
  const bool has_measures = header.find(robot.name + "_singularity_measures(") != std::string::npos;
  files["calls.c"] = emit::render("report/live_calls.c", {{"name", robot.name},
                                                          {"has_inverse", !inverse.function.empty()},
                                                          {"function", inverse.function},
                                                          {"call", inverse.arguments},
                                                          {"has_measures", has_measures},
                                                          {"geometry_size", robot.geometry.size() + 1}});
  const Compiled compiled = to_webassembly(files);
  if (!compiled.done) return without(compiled.reason);
  json data = chain_json(chain_of(robot));
  data["inverse"] = !inverse.function.empty();
  data["wholePose"] = inverse.arguments.find("arguments, ") == 0;
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
