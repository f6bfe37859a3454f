// SPDX-License-Identifier: MIT
// Inverse kinematics of C in float against that in double, which other tests hold to the C++ functions:
// accuracy, which solutions there are, and which poses are singular.
#include "float_inverse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

enum Status { solved, singular, unreachable, invalid, incomplete };

/// Bounds of the error of rows, in metres and radians: away from singular poses, and anywhere.
constexpr double close = 1e-5, anywhere = 1e-3;
/// Next to singular poses a wrist's angle that is nearly free is turned to the choice as far as noise allows:
/// at most 32 times its 18 epsilon, over sin(theta5/2), and two angles by each; the singular value is
/// theta5/sqrt(2).
constexpr double chosen = 2 * 32 * 18 * 1.4143 * std::numeric_limits<float>::epsilon();

template <class Pair>
class FloatInverse : public testing::Test {
 protected:
  using Double = typename Pair::InDouble;
  using Float = typename Pair::InFloat;
  static constexpr std::size_t dof = Double::dof;
  static constexpr int rows = dof > 3 ? 6 : 3;
  using Joints = std::array<double, dof>;
  using Small = std::array<float, dof>;

  Joints random_joints() {
    std::uniform_real_distribution<double> turn(-M_PI, M_PI);
    Joints q;
    for (double& each : q) each = turn(random_);
    return q;
  }
  static Small in_float(const Joints& q) {
    Small result;
    std::transform(q.begin(), q.end(), result.begin(), [](double each) { return static_cast<float>(each); });
    return result;
  }
  template <class Scalar>
  static Joints joints_of(const Scalar* q) {
    Joints result;
    std::copy(q, q + dof, result.begin());
    return result;
  }
  static Target<float> in_float(const Target<double>& pose) {
    Target<float> result;
    for (std::size_t i = 0; i < 4; ++i) result.orientation[i] = static_cast<float>(pose.orientation[i]);
    for (std::size_t i = 0; i < 3; ++i) result.position[i] = static_cast<float>(pose.position[i]);
    return result;
  }
  /// How far the tool of joints is from a pose: metres, and radians where these are asked for.
  static double miss(const Joints& q, const Target<double>& pose) {
    const Target<double> tool = Double::tool(q);
    double square = 0, dot = 0, turn = 0;
    for (std::size_t i = 0; i < 3; ++i) square += std::pow(tool.position[i] - pose.position[i], 2);
    if (rows == 3) return std::sqrt(square);
    for (std::size_t i = 0; i < 4; ++i) dot += tool.orientation[i] * pose.orientation[i];
    for (std::size_t i = 0; i < 4; ++i)
      turn += std::pow(tool.orientation[i] - std::copysign(1, dot) * pose.orientation[i], 2);
    return std::max(std::sqrt(square), 2 * std::sqrt(turn));
  }
  static double apart(const Joints& a, const Joints& b) {
    double most = 0;
    for (std::size_t i = 0; i < dof; ++i)
      most = std::max(most, std::abs(Double::turns(i) ? std::remainder(a[i] - b[i], 2 * M_PI) : a[i] - b[i]));
    return most;
  }
  /// The smallest singular value of what joints do to the tool, by differences.
  static double regularity(const Joints& q) {
    Eigen::Matrix<double, rows, static_cast<int>(dof)> jacobian;
    const double by = 1e-6;
    const Target<double> tool = Double::tool(q);
    const Eigen::Quaterniond at(tool.orientation[0], tool.orientation[1], tool.orientation[2],
                                tool.orientation[3]);
    for (std::size_t k = 0; k < dof; ++k) {
      Joints moved = q;
      moved[k] += by;
      const Target<double> there = Double::tool(moved);
      const Eigen::Quaterniond to(there.orientation[0], there.orientation[1], there.orientation[2],
                                  there.orientation[3]);
      const Eigen::Vector3d turn = 2 * (to * at.conjugate()).vec() * ((to.dot(at) < 0) ? -1 : 1);
      for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        jacobian(i, static_cast<int>(k)) = (there.position[axis] - tool.position[axis]) / by;
        if (rows == 6) jacobian(rows - 3 + i, static_cast<int>(k)) = turn[i] / by;
      }
    }
    return reference::smallest_singular_value(jacobian);
  }
  /// The least regularity of all solutions in double.
  static double least_regularity(const typename Double::Found& found) {
    double least = 1;
    for (int i = 0; i < found.count; ++i) least = std::min(least, regularity(joints_of(found.rows[i].q)));
    return least;
  }
  template <class Found>
  static double nearest(const Found& found, const Joints& q) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < found.count; ++i) least = std::min(least, apart(joints_of(found.rows[i].q), q));
    return least;
  }
  static bool has_mark(const typename Float::Found& found) {
    return std::any_of(found.rows, found.rows + found.count,
                       [](const auto& row) { return row.continuum != 0; });
  }

  std::mt19937 random_{7};
};

