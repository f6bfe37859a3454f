// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/commands.h"
#include "pipeline/pipeline.h"
#include "pipeline/products/inverse_derivation.h"

namespace qvgen::cli {
namespace {

using namespace pipeline;

/// Returns all that can be said of a robot without deriving everything.
RobotOutput outlook(const model::Robot& robot) {
  RobotOutput output{robot.name};
  attempt("inverse", output, [&](RobotOutput& made) {
    const InverseDerivation derivation = derive_inverse(robot);
    if (derivation.found()) return;
    for (const std::string& reason : derivation.reasons)
      made.missing.push_back({"inverse", Missing::Kind::not_derived, reason});
  });
  return output;
}

std::vector<RobotOutput> outlooks(const std::vector<model::Robot>& robots) {
  const auto work = [&](std::size_t i) { return to_text(outlook(robots[i])); };
  const std::vector<Outcome> outcomes = in_processes(robots.size(), work);
  std::vector<RobotOutput> outputs;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    outputs.push_back({robots[i].name});
    if (outcomes[i].done)
      outputs.back() = robot_output_from_text(outcomes[i].text);
    else
      outputs.back().missing.push_back({"inverse", Missing::Kind::not_finished, outcomes[i].text});
  }
  return outputs;
}

/// Says what `generate` will leave out of a robot. Returns false if a certificate has failed.
bool report_missing(const description::Diagnostic& place, const RobotOutput& output) {
  bool good = true;
  for (const Missing& missing : output.missing) {
    if (missing.kind == Missing::Kind::not_described) continue;
    description::Diagnostic note = place;
    note.severity = missing.kind == Missing::Kind::refuted ? description::Diagnostic::error
                                                           : description::Diagnostic::note;
    note.message = "no " + missing.part + ": " + missing.reason;
    note.hint.clear();
    fmt::print(stderr, "{}\n", description::to_string(note));
    good = good && missing.kind != Missing::Kind::refuted;
  }
  return good;
}

}  // namespace

int run_check(const std::vector<std::filesystem::path>& descriptions, const description::ReadOptions& options,
              bool thorough) {
  const auto results = read_descriptions(descriptions, options);
  if (!results) return bad_description;
  std::vector<model::Robot> robots;
  for (const auto& result : *results) robots.push_back(*result.robot);
  const std::vector<RobotOutput> outputs = thorough ? generate(robots, {}) : outlooks(robots);
  bool good = true;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    good = report_missing((*results)[i].name_place, outputs[i]) && good;
    std::string structure;
    for (const model::Joint& joint : robots[i].joints)
      structure += joint.type == model::JointType::revolute ? 'R' : 'P';
    fmt::print("{}: {} ({}), {} geometric parameters\n", robots[i].name, robots[i].title, structure,
               robots[i].geometry.size());
  }
  return good ? success : failure;
}

}  // namespace qvgen::cli
