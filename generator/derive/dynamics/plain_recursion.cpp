// SPDX-License-Identifier: MIT
#include "derive/dynamics/plain_recursion.h"

#include <algorithm>
#include <cstdlib>

#include "derive/dynamics/drive_parameters.h"
#include "derive/dynamics/exact_vectors.h"
#include "derive/dynamics/formulation.h"
#include "derive/dynamics/pseudo_inertia.h"
#include "derive/dynamics/rotation_sequence.h"
#include "model/coordinates.h"
#include "model/mechanism.h"

namespace qvgen::derive::dynamics {
namespace {

using exact::Number;

/// Rodrigues' formula, the matrix of the thesis's unit quaternion [cos(angle/2), sin(angle/2) axis] (1.3).
Matrix rotation(const Vector& axis, const exact::CosineSine& angle) {
  Matrix result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector e = identity()[k];
    result[k] =
        angle.cosine * e + angle.sine * cross(axis, e) + ((Number(1) - angle.cosine) * dot(axis, e)) * axis;
  }
  return transpose(result);
}

}  // namespace

PlainRecursion::PlainRecursion(const model::Robot& robot, const exact::ExactPoint& point, const Move& move)
    : point_(point),
      shares_(model::shares(robot)),
      driven_(model::coordinates(robot)),
      base_motions_(model::base_motions(robot)) {
  base_ = frame_of(robot.base);
  if (robot.floating_base) {
    base_mass_ = number_of(robot.floating_base->mass);
    base_centre_ = vector_of(robot.floating_base->centre_of_mass);
    base_inertia_ = tensor_of(*robot.floating_base);
  }
  tool_ = vector_of(robot.tool.translation);
  for (const model::Joint& joint : robot.joints) {
    Link link;
    link.revolute = joint.type == model::JointType::revolute;
    link.variable = joint.variable;
    link.parent = model::parent_of(robot, links_.size());
    link.before = frame_of(joint.before);
    link.after = frame_of(joint.after);
    link.axis = vector_of(joint.axis);
    const bool moved = links_.size() == move.joint;
    link.motion = {identity(), {}};
    if (link.revolute) {
      const exact::CosineSine angle = turn({{{joint.variable, 1}}, 0});
      link.motion.rotation = rotation(link.axis, moved ? exact::then(angle, move.turn) : angle);
    } else {
      const Number length = point.symbol(joint.variable);
      link.motion.position = (moved ? length + move.length : length) * link.axis;
    }
    link.mass = number_of(joint.inertia.mass);
    link.rotor = number_of(joint.drive.rotor_inertia);
    link.viscous = number_of(joint.drive.viscous_friction);
    link.coulomb = number_of(joint.drive.coulomb_friction);
    // Coulomb friction of joints with several leaders is refused by the readers.
    const model::Share& share = shares_[links_.size()].front();
    const std::string& leader = driven_[base_motions_ + share.driven];
    link.direction = Number(cln::signum(share.ratio)) * point.symbol(direction_of(leader));
    link.centre = vector_of(joint.inertia.centre_of_mass);
    link.inertia = tensor_of(joint.inertia);
    links_.push_back(link);
  }
  for (const model::Joint& joint : model::driven_joints(robot)) drives_.push_back(drive_of(robot, joint));
}

PlainRecursion::Drive PlainRecursion::drive_of(const model::Robot& robot, const model::Joint& driven) const {
  const auto is_it = [&](const model::Joint& joint) { return joint.variable == driven.variable; };
  if (std::any_of(robot.joints.begin(), robot.joints.end(), is_it)) return {};
  return {number_of(driven.drive.rotor_inertia), number_of(driven.drive.viscous_friction),
          number_of(driven.drive.coulomb_friction), point_.symbol(direction_of(driven.variable))};
}

Number PlainRecursion::number_of(const model::Expression& expression) const {
  using Kind = model::Expression::Kind;
  const auto operand = [&](std::size_t i) { return number_of(expression.operands()[i]); };
  switch (expression.kind()) {
    case Kind::number:
      return Number(expression.number());
    case Kind::pi:
      return point_.symbol("pi");
    case Kind::symbol:
      return point_.symbol(expression.name());
    case Kind::negate:
      return -operand(0);
    case Kind::quotient:
      return operand(0) / operand(1);
    case Kind::root:
      return point_.root(operand(0));
    case Kind::sine:
      return point_.sine(to_angle(expression.operands()[0]));
    case Kind::cosine:
      return point_.cosine(to_angle(expression.operands()[0]));
    default:
      break;
  }
  Number result = expression.kind() == Kind::sum ? 0 : 1;
  if (expression.kind() == Kind::power) {
    for (long i = 0; i < std::labs(expression.exponent()); ++i) result = result * operand(0);
    return expression.exponent() < 0 ? result.inverse() : result;
  }
  for (std::size_t i = 0; i < expression.operands().size(); ++i)
    result = expression.kind() == Kind::sum ? result + operand(i) : result * operand(i);
  return result;
}

