// SPDX-License-Identifier: MIT
#include "report/live_section.h"

#include <algorithm>

#include "emit/render.h"
#include "pipeline/pipeline.h"
#include "report/chain.h"
#include "report/live_functions.h"

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

json numbers(const Vector& v) { return {v[0], v[1], v[2]}; }
json to_json(const Motion& m) {
  return {{"r", {numbers(m.linear().row(0)), numbers(m.linear().row(1)), numbers(m.linear().row(2))}},
          {"p", numbers(m.translation())}};
}

json joint_json(const Chain& chain, std::size_t i) {
  const ChainJoint& joint = chain.joints[i];
  const auto [lower, upper] = range_of(chain, i);
  json result{{"name", typeset(joint.variable)},
              {"revolute", joint.revolute},
              {"axis", numbers(joint.axis)},
              {"before", to_json(joint.before.motion)},
              {"after", to_json(joint.after.motion)},
              {"lower", lower},
              {"upper", upper},
              {"limited", joint.limits.has_value()}};
  if (joint.follows) result["follows"] = {joint.follows->first, joint.follows->second};
  return result;
}

}  // namespace

json motion_data(const Motion& motion) { return to_json(motion); }

json chain_data(const Chain& chain) {
  json all = json::array(), moved = json::array(), start = json::array();
  const std::vector<double> bent = bent_pose(chain);
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    all.push_back(joint_json(chain, i));
    if (chain.joints[i].follows) continue;
    moved.push_back(all.back());
    start.push_back(bent[i]);
  }
  json result{
      {"base", to_json(chain.base.motion)}, {"joints", moved},        {"tool", to_json(chain.tool.motion)},
      {"geometry", chain.geometry},         {"size", size_of(chain)}, {"start", start}};
  if (moved.size() != all.size()) result["chain"] = all;  // all joints, beside those that are moved
  return result;
}

namespace {

std::string calls_text(const model::Robot& robot, const InverseCall& inverse, bool has_positions,
                       bool has_measures) {
  return emit::render("report/live_calls.c", {{"name", robot.name},
                                              {"has_inverse", !inverse.function.empty()},
                                              {"function", inverse.function},
                                              {"given", !inverse.given.empty()},
                                              {"has_positions", has_positions},
                                              {"has_measures", has_measures},
                                              {"geometry_size", robot.geometry.size() + 1}});
}

/// Index of a joint's variable, -1 of none.
int place_of(const model::Robot& robot, const std::string& variable) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (robot.joints[i].variable == variable) return static_cast<int>(i);
  return -1;
}

/// Returns a sentence on what the page cannot do for want of a library.
std::string lacking_library(const CppFunctions& more) {
  if (!more.wanted() || more.module.done) return "";
  const std::string what = more.has_arm_angle ? "The arm angle is not shown" : "Not all solutions are shown";
  return what + ": " + escaped(more.module.reason) + ".";
}

Section page_part(const model::Robot& robot, const InverseCall& inverse, const CppFunctions& more,
                  const json& data) {
  const std::string missing = lacking_library(more);
  return {"interactive", "Interactive view",
          emit::render("report/live.html", {{"data", data.dump()},
                                            {"name", escaped(robot.name)},
                                            {"has_inverse", !inverse.function.empty()},
                                            {"has_given", !inverse.given.empty()},
                                            {"has_arm_angle", more.has_arm_angle && more.module.done},
                                            {"lacks", !missing.empty()},
                                            {"lacking", missing},
                                            {"given", escaped(typeset(inverse.given))}})};
}

LiveArm lacking(const std::string& reason) { return {{}, {}, {}, reason}; }

}  // namespace

Section still_section(const std::string& reason) {
  return {"interactive", "Interactive view",
          "<p class=\"note\">This page is still: " + escaped(reason) + ".</p>\n"};
}

LiveArm live_arm(const model::Robot& robot, const toolchain::Runtime* runtime) {
  if (!robot.motors.empty()) return lacking("its joints follow motors");
  if (const std::string missing = missing_compiler(); !missing.empty()) return lacking(missing);
  const pipeline::RobotOutput output = pipeline::generate_page_functions(robot, pipeline::own_budget());
  std::map<std::string, std::string> files = files_of(output);
  const auto declares = [&](const std::string& header, const std::string& function) {
    return files["qvgen_" + robot.name + header].find(robot.name + "_" + function + "(") != std::string::npos;
  };
  if (!declares(".h", "jacobian")) return lacking("the robot has no C functions");
  constexpr std::size_t most_with_one_given = 7;  // the page has a slider for one
  const bool has_inverse =
      robot.joints.size() <= most_with_one_given && files.count("qvgen_" + robot.name + "_inverse.h") > 0;
  const InverseCall in_c = has_inverse ? inverse_call(output) : InverseCall{};
  const bool has_positions = in_c.given.empty() && declares("_inverse.h", in_c.function + "_of_position");
  const bool has_measures = declares(".h", "singularity_measures");
  files["calls.c"] = calls_text(robot, in_c, has_positions, has_measures);
  const Compiled compiled = to_webassembly(files);
  if (!compiled.done) return lacking(compiled.reason);
  const CppFunctions more = cpp_functions(robot, !in_c.function.empty(), runtime);
  const InverseCall& inverse = in_c.function.empty() && more.module.done ? more.inverse : in_c;
  json data = chain_data(chain_of(robot));
  data["inverse"] = !inverse.function.empty();
  data["measures"] = has_measures ? json(output.counts.at("measures")) : json::array();
  data["given"] = place_of(robot, inverse.given);
  data["module"] = base64(compiled.bytes);
  if (more.module.done) data["cpp"] = base64(more.module.bytes);
  return {data, inverse, more, ""};
}

Section live_section(const model::Robot& robot, const toolchain::Runtime* runtime) {
  const LiveArm arm = live_arm(robot, runtime);
  return arm.lacking.empty() ? page_part(robot, arm.inverse, arm.more, arm.data) : still_section(arm.lacking);
}

namespace {

std::string assets(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += asset(name);
  return all;
}

}  // namespace

std::string drawing_script() {
  return assets({"live_motion.js", "live_arm.js", "live_view.js", "live_panel.js"});
}

std::string live_script() {
  return drawing_script() +
         assets({"live_branches.js", "live_ring.js", "live_gallery.js", "live_hand.js", "live.js"});
}

std::string loop_script() { return drawing_script() + assets({"live_hand.js", "live_loops.js"}); }

std::string whole_script() { return drawing_script() + assets({"live_hand.js", "live_whole.js"}); }

}  // namespace qvgen::report
