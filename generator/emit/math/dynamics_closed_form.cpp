// SPDX-License-Identifier: MIT
#include "emit/math/dynamics_closed_form.h"

#include <map>
#include <stdexcept>

#include "dag/import.h"
#include "derive/dynamics/formulation.h"
#include "emit/math/notation.h"
#include "model/followers.h"
#include "passes/pass.h"
#include "symbolic/model.h"

namespace qvgen::emit {
namespace {

using derive::dynamics::acceleration_of;
using derive::dynamics::velocity_of;
using GiNaC::ex;

constexpr std::size_t most_joints = 3;

/// cos^2 -> 1 - sin^2 until no square of a cosine is left.
ex without_cosine_squares(const ex& value) {
  const ex w = GiNaC::wild();
  ex before;
  ex now = value.expand();
  while (!now.is_equal(before)) {
    before = now;
    now = now.subs(GiNaC::pow(GiNaC::cos(w), 2) == 1 - GiNaC::pow(GiNaC::sin(w), 2),
                   GiNaC::subs_options::algebraic)
              .expand();
  }
  return now;
}

std::vector<ex> forces(const model::Robot& robot) {
  const derive::dynamics::FormulationOptions choices;
  derive::dynamics::Formulation formulation = inverse_dynamics(robot, choices);
  std::erase_if(formulation.function.outputs,
                [](const dag::Output& output) { return output.name.front() == '?'; });
  std::map<std::string, ex> known;
  const std::vector<ex> constants = dag::to_symbolic(formulation.constants, {});
  for (std::size_t i = 0; i < constants.size(); ++i)
    known[formulation.constants.outputs[i].name] = constants[i];
  std::vector<ex> result;
  for (const ex& force : dag::to_symbolic(formulation.function, known))
    result.push_back(without_cosine_squares(force));
  return result;
}

class Writer {
 public:
  Writer(std::size_t joint, std::vector<ForceTerm>& terms) : joint_(joint), terms_(terms) {}

  void add(const std::string& motion, const ex& coefficient) {
    const ex flat = without_cosine_squares(coefficient);
    if (flat.is_zero()) return;
    symbolic::Program program;
    program.output("coefficient", flat);
    terms_.push_back({joint_, motion, passes::simplify(dag::import(program))});
  }

 private:
  std::size_t joint_;
  std::vector<ForceTerm>& terms_;
};

void write(const model::Robot& robot, std::size_t joint, ex force, std::vector<ForceTerm>& terms) {
  Writer writer(joint, terms);
  for (const model::Joint& other : robot.joints) {
    const GiNaC::symbol acceleration = symbolic::symbol(acceleration_of(other.variable));
    writer.add(acceleration_of(other.variable), force.coeff(acceleration, 1));
    force = force.coeff(acceleration, 0);
  }
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const std::string first = velocity_of(robot.joints[i].variable);
    const GiNaC::symbol rate = symbolic::symbol(first);
    writer.add(first + "^2", force.coeff(rate, 2));
    ex mixed = force.coeff(rate, 1);
    for (std::size_t k = i + 1; k < robot.joints.size(); ++k) {
      const std::string second = velocity_of(robot.joints[k].variable);
      writer.add(first + "*" + second, mixed.coeff(symbolic::symbol(second), 1));
      mixed = mixed.coeff(symbolic::symbol(second), 0);
    }
    writer.add(first, mixed);
    force = force.coeff(rate, 0);
  }
  writer.add("", force);
}

}  // namespace

std::vector<ForceTerm> dynamics_closed_form(const model::Robot& robot) {
  if (robot.joints.size() > most_joints)
    throw std::domain_error("the closed form of " + std::to_string(robot.joints.size()) +
                            " joints is too long to read");
  if (model::has_followers(robot))
    throw std::domain_error("there is no closed form where a joint follows another");
  std::vector<ForceTerm> terms;
  const std::vector<ex> all = forces(robot);
  for (std::size_t i = 0; i < all.size(); ++i) write(robot, i, all[i], terms);
  return terms;
}

std::vector<std::string> dynamics_closed_form_lines(const model::Robot& robot) {
  std::vector<std::string> lines;
  std::size_t joint = robot.joints.size();
  for (const ForceTerm& term : dynamics_closed_form(robot)) {
    if (term.joint != joint) lines.push_back("tau" + std::to_string(term.joint + 1) + " =");
    joint = term.joint;
    const dag::Output& output = term.coefficient.outputs.front();
    const std::string text = formula(term.coefficient.graph, output.value, Notation::text);
    lines.push_back("  + [" + text + "]" + (term.motion.empty() ? "" : " " + term.motion));
  }
  return lines;
}

}  // namespace qvgen::emit