Vector PlainRecursion::vector_of(const model::Vector3& v) const {
  return {number_of(v[0]), number_of(v[1]), number_of(v[2])};
}

PlainRecursion::Matrix PlainRecursion::tensor_of(const model::Inertia& inertia) const {
  std::array<Number, 6> i;
  for (std::size_t k = 0; k < 6; ++k) i[k] = number_of(inertia.inertia[k]);
  return {{{i[0], i[3], i[5]}, {i[3], i[1], i[4]}, {i[5], i[4], i[2]}}};
}

exact::CosineSine PlainRecursion::turn(const exact::Angle& angle) const {
  return {point_.cosine(angle), point_.sine(angle)};
}

PlainRecursion::Frame PlainRecursion::frame_of(const model::Displacement& displacement) const {
  Frame frame{identity(), vector_of(displacement.translation)};
  for (const model::Turn& each : displacement.turns)
    frame.rotation = frame.rotation * rotation(vector_of(each.axis), turn(to_angle(each.angle)));
  return frame;
}

void PlainRecursion::take_standard_parameters() {
  drives_.assign(drives_.size(), {});
  std::size_t body = 0;
  if (floats()) take_standard_parameters_of(body++, base_mass_, base_centre_, base_inertia_);
  for (Link& link : links_) {
    link.rotor = link.viscous = link.coulomb = 0;
    take_standard_parameters_of(body++, link.mass, link.centre, link.inertia);
  }
}

void PlainRecursion::take_standard_parameters_of(std::size_t body, Number& mass, Vector& centre,
                                                 Matrix& inertia) const {
  const auto value = [&](std::size_t k) { return point_.symbol(standard_parameter(10 * body + k)); };
  mass = value(0);
  centre = mass.inverse() * Vector{value(1), value(2), value(3)};
  inertia = {
      {{value(4), value(7), value(9)}, {value(7), value(5), value(8)}, {value(9), value(8), value(6)}}};
  // Steiner: about the centre of mass.
  for (std::size_t k = 0; k < 3; ++k)
    inertia[k] = inertia[k] + (-mass * dot(centre, centre)) * identity()[k] + (mass * centre[k]) * centre;
}

void PlainRecursion::take_drive_parameters() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const auto value = [&](DriveParameter kind) { return point_.symbol(drive_parameter(i, kind)); };
    links_[i].rotor = value(DriveParameter::rotor_inertia);
    links_[i].viscous = value(DriveParameter::viscous_friction);
    links_[i].coulomb = value(DriveParameter::coulomb_friction);
    links_[i].offset = value(DriveParameter::offset);
  }
}

void PlainRecursion::remove_friction() {
  for (Link& link : links_) link.viscous = link.coulomb = 0;
  for (Drive& drive : drives_) drive.viscous = drive.coulomb = 0;
}

PlainRecursion::Values PlainRecursion::rates() const {
  Values values;
  for (const std::string& variable : driven_) values.push_back(point_.symbol(velocity_of(variable)));
  return values;
}

PlainRecursion::Values PlainRecursion::accelerations() const {
  Values values;
  for (const std::string& variable : driven_) values.push_back(point_.symbol(acceleration_of(variable)));
  return values;
}

PlainRecursion::Values PlainRecursion::forces() const {
  Values values;
  for (const std::string& variable : driven_) values.push_back(point_.symbol(force_of(variable)));
  return values;
}

PlainRecursion::Load PlainRecursion::load(bool wrench) const {
  Load load;
  for (std::size_t k = 0; k < 3; ++k) {
    load.gravity[k] = point_.symbol(gravity_component(k));
    if (!wrench) continue;
    load.force[k] = point_.symbol(wrench_component(k));
    load.moment[k] = point_.symbol(wrench_component(3 + k));
  }
  return load;
}

PlainRecursion::Load PlainRecursion::usual_load() const {
  return floats() ? load(false) : falling(point_.symbol(gravity_symbol));
}

