// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_elimination.h"

#include <fmt/format.h>

#include "emit/cpp/inverse/entries.h"
#include "emit/cpp/inverse/setup_code.h"
#include "emit/cpp/printer.h"
#include "emit/inverse/arm.h"
#include "emit/render.h"
#include "emit/template_values.h"
#include "pipeline/products/inverse_motors.h"
#include "pipeline/products/inverse_variant.h"
#include "verify/inverse/certify_rows.h"

namespace qvgen::pipeline {
namespace {

namespace elimination = inverse::elimination;

using derive::inverse::EliminationDerivation;
using nlohmann::json;
using Rows = std::vector<std::vector<double>>;

/// Returns the values of the derivation's joints, without a heading behind them.
template <int dof>
Rows rows_of(const EliminationDerivation& derivation,
             const Solutions<dof, elimination::most_solutions>& found) {
  Rows rows;
  for (const auto& row : found) rows.emplace_back(row.q.data(), row.q.data() + derivation.joints.size());
  return rows;
}

/// Returns the arm that `dof` joints solve a pose of, one of them given where they are seven.
template <int dof>
inverse::ArmAtZero<dof> row_arm(const EliminationDerivation& derivation, const Pose<double>& pose,
                                double given) {
  const derive::inverse::Problem& problem = derivation.problem;
  if (!problem.has_heading()) return derivation.arm_at_zero<dof>();
  return elimination::with_heading(derivation.arm_at_zero<dof - 1>(),
                                   {problem.heading_joint(), problem.given}, pose, given);
}

/// Returns the setup for a pose of an arm without a given joint.
elimination::Setup setup_of(const EliminationDerivation& derivation, const Pose<double>& pose) {
  const derive::inverse::Problem& problem = derivation.problem;
  if (!derivation.is_constant)
    return set_up_first(elimination::description_of(row_arm<elimination::joints>(derivation, pose, 0)),
                        derivation.choices);
  if (!problem.has_heading()) return derivation.setup;
  return elimination::with_heading(derivation.setup, derivation.arm_at_zero<elimination::joints - 1>(),
                                   {problem.heading_joint(), problem.given}, pose);
}

/// By the functions that the generated code calls.
Rows solved(const EliminationDerivation& derivation, const Pose<double>& pose,
            const std::vector<double>& sampled) {
  constexpr inverse::Form form = inverse::Form::scalar;
  constexpr int six = elimination::joints;
  if (const int given = derivation.problem.given; given >= 0) {
    const double value = sampled[static_cast<std::size_t>(given)];
    const auto arm = row_arm<six + 1>(derivation, pose, value);
    return rows_of(derivation, elimination::solve_given(arm, given, value, derivation.choices, pose,
                                                        inverse::default_tolerance,
                                                        inverse::zero_preference<six + 1>, form));
  }
  elimination::Found found;
  elimination::solve(setup_of(derivation, pose), pose, inverse::default_tolerance,
                     inverse::zero_preference<six>, form, found);
  return rows_of(derivation, found);
}

verify::RowCertificate certify(const EliminationDerivation& derivation) {
  constexpr int poses = 5;
  const auto solver = [&](const verify::PoseInDoubles& numbers, const std::vector<double>& sampled) {
    const Pose<double> pose{Eigen::Quaterniond(numbers[0], numbers[1], numbers[2], numbers[3]),
                            Vector3<double>(numbers[4], numbers[5], numbers[6])};
    return solved(derivation, pose, sampled);
  };
  const int heading = derivation.problem.has_heading() ? derivation.problem.heading_joint() : -1;
  return verify::certify_rows(derivation.arm, {}, derivation.setup.chain.size, solver, poses, heading);
}

/// Returns the header's note on the time that a set-up takes, and on what may be missing.
std::string by_elimination(const EliminationDerivation& derivation) {
  std::string text =
      "Rows stand in the order of their joints, a row's branch is its place.\n"
      "/// Status::incomplete says that a solution may be missing: there is a reason to doubt that all have "
      "been found;\n"
      "/// near singular poses one may be missing without a word. No heap, no exceptions, bounded work.";
  if (!derivation.is_constant && derivation.problem.has_heading())
    text += "\n/// Each call works out what the inclination, the geometry and a given joint say.";
  else if (!derivation.is_constant)
    text += "\n/// What the geometry or a given joint says is worked out at every call.";
  return text;
}

std::string choices_text(const elimination::Choices& choices) {
  std::string text;
  for (int i = 0; i < choices.count; ++i)
    text +=
        fmt::format("{}{{{}, {}}}", i > 0 ? ", " : " ", choices.choice[i].backwards, choices.choice[i].shift);
  return text + " ";
}

json variant(const model::Robot& described, const EliminationDerivation& derivation) {
  const std::vector<std::string> mechanism = describe_elimination(derivation);
  json values = variant_names(described, derivation.problem);
  const auto setup =
      derivation.is_constant ? emit::setup_lines(derivation.setup) : std::vector<std::string>();
  values.update(json{{"elimination", true},
                     {"by_elimination", by_elimination(derivation)},
                     {"constant", derivation.is_constant},
                     {"heading", derivation.problem.has_heading()},
                     {"setup", emit::lines_of(setup)},
                     {"choice_count", derivation.choices.count},
                     {"choices", choices_text(derivation.choices)},
                     {"capacity", elimination::most_solutions},
                     {"structure", mechanism.front()},
                     {"summary", emit::lines_of({mechanism.begin() + 1, mechanism.end()})},
                     {"certificate", certify(derivation).text()},
                     {"stable_branches", "false"},
                     {"has_lanes", "false"},
                     {"counts_roots", false},
                     {"lanes", false},
                     {"most_of_rows", false},
                     {"most_of_reaching", false},
                     {"seed_branch", json::object()}});
  emit::add_entries(described, derivation.problem, values);
  return values;
}

}  // namespace

void add_eliminations(const model::Robot& robot, const InverseDerivation& derived, RobotOutput& output) {
  const model::Robot& described = derived.arm;
  json values{{"name", described.name},
              {"variants", json::array()},
              {"arm", emit::arm_values(described, emit::cpp())}};
  nlohmann::ordered_json targets;
  for (const EliminationDerivation& derivation : derived.eliminations) {
    values["variants"].push_back(variant(described, derivation));
    add_targets(derivation.problem, values["variants"].back(), targets);
  }
  conclude_variants(values);
  add_motors(derived.coupled, values);
  add_outer_joints(robot, derived.outer, emit::cpp(), values);
  output.files.push_back(
      {"include/qvgen/robots/" + described.name + "/inverse.h", emit::render("cpp/inverse.h", values)});
  output.files.push_back(
      {"source/" + described.name + "/inverse.cpp", emit::render("cpp/inverse_elimination.cpp", values)});
  output.counts["targets"] = targets;
  take_outer_names(values, output.counts);
}

}  // namespace qvgen::pipeline
