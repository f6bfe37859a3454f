// SPDX-License-Identifier: MIT
// The derivatives of inverse dynamics by composite bodies. With a body's pose as a 4x4 matrix, S_j the screw
// of a joint, V and A a link's velocity and acceleration as such matrices, gravity included, P its
// pseudo-inertia,
//   tau_i = sum tr(S_i P A^T),  dA/dq_j = S_j'' + 2 S_j' V + S_j A - A S_j,  dA/dq'_j = 2 (S_j' + S_j V)
// over the links that i carries. Sums are taken over what j carries for i <= j, over what i carries for i >
// j, so that each joint has four wrenches, carried inward once:
//   i <= j: tr(S_i Q_j), tr(S_i R_j);  i > j: tr(S_j'' D_i) + 2 tr(S_j' E_i), 2 tr(S_j' D_i) + 2 tr(S_j E_i),
// D_i = P S_i^T, and E_i = sum V P S_i^T, a couple. S', S'' are screws (Garofalo, Ott and Albu-Schaeffer
// 2013; Singh, Russell and Wensing 2022, in other notations).
#include <map>

#include "derive/dynamics/flow.h"
#include "derive/dynamics/followers.h"
#include "derive/dynamics/newton_euler.h"
#include "model/coordinates.h"

namespace qvgen::derive::dynamics {
namespace {

/// e_k x v.
Vector3 turned(std::size_t k, const Vector3& v) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  Vector3 result;
  result[i] = -v[j];
  result[j] = v[i];
  return result;
}

Vector3 unit_rate(std::size_t k, const Vector3& w) { return -turned(k, w); }  ///< w x e_k

Vector3 doubled(const Vector3& v) { return v + v; }

Column column_of(const Way& way, const Wrench& wrench) {
  return {way.coordinate, way.slides, wrench.force, wrench.moment, {}};
}

/// U e - e U for the cross product with e_k.
Matrix3 commutator(const Matrix3& u, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  Matrix3 w;
  w[i][i] = u[i][j] + u[j][i];
  w[j][j] = -w[i][i];
  w[i][j] = w[j][i] = u[j][j] - u[i][i];
  w[i][k] = u[j][k];
  w[j][k] = -u[i][k];
  w[k][i] = u[k][j];
  w[k][j] = -u[k][i];
  return w;
}

class CompositeDerivatives {
 public:
  CompositeDerivatives(const model::Robot& robot, const FormulationOptions& choices, Formulation& out)
      : robot_(robot),
        graph_(out.function.graph),
        suggest_(out.function),
        known_(newton_euler(robot, choices, out)),
        p_(known_.robot),
        inward_(p_, graph_, suggest_) {}

  void run(dag::Function& out) {
    find_velocities();
    std::vector<Behind> all(p_.chain.links.size());
    for (std::size_t j = p_.chain.links.size(); j-- > 0;) take_inward(j, all);
    append(out);
  }

 private:
  /// One coordinate on its way inward: D, R, Q, and twice E.
  struct Open {
    Column mass, by_rate, by_position;
    Vector3 couple;
  };
  /// Sum over the links that a link carries, in its frame; the flow is twice that of the velocities.
  struct Behind {
    PseudoInertia bodies;
    Flow flow;
    std::vector<Open> open;
  };
  /// Twice the angular velocity, and twice the velocity of the frame's origin against the base's.
  struct Velocity {
    Vector3 w, v;
  };

  Scalar rate_of(const Link& link) const {
    const Scalar rate = inward_.symbol(velocity_of(link.variable));
    return link.motion == Motion::prismatic ? p_.per_unit * rate : rate;
  }

  void find_velocities() {
    for (std::size_t j = 0; j < p_.chain.links.size(); ++j) {
      const Link& link = p_.chain.links[j];
      Velocity velocity{doubled(known_.states[j].w), {}};
      if (link.parent != no_link) {
        const Velocity& before = velocities_[link.parent];
        const Vector3 arriving = before.v + cross(before.w, {link.a, link.b, Scalar()});
        velocity.v =
            unrotate(2, circle(link.angle, graph_), unrotate(0, circle(link.alpha, graph_), arriving));
      }
      velocity.v = velocity.v + inward_.shift_of(link) * unit_rate(2, velocity.w);
      if (link.motion == Motion::prismatic) velocity.v[2] = velocity.v[2] + (rate_of(link) + rate_of(link));
      velocities_.push_back(velocity);
    }
  }

