// SPDX-License-Identifier: MIT
#include "cli/driven_joints.h"

#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "derive/loops/assembly_plan.h"
#include "pipeline/parallel.h"
#include "verify/loops/driven.h"

namespace qvgen::cli {
namespace {

using description::Diagnostic;
using description::ReadResult;
using Joints = std::vector<std::size_t>;

// The first letter of what the search says.
constexpr char chosen = 'c';   ///< the joints' indices
constexpr char problem = 'p';  ///< why there are none, then a line a choice

/// As the file wants it: TOML has a key, for others there is an option.
std::string line_of(const model::Mechanism& mechanism, const Joints& joints, bool is_toml) {
  std::vector<std::string> names;
  for (const std::size_t joint : joints) names.push_back(mechanism.robot.joints[joint].variable);
  const std::string line = is_toml ? fmt::format("actuated = [\"{}\"]", fmt::join(names, "\", \""))
                                   : fmt::format("--actuated {}", fmt::join(names, ","));
  return line + (derive::loops::assembly_plan(mechanism, joints).found ? "  # in closed form" : "");
}

std::string search(const model::Mechanism& mechanism, bool is_toml) {
  const verify::DrivenChoices found = verify::driven_choices(mechanism);
  if (!found.assembled)
    return problem +
           std::string(
               "the loops cannot be closed together: no joint values were found at which all of them "
               "are; correct lengths or points");
  if (found.free == 0)
    return problem + std::string("the loops leave nothing that moves; leave one of them out");
  if (found.choices.size() == 1 && found.are_all)
    return chosen + fmt::format("{}", fmt::join(found.choices.front(), " "));
  std::string text =
      problem + fmt::format("which joints have motors? The mechanism has {} freedom{}; copy one of these",
                            found.free, found.free == 1 ? "" : "s");
  for (const Joints& joints : found.choices) text += "\n  " + line_of(mechanism, joints, is_toml);
  return text + (found.are_all ? "" : "\n  ... and further ones");
}

/// Adds the first line as an error, and returns the others.
std::string report(const std::string& text, ReadResult& result) {
  Diagnostic error = result.name_place;
  error.severity = Diagnostic::error;
  const std::size_t end = text.find('\n');
  error.message = text.substr(0, end);
  result.diagnostics.push_back(error);
  return end == std::string::npos ? "" : text.substr(end + 1);
}

}  // namespace

std::string find_driven_joints(ReadResult& result) {
  if (!result.robot || result.loops.empty() || !result.loops.actuated.empty()) return "";
  const model::Mechanism mechanism = mechanism_of(result);
  const bool is_toml = std::filesystem::path(result.name_place.file).extension() == ".toml";
  const auto outcome =
      pipeline::in_processes(1, [&](std::size_t) { return search(mechanism, is_toml); }).front();
  if (!outcome.done) return report("the driven joints are not found: " + outcome.text, result);
  if (outcome.text.front() == problem) return report(outcome.text.substr(1), result);
  std::istringstream joints(outcome.text.substr(1));
  for (std::size_t joint = 0; joints >> joint;) result.loops.actuated.push_back(joint);
  return "";
}

}  // namespace qvgen::cli
