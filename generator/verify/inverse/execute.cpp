// SPDX-License-Identifier: MIT
#include "verify/inverse/execute.h"

#include <stdexcept>

#include <qvgen/inverse/polish.h>

#include "dag/evaluate.h"
#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "exact/named_constant.h"
#include "verify/certificate.h"

namespace qvgen::verify {

namespace names = derive::inverse::names;
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using Rotor = qvgen::inverse::Rotor<Real>;
using Branch = qvgen::inverse::Branch<Real>;

struct Leaves {
  const Values& values;
  Real constant(const exact::Number& number) const {
    Real sum(0);
    for (const auto& [radicand, coefficient] : number.terms())
      sum += Real(cln::cl_R(coefficient)) * sqrt(Real(cln::cl_R(radicand)));
    return sum;
  }
  Real symbol(const std::string& name) const {
    if (const auto constant = exact::named_value(name)) return Real(cln::cl_R(*constant));
    if (name == "pi") return Real::pi();
    const auto place = values.find(name);
    if (place == values.end()) throw std::logic_error("inverse kinematics: no value for " + name);
    return place->second;
  }
  Real sine(const dag::Angle& angle) const { return sin(of(angle)); }
  Real cosine(const dag::Angle& angle) const { return cos(of(angle)); }
  Real root(const Real& x) const { return sqrt(qvgen::inverse::not_negative(x)); }
  Real arctangent(const Real& y, const Real& x) const { return atan2(y, x); }

 private:
  Real of(const dag::Angle& angle) const {
    Real sum = Real(cln::cl_R(angle.pi)) * Real::pi();
    for (const auto& [name, coefficient] : angle.terms) sum += Real(cln::cl_R(coefficient)) * symbol(name);
    return sum;
  }
};

}  // namespace

Values outputs(const dag::Function& function, const Values& values) {
  const std::vector<Real> results = dag::evaluate<Real>(function, Leaves{values});
  Values named;
  for (std::size_t i = 0; i < results.size(); ++i) named[function.outputs[i].name] = results[i];
  return named;
}

namespace {

class Execution {
 public:
  explicit Execution(const LoweredPlan& plan)
      : plan_(plan), order_(derive::inverse::order(plan.plan, plan.plan.quartic())) {}

  std::vector<Row> run(Values values) {
    for (const auto& [name, value] : outputs(plan_.target, values)) values[name] = value;
    noise_ = {values.at(names::size_square)};
    range_test_ = outputs(plan_.range_test, values);
    follow(0, values, Branch{}, 0);
    return std::move(rows_);
  }

 private:
  void follow(std::size_t place, Values values, Branch branch, int label) {
    if (place == order_.size()) return finish(values, branch, label);
    const std::size_t index = order_[place];
    const Step& step = plan_.plan.steps[index];
    const Values in = outputs(plan_.steps[index].before, values);
    if (plan_.plan.range_test.is_of(step)) check_range_test(in);
    if (step.is_quartic()) return follow_quartic(place, values, in, branch, label);
    if (const auto* newton = step.as<kind::Newton>()) {
      if (polish(*newton, in, values)) follow(place + 1, std::move(values), branch, label);
      return;
    }
    const auto boundary = qvgen::inverse::Boundary::plain(qvgen::inverse::default_tolerance);
    for (int k = 0; k < step.branches; ++k) {
      Branch next = branch;
      Values known = values;
      RealBackend backend(in, known, noise_, Real(k == 0 ? 1 : -1), boundary, next);
      solve(step, backend);
      leave(index, known);
      if (next.exists) follow(place + 1, known, next, label * step.branches + k);
    }
  }

  static void solve(const Step& step, RealBackend& backend) {
    std::visit([&](const auto& kind) { kind.apply(step, backend); }, step.kind);
  }

  /// Adds the names that a step leaves.
  void leave(std::size_t index, Values& known) const {
    for (const auto& [name, value] : outputs(plan_.steps[index].after, known)) known[name] = value;
  }

