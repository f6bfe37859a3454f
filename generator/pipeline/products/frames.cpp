// SPDX-License-Identifier: MIT
#include "pipeline/products/frames.h"

#include "emit/c/parts.h"
#include "emit/cpp/scalars.h"
#include "emit/leaves.h"
#include "emit/render.h"
#include "model/frames.h"
#include "optimise/optimised_json.h"
#include "pipeline/c_files.h"
#include "pipeline/products/frame_functions.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

constexpr std::array kinds{FrameFunction::pose, FrameFunction::transform, FrameFunction::jacobian};

std::vector<emit::JacobianFunction> functions_of(const model::Robot& described, RobotOutput& output) {
  const std::vector<model::Frame> links = model::link_frames(described), all = model::all_frames(described);
  std::vector<emit::JacobianFunction> functions{frame_poses_function(described, "link_poses", links)};
  functions.push_back(frame_poses_function(described, "frame_poses", all));
  for (const model::Frame& frame : all)
    for (const FrameFunction kind : kinds) functions.push_back(frame_function(described, frame, kind));
  for (const emit::JacobianFunction& function : functions) {
    output.counts[function.name] = to_json(function.optimised);
    output.counts[function.name].erase("forms");
  }
  return functions;
}

json frame_values(const model::Robot& described) {
  json list = json::array();
  const std::vector<model::Frame> frames = model::all_frames(described);
  for (std::size_t i = 0; i < frames.size(); ++i)
    list.push_back({{"frame", frames[i].name}, {"last", i + 1 == frames.size()}});
  return list;
}

}  // namespace

void generate_frames(const model::Robot& described, RobotOutput& output) {
  const std::vector<emit::JacobianFunction> functions = functions_of(described, output);
  const std::vector<dag::Angle> angles = emit::angles_of(functions);
  json values{{"name", described.name}, {"scalars", emit::scalars()}};
  values["frames"] = frame_values(described);
  values["frame_count"] = values["frames"].size();
  values["link_count"] = described.joints.size();
  values["functions"] = json::array();
  for (const emit::JacobianFunction& function : functions)
    values["functions"].push_back(emit::to_values(function, described, angles, "detail::NoFrameAngles"));
  const std::string headers = "include/qvgen/robots/" + described.name + "/";
  output.files.push_back({headers + "frames.h", emit::render("cpp/frames.h", values)});
  output.files.push_back(
      {headers + "frames_definitions.h", emit::render("cpp/frames_definitions.h", values)});
  output.files.push_back(
      {"source/" + described.name + "/frames.cpp", emit::render("cpp/frames.cpp", values)});
}

void generate_frames_c(const model::Robot& described, RobotOutput& output) {
  const std::vector<emit::JacobianFunction> functions = functions_of(described, output);
  std::vector<std::string> names;
  for (const model::Frame& frame : model::all_frames(described)) names.push_back(frame.name);
  add_c_part(output, emit::c::frames(described, names, functions));
}

}  // namespace qvgen::pipeline
