// SPDX-License-Identifier: MIT
#include "emit/math/link_velocities.h"

#include <algorithm>

#include <fmt/format.h>

#include "canonical/arm.h"
#include "dag/import.h"
#include "derive/jacobian/definition.h"
#include "derive/jacobian/quantities.h"
#include "derive/jacobian/rates.h"
#include "emit/math/link_matrices.h"
#include "emit/math/tidy.h"
#include "optimise/described.h"
#include "symbolic/model.h"
#include "verify/certificate.h"

namespace qvgen::emit {
namespace {

using namespace symbolic;
using derive::Twist;
using GiNaC::ex;

/// Components longer than this are written in those of the link before.
constexpr std::size_t readable = 150;

/// Returns the velocities that a joint's unit rate adds to its link, in the link's frame.
Twist added_by(const model::Joint& joint) {
  const LinkMatrix after = matrix_of(joint.after);
  const Matrix3 back = transpose(after.rotation);
  const Vector axis = to_symbolic(joint.axis);
  if (joint.type == model::JointType::prismatic) return {back * axis, {}};
  return {back * cross(axis, after.position), back * axis};
}

Twist carried(const Twist& before, const LinkMatrix& link) {
  const Matrix3 back = transpose(link.rotation);
  return {back * (before.linear + cross(before.angular, link.position)), back * before.angular};
}

std::array<ex, 3> components(const Vector& v) { return {v.x, v.y, v.z}; }

bool is_identity(const LinkMatrix& matrix) {
  const std::array<ex, 3> position = components(matrix.position);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!matrix.rotation[i][j].is_equal(i == j ? 1 : 0)) return false;
  return std::all_of(position.begin(), position.end(), [](const ex& x) { return x.is_zero(); });
}

/// A sum of motions (rates, names of velocities) with their coefficients, those with one coefficient
/// together.
class LinearText {
 public:
  LinearText(const model::Robot& robot, Notation notation) : robot_(robot), notation_(notation) {}

  void add(const ex& coefficient, const std::string& motion) {
    const dag::Function function = optimise::with_definitions(tidy_in_sums(coefficient), robot_);
    const dag::Edge value = function.outputs.front().value;
    if (function.graph.is_zero(value)) return;
    const bool is_sum = function.graph.node(value).op == dag::Op::sum;
    const bool negative = !is_sum && value.negative;
    const auto name = [this](const std::string& symbol) { return formula(symbol, notation_); };
    const std::string text = formula(function.graph, negative ? -value : value, notation_, name);
    const std::string factor = text == "1" ? "" : is_sum ? "(" + text + ")" : text;
    const auto same =
        std::find_if(terms_.begin(), terms_.end(), [&](const Term& term) { return term.factor == factor; });
    if (same == terms_.end())
      terms_.push_back({factor, {{negative, motion}}});
    else
      same->motions.emplace_back(negative, motion);
  }
  [[nodiscard]] std::string text() const {
    if (terms_.empty()) return "0";
    std::string all;
    for (const Term& term : terms_) {
      const bool negative = term.motions.front().first;
      all += all.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
      const std::string sum = sum_of(term, negative);
      all += term.factor + (term.factor.empty() ? "" : notation_.typeset ? " " : "*");
      all += term.motions.size() > 1 && (!term.factor.empty() || negative) ? "(" + sum + ")" : sum;
    }
    return all;
  }

 private:
  struct Term {
    std::string factor;
    std::vector<std::pair<bool, std::string>> motions;  ///< with their signs
  };
  static std::string sum_of(const Term& term, bool reversed) {
    std::string sum;
    for (const auto& [negative, motion] : term.motions)
      sum += (sum.empty() ? "" : negative != reversed ? " - " : " + ") + motion;
    return sum;
  }

  const model::Robot& robot_;
  Notation notation_;
  std::vector<Term> terms_;
};

class Carrier {
 public:
  Carrier(const model::Robot& robot, Notation notation) : robot_(robot), notation_(notation) {
    for (const model::Joint& joint : robot.joints)
      motions_.push_back({symbol(derive::rate_name(joint.variable)), rate_text(joint.variable, notation)});
  }

