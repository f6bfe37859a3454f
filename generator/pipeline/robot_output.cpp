// SPDX-License-Identifier: MIT
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

using nlohmann::ordered_json;

std::string to_text(const RobotOutput& output) {
  ordered_json files = ordered_json::array();
  for (const OutputFile& file : output.files)
    files.push_back({{"path", file.path}, {"content", file.content}});
  return ordered_json{
      {"robot", output.robot}, {"files", files}, {"counts", output.counts}, {"missing", output.missing}}
      .dump();
}

RobotOutput robot_output_from_text(const std::string& text) {
  const ordered_json json = ordered_json::parse(text);
  RobotOutput output{json.at("robot"), {}, json.at("counts"), json.at("missing")};
  for (const auto& file : json.at("files")) output.files.push_back({file.at("path"), file.at("content")});
  return output;
}

}  // namespace qvgen::pipeline