  void take_inward(std::size_t j, std::vector<Behind>& all) {
    const Link& link = p_.chain.links[j];
    auto& [bodies, flow, open] = all[j];
    const PseudoInertia composite = link.inertia + bodies;
    const std::vector<Way> ways = ways_of(link);
    for (Open& other : open)
      for (const Way& way : ways) record(j, way, other);
    for (const Way& way : ways) open.push_back(opened(j, way, composite, flow));
    record_own(j, ways, open);
    if (link.parent == no_link) return;
    Behind& before = all[link.parent];
    for (Open& other : open) {
      transform_to_parent(j, other);
      before.open.push_back(other);
    }
    if (link.motion != Motion::none)
      flow = with_own_motion(flow, link, composite, rate_of(link) + rate_of(link));
    before.flow = sum(before.flow, carried(inward_, link, flow, graph_));
    before.bodies = before.bodies + inward_.transform_to_parent(j, composite);
  }

  Open opened(std::size_t j, const Way& way, const PseudoInertia& composite, const Flow& flow) {
    const Column mass = dynamics::column_of(way, composite);
    if (p_.chain.links[j].motion == Motion::free)
      return {mass, column_of(way, base_rate_wrench(j, way, composite, flow)), {}, {}};
    return {mass, column_of(way, coriolis_wrench(way, composite, flow, velocities_[j].w)),
            column_of(way, position_wrench(j, way, composite, flow)), couple(j, way, composite, flow)};
  }

  /// For a base's own velocity V_b, of which S_j is constant: dA/dq'_j = V_b S_j + S_j V_b + 2 S_j (V - V_b).
  Wrench base_rate_wrench(std::size_t j, const Way& way, const PseudoInertia& composite, const Flow& flow) {
    const Vector3& w = known_.states[j].w;
    if (way.slides) return coriolis_wrench(way, composite, {}, w);
    const std::size_t k = way.axis, i = (k + 1) % 3, l = (k + 2) % 3;
    Matrix3 both;
    both[i][i] = both[l][l] = -velocities_[j].w[k];
    both[i][k] = both[k][i] = w[i];
    both[l][k] = both[k][l] = w[l];
    const Wrench own = link_wrench(composite, both, turned(k, base_velocity()), suggest_);
    Flow rest;
    for (std::size_t r = 0; r < 4; ++r) rest[r] = turned(k, flow[r]);
    return own + wrench_of(rest);
  }

  Vector3 base_velocity() const {
    const auto component = [&](std::size_t k) {
      return inward_.symbol(velocity_of(model::base_coordinate(k)));
    };
    return {component(0), component(1), component(2)};
  }

  /// Q_j: the wrench on all that the joint carries turns with it, and the joint's acceleration sees them
  /// move.
  Wrench position_wrench(std::size_t j, const Way& way, const PseudoInertia& composite, const Flow& flow) {
    const State& state = known_.states[j];
    const Wrench& whole = known_.wrenches[j];
    const std::size_t k = way.axis;
    if (way.slides) {
      const Vector3 along = column(state.u, k);
      return {composite.mass() * along, turned(k, whole.force) + cross(composite.first_moments(), along)};
    }
    const Wrench moved = link_wrench(composite, commutator(state.u, k), -turned(k, state.v), suggest_);
    Flow rest;
    for (std::size_t r = 0; r < 4; ++r) rest[r] = cross(unit_rate(k, state.w), flow[r]);
    return Wrench{turned(k, whole.force), turned(k, whole.moment)} + moved + wrench_of(rest);
  }

  /// Twice E_j = H^T S_j^T, H = flow + P V^T.
  Vector3 couple(std::size_t j, const Way& way, const PseudoInertia& p, const Flow& flow) const {
    const auto& [w, v] = velocities_[j];
    const auto h = [&](std::size_t r, std::size_t a) {
      const Vector3 first = {p.at(r, 0), p.at(r, 1), p.at(r, 2)};
      return flow[r][a] + cross(w, first)[a] + p.at(r, 3) * v[a];
    };
    const std::size_t k = way.axis, i = (k + 1) % 3, l = (k + 2) % 3;
    Vector3 result;
    if (way.slides) return -turned(k, {h(3, 0), h(3, 1), h(3, 2)});
    result[i] = -h(i, k);
    result[l] = -h(l, k);
    result[k] = h(i, i) + h(l, l);
    return result;
  }

  Scalar scaled(const Way& way, const Column& column, const Scalar& value) const {
    const Scalar once = way.slides ? p_.per_unit * value : value;
    return column.slides ? p_.per_unit * once : once;
  }

