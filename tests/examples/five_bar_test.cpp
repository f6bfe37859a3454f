// SPDX-License-Identifier: MIT
// A parallel structure assembled from two generated chains: the planar five-bar. Two arms of two joints share
// their tool point; the joints at the bases are driven, the elbows follow.
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/paden_kahan.h>
#include <qvgen/robots/rr_planar.h>

namespace {

namespace arm = qvgen::robots::rr_planar;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Joints = arm::JointVector<double>;

const arm::Geometry links{0.4, 0.5};
const Vector3d bases[2] = {{-0.15, 0, 0}, {0.15, 0, 0}};

/// Driven joints of both chains for a position of the shared point: two branches each, four together.
std::vector<Vector2d> inverse(const Vector3d& point) {
  std::vector<Vector2d> driven;
  const auto left = arm::inverse_kinematics(point - bases[0], links);
  const auto right = arm::inverse_kinematics(point - bases[1], links);
  for (const auto& a : left)
    for (const auto& b : right) driven.emplace_back(a.q[0], b.q[0]);
  return driven;
}

/// Returns the places of the shared point for given driven joints: the left forearm turns until its end is as
/// far from the right elbow as the right forearm is long; none, one or two.
std::vector<Vector3d> forward(const Vector2d& driven) {
  Vector3d elbows[2];
  for (int i = 0; i < 2; ++i)
    elbows[i] = bases[i] + links.l1 * Vector3d(std::cos(driven[i]), std::sin(driven[i]), 0);
  const Vector3d end = elbows[0] + Vector3d(links.l2, 0, 0);
  std::vector<Vector3d> points;
  for (const auto& row :
       qvgen::paden_kahan_3<double>({Vector3d::UnitZ(), elbows[0]}, end, elbows[1], links.l2))
    points.emplace_back(elbows[0] + links.l2 * Vector3d(std::cos(row[0]), std::sin(row[0]), 0));
  return points;
}

/// The chain's joints that hold a point with a given driven joint.
Joints chain(const Vector3d& from_base, double driven) {
  for (const auto& solution : arm::inverse_kinematics(from_base, links))
    if (qvgen::angle_distance(solution.q[0], driven) < 1e-9) return solution.q;
  ADD_FAILURE() << "no branch with the driven joint at " << driven;
  return Joints::Zero();
}

/// Rates of the driven joints for the unit velocities of the shared point: both chains' points move alike, so
/// the first row of each chain's inverse Jacobian.
Matrix2d inverse_jacobian(const Vector3d& point, const Vector2d& driven) {
  Matrix2d result;
  for (int i = 0; i < 2; ++i) {
    const Joints q = chain(point - bases[i], driven[i]);
    const Matrix2d own = arm::jacobian(q, links).topRows<2>();
    result.row(i) = own.inverse().row(0);
  }
  return result;
}

class FiveBar : public testing::Test {
 protected:
  std::mt19937_64 random{5};
  Vector3d point() {
    std::uniform_real_distribution<double> x(-0.3, 0.3), y(0.25, 0.65);
    return {x(random), y(random), 0};
  }
};

TEST_F(FiveBar, ForwardGivesThePointBackInAllFourModes) {
  for (int i = 0; i < 200; ++i) {
    const Vector3d wanted = point();
    const auto driven = inverse(wanted);
    ASSERT_EQ(driven.size(), 4u);
    for (const Vector2d& mode : driven) {
      double nearest = 1;
      for (const Vector3d& reached : forward(mode)) nearest = std::min(nearest, (reached - wanted).norm());
      ASSERT_LT(nearest, 1e-9);
    }
  }
}

TEST_F(FiveBar, RatesAreThoseOfDifferences) {
  constexpr double h = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Vector3d at = point();
    for (const Vector2d& mode : inverse(at)) {
      const Matrix2d rates = inverse_jacobian(at, mode);
      for (int axis = 0; axis < 2; ++axis) {
        const Vector3d step = h * Vector3d::Unit(axis);
        Vector2d difference;
        for (int k = 0; k < 2; ++k) {
          const Joints seed = chain(at - bases[k], mode[k]);
          const double after = arm::inverse_kinematics(at + step - bases[k], seed, links)[0].q[0];
          const double before = arm::inverse_kinematics(at - step - bases[k], seed, links)[0].q[0];
          difference[k] = qvgen::wrap(after - before) / (2 * h);
        }
        ASSERT_LT((rates.col(axis) - difference).norm(), 1e-6 * (1 + difference.norm()));
      }
    }
  }
}

TEST_F(FiveBar, HasNoPointWhereTheElbowsAreTooFarApart) {
  const Vector2d apart(qvgen::pi<double>, 0);  // elbows 1.1 m apart, forearms 0.5 m each
  EXPECT_TRUE(forward(apart).empty());
  EXPECT_EQ(forward(Vector2d(2, 1)).size(), 2u);
}

}  // namespace
