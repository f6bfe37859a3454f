// SPDX-License-Identifier: MIT
#include "canonical/arm.h"

#include <algorithm>

#include <cln/integer.h>

#include "canonical/passages.h"
#include "canonical/pi.h"
#include "canonical/placement.h"
#include "exact/named_constant.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::canonical {
namespace {

using cln::cl_R;
using model::Expression;

bool is_rational(const Expression& e) {
  return model::symbols(e).empty() && model::rational_value(model::evaluate(e)).has_value();
}

bool is_rational(const model::Vector3& v) {
  return std::all_of(v.begin(), v.end(), [](const Expression& e) { return is_rational(e); });
}

bool is_plain(const model::Displacement& displacement) {
  const auto polynomial = [](const Expression& e) { return is_polynomial(e); };
  const auto right = [](const model::Turn& turn) {
    return is_rational(turn.axis) && to_angle(model::evaluate(turn.angle)).kind() != Expression::Kind::symbol;
  };
  return std::all_of(displacement.translation.begin(), displacement.translation.end(), polynomial) &&
         std::all_of(displacement.turns.begin(), displacement.turns.end(), right);
}

/// Constant turns by right angles alone, rational axes, polynomials with rational coefficients for lengths.
bool is_plain(const model::Robot& robot) {
  return is_plain(robot.base) && is_plain(robot.tool) &&
         std::all_of(robot.joints.begin(), robot.joints.end(), [](const model::Joint& joint) {
           return is_plain(joint.before) && is_rational(joint.axis) && is_plain(joint.after);
         });
}

model::Vector3 to_vector(const LengthVector& v) {
  return {to_expression(v[0]), to_expression(v[1]), to_expression(v[2])};
}

/// A multiple of pi or of a named angle, whose opposite cancels it in a sum of joints' angles.
exact::Angle to_phase(const cl_R& radians) {
  const cl_R angle = wrapped(radians);
  if (const auto turns = exact::rational_near(angle / pi())) return {{}, *turns};
  const bool negative = cln::minusp(angle);
  return {{{exact::name_of_angle(cln::abs(angle)), negative ? -1 : 1}}, 0};
}

/// Goes along the chain and hands turns about the axes over to the joints.
class Aligner {
 public:
  Aligner(const model::Robot& robot, std::vector<Placement> ways) : ways_(std::move(ways)) {
    arm_.robot = robot;
    arm_.phases.assign(robot.joints.size(), {});
  }

  Arm align() && {
    start();
    for (std::size_t i = 0; i < arm_.robot.joints.size(); ++i) pass(i);
    return std::move(arm_);
  }

 private:
  /// World to the first joint: right angles stay in the frame, the rest of a turn about the axis goes to the
  /// joint.
  void start() {
    const Placement& first = ways_.front();
    model::Robot& robot = arm_.robot;
    robot.base = {};
    robot.base.translation = to_vector(first.translation);
    if (is_right_angled(first.rotation)) {
      robot.base.turns = to_turns(euler(first.rotation));
    } else {
      Euler angles = euler(first.rotation);
      carried_ = angles.last;
      angles.last = 0;
      robot.base.turns = to_turns(angles);
    }
  }

  /// The turn about axis i is complete once it is known how the next axis lies.
  void pass(std::size_t i) {
    model::Joint& joint = arm_.robot.joints[i];
    const bool revolute = joint.type == model::JointType::revolute;
    const bool is_last = i + 1 == arm_.robot.joints.size();
    const Placement& way = ways_[i + 1];
    Euler angles = is_last && is_right_angled(way.rotation) && is_zero_turn(carried_) ? Euler{0, 0, 0, true}
                                                                                      : euler(way.rotation);
    if (angles.is_parallel) {
      const auto along = heading(way.translation);
      angles.first = along ? *along : -carried_;
      // Rz(first) Rx(0 or pi) Rz(rest) = Rx(0 or pi) Rz(last)
      const bool flipped = !is_zero_turn(angles.middle);
      angles.last = angles.last + (flipped ? angles.first : -angles.first);
    }
    // Reversing the axis's normal leaves the rotation; the smaller phase is taken.
    cl_R phase = wrapped(carried_ + angles.first);
    if (cln::abs(phase) > pi() / 2 || phase == -pi() / 2) {
      angles.first = angles.first + pi();
      angles.middle = -angles.middle;
      angles.last = angles.last + pi();
      phase = wrapped(carried_ + angles.first);
    }
    joint.before = i == 0 ? model::Displacement{} : joint.before;
    joint.axis = model::unit_vector(2);
    joint.after = {};
    if (revolute)
      arm_.phases[i] = to_phase(phase);
    else
      joint.after.turns = to_turns({phase, 0, 0, true});
    const Rotation back = about_z(-angles.first);
    const model::Vector3 offset = to_vector(back * way.translation);
    if (is_last) {
      arm_.robot.tool = {to_turns(euler(back * way.rotation)), offset};
      return;
    }
    carried_ = wrapped(angles.last);
    arm_.robot.joints[i + 1].before = {to_turns({0, angles.middle, 0, false}), offset};
  }

