// SPDX-License-Identifier: MIT
// Forward dynamics by articulated bodies (Featherstone 1983). What a link carries answers to an acceleration
// of its frame by a wrench, J a + p, with joints that give way:
//   J' = J - U U^T/D,  p' = p + U u/D,  U = J s,  D = s^T U + rotor,  u = force - drive - s^T p
// are carried inward to the link before; outward, q'' = (u - U^T a)/D and a + s q'' is the link's own. Here a
// is what accelerations without forces of the joints lack (Effects::bias), so that p holds the wrenches of
// those, gravity among them. Long branches take fewer operations so than by the mass matrix.
#include <algorithm>

#include "derive/dynamics/inward_recursion.h"
#include "derive/dynamics/linear_equations.h"
#include "derive/dynamics/newton_euler.h"
#include "model/coordinates.h"
#include "model/followers.h"

namespace qvgen::derive::dynamics {
namespace {

/// Force and moment for accelerations v of a frame's origin and w' of the frame:
/// f = linear v + mixed w', n = mixed^T v + angular w'.
struct Articulated {
  Matrix3 linear, mixed, angular;
};

Matrix3 operator+(const Matrix3& a, const Matrix3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Articulated operator+(const Articulated& a, const Articulated& b) {
  return {a.linear + b.linear, a.mixed + b.mixed, a.angular + b.angular};
}

Articulated rigid(const PseudoInertia& p) {
  const Vector3 h = p.first_moments();
  Articulated body;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    body.linear[k][k] = p.mass();
    body.mixed[i][j] = h[k];
    body.mixed[j][i] = -h[k];
    body.angular[k][k] = p.at(i, i) + p.at(j, j);
    body.angular[i][j] = body.angular[j][i] = -p.at(i, j);
  }
  return body;
}

/// R m R^T for a turn about axis k.
Matrix3 rotated(const Matrix3& m, std::size_t k, const Circle& by) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const auto& [c, s] = by;
  if (s.is_zero() && c.is_one()) return m;
  const Scalar t = s * (m[i][i] - m[j][j]) + c * (m[i][j] + m[j][i]);
  Matrix3 result = m;
  result[i][i] = m[i][i] - s * t;
  result[j][j] = m[j][j] + s * t;
  result[i][j] = c * t - m[j][i];
  result[j][i] = c * t - m[i][j];
  result[i][k] = c * m[i][k] - s * m[j][k];
  result[j][k] = s * m[i][k] + c * m[j][k];
  result[k][i] = c * m[k][i] - s * m[k][j];
  result[k][j] = s * m[k][i] + c * m[k][j];
  return result;
}

Articulated rotated(const Articulated& body, std::size_t k, const Circle& by) {
  return {rotated(body.linear, k, by), rotated(body.mixed, k, by), rotated(body.angular, k, by)};
}

/// About a point d further in along axis k.
Articulated shifted(const Articulated& body, std::size_t k, const Scalar& d) {
  if (d.is_zero()) return body;
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const Matrix3 &a = body.linear, &b = body.mixed, &c = body.angular;
  Articulated result = body;
  for (std::size_t r = 0; r < 3; ++r) {
    result.mixed[r][i] = b[r][i] - d * a[r][j];
    result.mixed[r][j] = b[r][j] + d * a[r][i];
  }
  const Matrix3& moved = result.mixed;
  Matrix3& angular = result.angular;
  angular[i][i] = c[i][i] - d * (b[j][i] + moved[j][i]);
  angular[j][j] = c[j][j] + d * (b[i][j] + moved[i][j]);
  angular[i][j] = angular[j][i] = c[i][j] + d * (b[i][i] - moved[j][j]);
  angular[k][i] = angular[i][k] = c[k][i] - d * b[j][k];
  angular[k][j] = angular[j][k] = c[k][j] + d * b[i][k];
  return result;
}

/// Acceleration of a frame's origin, and of its angle.
struct Acceleration {
  Vector3 linear, angular;
};

/// Wrench for the unit acceleration of one way.
Wrench column_of(const Articulated& body, const Way& way) {
  if (way.slides) return {column(body.linear, way.axis), body.mixed[way.axis]};
  return {column(body.mixed, way.axis), column(body.angular, way.axis)};
}

const Scalar& along(const Way& way, const Wrench& wrench) {
  return (way.slides ? wrench.force : wrench.moment)[way.axis];
}

/// J - t U^T: what gives way bears no load along its way but by its rotor.
Articulated without_way(const Articulated& body, const Way& way, const Wrench& u, const Wrench& t,
                        const Scalar& rotor) {
  Articulated result;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      result.mixed[r][c] = body.mixed[r][c] - t.force[r] * u.moment[c];
      if (c < r) continue;
      result.linear[r][c] = result.linear[c][r] = body.linear[r][c] - t.force[r] * u.force[c];
      result.angular[r][c] = result.angular[c][r] = body.angular[r][c] - t.moment[r] * u.moment[c];
    }
  const std::size_t k = way.axis;
  Matrix3& own = way.slides ? result.linear : result.angular;
  const Wrench rest{rotor * t.force, rotor * t.moment};
  for (std::size_t r = 0; r < 3; ++r) {
    own[k][r] = own[r][k] = (way.slides ? rest.force : rest.moment)[r];
    (way.slides ? result.mixed[k][r] : result.mixed[r][k]) = (way.slides ? rest.moment : rest.force)[r];
  }
  return result;
}

