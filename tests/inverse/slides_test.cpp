// SPDX-License-Identifier: MIT
// Blocks for slides that the pose may leave free.
#include <cmath>

#include <gtest/gtest.h>
#include <qvgen/inverse/slide_and_turn.h>

#include "random.h"

namespace {

using namespace qvgen::inverse;
using qvgen::test::Random;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Boundary plain = Boundary::plain(default_tolerance);
constexpr Boundary careful = Boundary::careful(default_tolerance);

Rotor<double> turn(double angle) { return {std::cos(angle), std::sin(angle)}; }

constexpr double arm_noise = 256 * eps * eps;  ///< of an arm of 1 m

double on_line(const Rotor<double>& along, const Rotor<double>& rhs, double choice, const Boundary& boundary,
               Branch<double>& branch) {
  return slide_on_line<double>(along, rhs, arm_noise, choice, boundary, branch);
}

TEST(SlideOnLine, DividesWhereItCan) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Rotor<double> along{random(), random()};
    const double t = random(-3, 3);
    Branch<double> branch;
    EXPECT_NEAR(on_line(along, t * along, 7, plain, branch), t, 1e-14);
    EXPECT_TRUE(branch.exists && !branch.continuum);
    const double square = along.cosine * along.cosine + along.sine * along.sine;
    EXPECT_EQ(branch.doubtful, square <= 1e-4);
  }
}

TEST(SlideOnLine, IsFreeWhereBothSidesVanish) {
  for (const Boundary& boundary : {plain, careful}) {
    Branch<double> branch;
    EXPECT_EQ(on_line({1e-15, -2e-15}, {-3e-15, 1e-15}, 7, boundary, branch), 7);
    EXPECT_TRUE(branch.exists && branch.continuum && branch.doubtful);
  }
  // One side only: out of reach, by more than a careful pass may make good.
  Branch<double> branch;
  on_line({1e-15, 0}, {1e-5, 0}, 7, careful, branch);
  EXPECT_FALSE(branch.exists);
}

/// A divisor of 1e-13: the quotient is known to 16 eps / 1e-13 = 0.036.
TEST(SlideOnLine, FollowsTheChoiceAsFarAsRoundingAllows) {
  const double width = 16 * eps / 1e-13;
  for (const auto& [choice, expected] :
       {std::pair{0.51, 0.51}, std::pair{2.0, 0.5 + width}, std::pair{-2.0, 0.5 - width}}) {
    Branch<double> branch;
    EXPECT_NEAR(on_line({1e-13, 0}, {0.5e-13, 0}, choice, careful, branch), expected, 1e-12);
    EXPECT_TRUE(branch.exists && branch.continuum && branch.doubtful);
  }
  // A pass that chooses takes what is next to nothing for nothing.
  Branch<double> branch;
  EXPECT_EQ(on_line({1e-13, 0}, {0.5e-13, 0}, 2, Boundary::choosing(default_tolerance), branch), 2);
  EXPECT_TRUE(branch.exists && branch.continuum);
}

TEST(SlideBeside, FindsOneOfTwo) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Rotor<double> along = turn(random(-3, 3)), other = turn(random(-3, 3));
    const double sine = along.cosine * other.sine - along.sine * other.cosine;
    if (std::abs(sine) < 0.01) continue;
    const double t = random(-3, 3), s = random(-3, 3);
    const Rotor<double> rhs{t * along.cosine + s * other.cosine, t * along.sine + s * other.sine};
    Branch<double> branch;
    EXPECT_NEAR(slide_beside<double>(along, other, rhs, arm_noise, 7, plain, branch), t, 1e-12);
    EXPECT_TRUE(branch.exists && !branch.doubtful && !branch.continuum);
  }
}

/// Beside one that does not move in the plane a slide is told by both components; beside one that moves as it
/// does it is free.
TEST(SlideBeside, KnowsWhereTheOtherOneVanishesAndWhereItIsParallel) {
  Branch<double> alone;
  EXPECT_NEAR(slide_beside<double>({0.6, 0.8}, {1e-16, 0}, {1.2, 1.6}, arm_noise, 7, careful, alone), 2,
              1e-14);
  EXPECT_TRUE(alone.exists && !alone.continuum);
  Branch<double> parallel;
  EXPECT_EQ(slide_beside<double>({0.6, 0.8}, {0.3, 0.4}, {1.2, 1.6}, arm_noise, 7, careful, parallel), 7);
  EXPECT_TRUE(parallel.exists && parallel.continuum && parallel.doubtful);
  Branch<double> apart;
  slide_beside<double>({0.6, 0.8}, {0.3, 0.4}, {1.2, -1.6}, arm_noise, 7, careful, apart);
  EXPECT_FALSE(apart.exists);
}

double square_at(const Rotor<double>& point, const Rotor<double>& along, double t) {
  const double x = point.cosine + t * along.cosine;
  const double y = point.sine + t * along.sine;
  return x * x + y * y;
}

