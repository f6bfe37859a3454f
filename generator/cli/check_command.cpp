// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/verdict.h"
#include "pipeline/assembly.h"
#include "pipeline/limbs.h"
#include "pipeline/loop_lines.h"
#include "pipeline/pipeline.h"
#include "pipeline/products/inverse_derivation.h"

namespace qvgen::cli {
namespace {

using namespace pipeline;

/// Returns all that can be said of a robot without deriving everything.
RobotOutput outlook(const model::Robot& robot) {
  RobotOutput output{robot.name};
  if (!model::is_chain(robot)) return output;
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

/// Says what `generate` will leave out of a robot.
ExitCode report_missing(const description::Diagnostic& place, const RobotOutput& output) {
  for (const Missing& missing : output.missing) {
    if (missing.kind == Missing::Kind::not_described) continue;
    description::Diagnostic note = place;
    note.severity = missing.kind == Missing::Kind::refuted ? description::Diagnostic::error
                                                           : description::Diagnostic::note;
    note.message = "no " + missing.part + ": " + missing.reason;
    note.hint.clear();
    fmt::print(stderr, "{}\n", description::to_string(note));
  }
  return verdict_of(output.missing);
}

std::string letters_of(const model::Robot& robot) {
  std::string letters;
  for (const model::Joint& joint : robot.joints)
    letters += joint.type == model::JointType::revolute ? 'R' : 'P';
  return letters;
}

/// A robot to check, with its place in the file that has it; a limb is one as well.
struct Checked {
  description::Diagnostic place;
  model::Robot robot;
};

std::vector<Checked> all_of(const std::vector<description::ReadResult>& results) {
  std::vector<Checked> all;
  for (const description::ReadResult& result : results) {
    const model::Mechanism mechanism = mechanism_of(result);
    all.push_back({result.name_place, mechanism.robot});
    for (const model::Robot& limb : limbs_of(mechanism)) all.push_back({result.name_place, limb});
    for (const ChainRobot& chain : chain_robots(mechanism))
      if (chain.part == "inverse") all.push_back({result.name_place, chain.robot});
  }
  return all;
}

/// Prints freedoms and closed forms of loops; what is wrong with them is an error at the robot's place.
ExitCode check_loops(const description::Diagnostic& place, const model::Mechanism& mechanism) {
  const auto work = [&] {
    const LoopLines loops = loop_lines(mechanism, false);
    for (const std::string& line : loops.lines) fmt::print("{}: {}\n", mechanism.robot.name, line);
    for (const std::string& problem : loops.problems) {
      description::Diagnostic error = place;
      error.severity = description::Diagnostic::error;
      error.message = problem;
      error.hint.clear();
      fmt::print(stderr, "{}\n", description::to_string(error));
    }
    std::fflush(stdout);
    return static_cast<int>(loops.problems.empty() ? success : bad_description);
  };
  return static_cast<ExitCode>(bounded("check " + mechanism.robot.name, {}, work));
}

}  // namespace

int run_check(const std::vector<std::filesystem::path>& descriptions, const description::ReadOptions& options,
              bool thorough) {
  const auto results = read_descriptions(descriptions, options);
  if (!results) return bad_description;
  const std::vector<Checked> checked = all_of(*results);
  std::vector<model::Robot> robots;
  for (const Checked& each : checked) robots.push_back(each.robot);
  const std::vector<RobotOutput> outputs = thorough ? generate(robots, {}) : outlooks(robots);
  ExitCode verdict = success;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    verdict = worse(verdict, report_missing(checked[i].place, outputs[i]));
    fmt::print("{}: {} ({}), {} geometric parameters\n", robots[i].name, robots[i].title,
               letters_of(robots[i]), robots[i].geometry.size());
  }
  std::fflush(stdout);
  for (const description::ReadResult& result : *results)
    if (!result.loops.empty()) verdict = worse(verdict, check_loops(result.name_place, mechanism_of(result)));
  return verdict;
}

}  // namespace qvgen::cli
