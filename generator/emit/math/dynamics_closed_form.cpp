// SPDX-License-Identifier: MIT
#include "emit/math/dynamics_closed_form.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "dag/import.h"
#include "derive/dynamics/formulation.h"
#include "emit/math/collect.h"
#include "emit/math/lines.h"
#include "model/followers.h"
#include "symbolic/model.h"
#include "verify/certificate.h"

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
    const dag::Function written = collected(dag::import(program));
    verify::certify(written, program, 2, "a joint force written otherwise");
    terms_.push_back({joint_, motion, written});
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

std::string motion_formula(const std::string& motion, Notation notation) {
  if (!notation.typeset) return motion;
  std::string result;
  std::size_t start = 0;
  while (start < motion.size()) {
    const std::size_t end = std::min(motion.find('*', start), motion.size());
    const std::string part = motion.substr(start, end - start);
    const std::size_t prime = part.find('\'');
    const bool second = part.compare(prime, 2, "''") == 0;
    result += std::string(result.empty() ? "" : " ") + (second ? "\\ddot{" : "\\dot{") +
              formula(part.substr(0, prime), notation) + "}" +
              (part.find("^2") == std::string::npos ? "" : "^2");
    start = end + 1;
  }
  return result;
}

namespace {

/// One term with its sign, in pieces that fit a line.
std::vector<std::string> term_lines(const ForceTerm& term, bool first, Notation notation) {
  const bool latex = notation.typeset;
  const dag::Output& output = term.coefficient.outputs.front();
  const bool negative = output.value.negative;
  const auto name = [notation](const std::string& symbol) { return formula(symbol, notation); };
  const std::string text =
      formula(term.coefficient.graph, negative ? -output.value : output.value, notation, name);
  std::vector<std::string> lines =
      broken("[" + text + "]" +
                 (term.motion.empty() ? "" : (latex ? "\\," : " ") + motion_formula(term.motion, notation)),
             notation, 7);
  lines.front().insert(0, negative ? "- " : first ? "" : "+ ");
  return lines;
}

}  // namespace

std::vector<std::string> dynamics_closed_form_lines(const model::Robot& robot, Notation notation) {
  const bool latex = notation.typeset;
  std::vector<std::string> lines{
      latex ? "$\\tau_i$: the torque of joint $i$, the force of one that slides; $\\dot q$ is a rate, "
              "$\\ddot q$ an "
              "acceleration;\n$\\mathrm{gravity}$ acts along $-z$ of the world."
            : "tau1, ...: the torque of each joint, the force of one that slides; ' is a rate, '' an "
              "acceleration;\ngravity acts along -z of the world."};
  std::size_t joint = robot.joints.size();
  if (latex) lines.emplace_back("\\begin{align*}");
  for (const ForceTerm& term : dynamics_closed_form(robot)) {
    const bool first = term.joint != joint;
    joint = term.joint;
    const std::string number = std::to_string(joint + 1);
    const std::string left = latex ? "\\tau_{" + number + "} &= " : "tau" + number + " = ";
    const std::string blank = latex ? "&\\quad {}" : "     ";
    bool begins = first;
    for (const std::string& line : term_lines(term, first, notation)) {
      lines.push_back((begins ? left : blank) + line + (latex ? " \\\\" : ""));
      begins = false;
    }
  }
  if (latex) lines.emplace_back("\\end{align*}");
  return lines;
}

}  // namespace qvgen::emit
