// SPDX-License-Identifier: MIT
#include "verify/inverse/execute.h"

#include <stdexcept>

#include <qvgen/inverse/conic_circle.h>
#include <qvgen/inverse/polish.h>
#include <qvgen/inverse/roots.h>
#include <qvgen/inverse/slide_and_turn.h>
#include <qvgen/inverse/wrist.h>

#include "dag/evaluate.h"
#include "derive/inverse/inverse.h"
#include "exact/named_constant.h"
#include "verify/certificate.h"

namespace qvgen::verify {
namespace {

using derive::inverse::Kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using Rotor = qvgen::inverse::Rotor<Real>;
using Branch = qvgen::inverse::Branch<Real>;

struct Leaves {
  const Values& values;
  Real constant(const exact::Number& number) const {
    Real sum(0);
    for (const auto& [radicand, coefficient] : number.terms())
      sum += Real(cln::cl_R(coefficient)) * sqrt(Real(cln::cl_R(cln::cl_I(radicand))));
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
    size_square_ = values.at(derive::inverse::size_square);
    range_test_ = outputs(plan_.range_test, values);
    follow(0, values, Branch{}, 0);
    return std::move(rows_);
  }

 private:
  static Real tolerance() { return Real(qvgen::inverse::default_tolerance); }
  static qvgen::inverse::Boundary boundary() {
    return qvgen::inverse::Boundary::plain(qvgen::inverse::default_tolerance);
  }

  Real tiny(int degree) const {
    const Real noise = Real(16) * qvgen::inverse::epsilon<Real>();
    const Real square = noise * noise;
    if (degree == 0) return square;
    if (degree == 1) return square * size_square_;
    return (degree == 2 ? square : square * square) * size_square_ * size_square_;
  }

  void follow(std::size_t place, Values values, Branch branch, int label) {
    if (place == order_.size()) return finish(values, branch, label);
    const std::size_t index = order_[place];
    const Step& step = plan_.plan.steps[index];
    const Values in = outputs(plan_.steps[index].before, values);
    if (plan_.plan.range_test.is_of(step)) check_range_test(in);
    if (step.is_quartic()) return follow_quartic(place, values, in, branch, label);
    if (step.kind == Kind::polish) {
      if (polish(step, in, values)) follow(place + 1, std::move(values), branch, label);
      return;
    }
    for (int k = 0; k < step.branches; ++k) {
      Branch next = branch;
      Values known = values;
      if (step.is_wrist()) {
        wrist(step, in, known, k, next);
        for (const auto& [name, value] : outputs(plan_.steps[index].after, known)) known[name] = value;
      } else {
        block(step, in, known, Real(k == 0 ? 1 : -1), next);
        for (const auto& [name, value] : outputs(plan_.steps[index].after, known)) known[name] = value;
      }
      if (next.exists) follow(place + 1, known, next, label * step.branches + k);
    }
  }

  /// On every branch the circle's share is what the test has told: middle + √swing or middle - √swing.
  void check_range_test(const Values& in) const {
    const Real off = in.at("low") * in.at("scale") - range_test_.at("middle");
    if (abs(off * off - range_test_.at("swing")).to_double() > fifty_digits)
      throw CertificateError("inverse kinematics: the range test is wrong");
  }

  [[nodiscard]] qvgen::inverse::SlideTurns<Real> quartic_roots(Kind kind, const Values& in) const {
    using namespace qvgen::inverse;
    const Boundary careful = Boundary::careful(default_tolerance);
    if (kind == Kind::slide_turn)
      return slide_and_turn<Real>({in.at("divisor"),
                                   in.at("h"),
                                   in.at("level"),
                                   {in.at("l_x"), in.at("l_y")},
                                   in.at("mean"),
                                   {in.at("m_x"), in.at("m_y")}},
                                  tiny(1), size_square_, Real(0), {Real(1), Real(0)}, careful, Real::pi());
    const Conic<Real> conic{in.at("xx"), in.at("xy"), in.at("yy"), in.at("x"), in.at("y"), in.at("one")};
    SlideTurns<Real> roots;
    const auto turns = conic_circle(conic, careful, Real::pi());
    for (int k = 0; k < turns.count; ++k) roots.add({turns.root[static_cast<std::size_t>(k)], Real(0)});
    return roots;
  }

  void follow_quartic(std::size_t place, const Values& values, const Values& in, const Branch& branch,
                      int label) {
    const auto roots = quartic_roots(plan_.plan.steps[order_[place]].kind, in);
    for (int k = 0; k < roots.count; ++k) {
      Values known = values;
      set(known, roots.root[static_cast<std::size_t>(k)].turn);
      known["result"] = roots.root[static_cast<std::size_t>(k)].slide;
      for (const auto& [name, value] : outputs(plan_.steps[order_[place]].after, known)) known[name] = value;
      follow(place + 1, known, branch, label * 4 + k);
    }
  }