  /// On every branch the circle's share is what the test has told: middle + √swing or middle - √swing.
  void check_range_test(const Values& in) const {
    const Real off = in.at("low") * in.at("scale") - range_test_.at("middle");
    if (abs(off * off - range_test_.at("swing")).to_double() > fifty_digits)
      throw CertificateError("inverse kinematics: the range test is wrong");
  }

  void follow_quartic(std::size_t place, Values values, const Values& in, Branch branch, int label) {
    const std::size_t index = order_[place];
    const auto boundary = qvgen::inverse::Boundary::careful(qvgen::inverse::default_tolerance);
    RealBackend backend(in, values, noise_, Real(1), boundary, branch);
    solve(plan_.plan.steps[index], backend);
    int k = 0;
    for (const auto& root : backend.all_roots()) {
      Values known = values;
      known[names::cosine_result] = root.turn.cosine;
      known[names::sine_result] = root.turn.sine;
      known[names::result] = root.slide;
      known[names::result_1] = root.second.cosine;
      known[names::result_2] = root.second.sine;
      leave(index, known);
      follow(place + 1, known, branch, label * plan_.plan.steps[index].branches + k++);
    }
  }

  bool polish(const kind::Newton& newton, const Values& in, Values& known) const {
    const std::size_t joints = newton.variables.size();
    if (newton.points == 1 && joints == 2) return polish<2, 1>(newton, in, known);
    if (newton.points == 1 && joints == 3) return polish<3, 1>(newton, in, known);
    if (newton.points == 3 && joints == 6) return polish<6, 3>(newton, in, known);
    throw std::logic_error("inverse kinematics: Newton steps for " + std::to_string(joints) + " joints");
  }

  template <std::size_t joints, std::size_t points>
  bool polish(const kind::Newton& newton, const Values& in, Values& known) const {
    using namespace qvgen::inverse;
    const auto triple = [&](const char* name, std::size_t i) {
      const std::string full = name + std::to_string(i + 1);
      return Triple<Real>{in.at(full + "_x"), in.at(full + "_y"), in.at(full + "_z")};
    };
    PointMatching<Real, joints, points> task;
    JointValues<Real, joints> values;
    for (std::size_t i = 0; i < joints; ++i) {
      const std::string& turn = newton.variables[i];
      const bool revolute = known.count(names::cosine(turn)) > 0;
      task.arm[i] = {revolute, triple("axis", i), triple("point", i)};
      values[i] = revolute ? Rotor{known.at(names::cosine(turn)), known.at(names::sine(turn))}
                           : Rotor{known.at(turn), Real(0)};
    }
    for (std::size_t i = 0; i < points; ++i) {
      task.start[i] = triple("start", i);
      task.goal[i] = triple("goal", i);
    }
    task.size_square = noise_.size_square;
    const bool reached = qvgen::inverse::polish(task, default_tolerance, values);
    for (std::size_t i = 0; i < joints; ++i) {
      known[(task.arm[i].revolute ? "cos_" : "") + newton.variables[i]] = values[i].cosine;
      if (task.arm[i].revolute) known[names::sine(newton.variables[i])] = values[i].sine;
    }
    return reached;
  }

  void finish(const Values& values, const Branch& branch, int label) {
    Row row;
    for (const auto& joint : plan_.plan.joints)
      row.q.push_back(joint.revolute ? atan2(values.at(joint.sine), values.at(joint.cosine))
                                     : values.at(joint.cosine));
    row.branch = label;
    row.continuum = branch.continuum;
    rows_.push_back(std::move(row));
  }

  const LoweredPlan& plan_;
  std::vector<std::size_t> order_;
  Noise noise_;
  Values range_test_;
  std::vector<Row> rows_;
};

}  // namespace

std::vector<Row> execute(const LoweredPlan& plan, Values values) {
  return Execution(plan).run(std::move(values));
}

}  // namespace qvgen::verify
