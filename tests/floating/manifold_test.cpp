// SPDX-License-Identifier: MIT
// Configurations with a base that floats: steps along them and between them are inverse, at any length; and
// the notations of other libraries describe the same motion, by differences in time and by power.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/base_conventions.h>

namespace qvgen::test::floating {
namespace {

using Scalar = long double;
constexpr int dof = 3;
using At = FloatingConfiguration<Scalar, dof>;
using Vector = Eigen::Matrix<Scalar, 6 + dof, 1>;

void expect_near(Scalar a, Scalar b, Scalar tolerance) { EXPECT_LE(std::abs(a - b), tolerance); }

class Manifold : public testing::Test {
 protected:
  Vector draw(Scalar size = 1) {
    return Vector::NullaryExpr([&] { return size * Scalar(unit_(random_)); });
  }
  At anywhere() {
    Eigen::Matrix<Scalar, 4, 1> r =
        Eigen::Matrix<Scalar, 4, 1>::NullaryExpr([&] { return Scalar(unit_(random_)); });
    r.normalize();
    const Vector rest = draw();
    return {{Quaternion<Scalar>(r[0], r[1], r[2], r[3]), rest.head<3>()}, rest.tail<dof>()};
  }
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

TEST_F(Manifold, StepsAndDifferencesAreInverse) {
  for (const Scalar size : {1e-15L, 1e-9L, 1e-4L, 0.3L, 0.55L, 0.6L, 1.7L})
    for (int k = 0; k < 200; ++k) {
      const At from = anywhere();
      const Vector step = draw(size);
      const At to = integrated(from, step);
      expect_near(to.base.orientation.norm(), 1, 1e-18L);
      EXPECT_LE((difference(from, to) - step).norm(), 1e-17L * (1 + step.norm())) << size;
      const At again = integrated(from, difference(from, to));
      EXPECT_LE(linear_distance(again.base, to.base), 1e-17L);
      EXPECT_LE(angular_distance(again.base, to.base), 1e-17L);
      EXPECT_LE((again.q - to.q).norm(), 1e-17L);
    }
}

/// Turns next to half a turn: the step back is the shorter way.
TEST_F(Manifold, DifferencesNextToHalfATurn) {
  for (const Scalar rest : {1e-3L, 1e-7L, 1e-12L}) {
    Vector step = draw();
    step.segment<3>(3) *= (Scalar(EIGEN_PI) - rest) / step.segment<3>(3).norm();
    const At from = anywhere();
    EXPECT_LE((difference(from, integrated(from, step)) - step).norm(), 1e-15L);
    step.segment<3>(3) *= (Scalar(EIGEN_PI) + rest) / step.segment<3>(3).norm();
    const Vector back = difference(from, integrated(from, step));
    expect_near(back.segment<3>(3).norm(), Scalar(EIGEN_PI) - rest, 1e-15L);
  }
}

/// The step is a constant velocity in the base's own frame: many short ones lead where one long does.
TEST_F(Manifold, ALongStepIsManyShortOnes) {
  const At from = anywhere();
  const Vector step = draw(2);
  At at = from;
  for (int k = 0; k < 64; ++k) at = integrated(at, step / 64);
  const At once = integrated(from, step);
  EXPECT_LE(linear_distance(at.base, once.base), 1e-16L);
  EXPECT_LE(angular_distance(at.base, once.base), 1e-16L);
}

TEST_F(Manifold, PosesNextToOneAnotherGiveTheVelocity) {
  const At from = anywhere();
  const Vector velocity = draw();
  const Scalar time = 1e-6L;
  const At before = integrated(from, -time * velocity), behind = integrated(from, time * velocity);
  const Vector3<Scalar> moved = (behind.base.position - before.base.position) / (2 * time);
  EXPECT_LE((moved - InWorld::velocity(from, velocity).head<3>()).norm(), 1e-11L);
  const Matrix3<Scalar> rate = (behind.base.rotation_matrix() - before.base.rotation_matrix()) / (2 * time);
  const Matrix3<Scalar> skew = rate * from.base.rotation_matrix().transpose();
  const Vector3<Scalar> w(skew(2, 1), skew(0, 2), skew(1, 0));
  const Vector in_world = InWorld::velocity(from, velocity);
  EXPECT_LE((w - in_world.segment<3>(3)).norm(), 1e-11L);
}

TEST_F(Manifold, PositionsOfOtherLibrariesAndBack) {
  for (int k = 0; k < 50; ++k) {
    const At at = anywhere();
    const auto same = [&](const At& other) {
      return other.base.position == at.base.position && other.q == at.q &&
             other.base.orientation.coeffs() == at.base.orientation.coeffs();
    };
    EXPECT_TRUE(same(Pinocchio::configuration<dof>(Pinocchio::position(at))));
    EXPECT_TRUE(same(MuJoCo::configuration<dof>(MuJoCo::position(at))));
    EXPECT_TRUE(same(Drake::configuration<dof>(Drake::position(at))));
    EXPECT_EQ(Pinocchio::position(at)[6], at.base.orientation.w());
    EXPECT_EQ(MuJoCo::position(at)[3], at.base.orientation.w());
    EXPECT_EQ(Drake::position(at)[0], at.base.orientation.w());
    EXPECT_EQ(Drake::position(at)[4], at.base.position.x());
  }
}

template <class Convention>
void expect_same_motion(const At& at, const Vector& qd, const Vector& qdd, const Vector& force) {
  const Vector velocity = Convention::velocity(at, qd);
  EXPECT_LE((Convention::to_base(at, velocity) - qd).norm(), 1e-18L * 10);
  expect_near(Convention::force(at, force).dot(velocity), force.dot(qd), 1e-17L);  // power
  // Accelerations are the derivatives of velocities in time.
  const Scalar time = 1e-6L;
  const auto after = [&](Scalar t) {
    return Convention::velocity(integrated(at, t * qd), Vector(qd + t * qdd));
  };
  const Vector rate = (after(time) - after(-time)) / (2 * time);
  EXPECT_LE((Convention::acceleration(at, qd, qdd) - rate).norm(), 1e-10L);
}

TEST_F(Manifold, OtherLibrariesDescribeTheSameMotion) {
  for (int k = 0; k < 50; ++k) {
    const At at = anywhere();
    const Vector qd = draw(), qdd = draw(), force = draw();
    expect_same_motion<InWorld>(at, qd, qdd, force);
    expect_same_motion<MuJoCo>(at, qd, qdd, force);
    expect_same_motion<Drake>(at, qd, qdd, force);
    EXPECT_LE((MuJoCo::acceleration_to_base(at, qd, MuJoCo::acceleration(at, qd, qdd)) - qdd).norm(), 1e-17L);
  }
}

TEST_F(Manifold, GravityIsThatOfTheWorldInTheBasesFrame) {
  for (int k = 0; k < 50; ++k) {
    const At at = anywhere();
    const GravityAtBase<Scalar> down = gravity_at_base(at.base, 9.81L);
    const GravityAtBase<Scalar> any = gravity_at_base(at.base, Vector3<Scalar>(0, 0, -9.81L));
    EXPECT_LE((down - any).norm(), 1e-17L);
  }
}

}  // namespace
}  // namespace qvgen::test::floating
