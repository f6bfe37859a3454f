// SPDX-License-Identifier: MIT
#include "derive/loops/assembly_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "derive/inverse/names.h"
#include "derive/inverse/schedule.h"
#include "derive/loops/hoist.h"
#include "derive/loops/in_space.h"
#include "derive/loops/named_angles.h"
#include "derive/loops/size.h"
#include "derive/loops/solver.h"
#include "model/private_names.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {
namespace {

using GiNaC::ex;
using inverse::Plan;
using symbolic::dot;
namespace names = inverse::names;

std::vector<std::size_t> others(std::size_t count, const std::vector<std::size_t>& joints) {
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < count; ++i)
    if (std::find(joints.begin(), joints.end(), i) == joints.end()) rest.push_back(i);
  return rest;
}

/// The names of a joint's value.
inverse::JointValue value_of(const model::Joint& joint) {
  if (joint.type == model::JointType::prismatic) return {false, joint.variable, ""};
  return {true, names::cosine(joint.variable), names::sine(joint.variable)};
}

/// Puts the values of a given joint into the plan's target, under the names that steps read.
void give(Plan& plan, inverse::Scope& scope, const model::Robot& robot, std::size_t joint) {
  const std::string& variable = robot.joints[joint].variable;
  plan.joints[joint] = value_of(robot.joints[joint]);
  if (!plan.joints[joint].revolute) return plan.target.output(variable, scope.length(variable));
  const inverse::Scope::Turn turn = scope.turn(variable);
  plan.target.output(names::cosine(variable), turn.cosine);
  plan.target.output(names::sine(variable), turn.sine);
}

/// Names of joints as the description has them, in a text of the derivation.
std::string with_described_names(std::string text, const model::Robot& robot,
                                 const std::vector<std::string>& described) {
  // From the last one on: joint12 before joint1.
  for (std::size_t i = described.size(); i-- > 0;) {
    const std::string& name = robot.joints[i].variable;
    if (name == described[i]) continue;
    for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + described[i].size()))
      text.replace(at, name.size(), described[i]);
  }
  return text;
}

/// Solves closures as long as one of them serves.
class Search {
 public:
  Search(const model::Mechanism& mechanism, AssemblyPlan& assembly, const std::vector<std::string>& described,
         inverse::Scope& scope, inverse::Builder& builder)
      : mechanism_(mechanism),
        assembly_(assembly),
        described_(described),
        solver_(assembly.robot, scope, builder),
        scope_(scope) {
    for (const std::size_t joint : assembly.known()) solver_.know(joint);
  }

  void run() {
    for (std::size_t i = 0; i < assembly_.cycles.size(); ++i) open_.push_back(i);
    for (const LoopChain& chain : assembly_.chains) close({chain.cycle}, assembly_.used);
    for (const Geared& geared : assembly_.geared) close({geared.cycle}, assembly_.used);
    while (step()) {
    }
    for (const std::size_t i : open_) add_reason(why_open(i), i);
    for (const std::size_t joint : assembly_.passive)
      if (equations_with(assembly_.cycles, joint) == 0)
        assembly_.reasons.push_back("joint " + described_[joint] +
                                    " is on no loop and is not driven; name it in `actuated`");
    assembly_.found = assembly_.reasons.empty();
  }

 private:
  [[nodiscard]] const Cycle& cycle(std::size_t i) const { return assembly_.cycles[i]; }
  [[nodiscard]] std::size_t unknowns(std::size_t i) const { return solver_.unknown(cycle(i)).size(); }

  /// A reason that another loop has, too, is said once.
  void add_reason(const std::string& reason, std::size_t loop) {
    const auto tail = [](const std::string& text) { return text.substr(text.find(": ") + 1); };
    for (std::string& other : assembly_.reasons) {
      if (tail(other).rfind(tail(reason), 0) != 0) continue;
      other += " (loop " + std::to_string(loop + 1) + " likewise)";
      return;
    }
    assembly_.reasons.push_back(reason);
  }

  void close(const std::vector<std::size_t>& solved, std::vector<std::size_t>& into) {
    for (const std::size_t i : solved) {
      into.push_back(i);
      std::erase(open_, i);
    }
  }

