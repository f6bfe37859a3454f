// SPDX-License-Identifier: MIT
#include "pipeline/translation.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "emit/c/single_precision.h"
#include "emit/javascript/module.h"
#include "emit/kernels/kernels.h"
#include "emit/octave/package.h"
#include "emit/rust/crate.h"
#include "pipeline/c_files.h"

namespace qvgen::pipeline {
namespace {

std::string content(const std::vector<emit::blocks::File>& files, const std::string& module, bool is_header) {
  const auto found = std::find_if(files.begin(), files.end(), [&](const emit::blocks::File& each) {
    return each.module == module && each.is_header == is_header;
  });
  return found == files.end() ? "" : found->text;
}

/// Returns the functions with numbers of float; none if a number has no place there, which a line says.
std::optional<emit::blocks::Unit> unit_in_single(const RobotOutput& output,
                                                 std::vector<std::string>& missing) {
  std::vector<emit::blocks::File> files;
  try {
    files = blocks_of(output, emit::c::with_single_numbers);
  } catch (const std::runtime_error& error) {
    missing.push_back(std::string("f32: ") + error.what());
    return std::nullopt;
  }
  return emit::blocks::parse(output.robot, files);
}

/// A crate in f64, and in f32 as far as the robot's numbers have a place there.
std::vector<std::pair<std::string, std::string>> crate(const RobotOutput& output,
                                                       const emit::blocks::Unit& unit,
                                                       std::vector<std::string> missing) {
  const std::optional<emit::blocks::Unit> in_single = unit_in_single(output, missing);
  return emit::rust::crate(unit, in_single, missing);
}

/// Returns C with the marks of numbers read for a language.
std::string with_numbers(Language language, const std::string& code) {
  return is_in_float(language) ? emit::c::with_single_numbers(code) : emit::c::in_double_precision(code);
}

/// Kernels of the robot's functions, and of all solutions of its poses. Those in float are printed in double,
/// with the numbers of float, and then renamed.
OutputFile kernels(const std::string& path, Language language, const emit::blocks::Unit& unit,
                   const std::vector<emit::blocks::File>& files, const std::vector<std::string>& missing) {
  const bool is_opencl = row_of(language).language == Language::opencl;
  const emit::kernels::Target target{is_opencl ? emit::kernels::Device::opencl : emit::kernels::Device::cuda,
                                     is_in_float(language)};
  const std::string text =
      emit::kernels::file(target, unit,
                          {content(files, "", true), content(files, "", false),
                           content(files, "inverse", true), content(files, "inverse", false)},
                          missing);
  return {path + (is_opencl ? ".cl" : ".cu"), target.in_float ? emit::c::in_single_precision(text) : text};
}

}  // namespace

RobotOutput translated(RobotOutput output, Language language) {
  // A folder of Octave's whose name begins with + is a package.
  const std::string mark = language == Language::octave ? "/+qvgen_" : "/qvgen_";
  const std::string folder = row_of(language).name + mark + output.robot + "/";
  try {
    const std::vector<emit::blocks::File> c =
        blocks_of(output, [&](const std::string& code) { return with_numbers(language, code); });
    const emit::blocks::Unit unit = emit::blocks::parse(output.robot, c);
    const std::vector<std::string> missing = lines_of_missing(output);
    if (is_of_devices(language)) {
      output.files = {kernels(row_of(language).name + "/qvgen_" + output.robot, language, unit, c, missing)};
      return output;
    }
    const auto files = language == Language::rust     ? crate(output, unit, missing)
                       : language == Language::octave ? emit::octave::package(unit, c, missing)
                                                      : emit::javascript::package(unit, c, missing);
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
