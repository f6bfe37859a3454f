// SPDX-License-Identifier: MIT
// A curve is followed by null vectors of the Jacobian, from the sampled joints until it closes or ends.
#include "curves.h"

#include <algorithm>

#include <Eigen/SVD>

namespace qvgen::test {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Found = inverse::elimination::Found;

constexpr double pi = 3.14159265358979323846;
/// Singular values below this belong to directions in which the pose does not change.
constexpr double idle = 1e-5;

Matrix6 jacobian(const Arm& arm, const Joints6& q) {
  Matrix6 result;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d tip = arm.tool(q).translation();
  for (std::size_t i = 0; i < 6; ++i) {
    const Eigen::Vector3d axis = frame.linear().col(2);
    const int k = static_cast<int>(i);
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    if (arm.slides[i]) {
      result.col(k) << axis, Eigen::Vector3d::Zero();
      motion.translate(q[k] * Eigen::Vector3d::UnitZ());
    } else {
      result.col(k) << axis.cross(tip - frame.translation()), axis;
      motion.rotate(Eigen::AngleAxisd(q[k], Eigen::Vector3d::UnitZ()));
    }
    frame = frame * motion * arm.links[i];
  }
  return result;
}

class Curve {
 public:
  Curve(const Arm& arm, const Found& found, const Joints6& start)
      : arm_(arm), found_(found), start_(start), target_(arm.tool(start)) {}

  /// In the idle direction that is nearest to `way`.
  [[nodiscard]] bool comes_to_a_marked_row(Joints6 way) const {
    constexpr double longest = 0.02, shortest = 1e-4, farthest = 40;
    Joints6 q = start_;
    if (!turn_along(q, way)) return false;
    double step = longest;
    for (double gone = 0; gone < farthest; gone += step) {
      Joints6 next = q + step * way, onward = way;
      const bool goes_on = project(next) && arm_.distance(next, q) < 3 * step && turn_along(next, onward) &&
                           onward.dot(way) > 0.8;
      if (!goes_on) {
        if ((step /= 2) < shortest) return false;
        continue;
      }
      if (passes_a_marked_row(q, next)) return true;
      q = next;
      way = onward;
      step = std::min(longest, 2 * step);
      if (gone > 10 * longest && arm_.distance(q, start_) < longest) return false;
    }
    return false;
  }

  /// True if all that lies between here and a row reaches the pose as rows do.
  [[nodiscard]] bool is_one_with_a_row() const {
    constexpr double farthest = 1e-2;
    return std::any_of(found_.begin(), found_.end(), [&](const auto& row) {
      const Joints6 way = difference(start_, row.q);
      if (way.norm() > farthest) return false;
      for (const double share : {0.2, 0.4, 0.6, 0.8}) {
        const Joints6 between = start_ + share * way;
        Joints6 q = between;
        if (!project(q) || (q - between).norm() > 0.1 * way.norm()) return false;
      }
      return true;
    });
  }

 private:
  [[nodiscard]] Joints6 residual(const Joints6& q) const {
    const Eigen::Isometry3d reached = arm_.tool(q);
    const Eigen::AngleAxisd turn(target_.linear() * reached.linear().transpose());
    Joints6 result;
    result << target_.translation() - reached.translation(), turn.angle() * turn.axis();
    return result;
  }

  /// Brings joints back to the pose, across the idle directions.
  bool project(Joints6& q) const {
    for (int k = 0; k < 8 && residual(q).norm() > 1e-12; ++k) {
      Eigen::JacobiSVD<Matrix6> parts(jacobian(arm_, q), Eigen::ComputeFullU | Eigen::ComputeFullV);
      parts.setThreshold(idle);
      q += parts.solve(residual(q));
    }
    return residual(q).norm() < 3e-12;
  }

  /// Takes a direction's part that does not change the pose; false if there is none.
  bool turn_along(const Joints6& q, Joints6& way) const {
    const Eigen::JacobiSVD<Matrix6> parts(jacobian(arm_, q), Eigen::ComputeFullV);
    Joints6 along = Joints6::Zero();
    for (int i = 0; i < 6; ++i)
      if (parts.singularValues()[i] < idle) along += parts.matrixV().col(i).dot(way) * parts.matrixV().col(i);
    if (!(along.norm() > 1e-9)) return false;
    way = along.normalized();
    return true;
  }

  [[nodiscard]] Joints6 difference(const Joints6& a, const Joints6& b) const {
    Joints6 result = b - a;
    for (int i = 0; i < 6; ++i)
      if (!arm_.slides[static_cast<std::size_t>(i)]) result[i] = std::remainder(result[i], 2 * pi);
    return result;
  }

  [[nodiscard]] bool passes_a_marked_row(const Joints6& from, const Joints6& to) const {
    const Joints6 way = difference(from, to);
    return std::any_of(found_.begin(), found_.end(), [&](const auto& row) {
      const Joints6 off = difference(from, row.q);
      const double share = std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0);
      return row.continuum && (off - share * way).norm() < 1e-2;
    });
  }

  const Arm& arm_;
  const Found& found_;
  Joints6 start_;
  Eigen::Isometry3d target_;
};

bool comes_out_of_a_seed(const Arm& arm, const inverse::elimination::Setup& setup, const Joints6& q,
                         double close) {
  Found seeded;
  solve(setup, Pose<double>::from_isometry(arm.tool(q)), inverse::default_tolerance,
        inverse::preference<6>(q), InstructionSet::avx512, seeded);
  return contains(arm, seeded, q, close);
}

}  // namespace

bool is_covered(const Arm& arm, const inverse::elimination::Setup& setup, const Found& found,
                const Joints6& q, double close) {
  if (contains(arm, found, q, close)) return true;
  const Curve curve(arm, found, q);
  if (curve.is_one_with_a_row()) return true;
  if (found.status != Status::singular) return false;
  if (comes_out_of_a_seed(arm, setup, q, close)) return true;
  Random random(5);
  constexpr int directions = 4;
  for (int i = 0; i < directions; ++i) {
    const Joints6 way = Joints6::NullaryExpr([&] { return uniform(random); });
    if (curve.comes_to_a_marked_row(way) || curve.comes_to_a_marked_row(-way)) return true;
  }
  return false;
}

}  // namespace qvgen::test