class ArticulatedBodies {
 public:
  ArticulatedBodies(const model::Robot& robot, const FormulationOptions& choices, Formulation& out)
      : robot_(robot),
        graph_(out.function.graph),
        suggest_(out.function),
        known_(newton_euler(robot, choices, out, Effects::bias)),
        p_(known_.robot),
        inward_(p_, graph_, suggest_),
        one_(graph_, graph_.constant(1)) {}

  std::vector<Scalar> accelerations() {
    const std::size_t links = p_.chain.links.size();
    carried_.resize(links);
    given_way_.resize(links);
    motion_.resize(links);
    result_.resize(model::coordinate_count(robot_));
    for (std::size_t j = links; j-- > 0;) take_inward(j);
    for (std::size_t j = 0; j < links; ++j) take_outward(j);
    return result_;
  }

 private:
  /// Body and wrench that a link carries, itself included, in its frame.
  struct Carried {
    Articulated body;
    Wrench wrench;
  };
  /// The joint's column, its inverse inertia, and the force that is left for it.
  struct GivenWay {
    Wrench column;
    Scalar inverse, force;
  };

  Scalar force_on(const Link& link) const {
    return inward_.symbol(force_of(link.variable)) -
           (link.viscous * inward_.symbol(velocity_of(link.variable)) +
            link.coulomb * inward_.symbol(direction_of(link.variable)));
  }

  void take_inward(std::size_t j) {
    const Link& link = p_.chain.links[j];
    const State& state = known_.states[j];
    Carried& own = carried_[j];
    own.body = rigid(link.inertia) + own.body;
    own.wrench = link_wrench(link.inertia, state.u, state.v, suggest_) + own.wrench;
    if (link.motion == Motion::free) return;
    Carried inward = own;
    if (link.motion != Motion::none) inward = given_way(j, own);
    if (link.parent == no_link) return;
    Carried& before = carried_[link.parent];
    before.body = before.body + moved_to_parent(link, inward.body);
    dynamics::Column column{0, false, inward.wrench.force, inward.wrench.moment, {}};
    inward_.transform_to_parent(j, column);
    before.wrench = before.wrench + Wrench{column.force, column.moment};
  }