  /// Entries of a coordinate further out with one of the link's ways: above the diagonal and below it.
  void record(std::size_t j, const Way& way, const Open& outer) {
    const std::size_t i = way.coordinate, o = outer.mass.coordinate;
    by_position_[{i, o}] = entry(p_, way, outer.by_position);
    by_rate_[{i, o}] = entry(p_, way, outer.by_rate);
    by_position_[{o, i}] = scaled(way, outer.mass, position_below(j, way, outer));
    by_rate_[{o, i}] = scaled(way, outer.mass, rate_below(j, way, outer));
  }

  Scalar position_below(std::size_t j, const Way& way, const Open& outer) const {
    const State& state = known_.states[j];
    const std::size_t k = way.axis;
    const Column& mass = outer.mass;
    if (p_.chain.links[j].motion == Motion::free)
      return way.slides ? Scalar() : -dot(turned(k, p_.gravity), mass.force);
    const Vector3 u = column(state.u, k);
    if (way.slides) return dot(u, mass.force);
    const Vector3 s = unit_rate(k, state.w);
    const Vector3 linear = cross(velocities_[j].v, s) - turned(k, state.v);
    return (dot(u, mass.moment) + dot(linear, mass.force)) + dot(s, outer.couple);
  }

  Scalar rate_below(std::size_t j, const Way& way, const Open& outer) const {
    const Column& mass = outer.mass;
    const std::size_t k = way.axis;
    if (p_.chain.links[j].motion == Motion::free) {
      const Vector3 s = unit_rate(k, known_.states[j].w);
      if (way.slides) return dot(s, mass.force);
      return (dot(s, mass.moment) + dot(turned(k, base_velocity()), mass.force)) + outer.couple[k];
    }
    const auto& [w, v] = velocities_[j];
    const Vector3 s = unit_rate(k, w);
    if (way.slides) return dot(s, mass.force);
    return (dot(s, mass.moment) + dot(unit_rate(k, v), mass.force)) + outer.couple[k];
  }

  /// Entries of a link's ways with one another, which are the last in `open`. A base's position is a pose:
  /// only gravity sees it.
  void record_own(std::size_t j, const std::vector<Way>& ways, const std::vector<Open>& open) {
    const Link& link = p_.chain.links[j];
    for (std::size_t c = 0; c < ways.size(); ++c) {
      const Open& column = open[open.size() - ways.size() + c];
      for (const Way& row : ways) {
        by_rate_[{row.coordinate, ways[c].coordinate}] = entry(p_, row, column.by_rate);
        if (link.motion == Motion::free)
          by_position_[{ways[c].coordinate, row.coordinate}] = position_below(j, row, column);
        else
          by_position_[{row.coordinate, ways[c].coordinate}] = entry(p_, row, column.by_position);
      }
    }
    if (link.motion == Motion::none || link.motion == Motion::free) return;
    Scalar& own = by_rate_[{link.coordinate, link.coordinate}];
    own = own + link.viscous;
  }

  void transform_to_parent(std::size_t j, Open& outer) {
    const Link& link = p_.chain.links[j];
    for (Column* column : {&outer.mass, &outer.by_rate, &outer.by_position})
      inward_.transform_to_parent(j, *column);
    outer.couple = rotate(0, circle(link.alpha, graph_), rotate(2, circle(link.angle, graph_), outer.couple));
  }

  void append(dag::Function& out) {
    const std::size_t base = model::base_motions(robot_), size = model::coordinate_count(robot_);
    Entries by_position = gathered(robot_, by_position_, graph_),
            by_rate = gathered(robot_, by_rate_, graph_);
    for (const MotorDrive& motor : p_.chain.motors) {
      Scalar& own = by_rate[{base + motor.driven, base + motor.driven}];
      own = own + motor.viscous;
    }
    for (std::size_t column = 0; column < size; ++column)
      for (const auto& [prefix, entries] : {std::pair("q", &by_position), std::pair("v", &by_rate)})
        for (std::size_t row = 0; row < size; ++row)
          out.outputs.push_back({prefix + std::to_string(row + 1) + "_" + std::to_string(column + 1),
                                 (*entries)[{row, column}].in(graph_)});
  }

  const model::Robot& robot_;
  dag::Graph& graph_;
  Suggestions suggest_;
  NewtonEuler known_;
  const Parametrisation& p_;
  InwardRecursion inward_;
  std::vector<Velocity> velocities_;
  Entries by_position_, by_rate_;
};

}  // namespace

Formulation inverse_dynamics_derivatives(const model::Robot& robot, const FormulationOptions& choices) {
  Formulation result;
  CompositeDerivatives(robot, choices, result).run(result.function);
  return in_rates_of_leaders(robot, std::move(result));
}

}  // namespace qvgen::derive::dynamics
