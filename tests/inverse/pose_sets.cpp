// SPDX-License-Identifier: MIT
#include "pose_sets.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/linear_algebra.h"

namespace qvgen::test {

Sample sample_at(Case& test, const Eigen::VectorXd& q) {
  const Pose<double> pose = Pose<double>::from_isometry(test.tool(q));
  return {pose, pose.isometry(), q, Expect::joints};
}

namespace {

using Drawn = std::optional<Sample>;

/// A free joint, each in its turn; never the one that the caller gives.
int joint_in_turn(const Case& test, int i) {
  const int given = test.robot().info.given_joint;
  const int joint = i % (given < 0 ? test.dof() : test.dof() - 1);
  return given >= 0 && joint >= given ? joint + 1 : joint;
}

Drawn random_pose(Case& test, int) { return sample_at(test, test.joints()); }

Drawn lattice(Case& test, int) {
  Eigen::VectorXd q = test.joints();
  for (double& value : q) value = pi / 4 * std::round(value / (pi / 4));
  return sample_at(test, q);
}

/// Size of 10^-u, u in [1, 12], either sign.
double nearly_zero(Case& test) {
  const double size = std::pow(10, -test.uniform(1, 12));
  return test.uniform(-1, 1) < 0 ? -size : size;
}

/// theta5, the middle joint of a wrist: last but one.
Drawn with_theta5(Case& test, double value) {
  if (test.dof() < 6) return std::nullopt;
  Eigen::VectorXd q = test.joints();
  q[test.dof() - 2] = value;
  return sample_at(test, q);
}

Drawn with_joint(Case& test, int i, double value) {
  Eigen::VectorXd q = test.joints();
  q[joint_in_turn(test, i)] = value;
  return sample_at(test, q);
}

/// Returns the point at which the last three axes meet.
std::optional<Eigen::Vector3d> wrist_centre(const Case& test, const Eigen::VectorXd& q) {
  const auto places = reference::joint_places(test.chain(), q);
  const auto& axis = places[places.size() - 3];
  const auto& next = places[places.size() - 2];
  const auto& last = places[places.size() - 1];
  // The point of axis n-2 nearest to axis n-1; it has to lie on both and on axis n.
  const Eigen::Vector3d normal = axis.axis.cross(next.axis);
  const Eigen::Vector3d between = next.point - axis.point;
  const double along = between.cross(next.axis).dot(normal) / normal.squaredNorm();
  const Eigen::Vector3d centre = axis.point + along * axis.axis;
  const double gap =
      (centre - next.point).cross(next.axis).norm() + (centre - last.point).cross(last.axis).norm();
  if (normal.norm() < 0.1 || gap > 1e-9) return std::nullopt;
  return centre;
}

std::optional<Eigen::Vector3d> tool_point(const Case& test, const Eigen::VectorXd& q) {
  return test.tool(q).translation();
}

/// A point that the joints move.
using Point = std::optional<Eigen::Vector3d> (*)(const Case&, const Eigen::VectorXd&);

/// Its offset from axis 1, two components.
std::optional<Eigen::Vector2d> offset_from_first_axis(const Case& test, const Eigen::VectorXd& q,
                                                      Point point) {
  const std::optional<Eigen::Vector3d> place = point(test, q);
  if (!place) return std::nullopt;
  const auto first = reference::joint_places(test.chain(), q).front();
  const Eigen::Vector3d side = first.axis.unitOrthogonal();
  const Eigen::Vector3d arm = *place - first.point;
  return Eigen::Vector2d{side.dot(arm), first.axis.cross(side).dot(arm)};
}

/// Joints with which the point lies on axis 1, by Gauss-Newton on `count` joints behind the first; an arm
/// with a lateral offset never gets there.
std::optional<Eigen::VectorXd> on_first_axis(Case& test, Point point, int count) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    Eigen::VectorXd q = test.joints();
    for (int step = 0; step < 30; ++step) {
      const auto offset = offset_from_first_axis(test, q, point);
      if (!offset) return std::nullopt;
      if (offset->norm() < 2e-16) return q;
      Eigen::MatrixXd slope(2, count);
      for (int k = 0; k < count; ++k) {
        Eigen::VectorXd moved = q;
        moved[k + 1] += 1e-6;
        slope.col(k) = (*offset_from_first_axis(test, moved, point) - *offset) / 1e-6;
        if (k + 1 == test.robot().info.given_joint) slope.col(k).setZero();
      }
      q.segment(1, count) -= reference::least_squares(slope, *offset);
    }
  }
  return std::nullopt;
}