TEST(FreeSlide, StaysWithinReachOfTheNextJoint) {
  Random random;
  const Rotor<double> preferred{1, 0};
  for (int i = 0; i < 1000; ++i) {
    const Rotor<double> point{random(), random()};
    const Rotor<double> along = turn(random(-3, 3));
    const double wanted = random(-5, 5);
    const double foot = square_at(point, along, -(point.cosine * along.cosine + point.sine * along.sine));
    const double inner = random(0, 3);
    const double outer = std::max(inner, foot) + random(0, 3);
    const double between = slide_between(point, along, inner, outer, wanted, preferred);
    const double beyond = slide_beyond(point, along, inner, 1.0, wanted, preferred);
    EXPECT_GE(square_at(point, along, between), inner - 1e-13);
    EXPECT_LE(square_at(point, along, between), outer + 1e-13);
    EXPECT_GE(square_at(point, along, beyond), inner - 1e-13);
    // A slide within reach is taken; else an end of the reach.
    const double square = square_at(point, along, wanted);
    const double end = square < inner ? inner : outer;
    const bool in_reach = square >= inner && square <= outer;
    EXPECT_NEAR(square_at(point, along, beyond), std::max(square, inner), 1e-13 * (1 + square));
    EXPECT_NEAR(square_at(point, along, between), in_reach ? square : end, 1e-13);
    if (in_reach) {
      EXPECT_NEAR(between, wanted, 1e-14);
      EXPECT_NEAR(beyond, wanted, 1e-14);
    }
  }
}

TEST(FreeSlide, IsSpreadOverTheReach) {
  const Rotor<double> point{0.2, 0.5};
  const Rotor<double> along{0, 1};
  for (int k = 1; k < 16; ++k) {
    const Rotor<double> spread = turn(k * pi<double>() / 16);
    // The line passes the origin 0.2 beside it: 1² - 0.2² and 2² - 0.2² are the squares of the ends'
    // distances from its foot.
    const double least = std::sqrt(0.96);
    const double most = std::sqrt(3.96);
    const double off = 0.5 + slide_between(point, along, 1.0, 4.0, 77.0, spread);
    EXPECT_NEAR(std::abs(off), least + std::abs(spread.cosine) * (most - least), 1e-14);
    EXPECT_NEAR(0.5 + slide_beyond(point, along, 0.0, 9.0, 77.0, spread), 3 * spread.cosine / spread.sine,
                1e-13);
  }
}

TEST(QuadraticRoot, BothRootsToRounding) {
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const double s = std::pow(10, random(-6, 2)) * (random() < 0 ? -1 : 1);
    const double t = std::pow(10, random(-6, 2)) * (random() < 0 ? -1 : 1);
    const double a = random(0.2, 2);
    if (std::abs(s - t) < 1e-3 * std::abs(s)) continue;
    for (const double sign : {1.0, -1.0}) {
      Branch<double> branch;
      const double found =
          quadratic_root<double>(a, -a * (s + t) / 2, a * s * t, 1e-60, 1.0, sign, plain, branch);
      const double expected = sign > 0 ? std::max(s, t) : std::min(s, t);
      ASSERT_TRUE(branch.exists);
      ASSERT_NEAR(found, expected, 1e-11 * std::abs(expected));
    }
  }
}

TEST(QuadraticRoot, LosesOneRootAtInfinity) {
  // -2e-16 t² + 2 t + 1 = 0
  Branch<double> near, far;
  EXPECT_NEAR(quadratic_root<double>(-2e-16, 1, 1, arm_noise, 1.0, 1.0, careful, near), -0.5, 1e-15);
  quadratic_root<double>(-2e-16, 1, 1, arm_noise, 1.0, -1.0, careful, far);
  EXPECT_TRUE(near.exists);
  EXPECT_FALSE(far.exists);
  Branch<double> linear;
  EXPECT_EQ(quadratic_root<double>(0, -2, 1, arm_noise, 1.0, 0.0, careful, linear), 0.25);
  EXPECT_TRUE(linear.exists);
}

/// Returns the residual of the two equations of two_slides.
double left_over(const Rotor<double>& ab, double k, const Rotor<double>& gf, double gap,
                 const Rotor<double>& st) {
  const double s = st.cosine, t = st.sine;
  return std::abs(ab.cosine * s - ab.sine * t - k) +
         std::abs(s * (s + 2 * gf.cosine) - t * (t + 2 * gf.sine) + gap);
}

struct SlidesAt {
  Rotor<double> ab, st, gf;
  [[nodiscard]] double k() const { return ab.cosine * st.cosine - ab.sine * st.sine; }
  [[nodiscard]] double gap() const {
    return st.sine * (st.sine + 2 * gf.sine) - st.cosine * (st.cosine + 2 * gf.cosine);
  }
  Rotor<double> solve(double choice, double sign, const Boundary& boundary, Branch<double>& branch) const {
    return two_slides<double>(ab, k(), gf, gap(), arm_noise, 1.0, choice, {1, 0}, sign, boundary, branch);
  }
};

