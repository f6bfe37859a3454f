// SPDX-License-Identifier: MIT
// Legs and arms that call the functions of the one that they are images of: poses, Jacobians, their rates and
// all rows of inverse kinematics are those of the robot that is described, by a chain of the tests' own.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/mirrored/limbs.h>

#include "reference/chain.h"
#include "reference/load.h"

namespace qvgen::test {
namespace {

namespace limbs = qvgen::robots::mirrored::limbs;
constexpr int dof = qvgen::robots::mirrored::dof;
using Eigen::VectorXd;

class Images : public testing::Test {
 protected:
  VectorXd random_joints(double most = 3) {
    return VectorXd::NullaryExpr(
        dof, [&] { return std::uniform_real_distribution<double>(-most, most)(random_); });
  }
  Pose<double> pose_of(std::size_t tip, const VectorXd& q) {
    return Pose<double>::from_isometry(reference::pose_of(chain_, chain_.frames[tip], q));
  }
  std::mt19937 random_{5};
  reference::Chain chain_ = reference::load(QVGEN_MIRRORED);
};

/// Calls `check(tip, joints, functions)` for each limb. Functions of namespaces are no values: each limb has
/// a type that calls them.
#define QVGEN_LIMB(NAME)                                                                     \
  struct NAME {                                                                              \
    static constexpr auto& joints = limbs::joints_of_##NAME;                                 \
    static constexpr int size = limbs::NAME::dof;                                            \
    using Vector = Eigen::Matrix<double, size, 1>;                                           \
    template <class... T>                                                                    \
    static auto pose(const T&... v) {                                                        \
      return limbs::NAME::forward_kinematics<double>(v...);                                  \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto transform(const T&... v) {                                                   \
      return limbs::NAME::homogeneous_transform<double>(v...);                               \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto jacobian(const T&... v) {                                                    \
      return limbs::NAME::jacobian<double>(v...);                                            \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto tool_jacobian(const T&... v) {                                               \
      return limbs::NAME::tool_jacobian<double>(v...);                                       \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto jacobian_at(const T&... v) {                                                 \
      return limbs::NAME::jacobian_at<double>(v...);                                         \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto both(const T&... v) {                                                        \
      return limbs::NAME::forward_kinematics_and_jacobian<double>(v...);                     \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto velocity(const T&... v) {                                                    \
      return limbs::NAME::velocity<double>(v...);                                            \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto jacobian_dot(const T&... v) {                                                \
      return limbs::NAME::jacobian_dot<double>(v...);                                        \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto bias(const T&... v) {                                                        \
      return limbs::NAME::jacobian_dot_times_qd<double>(v...);                               \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto rates(const T&... v) {                                                       \
      return limbs::NAME::inverse_velocity<double>(v...);                                    \
    }                                                                                        \
    static auto angles(const Vector& q) { return limbs::NAME::jacobian_angles<double>(q); }  \
    static auto pose_angles(const Vector& q) { return limbs::NAME::pose_angles<double>(q); } \
    template <class... T>                                                                    \
    static auto rows(const T&... v) {                                                        \
      return limbs::NAME::inverse_kinematics(v...);                                          \
    }                                                                                        \
    template <class... T>                                                                    \
    static auto near(const T&... v) {                                                        \
      return limbs::NAME::inverse_kinematics_near(v...);                                     \
    }                                                                                        \
    static auto limits() { return limbs::NAME::Limits(); }                                   \
    static constexpr auto& revolute = limbs::NAME::is_revolute;                              \
  }
QVGEN_LIMB(rf);
QVGEN_LIMB(rh);
QVGEN_LIMB(right);
#ifdef QVGEN_ALL_LIMBS
QVGEN_LIMB(lf);
QVGEN_LIMB(lh);
QVGEN_LIMB(left);
#endif
#undef QVGEN_LIMB

/// Images in one plane and in two, and of an arm; long runs have all limbs.
template <class Check>
void for_each_limb(const Check& check) {
  check(1, rf());
  check(3, rh());
  check(5, right());
#ifdef QVGEN_ALL_LIMBS
  check(0, lf());
  check(2, lh());
  check(4, left());
#endif
}

TEST_F(Images, MoveAsTheReferenceDoes) {
  for (int k = 0; k < 50; ++k) {
    const VectorXd q = random_joints(), qd = random_joints();
    for_each_limb([&](std::size_t tip, auto limb) {
      using Limb = decltype(limb);
      const typename Limb::Vector at = values_of(Limb::joints, Eigen::Matrix<double, dof, 1>(q));
      const typename Limb::Vector rate = values_of(Limb::joints, Eigen::Matrix<double, dof, 1>(qd));
      const auto expected = reference::pose_of(chain_, chain_.frames[tip], q);
      EXPECT_TRUE(Limb::pose(at).isometry().isApprox(expected, 1e-12)) << tip;
      EXPECT_TRUE(Limb::pose(at, Limb::pose_angles(at)).isometry().isApprox(expected, 1e-12)) << tip;
      EXPECT_TRUE(Limb::transform(at).isApprox(expected, 1e-12)) << tip;
      const auto jacobian = Limb::jacobian(at);
      const Eigen::MatrixXd whole = columns_in<dof>(Limb::joints, jacobian);
      EXPECT_TRUE(whole.isApprox(reference::jacobian_of(chain_, chain_.frames[tip], q), 1e-12)) << tip;
      EXPECT_TRUE(Limb::jacobian(at, Limb::angles(at)).isApprox(jacobian, 1e-14)) << tip;
      EXPECT_TRUE(Limb::both(at).transform.isApprox(expected, 1e-12)) << tip;
      EXPECT_TRUE(Limb::both(at).jacobian.isApprox(jacobian, 1e-12)) << tip;
      EXPECT_TRUE(Limb::velocity(at, rate).isApprox(jacobian * rate, 1e-12)) << tip;
      EXPECT_TRUE(Limb::bias(at, rate).isApprox(Limb::jacobian_dot(at, rate) * rate, 1e-11)) << tip;
      const double time = 1e-6;
      const auto ahead = Limb::jacobian(typename Limb::Vector(at + time * rate));
      const auto before = Limb::jacobian(typename Limb::Vector(at - time * rate));
      EXPECT_TRUE(Limb::jacobian_dot(at, rate).isApprox((ahead - before) / (2 * time), 1e-7)) << tip;
      const Eigen::Matrix3d r = expected.linear();
      auto turned = jacobian;
      turned.template topRows<3>() = r.transpose() * jacobian.template topRows<3>();
      turned.template bottomRows<3>() = r.transpose() * jacobian.template bottomRows<3>();
      EXPECT_TRUE(Limb::tool_jacobian(at).isApprox(turned, 1e-12)) << tip;
      const Eigen::Vector3d point(0.1, -0.2, 0.3);
      auto moved = jacobian;
      for (int j = 0; j < Limb::size; ++j)
        moved.template block<3, 1>(0, j) +=
            Eigen::Vector3d(jacobian.template block<3, 1>(3, j)).cross(r * point);
      EXPECT_TRUE(Limb::jacobian_at(at, point).isApprox(moved, 1e-12)) << tip;
      const auto found = Limb::rates(at, Eigen::Matrix<double, 6, 1>(jacobian * rate));
      EXPECT_TRUE(found.status != VelocityStatus::solved || found.qd.isApprox(rate, 1e-7)) << tip;
    });
  }
}

/// True if one of the rows is these joints, whole turns apart.
template <class Rows, class Vector>
bool has_row(const Rows& rows, const Vector& q) {
  for (const auto& row : rows) {
    double most = 0;
    for (Eigen::Index i = 0; i < q.size(); ++i)
      most = std::max(most, std::abs(std::remainder(row.q[i] - q[i], 2 * M_PI)));
    if (most < 1e-6) return true;
  }
  return false;
}

TEST_F(Images, EveryRowReachesThePoseAndNoneIsMissing) {
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = random_joints();
    for_each_limb([&](std::size_t tip, auto limb) {
      using Limb = decltype(limb);
      using Vector = typename Limb::Vector;
      const Vector at = values_of(Limb::joints, Eigen::Matrix<double, dof, 1>(q));
      const Pose<double> pose = pose_of(tip, q);
      const auto rows = Limb::rows(pose);
      ASSERT_TRUE(has_row(rows, at)) << tip;
      const auto reaches = [&](const Vector& joints) {
        const Pose<double> there = Limb::pose(joints);
        return linear_distance(there, pose) < 1e-9 &&
               (Limb::size < 6 || angular_distance(there, pose) < 1e-7);
      };
      for (const auto& row : rows) {
        EXPECT_TRUE(reaches(row.q)) << tip;
        EXPECT_LE(row.q.cwiseAbs().maxCoeff(), M_PI);
      }
      const auto seeded = Limb::rows(pose, at);
      EXPECT_EQ(seeded.size(), rows.size());
      EXPECT_TRUE(seeded[0].q.isApprox(at, 1e-6)) << tip;
      const auto near = Limb::near(pose, Vector(at + Vector::Constant(0.01)));
      ASSERT_FALSE(near.empty()) << tip;
      EXPECT_TRUE(reaches(near[0].q)) << tip;
      const bool is_apart = std::none_of(rows.begin(), rows.end(), [&](const auto& row) {
        const double distance = (row.q - seeded[0].q).norm();
        return distance > 1e-6 && distance < 0.2;
      });
      EXPECT_TRUE(!is_apart || near[0].q.isApprox(at, 1e-6)) << tip;
    });
  }
}

TEST_F(Images, RowsWithinLimitsAreThoseOfAllRows) {
  for (int k = 0; k < 100; ++k) {
    const VectorXd q = random_joints();
    for_each_limb([&](std::size_t tip, auto limb) {
      using Limb = decltype(limb);
      const typename Limb::Vector at = values_of(Limb::joints, Eigen::Matrix<double, dof, 1>(q));
      const Pose<double> pose = pose_of(tip, q);
      const auto limits = Limb::limits();
      const auto inside = Limb::rows(pose, limits);
      const auto expected = within_limits(Limb::rows(pose), limits, Limb::revolute);
      EXPECT_EQ(inside.size(), expected.size()) << tip;
      for (const auto& row : inside) {
        EXPECT_TRUE((row.q.array() >= limits.lower.array()).all()) << tip;
        EXPECT_TRUE((row.q.array() <= limits.upper.array()).all()) << tip;
        EXPECT_TRUE(has_row(expected, row.q)) << tip;
      }
      const auto nearest = nearest_within_limits(Limb::rows(pose, at), limits, Limb::revolute, at);
      const auto seeded = Limb::rows(pose, at, limits);
      ASSERT_EQ(seeded.size(), nearest.size()) << tip;
      for (int i = 0; i < seeded.size(); ++i) EXPECT_TRUE(seeded[i].q.isApprox(nearest[i].q, 1e-6)) << tip;
    });
  }
}

TEST(ImagesOfLimbs, HaveTheHostileAnswersOfTheOther) {
  const double nan = std::nan("");
  EXPECT_EQ(limbs::rf::inverse_kinematics(Eigen::Vector3d(nan, 0, 0)).status, Status::invalid);
  EXPECT_EQ(limbs::right::inverse_kinematics(
                Pose<double>{Eigen::Quaterniond(nan, 0, 0, 0), Eigen::Vector3d(0, 0, 0)})
                .status,
            Status::invalid);
  EXPECT_EQ(
      limbs::right::inverse_kinematics(Pose<double>{Eigen::Quaterniond::Identity(), Eigen::Vector3d(9, 0, 0)})
          .status,
      Status::unreachable);
  // A half turn stays in (-pi, pi].
  limbs::right::JointVector<double> q;
  q << M_PI, 0.3, -0.4, M_PI, 0.5, 0.6;
  for (const auto& row : limbs::right::inverse_kinematics(limbs::right::forward_kinematics(q)))
    EXPECT_GT(row.q.minCoeff(), -M_PI);
}

}  // namespace
}  // namespace qvgen::test