  static void set(Values& values, const Rotor& rotor) {
    values["cos_result"] = rotor.cosine;
    values["sin_result"] = rotor.sine;
  }

  void block(const Step& step, const Values& in, Values& known, const Real& sign, Branch& branch) const {
    using namespace qvgen::inverse;
    const Rotor choice{Real(1), Real(0)};
    switch (step.kind) {
      case Kind::circle:
        return set(known,
                   circle_angle(in.at("low"), in.at("high"), in.at("scale"), sign, boundary(), branch));
      case Kind::free_circle:
        return set(known, free_circle_angle(in.at("low"), in.at("high"), Rotor{in.at("x"), in.at("y")},
                                            tiny(step.degree), choice, sign, boundary(), branch));
      case Kind::factored:
        return set(known,
                   factored_line_angle(Rotor{in.at("x"), in.at("y")}, in.at("rhs"), in.at("low"),
                                       in.at("high"), tiny(step.degree), choice, sign, boundary(), branch));
      case Kind::reach:
        return set(known, reachable_direction(Rotor{in.at("point_x"), in.at("point_y")},
                                              Rotor{in.at("offset_x"), in.at("offset_y")}, in.at("inner"),
                                              in.at("outer"), choice));
      case Kind::opposite:
        return directed(step, in, sign, known, branch);
      case Kind::pair:
        return directed(step, in, Real(1), known, branch);
      case Kind::half: {
        const Rotor turn{in.at("cosine"), in.at("sine")};
        Real length(1);
        for (const std::string& unknown : step.lengths) length = length * known.at("length_" + unknown);
        return set(known, plan_.plan.wrist.right ? half_direction(turn, length) : half(turn));
      }
      case Kind::root:
        known["result"] = signed_root(in.at("square"), in.at("scale"), tiny(1), sign, boundary(), branch);
        return;
      case Kind::line:
        known["result"] = slide(in, branch);
        return;
      case Kind::slides: {
        const Rotor both =
            two_slides(Rotor{in.at("a"), in.at("b")}, in.at("k"), Rotor{in.at("g"), in.at("f")}, in.at("gap"),
                       tiny(1), size_square_, Real(0), Rotor{Real(1), Real(0)},
                       step.branches == 1 ? Real(0) : sign, boundary(), branch);
        known["result_1"] = both.cosine;
        known["result_2"] = both.sine;
        return;
      }
      case Kind::require:
        return require_zero(in.at("residual"), in.at("scale"), tolerance(), branch);
      case Kind::linear:
      case Kind::conic:
      case Kind::slide_turn:
      case Kind::polish:
      case Kind::right_wrist:
      case Kind::oblique_wrist:
        return;
    }
  }

  [[nodiscard]] Real slide(const Values& in, Branch& branch) const {
    const bool one = in.count("divisor") > 0;
    const Rotor along = one ? Rotor{in.at("divisor"), Real(0)} : Rotor{in.at("x"), in.at("y")};
    const Rotor rhs = one ? Rotor{in.at("rhs"), Real(0)} : Rotor{in.at("rhs_x"), in.at("rhs_y")};
    return qvgen::inverse::slide_on_line(along, rhs, tiny(1), slide_choice(in), boundary(), branch);
  }

  [[nodiscard]] Real slide_choice(const Values& in) const {
    using namespace qvgen::inverse;
    const Real zero(0);
    const Rotor not_spread{Real(1), zero};
    if (in.count("inner") == 0) return zero;
    const Rotor point{in.at("point_x"), in.at("point_y")};
    const Rotor along{in.at("along_x"), in.at("along_y")};
    if (in.count("outer") > 0)
      return slide_between(point, along, in.at("inner"), in.at("outer"), zero, not_spread);
    return slide_beyond(point, along, in.at("inner"), size_square_, zero, not_spread);
  }

  void directed(const Step& step, const Values& in, const Real& sign, Values& known, Branch& branch) const {
    using namespace qvgen::inverse;
    const Rotor v{in.at("x"), in.at("y")};
    const Rotor choice{Real(1), Real(0)};
    if (step.joint < 0) return set(known, chosen_direction(v, choice, boundary(), branch));
    if (step.unit) return set(known, sign * direction(v, tiny(step.degree), choice, branch));
    Real length;
    const Rotor brief = Real(brief_length) * choice;
    set(known, sign * (step.length_known
                           ? span_of_length(v, in.at("length"), tiny(step.degree), brief, length, branch)
                           : span(v, tiny(step.degree), brief, length, branch)));
    known["length_" + step.unknown] = length;
    known["result"] = sign * length;
  }

