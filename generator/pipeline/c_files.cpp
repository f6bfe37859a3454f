// SPDX-License-Identifier: MIT
#include "pipeline/c_files.h"

namespace qvgen::pipeline {
namespace {

std::string header_of(const std::string& robot) { return "c/qvgen_" + robot + ".h"; }
std::string source_of(const std::string& robot) { return "c/qvgen_" + robot + ".c"; }

}  // namespace

void add_c_part(RobotOutput& output, const emit::c::Part& part) {
  output.files.push_back({header_of(output.robot), part.header});
  output.files.push_back({source_of(output.robot), part.source});
}

void add_c_files(RobotOutput& output, const std::string& name, const emit::c::Part& part) {
  const std::string file = "c/qvgen_" + output.robot + "_" + name;
  output.files.push_back({file + ".h", part.header});
  output.files.push_back({file + ".c", part.source});
}

RobotOutput with_c_files(RobotOutput output) {
  emit::c::Part all;
  std::vector<OutputFile> others;
  for (const OutputFile& file : output.files) {
    if (file.path == header_of(output.robot))
      all += {file.content, ""};
    else if (file.path == source_of(output.robot))
      all += {"", file.content};
    else
      others.push_back(file);
  }
  const emit::c::Part text = emit::c::file(output.robot, all, lines_of_missing(output));
  output.files = {{header_of(output.robot), text.header}, {source_of(output.robot), text.source}};
  output.files.insert(output.files.end(), others.begin(), others.end());
  return output;
}

}  // namespace qvgen::pipeline