TEST(TwoSlides, BothSolutions) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const SlidesAt at{{random(), random()}, {random(), random()}, {random(), random()}};
    double closest = 1;
    for (const double sign : {1.0, -1.0}) {
      Branch<double> branch;
      const Rotor<double> found = at.solve(7, sign, plain, branch);
      if (!branch.exists) continue;
      EXPECT_FALSE(branch.continuum);
      const double size = 1 + found.cosine * found.cosine + found.sine * found.sine;
      EXPECT_TRUE(branch.doubtful || left_over(at.ab, at.k(), at.gf, at.gap(), found) < 1e-13 * size);
      closest = std::min(closest, std::hypot(found.cosine - at.st.cosine, found.sine - at.st.sine));
    }
    EXPECT_LT(closest, 1e-6);
  }
}

TEST(TwoSlides, OneIsFreeWhereBothLieAcross) {
  const SlidesAt at{{0, 0}, {0.2, 0.5}, {0.1, -0.3}};
  for (const double sign : {1.0, -1.0}) {
    Branch<double> branch;
    const Rotor<double> found = at.solve(0.7, sign, careful, branch);
    EXPECT_TRUE(branch.exists && branch.continuum);
    EXPECT_EQ(found.cosine, 0.7);
    EXPECT_LT(left_over(at.ab, at.k(), at.gf, at.gap(), found), 1e-15);
  }
  // The second slide cannot follow to (s + 0.1)² < 0.05, where its own square would be negative.
  Branch<double> branch;
  EXPECT_NEAR(at.solve(0, 1.0, careful, branch).cosine, std::sqrt(0.05) - 0.1, 1e-12);
}

/// Equations that (slide, turn) solves.
SlideAndTurn<double> equations(double divisor, const Rotor<double>& l, const Rotor<double>& m, double h,
                               double slide, const Rotor<double>& u) {
  return {divisor,
          h,
          divisor * slide - l.cosine * u.cosine - l.sine * u.sine,
          l,
          -slide * (slide + 2 * h) - m.cosine * u.cosine - m.sine * u.sine,
          m};
}

double left_over(const SlideAndTurn<double>& e, const SlideTurn<double>& found) {
  const Rotor<double>& u = found.turn;
  return std::abs(e.divisor * found.slide - e.level - e.l.cosine * u.cosine - e.l.sine * u.sine) +
         std::abs(found.slide * (found.slide + 2 * e.h) + e.mean + e.m.cosine * u.cosine + e.m.sine * u.sine);
}

SlideTurns<double> solved(const SlideAndTurn<double>& e, double choice = 7) {
  return slide_and_turn<double>(e, arm_noise, 1.0, choice, {1, 0}, careful, pi<double>());
}

TEST(SlideAndTurn, FindsWhatItWasMadeFrom) {
  Random random;
  for (const double divisor : {0.7, -0.1, 1e-3, 1e-5, 1e-8, 1e-12, 0.0}) {
    for (int i = 0; i < 300; ++i) {
      const Rotor<double> u = turn(random(-3, 3));
      const double slide = random();
      const auto e = equations(divisor, {random(), random()}, {random(), random()}, random(), slide, u);
      const auto found = solved(e);
      double closest = 1;
      for (int k = 0; k < found.count; ++k) {
        const auto& root = found.root[static_cast<std::size_t>(k)];
        EXPECT_FALSE(root.chosen);
        closest = std::min(closest, std::abs(root.slide - slide) + std::abs(root.turn.cosine - u.cosine) +
                                        std::abs(root.turn.sine - u.sine));
      }
      // Starts for Newton's steps.
      EXPECT_LT(closest, 2e-2) << divisor;
    }
  }
}

/// Two solutions for each turn, and two turns: none is lost where the divisor vanishes.
TEST(SlideAndTurn, KeepsFourWhereTheDivisorVanishes) {
  for (const double divisor : {1e-2, 1e-4, 2e-6, 1e-7, 1e-12, 0.0}) {
    const auto found = solved({divisor, 0.3, 0.1, {0.8, 0.2}, -0.5, {0.1, 0.2}});
    EXPECT_EQ(found.count, 4) << divisor;
    for (int k = 0; k < found.count; ++k)
      EXPECT_LT(left_over({divisor, 0.3, 0.1, {0.8, 0.2}, -0.5, {0.1, 0.2}},
                          found.root[static_cast<std::size_t>(k)]),
                1e-3)
          << divisor;
  }
}

TEST(SlideAndTurn, TheSlideIsChosenWithinReachWhereItIsFree) {
  const auto e = equations(0, {0, 0}, {0.3, 0.4}, 0.2, 0.1, turn(1));
  for (const double choice : {0.1, 5.0, -5.0}) {
    const auto found = solved(e, choice);
    EXPECT_EQ(found.count, 2);
    for (int k = 0; k < found.count; ++k) {
      const auto& root = found.root[static_cast<std::size_t>(k)];
      EXPECT_TRUE(root.chosen);
      EXPECT_LT(left_over(e, root), 1e-14);
      EXPECT_TRUE(choice != 0.1 || std::abs(root.slide - choice) < 1e-15);
    }
  }
}

}  // namespace