#if defined(QVGEN_ALL_ARMS)
using Arms = testing::Types<puma560_pair, ur5_pair, stanford_pair, nn_pair, rrr_pair>;
#else
using Arms = testing::Types<ur5_pair, stanford_pair, rrr_pair>;
#endif
TYPED_TEST_SUITE(FloatInverse, Arms);

/// Away from singular poses the solutions are those of double: each has a row, within what rounding of the
/// pose and of the steps makes of it, and there are no others.
TYPED_TEST(FloatInverse, HasTheSolutionsOfDouble) {
  int regular = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto q = this->random_joints();
    const auto pose = TestFixture::Double::tool(q);
    const auto expected = TestFixture::Double::all(pose);
    const auto found = TestFixture::Float::all(TestFixture::in_float(pose));
    const double least = TestFixture::least_regularity(expected);
    if (expected.status != solved || least < 0.02) continue;
    ++regular;
    EXPECT_EQ(found.status, solved) << least;
    EXPECT_EQ(found.count, expected.count) << least;
    for (int i = 0; i < expected.count; ++i) {
      const auto row = TestFixture::joints_of(expected.rows[i].q);
      EXPECT_LT(TestFixture::nearest(found, row), 4e-6 / least);
    }
    for (int i = 0; i < found.count; ++i)
      EXPECT_LT(TestFixture::miss(TestFixture::joints_of(found.rows[i].q), pose), close);
  }
  EXPECT_GT(regular, 400);
}

/// Near and at singular poses every row reaches the pose; the joints that led there are a row, or the pose is
/// marked or incomplete, or the pose leaves them open by more than rounding.
TYPED_TEST(FloatInverse, IsRightNextToSingularPoses) {
  std::uniform_real_distribution<double> digits(-8, 0);
  std::uniform_int_distribution<std::size_t> joint(1, TestFixture::dof - 1);
  for (int k = 0; k < 1000; ++k) {
    auto q = this->random_joints();
    q[joint(this->random_)] = k % 4 == 0 ? 0 : std::pow(10, digits(this->random_));
    const auto pose = TestFixture::Double::tool(q);
    const auto found = TestFixture::Float::all(TestFixture::in_float(pose));
    EXPECT_TRUE(found.status == solved || found.status == singular || found.status == incomplete);
    for (int i = 0; i < found.count; ++i)
      EXPECT_LT(TestFixture::miss(TestFixture::joints_of(found.rows[i].q), pose), anywhere);
    const double regular = TestFixture::regularity(q);
    if (found.status == solved && regular > 1e-3) {
      EXPECT_LT(TestFixture::nearest(found, q), chosen / regular);
    }
  }
}