Drawn centre_on_first_axis(Case& test, int) {
  if (test.dof() < 6 || !test.revolute(0)) return std::nullopt;
  const auto q = on_first_axis(test, wrist_centre, test.dof() - 4);
  if (!q) return std::nullopt;
  return sample_at(test, *q);
}

/// Every second time one of the joints behind the first is moved by 10^-u.
Drawn tool_on_first_axis(Case& test, int i) {
  if (test.dof() < 3 || !test.revolute(0)) return std::nullopt;
  auto q = on_first_axis(test, tool_point, test.dof() - 1);
  if (!q) return std::nullopt;
  const int next = 1 + (i / 2) % (test.dof() - 1);
  if (i % 2 == 1) (*q)[next] += nearly_zero(test);
  return sample_at(test, *q);
}

/// Determinant of the Jacobian, seen in the space of velocities that the arm has at an ordinary place.
class Singularity {
 public:
  explicit Singularity(Case& test) : test_(test) {
    const auto parts = reference::singular_values(test.jacobian(test.joints()));
    space_ = parts.u.leftCols(parts.values.size());
  }
  double operator()(const Eigen::VectorXd& q) const {
    return reference::determinant(space_.transpose() * test_.jacobian(q));
  }

 private:
  Case& test_;
  Eigen::MatrixXd space_;
};

/// Turns one joint until a function of the joints changes its sign; false if it keeps its sign all the way
/// round.
bool turn_to_zero(const std::function<double(const Eigen::VectorXd&)>& function, int joint,
                  Eigen::VectorXd& q) {
  const auto value = [&](double t) {
    q[joint] = t;
    return function(q);
  };
  constexpr int steps = 12;
  for (int k = 0; k < steps; ++k) {
    double low = -pi + 2 * pi * k / steps;
    double high = low + 2 * pi / steps;
    const double at_low = value(low);
    if ((at_low < 0) == (value(high) < 0)) continue;
    while (std::abs(high - low) > 1e-16 * (1 + std::abs(low))) {
      const double middle = (low + high) / 2;
      if (middle == low || middle == high) break;
      ((value(middle) < 0) == (at_low < 0) ? low : high) = middle;
    }
    q[joint] = low;
    return true;
  }
  return false;
}

/// Joints at which two branches meet: the boundary of what a branch reaches, found by turning one joint until
/// the determinant changes its sign.
Drawn at_a_boundary(Case& test, int i) {
  const Singularity determinant(test);
  const int joint = joint_in_turn(test, i);
  for (int attempt = 0; attempt < 5; ++attempt) {
    Eigen::VectorXd q = test.joints();
    if (turn_to_zero(determinant, joint, q)) return sample_at(test, q);
  }
  // Some joints (the first, the last) never decide: an ordinary pose would say nothing, so there is none.
  return std::nullopt;
}

/// Moved outwards from a reachable pose by the factor 1 + s.
Sample outwards(const Sample& start, double s) {
  Sample moved = start;
  moved.pose.position *= 1 + s;
  moved.target.translation() *= 1 + s;
  return moved;
}

/// A little beyond the last reachable pose on the ray through a sampled one, by a share of 1e-9.
Drawn just_outside(Case& test, int) {
  const Sample start = sample_at(test, test.joints());
  const auto reached = [&](double s) {
    const Sample moved = outwards(start, s);
    return !test.robot().solve(moved.pose, test.given(start.q), inverse::default_tolerance).rows.empty();
  };
  double inside = 0;
  double outside = 100;
  if (reached(outside) || !reached(inside)) return std::nullopt;
  while (outside - inside > 1e-14 * (1 + inside)) {
    const double middle = (inside + outside) / 2;
    (reached(middle) ? inside : outside) = middle;
  }
  Sample sample = outwards(start, outside + 1e-9 * (1 + outside));
  sample.expect = Expect::unreachable;
  return sample;
}

/// A kilometre and more away: out of reach, unless slides go there.
Drawn far_outside(Case& test, int) {
  const Sample start = sample_at(test, test.joints());
  Sample sample = outwards(start, 999);
  bool slides = false;
  for (int k = 0; k < test.dof(); ++k) slides = slides || !test.revolute(k);
  const bool away = start.target.translation().norm() > 0.1;
  sample.expect = slides || !away || !test.asks_position() ? Expect::clean : Expect::unreachable;
  return sample;
}