  void base() { turns_.push_back(matrix_of(robot_.base).rotation); }
  void joint(std::size_t i) {
    const model::Joint& moved = robot_.joints[i];
    const Twist own = added_by(moved);
    const ex rate = motions_[i].symbol;
    go(std::to_string(i + 1), matrix_of(moved), {rate * own.linear, rate * own.angular});
  }
  /// Moves with the last link; if it is that link's frame it is not worth a line.
  void tool() {
    const LinkMatrix matrix = matrix_of(robot_.tool);
    if (!is_identity(matrix)) go(std::to_string(robot_.joints.size() + 1), matrix, {});
  }
  /// The velocities of the tool in the base frame, as they were written, against the definition.
  void certify() {
    for (std::size_t i = turns_.size(); i-- > 0;)
      known_ = {program_.let(turns_[i] * known_.linear), program_.let(turns_[i] * known_.angular)};
    std::size_t row = 0;
    for (const Vector& v : {known_.linear, known_.angular})
      for (const ex& value : components(v)) program_.output(derive::twist_entry(row++), value);
    verify::certify(dag::import(program_), derive::velocity(robot_).definition, 3, "velocities of the links");
  }
  [[nodiscard]] std::vector<LinkVelocity> take() { return std::move(links_); }

 private:
  struct Motion {
    ex symbol;
    std::string text;
  };
  void go(const std::string& link, const LinkMatrix& matrix, const Twist& own) {
    const auto next = [&](const Twist& before) {
      const Twist moved = carried(before, matrix);
      return Twist{moved.linear + own.linear, moved.angular + own.angular};
    };
    turns_.push_back(matrix.rotation);
    Twist twist = next(whole_);
    LinkVelocity velocity;
    if (is_whole_) velocity = written(link, twist);
    if (!is_whole_ || longest(velocity) > readable) {
      is_whole_ = false;
      twist = next(named_);
      velocity = written(link, twist);
    }
    whole_ = is_whole_ ? twist : Twist{};
    known_ = {learned(twist.linear), learned(twist.angular)};
    named_ = {named("v", link, velocity.linear, known_.linear),
              named("omega", link, velocity.angular, known_.angular)};
    links_.push_back(velocity);
  }
  Vector learned(const Vector& v) {
    const auto value = [this](const ex& x) { return program_.let(x.subs(meanings_)); };
    return {value(v.x), value(v.y), value(v.z)};
  }
  /// The symbols that stand for a link's velocity in the next link's formulas; nothing for zeros.
  Vector named(const std::string& vector, const std::string& link, const std::array<std::string, 3>& texts,
               const Vector& value) {
    std::array<ex, 3> symbols;
    for (std::size_t k = 0; k < 3; ++k) {
      if (texts[k] == "0") continue;
      const std::string name = component_name(vector, link, k);
      symbols[k] = symbol(name);
      meanings_[symbols[k]] = components(value)[k];
      motions_.push_back({symbols[k], formula(name, notation_)});
    }
    return {symbols[0], symbols[1], symbols[2]};
  }
  LinkVelocity written(const std::string& link, const Twist& twist) const {
    LinkVelocity velocity{link, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      velocity.linear[k] = text_of(components(twist.linear)[k]);
      velocity.angular[k] = text_of(components(twist.angular)[k]);
    }
    return velocity;
  }
  /// Linear in all motions: the coefficient of one is the value with that one 1 and the others 0.
  [[nodiscard]] std::string text_of(const ex& value) const {
    LinearText text(robot_, notation_);
    GiNaC::exmap none;
    for (const Motion& motion : motions_) none[motion.symbol] = 0;
    for (const Motion& motion : motions_) {
      if (!value.has(motion.symbol)) continue;
      GiNaC::exmap one = none;
      one[motion.symbol] = 1;
      text.add(value.subs(one), motion.text);
    }
    return text.text();
  }
  static std::size_t longest(const LinkVelocity& velocity) {
    std::size_t most = 0;
    for (const auto& texts : {velocity.angular, velocity.linear})
      for (const std::string& text : texts) most = std::max(most, text.size());
    return most;
  }

  const model::Robot& robot_;
  Notation notation_;
  std::vector<Motion> motions_;
  std::vector<LinkVelocity> links_;
  std::vector<Matrix3> turns_;
  Program program_;
  GiNaC::exmap meanings_;  ///< of the names, in the program
  bool is_whole_ = true;
  Twist whole_, named_, known_;
};

}  // namespace

std::string component_name(const std::string& vector, const std::string& link, std::size_t component) {
  return vector + "_" + link + "xyz"[component];
}

std::string rate_text(const std::string& variable, Notation notation) {
  const std::string name = formula(variable, notation);
  return notation.typeset ? "\\dot{" + name + "}" : name + "'";
}

std::vector<LinkVelocity> link_velocities(const model::Robot& described, Notation notation) {
  const model::Robot robot = canonical::for_dynamics(described);
  Carrier carrier(robot, notation);
  carrier.base();
  for (std::size_t i = 0; i < robot.joints.size(); ++i) carrier.joint(i);
  carrier.tool();
  carrier.certify();
  return carrier.take();
}

}  // namespace qvgen::emit
