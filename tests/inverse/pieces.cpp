// SPDX-License-Identifier: MIT
#include "pieces.h"

#include <algorithm>
#include <cmath>

#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

using Eigen::VectorXd;

/// Singular values below this belong to directions in which the pose does not change.
constexpr double idle = 1e-5;

/// Returns the least step by which joints make up for what is off, without the idle directions.
VectorXd step_along(const Eigen::MatrixXd& jacobian, const VectorXd& off) {
  const reference::SingularValues parts = reference::singular_values(jacobian);
  VectorXd step = VectorXd::Zero(jacobian.cols());
  for (Eigen::Index i = 0; i < parts.values.size(); ++i)
    if (parts.values[i] > idle * parts.values[0])
      step += parts.u.col(i).dot(off) / parts.values[i] * parts.v.col(i);
  return step;
}

class Curve {
 public:
  Curve(const Case& test, const Found& found, const Sample& sample)
      : test_(test), found_(found), sample_(sample) {}

  /// In one direction.
  bool comes_to_a_row(double direction) const {
    constexpr double longest = 0.02, shortest = 1e-4, farthest = 60;
    VectorXd q = sample_.q;
    project(q);
    const VectorXd start = q;
    std::optional<VectorXd> way = tangent(q, VectorXd());
    if (!way) return false;
    *way *= direction;
    double step = longest;
    for (double gone = 0; gone < farthest; gone += step) {
      VectorXd next = test_.moved(q, step * *way);
      const bool is_near = project(next) && test_.distance(next, q) < 3 * step;
      const std::optional<VectorXd> onward = is_near ? tangent(next, *way) : std::nullopt;
      if (!onward || onward->dot(*way) < 0.8) {
        if ((step /= 2) < shortest) return false;
        continue;
      }
      if (passes_a_row(q, next)) return true;
      q = next;
      way = onward;
      step = std::min(longest, 2 * step);
      if (gone > 10 * longest && test_.difference(q, start).norm() < 1.5 * longest) return false;
    }
    return false;
  }

 private:
  bool project(VectorXd& q) const {
    for (int k = 0; k < 8 && test_.miss(q, sample_.target).largest() > 1e-12; ++k) {
      q = test_.moved(q, step_along(test_.jacobian(q), test_.residual(q, sample_.target)));
    }
    return test_.miss(q, sample_.target).largest() < 3e-12;
  }

  /// The null direction nearest to the one before.
  std::optional<VectorXd> tangent(const VectorXd& q, const VectorXd& before) const {
    const reference::SingularValues parts = reference::singular_values(test_.jacobian(q));
    VectorXd way = VectorXd::Zero(q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      if (!(parts.values[i] < idle)) continue;
      const VectorXd own = parts.v.col(i);
      way += before.size() == 0 ? own : VectorXd(own * own.dot(before));
    }
    if (way.norm() == 0) return std::nullopt;
    return way.normalized();
  }

  bool passes_a_row(const VectorXd& from, const VectorXd& to) const {
    constexpr double near = 1e-2;
    const VectorXd way = test_.difference(from, to);
    return std::any_of(found_.rows.begin(), found_.rows.end(), [&](const Row& row) {
      const VectorXd off = test_.difference(from, row.q);
      const double share = std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0);
      return (off - share * way).norm() < near;
    });
  }

  const Case& test_;
  const Found& found_;
  const Sample& sample_;
};

/// The point of one axis that is nearest to another; nothing if they are nearly parallel.
std::optional<Eigen::Vector3d> foot(const reference::JointPlace& on, const reference::JointPlace& of) {
  const Eigen::Vector3d normal = on.axis.cross(of.axis);
  if (normal.norm() < 0.1) return std::nullopt;
  const double along = (of.point - on.point).cross(of.axis).dot(normal) / normal.squaredNorm();
  return Eigen::Vector3d(on.point + along * on.axis);
}

}  // namespace

bool is_on_a_curve(const Case& test, const Sample& sample) {
  return (reference::spectrum(test.jacobian(sample.q)).array() < idle).count() == 1;
}

bool leads_to_a_row(const Case& test, const Found& found, const Sample& sample) {
  const Curve curve(test, found, sample);
  return curve.comes_to_a_row(1) || curve.comes_to_a_row(-1);
}

std::optional<Sample> point_on_an_end_axis(Case& test, int i) {
  struct Kind {
    std::size_t end, on, of;  ///< joints
  };
  constexpr Kind kinds[] = {{0, 5, 4}, {0, 4, 5}, {0, 4, 3}, {0, 3, 4}, {0, 3, 2},
                            {5, 0, 1}, {5, 1, 0}, {5, 1, 2}, {5, 2, 1}, {5, 2, 3}};
  const Kind kind = kinds[i % 10];
  if (test.dof() != 6 || !test.revolute(static_cast<int>(kind.end))) return std::nullopt;
  const auto gap = [&](const VectorXd& q) -> std::optional<Eigen::Vector2d> {
    const auto places = reference::joint_places(test.chain(), q);
    const auto point = foot(places[kind.on], places[kind.of]);
    if (!point) return std::nullopt;
    const auto& end = places[kind.end];
    const Eigen::Vector3d side =
        end.axis.cross(places[kind.end == 0 ? 1 : 4].axis + 0.3 * end.axis.unitOrthogonal()).normalized();
    const Eigen::Vector3d off = *point - end.point;
    return Eigen::Vector2d(side.dot(off), end.axis.cross(side).dot(off));
  };
  constexpr int attempts = 10, steps = 30, moving = 4;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    VectorXd q = test.joints();
    for (int step = 0; step < steps; ++step) {
      const auto off = gap(q);
      if (!off || !off->allFinite()) break;
      if (off->norm() < 3e-16) return sample_at(test, q);
      Eigen::MatrixXd slope(2, moving);
      for (int k = 0; k < moving; ++k) {
        VectorXd moved = q;
        moved[1 + k] += 1e-6;
        slope.col(k) = (gap(moved).value_or(*off) - *off) / 1e-6;
      }
      q.segment(1, moving) -= reference::least_squares(slope, *off);
    }
  }
  return std::nullopt;
}

}  // namespace qvgen::test