  Carried given_way(std::size_t j, const Carried& own) {
    const Link& link = p_.chain.links[j];
    const Way way = ways_of(link).front();
    const Wrench u = column_of(own.body, way);
    const Scalar inverse = one_ / (along(way, u) + link.rotor);
    const Wrench t{inverse * u.force, inverse * u.moment};
    const Scalar force = force_on(link) - along(way, own.wrench);
    given_way_[j] = {u, inverse, force};
    return {without_way(own.body, way, u, t, link.rotor),
            own.wrench + Wrench{force * t.force, force * t.moment}};
  }

  Articulated moved_to_parent(const Link& link, const Articulated& body) {
    const Articulated turned =
        rotated(shifted(body, 2, inward_.shift_of(link)), 2, circle(link.angle, graph_));
    return shifted(shifted(rotated(turned, 0, circle(link.alpha, graph_)), 0, link.a), 1, link.b);
  }

  void take_outward(std::size_t j) {
    const Link& link = p_.chain.links[j];
    if (link.motion == Motion::free) return float_freely(j);
    motion_[j] = arriving(link);
    if (link.motion == Motion::none) return;
    const auto& [u, inverse, force] = given_way_[j];
    Acceleration& own = motion_[j];
    const Scalar rest = force - (dot(u.force, own.linear) + dot(u.moment, own.angular));
    const Scalar acceleration = rest * inverse;
    result_[link.coordinate] = acceleration;
    Scalar& moves = link.motion == Motion::prismatic ? own.linear[2] : own.angular[2];
    moves = moves + acceleration;
  }

  /// Acceleration of the link before at this link's frame, in this frame.
  Acceleration arriving(const Link& link) {
    if (link.parent == no_link) return {};
    const Acceleration& before = motion_[link.parent];
    const auto turned = [&](const Vector3& v) {
      return unrotate(2, circle(link.angle, graph_), unrotate(0, circle(link.alpha, graph_), v));
    };
    Acceleration result{turned(before.linear + cross(before.angular, Vector3{link.a, link.b, Scalar()})),
                        turned(before.angular)};
    result.linear =
        result.linear + cross(result.angular, Vector3{Scalar(), Scalar(), inward_.shift_of(link)});
    return result;
  }

  void float_freely(std::size_t j) {
    const auto& [body, wrench] = carried_[j];
    const std::vector<Way> ways = ways_of(p_.chain.links[j]);
    SquareMatrix matrix;
    std::vector<Scalar> rest;
    for (const Way& way : ways) {
      const Wrench u = column_of(body, way);
      matrix.push_back({u.force[0], u.force[1], u.force[2], u.moment[0], u.moment[1], u.moment[2]});
      rest.push_back(inward_.symbol(force_of(model::base_coordinate(rest.size()))) - along(way, wrench));
    }
    const std::vector<Scalar> a = solved(matrix, rest, one_);
    std::copy(a.begin(), a.end(), result_.begin());
    motion_[j] = {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}};
  }

  const model::Robot& robot_;
  dag::Graph& graph_;
  Suggestions suggest_;
  NewtonEuler known_;
  const Parametrisation& p_;
  InwardRecursion inward_;
  Scalar one_;
  std::vector<Carried> carried_;
  std::vector<GivenWay> given_way_;
  std::vector<Acceleration> motion_;
  std::vector<Scalar> result_;
};

}  // namespace

std::optional<Formulation> forward_dynamics_by_articulated_bodies(const model::Robot& robot,
                                                                  const FormulationOptions& choices) {
  if (choices.wrench || choices.convention.unit || model::has_followers(robot) || !robot.motors.empty())
    return std::nullopt;
  Formulation result;
  const std::vector<Scalar> accelerations = ArticulatedBodies(robot, choices, result).accelerations();
  std::vector<dag::Output>& outputs = result.function.outputs;
  std::erase_if(outputs, [](const dag::Output& output) { return output.name.front() != '?'; });
  for (std::size_t i = 0; i < accelerations.size(); ++i)
    outputs.push_back({"qdd" + std::to_string(i + 1), accelerations[i].in(result.function.graph)});
  return result;
}

}  // namespace qvgen::derive::dynamics