/// Poses that are singular in double are so in float, and have marked rows.
TYPED_TEST(FloatInverse, MarksSingularPoses) {
  std::uniform_int_distribution<int> quarter(-1, 2);
  int marked = 0;
  for (int k = 0; k < 1000; ++k) {
    auto q = this->random_joints();
    for (std::size_t i = k % 3; i < TestFixture::dof; i += 1 + k % 2)
      q[i] = quarter(this->random_) * M_PI / 2;
    const auto pose = TestFixture::Double::tool(q);
    const auto expected = TestFixture::Double::all(pose);
    const auto found = TestFixture::Float::all(TestFixture::in_float(pose));
    EXPECT_NE(found.status, invalid);
    EXPECT_NE(found.status, unreachable);
    if (expected.status != singular) continue;
    ++marked;
    EXPECT_TRUE(found.status == singular || found.status == incomplete);
    EXPECT_TRUE(found.status == incomplete || TestFixture::has_mark(found));
  }
  if (TestFixture::dof > 3) {  // a wrist
    EXPECT_GT(marked, 50);
  }
}

TYPED_TEST(FloatInverse, FollowsTheSeed) {
  std::uniform_real_distribution<double> step(-0.01, 0.01);
  int regular = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto q = this->random_joints();
    auto before = q;
    for (double& each : before) each += step(this->random_);
    const auto pose = TestFixture::Double::tool(q);
    const auto found = TestFixture::Float::near(TestFixture::in_float(pose), TestFixture::in_float(before));
    ASSERT_EQ(found.count, 1);
    EXPECT_LT(TestFixture::miss(TestFixture::joints_of(found.rows[0].q), pose), anywhere);
    const double least = TestFixture::regularity(q);
    if (least < 0.05) continue;
    ++regular;
    EXPECT_LT(TestFixture::nearest(found, q), 4e-6 / least);
  }
  EXPECT_GT(regular, 300);
}

/// Rows within limits are inside, next to the seed first, and as many as in double.
TYPED_TEST(FloatInverse, KeepsLimits) {
  int several = 0;
  for (int k = 0; k < 500; ++k) {
    const auto q = this->random_joints(), seed = this->random_joints();
    typename TestFixture::Joints lower, upper;
    for (std::size_t i = 0; i < TestFixture::dof; ++i) {
      lower[i] = q[i] - 2;
      upper[i] = q[i] + 5;
    }
    const auto pose = TestFixture::Double::tool(q);
    const auto expected = TestFixture::Double::within(pose, seed, lower, upper);
    const auto found = TestFixture::Float::within(TestFixture::in_float(pose), TestFixture::in_float(seed),
                                                  TestFixture::in_float(lower), TestFixture::in_float(upper));
    for (int i = 0; i < found.count; ++i)
      for (std::size_t j = 0; j < TestFixture::dof; ++j) {
        EXPECT_GE(found.rows[i].q[j], TestFixture::in_float(lower)[j]);
        EXPECT_LE(found.rows[i].q[j], TestFixture::in_float(upper)[j]);
      }
    if (TestFixture::least_regularity(TestFixture::Double::all(pose)) < 0.02) continue;
    EXPECT_GE(found.count, 1);
    EXPECT_LE(std::abs(found.count - expected.count), 1);  // a row may stand on a limit
    several += found.count > 1 ? 1 : 0;
  }
  EXPECT_GT(several, 20);
}

TYPED_TEST(FloatInverse, OddPosesAreAnswered) {
  const auto q = this->random_joints();
  auto far = TestFixture::in_float(TestFixture::Double::tool(q));
  far.position = {100, 50, -70};
  if (!TestFixture::Double::turns(2)) return;  // a slide without end reaches everything
  EXPECT_EQ(TestFixture::Float::all(far).status, unreachable);
  far.position[0] = 3e38F;
  const auto beyond = TestFixture::Float::all(far);
  EXPECT_TRUE(beyond.status == unreachable || beyond.status == invalid);
  far.position[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(TestFixture::Float::all(far).status, invalid);
  far.position[0] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(TestFixture::Float::all(far).status, invalid);
}

}  // namespace
}  // namespace qvgen::test
