// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>

#include "derive/dynamics/followers.h"
#include "derive/dynamics/inward_recursion.h"
#include "model/coordinates.h"

namespace qvgen::derive::dynamics {
namespace {

class CompositeBodies {
 public:
  CompositeBodies(const model::Robot& robot, const FormulationOptions& choices, Formulation& out)
      : robot_(robot),
        graph_(out.function.graph),
        suggest_(out.function),
        p_(parametrise(robot, choices.convention, graph_)),
        inward_(p_, graph_, suggest_) {
    out.constants = p_.constants;
  }

  void run(dag::Function& out) {
    // Sums over the links that each link carries, in its frame.
    std::vector<PseudoInertia> behind(p_.chain.links.size());
    std::vector<std::vector<Column>> columns(p_.chain.links.size());
    for (std::size_t j = p_.chain.links.size(); j-- > 0;) {
      const Link& link = p_.chain.links[j];
      const PseudoInertia composite = link.inertia + behind[j];
      const std::vector<Way> ways = ways_of(link);
      for (const Way& way : ways) columns[j].push_back(column_of(way, composite));
      for (Column& column : columns[j]) {
        for (const Way& way : ways)
          if (way.coordinate <= column.coordinate)
            entries_[{way.coordinate, column.coordinate}] = entry_of(link, way, column);
        if (link.parent == no_link) continue;
        inward_.transform_to_parent(j, column);
        columns[link.parent].push_back(column);
      }
      if (link.parent != no_link)
        behind[link.parent] = behind[link.parent] + inward_.transform_to_parent(j, composite);
    }
    // Joints that do not carry one another do not feel one another.
    const std::size_t base = model::base_motions(robot_), size = base + robot_.joints.size();
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = i; k < size; ++k) entries_.try_emplace({i, k});
    Entries gathered = gathered_symmetric(robot_, entries_, graph_);
    for (const MotorDrive& motor : p_.chain.motors) {
      Scalar& inertia = gathered[{base + motor.driven, base + motor.driven}];
      inertia = inertia + motor.rotor;
    }
    for (const auto& [place, value] : gathered)
      out.outputs.push_back(
          {"m" + std::to_string(place.first + 1) + "_" + std::to_string(place.second + 1), value.in(graph_)});
  }

 private:
  Scalar entry_of(const Link& link, const Way& way, const Column& column) const {
    const Scalar value = entry(p_, way, column);
    return way.coordinate == column.coordinate ? value + link.rotor : value;
  }

  const model::Robot& robot_;
  dag::Graph& graph_;
  Suggestions suggest_;
  Parametrisation p_;
  InwardRecursion inward_;
  Entries entries_;
};

}  // namespace

Formulation mass_matrix(const model::Robot& robot, const FormulationOptions& choices) {
  Formulation result;
  CompositeBodies(robot, choices, result).run(result.function);
  return result;
}

Formulation momentum_matrix(const model::Robot& robot, const FormulationOptions& choices) {
  Formulation result = mass_matrix(robot, choices);
  std::vector<dag::Output>& outputs = result.function.outputs;
  std::map<std::string, dag::Edge> entries;
  for (const dag::Output& output : outputs) entries.emplace(output.name, output.value);
  std::erase_if(outputs, [](const dag::Output& output) { return output.name.front() != '?'; });
  std::vector<dag::Output> rows;
  for (std::size_t i = 1; i <= model::base_motions(robot); ++i)
    for (std::size_t k = 1; k <= model::coordinate_count(robot); ++k) {
      const auto number = [](std::size_t a, std::size_t b) {
        return std::to_string(a) + "_" + std::to_string(b);
      };
      rows.push_back({"h" + number(i, k), entries.at("m" + number(std::min(i, k), std::max(i, k)))});
    }
  outputs.insert(outputs.begin(), rows.begin(), rows.end());
  return result;
}

}  // namespace qvgen::derive::dynamics
