// SPDX-License-Identifier: MIT
#include "pipeline/loop_lines.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "derive/inverse/lower.h"
#include "emit/math/describe_steps.h"
#include "emit/math/lines.h"
#include "pipeline/assembly.h"
#include "pipeline/assembly_values.h"
#include "pipeline/loop_variants.h"
#include "pipeline/six_rods.h"
#include "verify/loops/driven.h"
#include "verify/loops/mobility.h"

namespace qvgen::pipeline {
namespace {

std::string names_of(const model::Mechanism& mechanism, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t joint : joints) names.push_back(mechanism.robot.joints[joint].variable);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Joints that others lead without a step, a line each.
std::vector<std::string> gear_lines(const model::Mechanism& mechanism,
                                    const derive::loops::AssemblyPlan& assembly,
                                    const std::vector<derive::loops::Geared>& gears) {
  std::vector<std::string> lines;
  for (const derive::loops::Geared& each : gears) {
    const auto& steps = assembly.plan.steps;
    if (std::any_of(steps.begin(), steps.end(), [&](const derive::inverse::Step& step) {
          return step.joint == static_cast<int>(each.joint);
        }))
      continue;
    std::vector<std::size_t> leaders;
    for (const auto& [joint, factor] : each.sum) leaders.push_back(joint);
    lines.push_back(fmt::format("{}: {}; from {}, 1 value", mechanism.robot.joints[each.joint].variable,
                                assembly.cycles[each.cycle].powers.empty() ? "gears" : "a polynomial",
                                names_of(mechanism, leaders)));
  }
  return lines;
}

/// The line of a way without a closed form: a platform on six rods has another.
std::string line_without_plan(const model::Mechanism& mechanism, const LoopVariant& variant,
                              const std::vector<std::string>& reasons) {
  const std::string from = names_of(mechanism, variant.given);
  std::string reason = fmt::format("{}", fmt::join(reasons, "; "));
  try {
    const std::string places = variant.function == "assemble" ? text_of_places(mechanism) : "";
    if (!places.empty()) return fmt::format("assemble from {}: {}", from, places);
  } catch (const std::domain_error& error) {
    reason += "; " + std::string(error.what());
  }
  const auto& joints = mechanism.robot.joints;
  const auto other = variant.function == "assemble" ? verify::motor_for_closed_form(mechanism) : std::nullopt;
  if (other)
    reason += fmt::format("; with {} driven in place of {} there is a closed form",
                          joints[other->joint].variable, joints[other->motor].variable);
  return fmt::format("no {} from {}: {}", variant.function, from, reason);
}

/// A sentence; in LaTeX it is a paragraph.
std::string sentence(const std::string& line, emit::Notation notation) {
  return notation.typeset ? emit::latex_words(line) + ".\n" : line;
}

/// The steps with their formulas, behind what these call the joints.
std::vector<std::string> steps_in_latex(const model::Mechanism& mechanism,
                                        const derive::loops::AssemblyPlan& assembly) {
  std::vector<std::string> variables, called;
  for (std::size_t i = 0; i < assembly.robot.joints.size(); ++i) {
    variables.push_back(assembly.robot.joints[i].variable);
    const std::string& described = mechanism.robot.joints[i].variable;
    if (described != variables.back())
      called.push_back(fmt::format("${}$ is {}", emit::formula(variables.back(), emit::Notation::latex),
                                   emit::latex_words(described)));
  }
  std::vector<std::string> lines;
  if (!called.empty()) lines.push_back(fmt::format("In formulas {}.\n", fmt::join(called, ", ")));
  for (const std::string& line :
       emit::describe_steps(derive::inverse::lower(assembly.plan), variables, emit::Notation::latex))
    lines.push_back(line);
  return lines;
}

/// `only_found`: a plan that is not found is not mentioned.
void add_plan(const model::Mechanism& mechanism, const LoopVariant& variant, bool steps, bool only_found,
              emit::Notation notation, LoopLines& to) {
  const derive::loops::AssemblyPlan assembly = derive::loops::assembly_plan(mechanism, variant.given);
  const std::string from = names_of(mechanism, variant.given);
  const auto say = [&](const std::string& line) { to.lines.push_back(sentence(line, notation)); };
  if (!assembly.found && only_found) return;
  if (!assembly.found) {
    say(line_without_plan(mechanism, variant, assembly.reasons));
    return;
  }
  say(fmt::format("{} from {}: {} at most", variant.function, from,
                  assembly.chains.empty() ? capacity_of(assembly, "", "") + " assemblies"
                                          : capacity_of(assembly, "the solutions of ", "")));
  for (const derive::loops::LoopChain& chain : assembly.chains)
    say(fmt::format("loop {} in space: {} by the inverse kinematics of {}", chain.cycle + 1,
                    names_of(mechanism, chain.held()), chain.chain.name));
  if (!steps) return;
  const auto say_all = [&](const std::vector<std::string>& lines) {
    for (const std::string& line : lines) say((notation.typeset ? "" : "  ") + line);
  };
  say_all(gear_lines(mechanism, assembly, assembly.geared));
  if (notation.typeset)
    for (const std::string& line : steps_in_latex(mechanism, assembly)) to.lines.push_back(line);
  else
    say_all(step_lines(mechanism.robot, assembly.plan));
  say_all(gear_lines(mechanism, assembly, assembly.led));
}

}  // namespace

LoopLines loop_lines(const model::Mechanism& mechanism, bool steps, emit::Notation notation) {
  LoopLines result;
  const verify::Mobility mobility = verify::mobility_of(mechanism);
  const std::vector<std::string> text = verify::text_of(mobility, mechanism);
  if (!mobility.assembled) {
    result.problems = text;
    return result;
  }
  for (const std::string& line : text) result.lines.push_back(sentence(line, notation));
  if (const std::string problem = problem_of_motors(mechanism, mobility); !problem.empty())
    result.problems.push_back(problem);
  for (const LoopVariant& variant : loop_variants(mechanism.loops))
    add_plan(mechanism, variant, steps, false, notation, result);
  for (const LoopVariant& variant : limb_variants(mechanism))
    add_plan(mechanism, variant, steps, true, notation, result);
  return result;
}

}  // namespace qvgen::pipeline
