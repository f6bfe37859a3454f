// SPDX-License-Identifier: MIT
// Every solution satisfies the subproblem's equation, as Eigen turns vectors, and a search over the circle
// finds as many.
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <qvgen/paden_kahan.h>

namespace {

using Eigen::Vector3d;
using qvgen::FreeTurn;
using qvgen::Status;
using Axis = qvgen::TurnAxis<double>;

constexpr double pi = qvgen::pi<double>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int tries = 300;

class PadenKahan : public testing::Test {
 protected:
  std::mt19937_64 random{17};
  double within(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vector3d vector() { return {within(-1, 1), within(-1, 1), within(-1, 1)}; }
  Axis axis() { return {vector() * std::pow(10, within(-3, 3)), vector()}; }
};

Vector3d turned(const Axis& axis, double angle, const Vector3d& x) {
  return Eigen::AngleAxisd(angle, axis.direction.normalized()) * (x - axis.point) + axis.point;
}

/// How often f changes its sign around the circle.
int sign_changes(const std::function<double(double)>& f) {
  constexpr int steps = 2000;
  int changes = 0;
  for (int i = 0; i < steps; ++i)
    changes += (f(2 * pi * i / steps) < 0) != (f(2 * pi * (i + 1) / steps) < 0) ? 1 : 0;
  return changes;
}

TEST_F(PadenKahan, OneTurnsAPointOntoAPoint) {
  for (int i = 0; i < tries; ++i) {
    const Axis about = axis();
    const Vector3d from = vector();
    const double angle = within(-pi, pi);
    const auto found = qvgen::paden_kahan_1<double>(about, from, turned(about, angle, from));
    ASSERT_EQ(found.status, Status::solved);
    ASSERT_EQ(found.count, 1);
    ASSERT_NEAR(qvgen::angle_distance(found.rows[0][0], angle), 0, 1e-11);
    const auto missed = qvgen::paden_kahan_1<double>(about, from, vector());
    ASSERT_EQ(missed.status, Status::unreachable);
    ASSERT_EQ(missed.count, 0);
  }
}

TEST_F(PadenKahan, OneOfPointsOnTheAxis) {
  const Axis z{{0, 0, 2}, {1, 1, 0}};
  const auto found = qvgen::paden_kahan_1<double>(z, {1, 1, 3}, {1, 1, 3});
  EXPECT_EQ(found.status, Status::singular);
  EXPECT_EQ(found.free, FreeTurn::first);
  EXPECT_EQ(found.count, 1);
  EXPECT_EQ(qvgen::paden_kahan_1<double>(z, {1, 1, 3}, {1, 1, 4}).status, Status::unreachable);
  EXPECT_EQ(qvgen::paden_kahan_1<double>(z, {1, 1, 3}, {1, 2, 3}).status, Status::unreachable);
  EXPECT_EQ(qvgen::paden_kahan_1<double>(z, {1, 1, 0}, {1, 1, 0}).status, Status::singular);
}

TEST_F(PadenKahan, OneAtAHalfTurnGivesPlusPi) {
  const Axis z{{0, 0, 1}, {0, 0, 0}};
  EXPECT_EQ(qvgen::paden_kahan_1<double>(z, {1, 0, 0}, {-1, 0, 0}).rows[0][0], pi);
  EXPECT_EQ(qvgen::paden_kahan_1<double>(z, {1, 0, 0}, {-1, -0.0, 0}).rows[0][0], pi);
}

/// Checks a solution set of subproblem 2 and says how many solutions a search finds.
void judge_two(const Vector3d& first, const Vector3d& second, const Vector3d& point, const Vector3d& from,
               const Vector3d& to, bool same_length) {
  const auto found = qvgen::paden_kahan_2<double>(first, second, point, from, to);
  for (const auto& row : found) {
    const Vector3d reached = turned({first, point}, row[0], turned({second, point}, row[1], from));
    ASSERT_LT((reached - to).norm(), 1e-11);
  }
  // z on the circle of `to` about the first axis must have the height of `from` along the second.
  const int searched = sign_changes([&](double angle) {
    return second.normalized().dot(turned({first, point}, -angle, to) - from);
  });
  ASSERT_EQ(found.count, same_length ? searched : 0);
  ASSERT_EQ(found.status, found.count > 0 ? Status::solved : Status::unreachable);
  ASSERT_EQ(found.free, FreeTurn::none);
}

TEST_F(PadenKahan, TwoFindsAllPairs) {
  int unreachable = 0;
  for (int i = 0; i < tries; ++i) {
    const Axis one = axis();
    const Axis two{vector(), one.point};
    const Vector3d from = vector();
    judge_two(one.direction, two.direction, one.point, from,
              turned(one, within(-pi, pi), turned(two, within(-pi, pi), from)), true);
    // Anywhere at the right distance: sometimes out of reach.
    const Vector3d anywhere = one.point + (from - one.point).norm() * vector().normalized();
    judge_two(one.direction, two.direction, one.point, from, anywhere, true);
    unreachable +=
        qvgen::paden_kahan_2<double>(one.direction, two.direction, one.point, from, anywhere).count == 0;
    judge_two(one.direction, two.direction, one.point, from, vector(), false);
  }
  EXPECT_GT(unreachable, tries / 20);
  EXPECT_LT(unreachable, tries);
}

TEST_F(PadenKahan, TwoFindsTheAnglesItWasMadeOf) {
  for (int i = 0; i < tries; ++i) {
    const Axis one = axis();
    const Axis two{vector(), one.point};
    const Vector3d from = vector();
    const double first = within(-pi, pi);
    const double second = within(-pi, pi);
    const auto found = qvgen::paden_kahan_2<double>(one.direction, two.direction, one.point, from,
                                                    turned(one, first, turned(two, second, from)));
    double nearest = infinity;
    for (const auto& row : found)
      nearest =
          std::min(nearest, qvgen::angle_distance(row[0], first) + qvgen::angle_distance(row[1], second));
    ASSERT_LT(nearest, 1e-6);
  }
}

TEST_F(PadenKahan, TwoWhereBothSolutionsMeet) {
  // z is at its greatest height in the plane of both axes.
  const Vector3d x(1, 0, 0), z(0, 0, 1), o(0, 0, 0);
  const Vector3d from = Eigen::AngleAxisd(0.7, x) * Vector3d(0.6, 0, 0.8);
  const Vector3d to = Eigen::AngleAxisd(-1.1, z) * Vector3d(0.6, 0, 0.8);
  const auto found = qvgen::paden_kahan_2<double>(z, x, o, from, to);
  EXPECT_EQ(found.status, Status::solved);
  EXPECT_TRUE(found.touching);
  ASSERT_EQ(found.count, 1);
  EXPECT_NEAR(found.rows[0][0], -1.1, 1e-7);
  EXPECT_NEAR(found.rows[0][1], -0.7, 1e-7);
  const Vector3d beyond = Vector3d(0.6 + 1e-9, 0, 0).array() + Vector3d(0, 0, 0.8).array();
  EXPECT_EQ(qvgen::paden_kahan_2<double>(z, x, o, beyond.normalized(), to).status, Status::unreachable);
}

TEST_F(PadenKahan, TwoMarksWhatIsFree) {
  const Vector3d x(3, 0, 0), z(0, 0, 0.5), o(0, 0, 0);
  const auto on_first = qvgen::paden_kahan_2<double>(z, x, o, {0, 1, 0}, {0, 0, 1});
  EXPECT_EQ(on_first.status, Status::singular);
  EXPECT_EQ(on_first.free, FreeTurn::first);
  ASSERT_EQ(on_first.count, 1);
  EXPECT_NEAR(on_first.rows[0][1], pi / 2, 1e-15);
  const auto on_second = qvgen::paden_kahan_2<double>(z, x, o, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(on_second.free, FreeTurn::second);
  ASSERT_EQ(on_second.count, 1);
  EXPECT_NEAR(on_second.rows[0][0], pi / 2, 1e-15);
  EXPECT_EQ(qvgen::paden_kahan_2<double>(z, x, o, o, o).free, FreeTurn::both);
  EXPECT_EQ(qvgen::paden_kahan_2<double>(z, x, o, {1, 0, 0}, {0, 0, 1}).status, Status::unreachable);
}

TEST_F(PadenKahan, TwoAboutOneLine) {
  for (const double sense : {1.0, -1.0}) {
    for (int i = 0; i < tries; ++i) {
      const Axis about = axis();
      const Axis other{sense * 2 * about.direction, about.point};
      const Vector3d from = vector();
      const double first = within(-pi, pi), second = within(-pi, pi);
      const Vector3d to = turned(about, first, turned(other, second, from));
      const auto found =
          qvgen::paden_kahan_2<double>(about.direction, other.direction, about.point, from, to);
      ASSERT_EQ(found.status, Status::singular);
      ASSERT_EQ(found.free, sense > 0 ? FreeTurn::sum : FreeTurn::difference);
      ASSERT_EQ(found.count, 1);
      ASSERT_NEAR(qvgen::angle_distance(found.rows[0][0] + sense * found.rows[0][1], first + sense * second),
                  0, 1e-11);
      ASSERT_EQ(
          qvgen::paden_kahan_2<double>(about.direction, other.direction, about.point, from, vector()).status,
          Status::unreachable);
    }
  }
}

TEST_F(PadenKahan, ThreeFindsAllAngles) {
  int unreachable = 0;
  for (int i = 0; i < tries; ++i) {
    const Axis about = axis();
    const Vector3d from = vector(), to = vector();
    const double distance = within(0, 3);
    const auto found = qvgen::paden_kahan_3<double>(about, from, to, distance);
    for (const auto& row : found) ASSERT_NEAR((turned(about, row[0], from) - to).norm(), distance, 1e-12);
    ASSERT_EQ(found.count, sign_changes([&](double angle) {
                return (turned(about, angle, from) - to).norm() - distance;
              }));
    ASSERT_EQ(found.status, found.count > 0 ? Status::solved : Status::unreachable);
    unreachable += found.count == 0;
    const double angle = within(-pi, pi);
    const auto made = qvgen::paden_kahan_3<double>(about, from, to, (turned(about, angle, from) - to).norm());
    double nearest = infinity;
    for (const auto& row : made) nearest = std::min(nearest, qvgen::angle_distance(row[0], angle));
    ASSERT_LT(nearest, 1e-6);
  }
  EXPECT_GT(unreachable, tries / 20);
  EXPECT_LT(unreachable, tries);
}

TEST_F(PadenKahan, ThreeAtBothEndsOfReach) {
  const Axis z{{0, 0, 1}, {0, 0, 5}};
  const Vector3d from(2, 0, 0), to(0, 1, 0);
  const auto near = qvgen::paden_kahan_3<double>(z, from, to, 1.0);
  EXPECT_TRUE(near.touching);
  ASSERT_EQ(near.count, 1);
  EXPECT_NEAR(near.rows[0][0], pi / 2, 1e-15);
  const auto far = qvgen::paden_kahan_3<double>(z, from, to, 3.0);
  EXPECT_TRUE(far.touching);
  ASSERT_EQ(far.count, 1);
  EXPECT_NEAR(far.rows[0][0], -pi / 2, 1e-15);
  EXPECT_EQ(qvgen::paden_kahan_3<double>(z, from, to, 1 - 1e-9).status, Status::unreachable);
  EXPECT_EQ(qvgen::paden_kahan_3<double>(z, from, to, 3 + 1e-9).status, Status::unreachable);
  EXPECT_EQ(qvgen::paden_kahan_3<double>(z, from, to, 1 + 1e-9).count, 2);
}

TEST_F(PadenKahan, ThreeOfAPointOnTheAxis) {
  const Axis z{{0, 0, 1}, {0, 0, 0}};
  const auto found = qvgen::paden_kahan_3<double>(z, {0, 0, 1}, {1, 0, 1}, 1.0);
  EXPECT_EQ(found.status, Status::singular);
  EXPECT_EQ(found.free, FreeTurn::first);
  EXPECT_EQ(found.count, 1);
  EXPECT_EQ(qvgen::paden_kahan_3<double>(z, {0, 0, 1}, {1, 0, 1}, 2.0).status, Status::unreachable);
}

TEST_F(PadenKahan, AnyUnitOfLength) {
  for (const double unit : {1e-200, 1e-5, 1e200}) {
    const Axis about{{0, 0, unit}, {0, 0, 0}};
    const Vector3d x(unit, 0, 0), y(0, unit, 0);
    EXPECT_NEAR(qvgen::paden_kahan_1<double>(about, x, y).rows[0][0], pi / 2, 1e-15) << unit;
    EXPECT_EQ(qvgen::paden_kahan_2<double>({0, 0, unit}, {unit, 0, unit}, {0, 0, 0}, y, x).count, 2) << unit;
    EXPECT_EQ(qvgen::paden_kahan_3<double>(about, x, y, unit).count, 2) << unit;
  }
}

TEST_F(PadenKahan, AnswersWhatIsNoQuestion) {
  const Axis z{{0, 0, 1}, {0, 0, 0}};
  const Vector3d x(1, 0, 0), o(0, 0, 0);
  for (const double bad : {nan, infinity, -infinity}) {
    const Vector3d wrong(bad, 0, 0);
    EXPECT_EQ(qvgen::paden_kahan_1<double>({wrong, o}, x, x).status, Status::invalid);
    EXPECT_EQ(qvgen::paden_kahan_1<double>({z.direction, wrong}, x, x).status, Status::invalid);
    EXPECT_EQ(qvgen::paden_kahan_1<double>(z, wrong, x).status, Status::invalid);
    EXPECT_EQ(qvgen::paden_kahan_1<double>(z, x, wrong).status, Status::invalid);
    EXPECT_EQ(qvgen::paden_kahan_2<double>(wrong, x, o, x, x).status, Status::invalid);
    EXPECT_EQ(qvgen::paden_kahan_2<double>(x, wrong, o, x, x).status, Status::invalid);
    EXPECT_EQ(qvgen::paden_kahan_2<double>(x, z.direction, o, wrong, x).status, Status::invalid);
    EXPECT_EQ(qvgen::paden_kahan_3<double>(z, wrong, x, 1).status, Status::invalid);
    EXPECT_EQ(qvgen::paden_kahan_3<double>(z, x, x, bad).status, Status::invalid);
  }
  EXPECT_EQ(qvgen::paden_kahan_1<double>({o, o}, x, x).status, Status::invalid);
  EXPECT_EQ(qvgen::paden_kahan_2<double>(o, x, o, x, x).status, Status::invalid);
  EXPECT_EQ(qvgen::paden_kahan_3<double>(z, x, x, -1).status, Status::invalid);
  EXPECT_EQ(qvgen::paden_kahan_3<double>({o, o}, x, x, 1).status, Status::invalid);
}

TEST_F(PadenKahan, InFloatToo) {
  using Vector = Eigen::Vector3f;
  const Vector z(0, 0, 1), x(1, 0, 0), o(0, 0, 0);
  const Vector from(0.3F, 0.5F, 0.2F);
  const Vector to = Eigen::AngleAxisf(0.4F, z) * (Eigen::AngleAxisf(1.2F, x) * from);
  EXPECT_NEAR(qvgen::paden_kahan_1<float>({z, o}, {1, 0, 0}, {0, 1, 0}).rows[0][0], pi / 2, 1e-6);
  for (const auto& row : qvgen::paden_kahan_2<float>(z, x, o, from, to))
    EXPECT_LT((Eigen::AngleAxisf(row[0], z) * (Eigen::AngleAxisf(row[1], x) * from) - to).norm(), 1e-6F);
  EXPECT_EQ(qvgen::paden_kahan_2<float>(z, x, o, from, to).count, 2);
}

// The point between the turns as the Paden-Kahan document has it, z = alpha w4 + beta w5 + gamma w4 x w5.
TEST_F(PadenKahan, TheDocumentsPointBetweenTheTurns) {
  for (int i = 0; i < tries; ++i) {
    const Vector3d w4 = vector().normalized(), w5 = vector().normalized(), u = vector();
    const Vector3d v = Eigen::AngleAxisd(within(-pi, pi), w4) * (Eigen::AngleAxisd(within(-pi, pi), w5) * u);
    const double c = w4.dot(w5);
    const double determinant = c * c - 1;
    const auto satisfies = [&](double alpha, double beta) {
      const double square = u.squaredNorm() - alpha * alpha - beta * beta - 2 * alpha * beta * c;
      const double gamma = std::sqrt(std::max(square, 0.0)) / w4.cross(w5).norm();
      const Vector3d z = alpha * w4 + beta * w5 + gamma * w4.cross(w5);
      return std::abs(w4.dot(z - v)) < 1e-9 && std::abs(w5.dot(z - u)) < 1e-9 &&
             std::abs(z.norm() - u.norm()) < 1e-9;
    };
    // As printed: alpha with w4.u where w5.u belongs, beta with w5.v where w4.v belongs. gamma^2 is right.
    EXPECT_FALSE(
        satisfies((c * w4.dot(u) - w4.dot(v)) / determinant, (c * w5.dot(v) - w5.dot(u)) / determinant));
    ASSERT_TRUE(
        satisfies((c * w5.dot(u) - w4.dot(v)) / determinant, (c * w4.dot(v) - w5.dot(u)) / determinant));
  }
}

}  // namespace
