// SPDX-License-Identifier: MIT
#include "pipeline/c_files.h"

#include <fmt/format.h>

#include "emit/blocks/stack.h"
#include "emit/c/single_precision.h"

namespace qvgen::pipeline {
namespace {

std::string header_of(const std::string& robot) { return "c/qvgen_" + robot + ".h"; }
std::string source_of(const std::string& robot) { return "c/qvgen_" + robot + ".c"; }

/// The place of the line that declares a function, comments apart.
std::size_t declaration_of(const std::string& function, const std::string& header) {
  for (std::size_t at = 0; (at = header.find(" " + function + "(", at)) != std::string::npos; ++at) {
    const std::size_t line = header.rfind('\n', at) + 1;
    if (header[line] != '/') return line;
  }
  return std::string::npos;
}

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

std::vector<emit::blocks::File> blocks_of(const RobotOutput& output,
                                          const std::function<std::string(const std::string&)>& numbers) {
  std::vector<emit::blocks::File> files;
  for (const auto& [suffix, module] : {std::pair{"", ""}, {"_inverse", "inverse"}, {"_velocity", "velocity"}})
    for (const bool is_header : {true, false}) {
      const std::string name = "qvgen_" + output.robot + suffix + (is_header ? ".h" : ".c");
      for (const OutputFile& each : output.files)
        if (each.path == "c/" + name) files.push_back({name, module, is_header, numbers(each.content)});
    }
  return files;
}

std::map<std::string, int> stack_of(const RobotOutput& output, int real_bytes) {
  try {
    const auto unit = emit::blocks::parse(output.robot, blocks_of(output, emit::c::in_double_precision));
    return emit::blocks::stack_bytes(unit, real_bytes);
  } catch (const emit::blocks::NotInSubset&) {
    return {};
  }
}

void add_stack_lines(RobotOutput& output, const std::map<std::string, int>& stack) {
  for (OutputFile& file : output.files) {
    if (!file.path.ends_with(".h")) continue;
    for (const auto& [name, bytes] : stack)
      if (const std::size_t line = declaration_of(name, file.content); line != std::string::npos)
        file.content.insert(line, fmt::format("/// Stack: at most {} bytes.\n", bytes));
  }
}

}  // namespace qvgen::pipeline