  static bool is_zero_turn(const cl_R& angle) { return cln::zerop(wrapped(angle)); }

  std::vector<Placement> ways_;
  Arm arm_;
  cl_R carried_ = 0;  ///< turn about the next axis that lies between the last frame and the joint
};

model::Vector3 named(const model::Vector3& v, Definitions& definitions) {
  return {named_constants(v[0], definitions), named_constants(v[1], definitions),
          named_constants(v[2], definitions)};
}

/// An angle that the derivations can read: linear in symbols by halves at most and whole right angles. Others
/// get a name.
Expression named_angle(const Expression& angle, Definitions& definitions) {
  if (model::symbols(angle).empty()) return to_angle(model::evaluate(angle));
  const Length form = to_length(angle, definitions);
  const bool readable = std::all_of(form.begin(), form.end(), [](const auto& term) {
    const auto factor = exact::rational_near(term.second);
    return term.first.size() == 1 && factor && cln::denominator(*factor * 2) == 1;
  });
  if (readable) return to_expression(form);
  // A constant part besides the symbols may be a multiple of a right angle.
  Length symbols = form;
  symbols.erase(std::vector<std::string>());
  const auto constant = form.find(std::vector<std::string>());
  if (constant != form.end() && !symbols.empty()) {
    const Expression rest = to_angle(constant->second);
    return model::add(named_angle(to_expression(symbols), definitions), rest);
  }
  const std::string name = "value(" + model::to_string(angle) + ")";
  definitions.emplace(name, angle);
  return Expression::symbol(name);
}

/// Turns about coordinate axes by readable angles; an oblique axis becomes one along z between two turns.
model::Displacement named(const model::Displacement& displacement, Definitions& definitions) {
  model::Displacement result{{}, named(displacement.translation, definitions)};
  for (const model::Turn& turn : displacement.turns) {
    const Expression angle = named_angle(turn.angle, definitions);
    if (is_rational(turn.axis)) {
      result.turns.push_back({turn.axis, angle});
      continue;
    }
    const Rotation to = from_z_to(turn.axis);
    for (const model::Turn& part : to_turns(euler(to))) result.turns.push_back(part);
    result.turns.push_back({model::unit_vector(2), angle});
    for (const model::Turn& part : to_turns(euler(transpose(to)))) result.turns.push_back(part);
  }
  return result;
}

/// The axis along z, the turns to it and back taken into the frames beside it, where its components are not
/// rational.
void straighten(model::Joint& joint) {
  if (is_rational(joint.axis)) return;
  const Rotation to = from_z_to(joint.axis);
  for (const model::Turn& part : to_turns(euler(to))) joint.before.turns.push_back(part);
  model::Displacement back{to_turns(euler(transpose(to))), {}};
  joint.after = model::compose(back, joint.after);
  joint.axis = model::unit_vector(2);
}

model::Robot with_names(const model::Robot& robot) {
  model::Robot arm = robot;
  arm.base = named(robot.base, arm.definitions);
  arm.tool = named(robot.tool, arm.definitions);
  for (model::Joint& joint : arm.joints) {
    joint.before = named(joint.before, arm.definitions);
    joint.after = named(joint.after, arm.definitions);
    straighten(joint);
    joint.after.translation = named(joint.after.translation, arm.definitions);
  }
  return arm;
}

}  // namespace

bool Arm::has_phases() const {
  return std::any_of(phases.begin(), phases.end(),
                     [](const exact::Angle& phase) { return !phase.terms.empty() || !cln::zerop(phase.pi); });
}

Arm for_kinematics(const model::Robot& robot) {
  Arm plain{robot, std::vector<exact::Angle>(robot.joints.size())};
  if (robot.joints.empty()) return plain;
  if (has_symbolic_turns(robot)) return {with_names(robot), plain.phases};
  if (is_plain(robot)) return plain;
  return along_normals(robot);
}

Arm along_normals(const model::Robot& robot) {
  if (robot.joints.empty() || has_symbolic_turns(robot)) return for_kinematics(robot);
  Definitions definitions;
  std::vector<Placement> ways = passages(robot, definitions);

  Arm arm = Aligner(robot, std::move(ways)).align();
  arm.robot.definitions = std::move(definitions);
  return arm;
}

model::Robot for_dynamics(const model::Robot& robot) { return with_names(robot); }

model::Bindings constants_of(const model::Expression& expression) {
  model::Bindings values;
  for (const std::string& name : model::symbols(expression))
    if (const auto value = exact::named_value(name)) values[name] = *value;
  return values;
}

bool is_known(const model::Expression& expression) {
  return constants_of(expression).size() == model::symbols(expression).size();
}

}  // namespace qvgen::canonical