Drawn rounded_to_float(Case& test, int) {
  Sample sample = sample_at(test, test.joints());
  sample.pose = sample.pose.cast<float>().cast<double>();
  sample.target = sample.pose.normalised().isometry();
  sample.expect = Expect::clean;
  return sample;
}

/// NaN and infinity in each component in turn, then quaternions of a wrong length.
Drawn invalid(Case& test, int i) {
  Sample sample = sample_at(test, test.joints());
  sample.expect = Expect::invalid;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
  const double lengths[] = {0.0, 0.5, 2.0};
  const int kind = i % 24;
  if (kind < 12)
    sample.pose.orientation.coeffs()[kind % 4] = bad[kind / 4];
  else if (kind < 21)
    sample.pose.position[(kind - 12) % 3] = bad[(kind - 12) / 3];
  else
    sample.pose.orientation.coeffs() *= lengths[kind - 21];
  return sample;
}

/// A set whose poses are searched for. A search in vain is the longest: an arm of which sixty find nothing
/// has no such pose.
PoseSet searched(const std::string& name, const std::function<Drawn(Case&, int)>& draw) {
  const auto search = [name, draw](Case& test, int i) -> Drawn {
    Case::Searches& searches = test.searches(name);
    if (searches.found == 0 && searches.tried >= 60) return std::nullopt;
    const Drawn drawn = draw(test, i);
    ++searches.tried;
    searches.found += drawn ? 1 : 0;
    return drawn;
  };
  // An arm's lengths decide which of these it has.
  return {name, search, [](const Case&) { return false; }};
}

bool has_six_joints(const Case& test) { return test.dof() >= 6; }

std::vector<PoseSet> all() {
  return {{"random", random_pose},
          {"theta5 = 0", [](Case& test, int) { return with_theta5(test, 0); }, has_six_joints},
          {"theta5 = pi", [](Case& test, int) { return with_theta5(test, pi); }, has_six_joints},
          {"theta5 = 10^-u", [](Case& test, int) { return with_theta5(test, nearly_zero(test)); },
           has_six_joints},
          searched("centre on axis 1", centre_on_first_axis),
          searched("tool on axis 1", tool_on_first_axis),
          searched("boundary", at_a_boundary),
          searched("just outside", just_outside),
          {"far outside", far_outside},
          {"float32", rounded_to_float},
          {"45° lattice", lattice},
          {"invalid", invalid},
          {"a joint at 0", [](Case& test, int i) { return with_joint(test, i, 0); }},
          {"a joint at pi", [](Case& test, int i) { return with_joint(test, i, pi); }},
          {"a joint at 10^-u", [](Case& test, int i) { return with_joint(test, i, nearly_zero(test)); }}};
}

}  // namespace

/// One joint is turned until the determinant changes its sign, then another until the determinant's slope
/// along the first does.
std::optional<Sample> at_two_singularities(Case& test, int i) {
  const Singularity determinant(test);
  const int inner = test.dof() - 2, one = 1 + i % inner,
            other = 1 + (i + 1 + i / inner % (inner - 1)) % inner;
  Eigen::VectorXd q = test.joints();
  if (!turn_to_zero(determinant, one, q)) return std::nullopt;
  const auto slope = [&](Eigen::VectorXd place) {
    constexpr double little = 1e-3;
    place[one] += little;
    const double above = determinant(place);
    place[one] -= 2 * little;
    return above - determinant(place);
  };
  if (!turn_to_zero(slope, other, q)) return std::nullopt;
  // The determinant vanishes along either joint, and beside both it does not.
  const auto beside = [&](double by_one, double by_other) {
    Eigen::VectorXd place = q;
    place[one] += by_one;
    place[other] += by_other;
    return std::abs(determinant(place));
  };
  constexpr double aside = 1e-2, vanishing = 1e-6;
  const double both = vanishing * beside(aside, aside);
  if (!(beside(aside, 0) < both && beside(0, aside) < both)) return std::nullopt;
  for (const int joint : {one, other}) {
    const double size = test.uniform(0, 1) < 0.15 ? 0 : std::pow(10, -test.uniform(2, 14));
    q[joint] += test.uniform(-1, 1) < 0 ? -size : size;
  }
  return sample_at(test, q);
}

const std::vector<PoseSet>& pose_sets() {
  static const std::vector<PoseSet> sets = all();
  return sets;
}

const PoseSet& pose_set(const std::string& name) {
  for (const PoseSet& set : pose_sets())
    if (set.name == name) return set;
  throw std::invalid_argument("no pose set " + name);
}

}  // namespace qvgen::test