  bool polish(const Step& step, const Values& in, Values& known) const {
    if (step.points == 1 && step.turns.size() == 2) return polish<2, 1>(step, in, known);
    if (step.points == 1 && step.turns.size() == 3) return polish<3, 1>(step, in, known);
    if (step.points == 3 && step.turns.size() == 6) return polish<6, 3>(step, in, known);
    throw std::logic_error("inverse kinematics: Newton steps for " + std::to_string(step.turns.size()) +
                           " joints");
  }

  template <std::size_t joints, std::size_t points>
  bool polish(const Step& step, const Values& in, Values& known) const {
    using namespace qvgen::inverse;
    const auto triple = [&](const char* name, std::size_t i) {
      const std::string full = name + std::to_string(i + 1);
      return Triple<Real>{in.at(full + "_x"), in.at(full + "_y"), in.at(full + "_z")};
    };
    PointMatching<Real, joints, points> task;
    JointValues<Real, joints> values;
    for (std::size_t i = 0; i < joints; ++i) {
      const auto& turn = step.turns[i];
      const bool revolute = known.count("cos_" + turn) > 0;
      task.arm[i] = {revolute, triple("axis", i), triple("point", i)};
      values[i] =
          revolute ? Rotor{known.at("cos_" + turn), known.at("sin_" + turn)} : Rotor{known.at(turn), Real(0)};
    }
    for (std::size_t i = 0; i < points; ++i) {
      task.start[i] = triple("start", i);
      task.goal[i] = triple("goal", i);
    }
    task.size_square = size_square_;
    const bool reached = qvgen::inverse::polish(task, default_tolerance, values);
    for (std::size_t i = 0; i < joints; ++i) {
      known[(task.arm[i].revolute ? "cos_" : "") + step.turns[i]] = values[i].cosine;
      if (task.arm[i].revolute) known["sin_" + step.turns[i]] = values[i].sine;
    }
    return reached;
  }

  /// A wrist in the middle of a plan: the blocks that leave cosines and sines.
  void wrist_turns(const Step& step, const Values& in, Values& known, int k, Branch& branch) const {
    using namespace qvgen::inverse;
    const Rotor u{in.at("u_x"), in.at("u_y")};
    const Rotor v{in.at("v_x"), in.at("v_y")};
    const Rotor choice{in.at("choice_x"), in.at("choice_y")};
    const Real sign(k == 0 ? 1 : -1);
    WristTurns<Real> turns;
    if (step.kind == Kind::right_wrist)
      turns = right_wrist_turns(u, v, plan_.plan.wrist.middle_swapped, choice, sign, boundary(), branch);
    else
      turns = oblique_wrist_turns(u, v, shape(in), Rotor{in.at("cosine_delta"), in.at("sine_delta")}, choice,
                                  sign, boundary(), branch);
    const std::array<Rotor, 3> values = {turns.first, turns.middle, turns.last};
    for (std::size_t i = 0; i < 3; ++i) {
      known["cos_" + step.turns[i]] = values[i].cosine;
      known["sin_" + step.turns[i]] = values[i].sine;
    }
  }

  static qvgen::inverse::WristShape<Real> shape(const Values& in) {
    return {in.at("cosine_sum"), in.at("sine_sum"), in.at("cosine_difference"), in.at("sine_difference"),
            in.at("product")};
  }

  void wrist(const Step& step, const Values& in, Values& known, int k, Branch& branch) const {
    using namespace qvgen::inverse;
    if (!plan_.plan.wrist.ends_the_plan) return wrist_turns(step, in, known, k, branch);
    const Rotor u{in.at("u_x"), in.at("u_y")};
    const Rotor v{in.at("v_x"), in.at("v_y")};
    const Real pi = Real::pi();
    WristAngles<Real> angles;
    if (step.kind == Kind::right_wrist) {
      const auto both = right_wrist(u, v, plan_.plan.wrist.middle_swapped, Real(0), pi, branch);
      angles = k == 0 ? both.one : both.other;
    } else {
      angles = oblique_wrist(u, v, shape(in), Real(k == 0 ? 1 : -1), Real(0), boundary(), pi, branch);
      angles.middle = wrapped(Real(angles.middle - atan2(in.at("sine_delta"), in.at("cosine_delta"))), pi);
    }
    const std::array<Real, 3> values = {angles.first, angles.middle, angles.last};
    for (std::size_t i = 0; i < 3; ++i) {
      known["cos_" + step.turns[i]] = cos(values[i]);
      known["sin_" + step.turns[i]] = sin(values[i]);
    }
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
  Real size_square_;
  Values range_test_;
  std::vector<Row> rows_;
};

}  // namespace

std::vector<Row> execute(const LoweredPlan& plan, Values values) {
  return Execution(plan).run(std::move(values));
}

}  // namespace qvgen::verify