  /// True if a closure was solved, or found to hold nothing more.
  bool step() {
    for (const std::size_t i : open_) {
      if (unknowns(i) == 0) {
        if (is_gear(i)) return refuse(names_in(cycle(i).joints()) + " have values, and gears tie them");
        close({i}, assembly_.redundant);
        return true;
      }
    }
    for (const std::size_t i : open_) {
      if (!serves(i)) continue;
      const std::string problem = is_gear(i) ? lead(i) : solve(cycle(i));
      if (!problem.empty()) return refuse(problem);
      close({i}, assembly_.used);
      return true;
    }
    return coupled() || platform() || swinging_legs();
  }

  /// Notes why there is no closed form, with the description's names.
  bool refuse(const std::string& reason) {
    assembly_.reasons.push_back(with_described_names(reason, assembly_.robot, described_));
    return false;
  }

  [[nodiscard]] bool is_gear(std::size_t i) const { return cycle(i).type == model::LoopType::gear; }

  /// Finds the one open joint of a gear; returns why that is not possible.
  std::string lead(std::size_t i) {
    const std::size_t open = solver_.unknown(cycle(i)).front();
    if (leads_by_powers(cycle(i), open)) return solver_.no_root(cycle(i));
    const Geared geared = solved_for(assembly_.cycles, i, open);
    const bool is_needed = equations_with(assembly_.cycles, open) > 1;
    const std::string problem = solver_.gear(cycle(i), geared, is_needed);
    if (!cycle(i).powers.empty() && !is_needed)
      assembly_.plan.joints[open] = value_of(assembly_.robot.joints[open]);
    if (problem.empty()) assembly_.led.push_back(geared);
    return problem;
  }

  /// An open closure as a distance, if it is one.
  [[nodiscard]] std::optional<Solver::Span> span_of(std::size_t i) const {
    if (is_gear(i) || !solver_.knows_length(cycle(i))) return std::nullopt;
    if (cycle(i).type == model::LoopType::rod) return Solver::Span{&cycle(i), {}};
    const bool is_point = cycle(i).directions.empty();
    if (!is_point || !cycle(i).normal || !gap_along_normal(i).empty()) return std::nullopt;
    for (const std::size_t joint : solver_.unknown(cycle(i)))
      if (turns(joint) && holders(joint) == 1) return Solver::Span{&cycle(i), joint};
    return std::nullopt;
  }
  [[nodiscard]] bool turns(std::size_t joint) const {
    return assembly_.robot.joints[joint].type == model::JointType::revolute;
  }
  /// How many open closures hold a joint.
  [[nodiscard]] std::ptrdiff_t holders(std::size_t joint) const {
    return std::count_if(open_.begin(), open_.end(), [&](std::size_t i) {
      const std::vector<std::size_t> joints = solver_.unknown(cycle(i));
      return std::find(joints.begin(), joints.end(), joint) != joints.end();
    });
  }

  /// True if no other open closure holds the same joints.
  [[nodiscard]] bool is_alone(std::size_t i) const {
    return std::count_if(open_.begin(), open_.end(), [&](std::size_t other) {
             return solver_.unknown(cycle(other)) == solver_.unknown(cycle(i));
           }) == 1;
  }

  /// True if several distances that hold the same joints were solved together.
  bool coupled() {
    for (const std::size_t i : open_) {
      const auto first = span_of(i);
      if (!first) continue;
      const std::vector<std::size_t> joints = solver_.held(*first);
      const auto turning =
          std::count_if(joints.begin(), joints.end(), [&](std::size_t j) { return turns(j); });
      const bool is_pair = joints.size() == 2 && turning == 2,
                 is_platform = joints.size() == 3 && turning == 1;
      if (!is_pair && !is_platform) continue;
      std::vector<std::size_t> group;
      std::vector<Solver::Span> spans;
      for (const std::size_t k : open_) {
        const auto span = span_of(k);
        if (!span || solver_.held(*span) != joints || spans.size() == joints.size()) continue;
        group.push_back(k);
        spans.push_back(*span);
      }
      if (spans.size() < joints.size()) continue;
      const std::string problem = is_pair ? solver_.two_turns({spans[0], spans[1]})
                                          : solver_.planar_platform({spans[0], spans[1], spans[2]});
      if (!problem.empty()) return refuse(problem);
      close(group, assembly_.used);
      return true;
    }
    return false;
  }

  [[nodiscard]] bool serves(std::size_t i) const {
    if (unknowns(i) != rows_of(cycle(i))) return false;
    return is_gear(i) || cycle(i).type == model::LoopType::rod ||
           (cycle(i).normal && gap_along_normal(i).empty());
  }

