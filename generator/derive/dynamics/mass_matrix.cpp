// SPDX-License-Identifier: MIT
#include "derive/dynamics/followers.h"
#include "derive/dynamics/inward_recursion.h"

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
      if (link.motion != Motion::none) columns[j].push_back(column_of(link, composite));
      for (Column& column : columns[j]) {
        if (link.motion != Motion::none) entries_[{link.joint, column.joint}] = entry_of(link, column);
        if (link.parent == no_link) continue;
        inward_.transform_to_parent(j, column);
        columns[link.parent].push_back(column);
      }
      if (link.parent != no_link)
        behind[link.parent] = behind[link.parent] + inward_.transform_to_parent(j, composite);
    }
    // Joints that do not carry one another do not feel one another.
    for (std::size_t i = 0; i < robot_.joints.size(); ++i)
      for (std::size_t k = i; k < robot_.joints.size(); ++k) entries_.try_emplace({i, k});
    Entries gathered = gathered_symmetric(robot_, entries_, graph_);
    for (const MotorDrive& motor : p_.chain.motors) {
      Scalar& inertia = gathered[{motor.driven, motor.driven}];
      inertia = inertia + motor.rotor;
    }
    for (const auto& [place, value] : gathered)
      out.outputs.push_back(
          {"m" + std::to_string(place.first + 1) + "_" + std::to_string(place.second + 1), value.in(graph_)});
  }

 private:
  Scalar entry_of(const Link& link, const Column& column) const {
    const Scalar value = entry(p_, link, column);
    return link.joint == column.joint ? value + link.rotor : value;
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

}  // namespace qvgen::derive::dynamics
