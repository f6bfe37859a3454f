// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_motors.h"

#include <algorithm>
#include <optional>

namespace qvgen::description::xml {
namespace {

/// More tendons that have joints in common than any hand has; solving them takes the third power of time.
constexpr std::size_t most_tendons = 32;

/// An equation: joints on one side, lengths and other joints on the other.
struct Equation {
  JointSum unknown, known;
};

void add(JointSum& sum, const cln::cl_RA& factor, const JointSum& other) {
  for (const auto& [name, share] : other) {
    const cln::cl_RA total = sum[name] + factor * share;
    if (cln::zerop(total))
      sum.erase(name);
    else
      sum[name] = total;
  }
}

void multiply(JointSum& sum, const cln::cl_RA& factor) {
  for (auto& [name, share] : sum) share = share * factor;
}

/// Solves each equation for a joint, in terms of what is known and of joints that none is solved for; nothing
/// if the equations depend on one another.
std::optional<std::map<std::string, JointSum>> solved(std::vector<Equation> equations) {
  for (std::size_t k = 0; k < equations.size(); ++k) {
    if (equations[k].unknown.empty()) return std::nullopt;
    const auto [joint, factor] = *equations[k].unknown.begin();
    multiply(equations[k].unknown, 1 / factor);
    multiply(equations[k].known, 1 / factor);
    for (std::size_t i = 0; i < equations.size(); ++i) {
      const auto share = equations[i].unknown.find(joint);
      if (i == k || share == equations[i].unknown.end()) continue;
      const cln::cl_RA by = -share->second;
      add(equations[i].unknown, by, equations[k].unknown);
      add(equations[i].known, by, equations[k].known);
    }
  }
  std::map<std::string, JointSum> relations;
  for (Equation& equation : equations) {
    const std::string joint = equation.unknown.begin()->first;
    equation.unknown.erase(joint);
    add(equation.known, -1, equation.unknown);
    relations[joint] = equation.known;
  }
  return relations;
}

Equation equation_of(const std::string& tendon, const JointSum& length, const std::set<std::string>& driven) {
  Equation equation{{}, {{tendon, 1}}};
  for (const auto& [joint, factor] : length) {
    const bool is_known = driven.count(joint) > 0;
    add(is_known ? equation.known : equation.unknown, is_known ? -factor : factor, {{joint, 1}});
  }
  return equation;
}

std::map<std::string, JointSum> relations_of(const TendonGroup& group,
                                             const std::map<std::string, JointSum>& lengths,
                                             const std::set<std::string>& driven, bool beside_loops) {
  const auto unknown = std::count_if(group.joints.begin(), group.joints.end(),
                                     [&](const std::string& joint) { return driven.count(joint) == 0; });
  const auto lacking = unknown - static_cast<long>(group.tendons.size());
  if (group.tendons.size() > most_tendons || lacking < 0 || (lacking > 0 && !beside_loops)) return {};
  std::vector<Equation> equations;
  for (const std::string& tendon : group.tendons)
    equations.push_back(equation_of(tendon, lengths.at(tendon), driven));
  return solved(std::move(equations)).value_or(std::map<std::string, JointSum>{});
}

/// Puts a tendon with the groups with which it shares joints, which become one.
void join(std::vector<TendonGroup>& groups, const std::string& tendon, const JointSum& length) {
  TendonGroup joined{{tendon}, {}, {}};
  for (const auto& [joint, factor] : length) joined.joints.insert(joint);
  const std::set<std::string> own = joined.joints;
  const auto shares = [&](const TendonGroup& group) {
    return std::any_of(own.begin(), own.end(),
                       [&](const std::string& joint) { return group.joints.count(joint) > 0; });
  };
  for (const TendonGroup& group : groups) {
    if (!shares(group)) continue;
    joined.tendons.insert(joined.tendons.end(), group.tendons.begin(), group.tendons.end());
    joined.joints.insert(group.joints.begin(), group.joints.end());
  }
  std::erase_if(groups, shares);
  groups.push_back(std::move(joined));
}

}  // namespace

std::vector<TendonGroup> tendon_groups(const std::map<std::string, JointSum>& lengths,
                                       const std::set<std::string>& driven, bool beside_loops) {
  std::vector<TendonGroup> groups;
  for (const auto& [tendon, length] : lengths) join(groups, tendon, length);
  for (TendonGroup& group : groups) {
    std::sort(group.tendons.begin(), group.tendons.end());
    group.relations = relations_of(group, lengths, driven, beside_loops);
  }
  return groups;
}

std::map<std::string, const Element*> actuators_of(const Element& root, const std::string& key) {
  std::map<std::string, const Element*> actuators;
  for (const Element& section : root.children)
    if (section.name == "actuator")
      for (const Element& actuator : section.children)
        if (const Attribute* target = actuator.attribute(key))
          actuators.try_emplace(target->value, &actuator);
  return actuators;
}

}  // namespace qvgen::description::xml
