// SPDX-License-Identifier: MIT
#include "derive/loops/gears.h"

#include <algorithm>

#include "derive/loops/solver.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {

using GiNaC::ex;
using inverse::Flat;

namespace {

/// Greatest factor of an angle that steps find.
constexpr int most_turns = 1000;

/// A factor that whole turns of its joint do not matter for.
std::optional<int> whole(const cln::cl_RA& factor) {
  if (cln::denominator(factor) != 1 || cln::abs(factor) > most_turns) return std::nullopt;
  return static_cast<int>(cln::double_approx(factor));
}

}  // namespace

ex powers_at(const Cycle& gear, const ex& leader) {
  ex sum = 0;
  for (std::size_t i = 0; i < gear.powers.size(); ++i)
    sum += GiNaC::numeric(gear.powers[i]) * GiNaC::pow(leader - gear.powers_from, static_cast<int>(i) + 2);
  return sum;
}

bool leads_by_powers(const Cycle& gear, std::size_t joint) {
  return !gear.powers.empty() && gear.gear.front().first != joint;
}

Geared solved_for(const std::vector<Cycle>& cycles, std::size_t index, std::size_t joint) {
  const auto& gear = cycles[index].gear;
  const auto own =
      std::find_if(gear.begin(), gear.end(), [&](const auto& term) { return term.first == joint; });
  Geared geared{joint, {}, 1 / own->second, index};
  for (const auto& [other, factor] : gear)
    if (other != joint) geared.sum.emplace_back(other, -factor / own->second);
  return geared;
}

std::vector<Geared> geared_by(const std::vector<Cycle>& cycles, const std::vector<std::size_t>& given) {
  std::vector<Geared> all;
  std::vector<std::size_t> known = given;
  const auto is_open = [&](const auto& term) {
    return std::find(known.begin(), known.end(), term.first) == known.end();
  };
  for (bool found = true; found;) {
    found = false;
    for (std::size_t i = 0; i < cycles.size(); ++i) {
      const auto& gear = cycles[i].gear;
      if (std::count_if(gear.begin(), gear.end(), is_open) != 1) continue;
      const std::size_t joint = std::find_if(gear.begin(), gear.end(), is_open)->first;
      if (leads_by_powers(cycles[i], joint)) continue;
      all.push_back(solved_for(cycles, i, joint));
      known.push_back(all.back().joint);
      found = true;
    }
  }
  return all;
}

symbolic::Program program_of(const Geared& geared, const model::Robot& robot,
                             const std::vector<Cycle>& cycles) {
  ex value = GiNaC::numeric(geared.constant) * cycles[geared.cycle].offset;
  const auto value_of = [&](std::size_t joint) { return symbolic::symbol(robot.joints[joint].variable); };
  for (const auto& [joint, factor] : geared.sum) value += GiNaC::numeric(factor) * value_of(joint);
  if (!cycles[geared.cycle].powers.empty())
    value += powers_at(cycles[geared.cycle], value_of(geared.sum.front().first));
  symbolic::Program program;
  program.output("value", value);
  return program;
}

Flat Solver::power(Flat base, int exponent) {
  if (exponent < 0) return power(inverse::conjugate(base), -exponent);
  Flat result{1, 0};
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = kept(result * base);
    if (exponent > 1) base = kept(base * base);
  }
  return result;
}

std::string Solver::turn_by_gear(const Cycle& cycle, const Geared& gear) {
  const std::string& variable = robot_.joints[gear.joint].variable;
  const symbolic::Vector offset = symbolic::rotate(cycle.turn, symbolic::Vector{1, 0, 0});
  const auto constant = whole(gear.constant);
  if (!constant) return no_whole_turns(variable, gear);
  Flat direction = power({scope_.clean(offset.x), scope_.clean(offset.y)}, *constant);
  for (const auto& [joint, factor] : gear.sum) {
    const auto times = whole(factor);
    if (!times || !turns(joint)) return no_whole_turns(variable, gear);
    const inverse::Scope::Turn turn = builder_.value(screw_of(joint));
    direction = kept(direction * power({turn.cosine, turn.sine}, *times));
  }
  builder_.turn_by_pair(screw_of(gear.joint), direction, "the gears of " + variable, 1);
  return "";
}

std::string Solver::slide_by_gear(const Cycle& cycle, const Geared& gear) {
  ex value = GiNaC::numeric(gear.constant) * cycle.offset;
  for (const auto& [joint, factor] : gear.sum) {
    if (turns(joint)) return no_whole_turns(robot_.joints[gear.joint].variable, gear);
    value += GiNaC::numeric(factor) * builder_.value(screw_of(joint)).cosine;
  }
  if (!cycle.powers.empty())
    value += powers_at(cycle, builder_.value(screw_of(gear.sum.front().first)).cosine);
  builder_.slide_by_value(screw_of(gear.joint), value, "the gears of " + robot_.joints[gear.joint].variable);
  return "";
}

std::string Solver::no_whole_turns(const std::string& variable, const Geared& gear) const {
  std::string leaders;
  for (const auto& [joint, factor] : gear.sum)
    leaders += (leaders.empty() ? "" : ", ") + robot_.joints[joint].variable;
  return "the value of " + variable + " depends on whole turns, or the length, of " + leaders +
         ", which loops do not tell; drive what leads";
}

std::string Solver::no_powers(const Cycle& cycle) const {
  const std::string follower = robot_.joints[cycle.gear.front().first].variable,
                    leader = robot_.joints[cycle.gear.back().first].variable;
  return "the value of " + follower + " is a polynomial of " + leader +
         ", which the steps of a loop do not take; drive " + leader;
}

std::string Solver::no_root(const Cycle& cycle) const {
  const std::string leader = robot_.joints[cycle.gear.back().first].variable;
  return "the value of " + leader + " would be a root of the polynomial by which " +
         robot_.joints[cycle.gear.front().first].variable + " follows it; drive " + leader;
}

std::string Solver::gear(const Cycle& cycle, const Geared& gear, bool is_needed) {
  std::string problem;
  if (!cycle.powers.empty() && is_needed && (turns(gear.joint) || turns(gear.sum.front().first)))
    problem = no_powers(cycle);
  else if (cycle.powers.empty() || is_needed)
    problem = turns(gear.joint) ? turn_by_gear(cycle, gear) : slide_by_gear(cycle, gear);
  if (problem.empty()) know(gear.joint);
  return problem;
}

}  // namespace qvgen::derive::loops
