// SPDX-License-Identifier: MIT
#include "pipeline/translation.h"

#include "emit/javascript/module.h"
#include "emit/rust/crate.h"

namespace qvgen::pipeline {
namespace {

/// The robot's C files that are translated, headers first; each pair is a module.
std::vector<emit::blocks::File> files_of(const RobotOutput& output) {
  std::vector<emit::blocks::File> files;
  for (const auto& [suffix, module] : {std::pair{"", ""}, {"_inverse", "inverse"}, {"_velocity", "velocity"}})
    for (const bool is_header : {true, false}) {
      const std::string name = "qvgen_" + output.robot + suffix + (is_header ? ".h" : ".c");
      for (const OutputFile& each : output.files)
        if (each.path == "c/" + name) files.push_back({name, module, is_header, each.content});
    }
  return files;
}

}  // namespace

RobotOutput translated(RobotOutput output, Language language) {
  const std::string folder = row_of(language).name + "/qvgen_" + output.robot + "/";
  try {
    const emit::blocks::Unit unit = emit::blocks::parse(output.robot, files_of(output));
    const std::vector<std::string> missing = lines_of_missing(output);
    const auto files = language == Language::rust ? emit::rust::crate(unit, missing)
                                                  : emit::javascript::package(unit, missing);
    output.files.clear();
    for (const auto& [path, content] : files) output.files.push_back({folder + path, content});
  } catch (const emit::blocks::NotInSubset& error) {
    output.files.clear();
    output.missing.push_back({"model", Missing::Kind::refuted, defect_text(error.what())});
    output.counts["missing"] = missing_to_json(output.missing);
  }
  return output;
}

}  // namespace qvgen::pipeline
