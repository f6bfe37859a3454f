// SPDX-License-Identifier: MIT
#include "report/live_functions.h"

#include "emit/render.h"
#include "model/followers.h"
#include "pipeline/pipeline.h"

namespace qvgen::report {
namespace {

bool has_file(const pipeline::RobotOutput& output, const std::string& end) {
  for (const pipeline::OutputFile& file : output.files)
    if (file.path.ends_with(end)) return true;
  return false;
}

/// All that is compiled as one source, so that headers are read once.
std::map<std::string, std::string> sources_of(const model::Robot& robot, const CppFunctions& functions,
                                              const pipeline::RobotOutput& output) {
  std::map<std::string, std::string> files;
  for (const pipeline::OutputFile& file : output.files)
    if (file.path.find("_avx2") == std::string::npos) files[file.path] = file.content;
  files["calls.cpp"] =
      emit::render("report/live_calls.cpp", {{"name", robot.name},
                                             {"has_inverse", !functions.inverse.function.empty()},
                                             {"function", functions.inverse.function},
                                             {"given", !functions.inverse.given.empty()},
                                             {"has_arm_angle", functions.has_arm_angle},
                                             {"geometry_size", robot.geometry.size() + 1}});
  return files;
}

std::vector<std::string> folders_of(const CppFunctions& functions) {
  std::vector<std::string> folders;
  if (functions.has_arm_angle) folders.push_back("arm_angle");
  if (!functions.inverse.function.empty()) folders.push_back("elimination");
  return folders;
}

}  // namespace

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

CppFunctions cpp_functions(const model::Robot& robot, bool has_inverse_in_c,
                           const toolchain::Runtime* runtime) {
  CppFunctions functions;
  // The arm angle is that of seven joints.
  const std::size_t joints = robot.joints.size();
  if (model::has_followers(robot) || joints > 7 || (has_inverse_in_c && joints != 7)) return functions;
  pipeline::Parts parts{"model", "arm_angle"};
  if (!has_inverse_in_c) parts.push_back("inverse");
  const pipeline::RobotOutput output = pipeline::generate({robot}, parts, pipeline::own_budget()).front();
  functions.has_arm_angle = has_file(output, "/arm_angle.cpp");
  if (!has_inverse_in_c && has_file(output, "/inverse.cpp")) functions.inverse = inverse_call(output);
  if (!functions.wanted()) return functions;
  functions.module = cpp_to_webassembly(sources_of(robot, functions, output), folders_of(functions), runtime);
  return functions;
}

}  // namespace qvgen::report