  [[nodiscard]] std::string solve(const Cycle& cycle) {
    switch (cycle.type) {
      case model::LoopType::rod:
        return solver_.rod(cycle);
      case model::LoopType::weld:
        return solver_.weld(cycle);
      case model::LoopType::slide:
        return solver_.slide(cycle);
      case model::LoopType::pin:
      case model::LoopType::ball:
      case model::LoopType::gear:
        break;
    }
    return solver_.meeting(cycle);
  }

  /// True if three rods hold the same three slides.
  bool platform() {
    std::vector<std::size_t> group;
    for (const std::size_t i : open_) {
      const std::vector<std::size_t> joints = solver_.unknown(cycle(i));
      const bool slides = std::none_of(joints.begin(), joints.end(), [&](auto j) { return turns(j); });
      if (cycle(i).type != model::LoopType::rod || joints.size() != 3 || !slides ||
          !solver_.knows_length(cycle(i)))
        continue;
      if (group.empty() || joints == solver_.unknown(cycle(group.front()))) group.push_back(i);
      if (group.size() == 3) break;
    }
    if (group.size() != 3) return false;
    const std::string problem = solver_.three_spheres({&cycle(group[0]), &cycle(group[1]), &cycle(group[2])});
    if (!problem.empty()) return refuse(problem);
    close(group, assembly_.used);
    return true;
  }

  /// True if three legs that swing in planes hold the same joints of a platform.
  bool swinging_legs() {
    std::vector<std::size_t> group;
    std::vector<Solver::Swing> swings;
    for (const std::size_t i : open_) {
      const auto swing = solver_.swing_of(cycle(i));
      if (!swing || swings.size() == 3) continue;
      if (std::any_of(swing->leg.begin(), swing->leg.end(), [&](std::size_t j) { return holders(j) > 1; }))
        continue;
      if (!swings.empty() && swing->held != swings.front().held) continue;
      group.push_back(i);
      swings.push_back(*swing);
    }
    if (swings.size() < 3) return false;
    const std::string problem = solver_.three_planes({swings[0], swings[1], swings[2]});
    if (!problem.empty()) return refuse(problem);
    close(group, assembly_.used);
    return true;
  }

  /// Why a planar loop does not close: its ends are in different planes.
  [[nodiscard]] std::string gap_along_normal(std::size_t i) const {
    const Cycle& of = cycle(i);
    const Carrier at_zero{assembly_.robot, [&](std::size_t joint) {
                            const bool turns =
                                assembly_.robot.joints[joint].type == model::JointType::revolute;
                            return inverse::Scope::Turn{turns ? 1 : 0, 0};
                          }};
    const ex gap = dot(*of.normal, at_zero.end(of.sides[0], -1) - at_zero.end(of.sides[1], -1));
    // Points that rounded turns have placed miss each other by 40 digits.
    constexpr double rounded = 1e-30;
    if (scope_.is_zero(gap) || std::abs(scope_.sample(gap)) < rounded) return "";
    return "loop " + std::to_string(of.number) +
           " never closes: its ends move in parallel planes that do not meet; correct `at` or an origin";
  }

  [[nodiscard]] std::string names_in(const std::vector<std::size_t>& joints) const {
    std::string text;
    for (const std::size_t joint : joints) text += (text.empty() ? "" : ", ") + described_[joint];
    return text;
  }
  [[nodiscard]] std::string unknown_names(std::size_t i) const { return names_in(solver_.unknown(cycle(i))); }