std::vector<PlainRecursion::Frame> PlainRecursion::link_frames() const {
  std::vector<Frame> frames;
  for (const Link& link : links_) {
    Frame at = link.parent == model::base_link ? base_ : frames[link.parent];
    for (const Frame* step : {&link.before, &link.motion, &link.after})
      at = {at.rotation * step->rotation, at.position + at.rotation * step->position};
    frames.push_back(at);
  }
  return frames;
}

bool PlainRecursion::carries(std::size_t i, std::size_t k) const {
  while (k != i && k != model::base_link) k = links_[k].parent;
  return k == i;
}

PlainRecursion::Values PlainRecursion::of_chain(const Values& coordinates) const {
  Values values;
  for (const std::vector<model::Share>& row : shares_) {
    Number sum = 0;
    for (const model::Share& share : row)
      sum = sum + Number(share.ratio) * coordinates[base_motions_ + share.driven];
    values.push_back(sum);
  }
  return values;
}

/// The rate of a velocity's components in a frame that turns lacks w x v.
PlainRecursion::Moving PlainRecursion::base_motion(const Values& rates, const Values& accelerations,
                                                   const Load& load) const {
  Moving base{{}, {}, {}, Number(-1) * load.gravity, base_.position, base_.rotation};
  if (!floats()) return base;
  const auto three = [](const Values& of, std::size_t first) {
    return Vector{of[first], of[first + 1], of[first + 2]};
  };
  base.v = three(rates, 0);
  base.w = three(rates, 3);
  base.dw = three(accelerations, 3);
  base.a = base.a + three(accelerations, 0) + cross(base.w, base.v);
  return base;
}

/// Returns the forces that move all joints of the chain at once, by their ratios: virtual work.
PlainRecursion::Values PlainRecursion::inverse_dynamics(const Values& rates, const Values& accelerations,
                                                        const Load& load) const {
  const auto [force, moment, joints] = forces_of_chain(base_motion(rates, accelerations, load),
                                                       of_chain(rates), of_chain(accelerations), load);
  Values result(size());
  for (std::size_t k = 0; k < base_motions_; ++k) result[k] = k < 3 ? force[k] : moment[k - 3];
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (const model::Share& share : shares_[i]) {
      Number& sum = result[base_motions_ + share.driven];
      sum = sum + Number(share.ratio) * joints[i];
    }
  for (std::size_t k = 0; k < drives_.size(); ++k) {
    const Drive& drive = drives_[k];
    const std::size_t at = base_motions_ + k;
    const Number coulomb = rates[at].is_zero() ? Number(0) : drive.coulomb * drive.direction;
    result[at] = result[at] + drive.rotor * accelerations[at] + drive.viscous * rates[at] + coulomb;
  }
  return result;
}

/// Everything in the world frame: 5.2-5.5 for the motion, 5.6-5.9 for force and moment, 5.10-5.15 inward.
PlainRecursion::Forces PlainRecursion::forces_of_chain(const Moving& base, const Values& rates,
                                                       const Values& accelerations, const Load& load) const {
  const std::vector<Frame> frames = link_frames();
  const std::size_t n = links_.size();
  std::vector<Vector> axes(n), origins(n), force(n), moment(n), centres(n);
  std::vector<Moving> links(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Link& link = links_[i];
    Moving& here = links[i] = link.parent == model::base_link ? base : links[link.parent];
    auto& [w, dw, v, a, origin, rotation] = here;
    const auto moved_to = [&here](const Vector& point) {
      const Vector lever = point + Number(-1) * here.origin;
      here.a = here.a + cross(here.dw, lever) + cross(here.w, cross(here.w, lever));
      here.origin = point;
    };
    const Vector joint_origin = origin + rotation * link.before.position;
    rotation = rotation * link.before.rotation;
    axes[i] = rotation * link.axis;
    moved_to(joint_origin);
    if (link.revolute) {
      dw = dw + accelerations[i] * axes[i] + cross(w, rates[i] * axes[i]);
      w = w + rates[i] * axes[i];
    } else {
      moved_to(joint_origin + rotation * link.motion.position);
      a = a + accelerations[i] * axes[i] + Number(2) * cross(w, rates[i] * axes[i]);
    }
    origins[i] = origin;
    moved_to(frames[i].position);
    rotation = frames[i].rotation;
    const Vector lever = rotation * link.centre;
    centres[i] = origin + lever;
    force[i] = link.mass * (a + cross(dw, lever) + cross(w, cross(w, lever)));
    const Matrix inertia = rotation * link.inertia * transpose(rotation);
    moment[i] = inertia * dw + cross(w, inertia * w);
  }
  Values torques(n);
  const Vector tool = frames.back().position + frames.back().rotation * tool_;
  for (std::size_t i = 0; i < n; ++i) {
    Vector f = Number(-1) * load.force;
    Vector m = Number(-1) * load.moment + cross(tool + Number(-1) * origins[i], f);
    for (std::size_t k = i; k < n; ++k) {
      if (!carries(i, k)) continue;
      f = f + force[k];
      m = m + moment[k] + cross(centres[k] + Number(-1) * origins[i], force[k]);
    }
    const Number coulomb = rates[i].is_zero() ? Number(0) : links_[i].coulomb * links_[i].direction;
    torques[i] = dot(axes[i], links_[i].revolute ? m : f) + links_[i].rotor * accelerations[i] +
                 links_[i].viscous * rates[i] + coulomb + links_[i].offset;
  }
  Vector f =
      base_mass_ * (base.a + cross(base.dw, base_centre_) + cross(base.w, cross(base.w, base_centre_)));
  Vector m = base_inertia_ * base.dw + cross(base.w, base_inertia_ * base.w) + cross(base_centre_, f);
  for (std::size_t k = 0; k < n; ++k) {
    f = f + force[k];
    m = m + moment[k] + cross(centres[k], force[k]);
  }
  return {f, m, torques};
}

