// SPDX-License-Identifier: MIT
#include "derive/dynamics/plain_recursion.h"

#include "derive/dynamics/exact_vectors.h"
#include "derive/dynamics/formulation.h"
#include "model/mechanism.h"

namespace qvgen::derive::dynamics {

using exact::Number;

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
    result[at] =
        result[at] + drive.rotor * accelerations[at] + drive.viscous * rates[at] + coulomb + drive.offset;
  }
  return result;
}

void PlainRecursion::Moving::go_to(const Vector& point) {
  const Vector lever = point + Number(-1) * origin;
  a = a + cross(dw, lever) + cross(w, cross(w, lever));
  origin = point;
}

/// 5.2-5.5. Leaves the motion behind the joint, at the joint's origin.
Vector PlainRecursion::go_over_joint(const Link& link, const Number& rate, const Number& acceleration,
                                     Moving& here) {
  const Vector joint_origin = here.origin + here.rotation * link.before.position;
  here.rotation = here.rotation * link.before.rotation;
  const Vector axis = here.rotation * link.axis;
  here.go_to(joint_origin);
  if (link.revolute) {
    here.dw = here.dw + acceleration * axis + cross(here.w, rate * axis);
    here.w = here.w + rate * axis;
  } else {
    here.go_to(joint_origin + here.rotation * link.motion.position);
    here.a = here.a + acceleration * axis + Number(2) * cross(here.w, rate * axis);
  }
  return axis;
}

/// Outward, all in the world frame: 5.2-5.5 for the motion, 5.6-5.9 for force and moment.
std::vector<PlainRecursion::Body> PlainRecursion::bodies_of(const Moving& base, const Values& rates,
                                                            const Values& accelerations) const {
  const std::vector<Frame> frames = link_frames();
  std::vector<Moving> links(links_.size());
  std::vector<Body> bodies(links_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    Moving& here = links[i] = link.parent == model::base_link ? base : links[link.parent];
    Body& body = bodies[i];
    body.axis = go_over_joint(link, rates[i], accelerations[i], here);
    body.origin = here.origin;
    here.go_to(frames[i].position);
    here.rotation = frames[i].rotation;
    const Vector lever = here.rotation * link.centre;
    body.centre = here.origin + lever;
    body.force = link.mass * (here.a + cross(here.dw, lever) + cross(here.w, cross(here.w, lever)));
    const Matrix inertia = here.rotation * link.inertia * transpose(here.rotation);
    body.moment = inertia * here.dw + cross(here.w, inertia * here.w);
  }
  return bodies;
}

/// 5.10-5.15: what a joint carries, without its drive.
Number PlainRecursion::carried_by(std::size_t joint, const std::vector<Body>& bodies, const Vector& tool,
                                  const Load& load) const {
  const Vector& origin = bodies[joint].origin;
  Vector f = Number(-1) * load.force;
  Vector m = Number(-1) * load.moment + cross(tool + Number(-1) * origin, f);
  for (std::size_t k = joint; k < bodies.size(); ++k) {
    if (!carries(joint, k)) continue;
    f = f + bodies[k].force;
    m = m + bodies[k].moment + cross(bodies[k].centre + Number(-1) * origin, bodies[k].force);
  }
  return dot(bodies[joint].axis, links_[joint].revolute ? m : f);
}

PlainRecursion::Forces PlainRecursion::forces_of_chain(const Moving& base, const Values& rates,
                                                       const Values& accelerations, const Load& load) const {
  const std::vector<Body> bodies = bodies_of(base, rates, accelerations);
  const Frame last = link_frames().back();
  const Vector tool = last.position + last.rotation * tool_;
  Forces result;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Link& link = links_[i];
    const Number coulomb = rates[i].is_zero() ? Number(0) : link.coulomb * link.direction;
    result.joints.push_back(carried_by(i, bodies, tool, load) + link.rotor * accelerations[i] +
                            link.viscous * rates[i] + coulomb + link.offset);
  }
  result.force =
      base_mass_ * (base.a + cross(base.dw, base_centre_) + cross(base.w, cross(base.w, base_centre_)));
  result.moment =
      base_inertia_ * base.dw + cross(base.w, base_inertia_ * base.w) + cross(base_centre_, result.force);
  for (const Body& body : bodies) {
    result.force = result.force + body.force;
    result.moment = result.moment + body.moment + cross(body.centre, body.force);
  }
  return result;
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