  [[nodiscard]] std::string why_open(std::size_t i) const {
    const std::string head = "loop " + std::to_string(cycle(i).number) + " has no closed form: ";
    const std::size_t count = unknowns(i);
    if (is_gear(i))
      return "joints that follow each other have no closed form here: " + unknown_names(i) +
             " are open; drive the one that leads";
    if (cycle(i).type == model::LoopType::rod)
      return head + "its rod places one joint, and " + unknown_names(i) + " are open; " +
             (is_alone(i) ? "drive all but one of them"
                          : "rods that hold the same joints are solved together if two hold two turns, or "
                            "three hold three slides at right angles or, in a plane, two slides and a turn; "
                            "else drive some of these joints in place of motors, or name them in `outputs`");
    if (is_rigid_in_space(cycle(i))) {
      const std::string reason = chain_of(mechanism_, cycle(i), known()).reason;
      return head + (reason.empty()
                         ? "in space it is derived from the driven joints and from the outputs alone"
                         : reason);
    }
    if (!cycle(i).normal)
      return head +
             "its axes are not all parallel; in space, write rods in place of links with balls at both ends";
    if (const std::string gap = gap_along_normal(i); !gap.empty()) return gap;
    const std::string equations = rows_of(cycle(i)) == 2 ? "two" : "three";
    if (count < rows_of(cycle(i)))
      return head + "it has " + equations + " equations, and only " + unknown_names(i) +
             " is open; drive fewer joints of it, write a link between two pins as a rod, or leave the loop "
             "out";
    return head + "its " + (cycle(i).directions.empty() ? "point" : "links") + " place" +
           (cycle(i).directions.empty() ? "s " : " ") + equations + " joints, and " + unknown_names(i) +
           " are open; drive all but " + equations + " of them, or close the loops that hold them one by one";
  }

  /// Joints that have values by now.
  [[nodiscard]] std::vector<std::size_t> known() const {
    std::vector<std::size_t> all(assembly_.robot.joints.size()), open;
    std::iota(all.begin(), all.end(), 0);
    for (const Cycle& each : assembly_.cycles)
      for (const std::size_t joint : solver_.unknown(each)) open.push_back(joint);
    std::erase_if(all, [&](auto j) { return std::find(open.begin(), open.end(), j) != open.end(); });
    return all;
  }

  const model::Mechanism& mechanism_;
  AssemblyPlan& assembly_;
  const std::vector<std::string>& described_;
  Solver solver_;
  const inverse::Scope& scope_;
  std::vector<std::size_t> open_;
};

/// Places in a row, the number of branches, and what steps leave for later ones.
void conclude(AssemblyPlan& assembly, const std::vector<std::string>& described) {
  Plan& plan = assembly.plan;
  for (std::size_t i = 0; i < assembly.robot.joints.size(); ++i) plan.places.push_back(static_cast<int>(i));
  plan.row_size = static_cast<int>(assembly.robot.joints.size());
  plan.capacity = 1;
  for (const inverse::Step& step : plan.steps) plan.capacity *= step.branches;
  for (inverse::Step& step : plan.steps) {
    step.equation = with_described_names(step.equation, assembly.robot, described);
    step.degenerate = with_described_names(step.degenerate, assembly.robot, described);
  }
  plan.structure = "closed loops, one after the other";
  hoist(plan);
  inverse::prune(plan);
}

}  // namespace

std::vector<std::size_t> AssemblyPlan::told() const {
  std::vector<std::size_t> joints = given;
  for (const Geared& each : geared) joints.push_back(each.joint);
  return joints;
}

std::vector<std::size_t> AssemblyPlan::known() const {
  std::vector<std::size_t> joints = told();
  for (const LoopChain& each : chains)
    for (const std::size_t joint : each.held()) joints.push_back(joint);
  return joints;
}

std::vector<std::size_t> AssemblyPlan::held_by(std::size_t cycle) const {
  for (const LoopChain& each : chains)
    if (each.cycle == cycle) return each.held();
  return {};
}

AssemblyPlan assembly_plan(const model::Mechanism& mechanism, const std::vector<std::size_t>& given) {
  AssemblyPlan assembly;
  assembly.robot = with_named_angles(model::with_private_names(mechanism.robot));
  assembly.given = given;
  assembly.passive = others(mechanism.robot.joints.size(), given);
  std::vector<std::string> described;
  for (const model::Joint& joint : mechanism.robot.joints) described.push_back(joint.variable);
  inverse::Scope scope = scope_of(assembly.robot, mechanism.loops);
  assembly.cycles = cycles_of(mechanism, assembly.robot, scope);
  assembly.geared = geared_by(assembly.cycles, given);
  assembly.chains = chains_of(mechanism, assembly.cycles, given);
  inverse::Builder builder(assembly.robot, scope, assembly.plan);
  for (const std::size_t joint : assembly.known()) give(assembly.plan, scope, assembly.robot, joint);
  scope.rename(assembly.plan.target, names::size_square, size_square(assembly));
  Search(mechanism, assembly, described, scope, builder).run();
  if (assembly.found) conclude(assembly, described);
  return assembly;
}

}  // namespace qvgen::derive::loops