std::vector<PlainRecursion::Values> PlainRecursion::mass_matrix() const {
  std::vector<Values> matrix(size(), Values(size()));
  for (std::size_t k = 0; k < size(); ++k) {
    Values unit(size());
    unit[k] = 1;
    const Values column = inverse_dynamics(Values(size()), unit, 0);
    for (std::size_t i = 0; i < size(); ++i) matrix[i][k] = column[i];
  }
  return matrix;
}

Number PlainRecursion::kinetic_energy(const Values& driven) const {
  const Values rates = of_chain(driven);
  const std::vector<Frame> frames = link_frames();
  const Moving base = base_motion(driven, Values(size()), {});
  std::vector<Moving> links(links_.size());
  const Vector base_velocity = base.v + cross(base.w, base_centre_);
  Number twice = base_mass_ * dot(base_velocity, base_velocity) + dot(base.w, base_inertia_ * base.w);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    auto& [w, dw, v, a, origin, rotation] = links[i] =
        link.parent == model::base_link ? base : links[link.parent];
    const Vector joint_origin = origin + rotation * link.before.position;
    const Vector axis = rotation * (link.before.rotation * link.axis);
    v = v + cross(w, joint_origin + Number(-1) * origin);
    if (link.revolute)
      w = w + rates[i] * axis;
    else
      v = v + rates[i] * axis;
    v = v + cross(w, frames[i].position + Number(-1) * joint_origin);
    origin = frames[i].position;
    rotation = frames[i].rotation;
    const Vector centre_velocity = v + cross(w, rotation * link.centre);
    const Vector local = transpose(rotation) * w;
    twice = twice + link.mass * dot(centre_velocity, centre_velocity) + dot(local, link.inertia * local) +
            link.rotor * rates[i] * rates[i];
  }
  for (std::size_t k = 0; k < drives_.size(); ++k) {
    const Number& rate = driven[base_motions_ + k];
    twice = twice + drives_[k].rotor * rate * rate;
  }
  return twice / Number(2);
}

Number PlainRecursion::potential_energy(const Vector& gravity) const {
  const std::vector<Frame> frames = link_frames();
  Number sum = 0;
  for (std::size_t i = 0; i < links_.size(); ++i)
    sum = sum - links_[i].mass * dot(gravity, frames[i].position + frames[i].rotation * links_[i].centre);
  return sum;
}

Number PlainRecursion::potential_energy_of_floating_base() const {
  const Vector gravity = load(false).gravity;
  return potential_energy(gravity) + total_mass() * point_.symbol(gravity_component(3)) -
         base_mass_ * dot(gravity, base_centre_);
}

Number PlainRecursion::total_mass() const {
  Number sum = base_mass_;
  for (const Link& link : links_) sum = sum + link.mass;
  return sum;
}

Vector PlainRecursion::centre_of_mass() const {
  const std::vector<Frame> frames = link_frames();
  Vector sum = base_mass_ * base_centre_;
  for (std::size_t i = 0; i < links_.size(); ++i)
    sum = sum + links_[i].mass * (frames[i].position + frames[i].rotation * links_[i].centre);
  return total_mass().inverse() * sum;
}

}  // namespace qvgen::derive::dynamics
