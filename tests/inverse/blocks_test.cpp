// SPDX-License-Identifier: MIT
// The building blocks of inverse kinematics by themselves.
#include <gtest/gtest.h>
#include <qvgen/assembly.h>
#include <qvgen/inverse/conic_circle.h>
#include <qvgen/inverse/roots.h>
#include <qvgen/inverse/wrist.h>

#include "random.h"

namespace {

using namespace qvgen::inverse;
using qvgen::test::Random;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Boundary plain = Boundary::plain(default_tolerance);
constexpr Boundary careful = Boundary::careful(default_tolerance);

Rotor<double> turn(double angle) { return {std::cos(angle), std::sin(angle)}; }

TEST(CircleAngle, SolvesALine) {
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const double amplitude = random(0.1, 3);
    const double angle = random(0, 3.14);
    const double d = amplitude * std::cos(angle);
    for (const double sign : {1.0, -1.0}) {
      Branch<double> branch;
      const Rotor<double> found =
          circle_angle(amplitude - d, amplitude + d, 0.5 / amplitude, sign, plain, branch);
      ASSERT_TRUE(branch.exists || branch.doubtful);
      // cos φ carries the rounding of d; near 0 and pi the angle magnifies it by 1/sin φ.
      if (branch.exists) {
        ASSERT_NEAR(std::atan2(found.sine, found.cosine), sign * angle,
                    8 * eps / std::max(std::sin(angle), 1e-7));
      }
    }
  }
}

TEST(CircleAngle, FlippedSignsMeanTheSame) {
  Branch<double> a;
  Branch<double> b;
  const auto x = circle_angle(0.3, 1.1, 1 / 1.4, 1.0, plain, a);
  const auto y = circle_angle(-0.3, -1.1, -1 / 1.4, 1.0, plain, b);
  EXPECT_TRUE(a.exists && b.exists);
  EXPECT_EQ(x.cosine, y.cosine);
  EXPECT_EQ(x.sine, y.sine);
}

struct Fate {
  bool exists, doubtful;
  bool operator==(const Fate& other) const { return exists == other.exists && doubtful == other.doubtful; }
};

Fate fate(double low, double high, const Boundary& boundary) {
  Branch<double> branch;
  circle_angle(low, high, 1 / (low + high), 1.0, boundary, branch);
  return {branch.exists, branch.doubtful};
}

TEST(CircleAngle, BoundaryOutsideAndNaN) {
  EXPECT_EQ(fate(0.5, 1.5, plain), (Fate{true, false}));
  EXPECT_EQ(fate(0.0, 2.0, plain), (Fate{true, true})) << "at the boundary rounding decides";
  EXPECT_EQ(fate(-1e-13, 2.0, plain), (Fate{false, true}));
  EXPECT_EQ(fate(-1e-9, 2.0, plain), (Fate{false, false})) << "a billionth is more than rounding";
  EXPECT_EQ(fate(2.0, 1e-9, plain), (Fate{true, true}));
  EXPECT_EQ(fate(-1e-3, 2.0, plain), (Fate{false, false}));
  EXPECT_EQ(fate(3.0, -1.0, plain), (Fate{false, false}));
  EXPECT_EQ(fate(0.0, 0.0, plain), (Fate{false, false}));
  EXPECT_EQ(fate(std::numeric_limits<double>::quiet_NaN(), 1.0, plain), (Fate{false, false}));
}

/// A nearly free direction of noise, and an equation that an earlier double root has moved far beyond it.
TEST(CircleAngle, NearSingularNearlyFreeAnglesAreTurns) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Rotor<double> from = random(1e-14, 1e-12) * turn(random(-3, 3));
    const double length = std::hypot(from.cosine, from.sine), rest = random(-1e-8, 1e-8);
    for (const double sign : {1.0, -1.0}) {
      Branch<double> branch;
      const Rotor<double> found =
          free_circle_angle(length - rest, length + rest, from, 1e-30, turn(1), sign, careful, branch);
      ASSERT_TRUE(branch.exists && branch.unsure);
      ASSERT_NEAR(std::hypot(found.cosine, found.sine), 1, 1e-9);
    }
  }
}

/// A root before the angle is of a square that should be zero and is rounding.
TEST(OutOfRange, IsNotToldWithinTheRootOfRounding) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double square = std::pow(10, random(-18, -14)), swing = square + random(-1, 1) * 1e-16;
    for (const double end : {0.0, 1.0})
      EXPECT_FALSE(is_out_of_range(end + (end - 0.5) * 2 * std::sqrt(square), swing, plain));
  }
  EXPECT_TRUE(is_out_of_range(1 + 1e-5, 1e-12, plain));
  EXPECT_TRUE(is_out_of_range(-1e-5, 1e-12, plain));
  EXPECT_TRUE(is_out_of_range(0.5, 1.1, plain));
}

TEST(CircleAngle, NearSingularWhatIsOutsideIsTakenToTheEnd) {
  EXPECT_TRUE(fate(-1e-4, 2.0, careful).exists);
  EXPECT_FALSE(fate(-1e-2, 2.0, careful).exists);
  Branch<double> branch;
  EXPECT_EQ(circle_angle(-1e-9, 2.0, 0.5, 1.0, careful, branch).sine, 0);
  EXPECT_TRUE(branch.unsure);
}

TEST(Branch, DoubtsStayButNotThoseOfOneBranch) {
  const Branch<double> fork;
  Branch<double> branch;
  circle_angle(0.0, 1.0, 1.0, 1.0, plain, branch);
  EXPECT_TRUE(branch.unsure);
  branch.resume(fork);
  EXPECT_TRUE(branch.doubtful && !branch.unsure);
}

/// Parallelograms and kites: both angles, their order and their marks are those of the circle with roots,
/// next to the ends too.
TEST(FoldingCircleAngle, IsTheCirclesOfSidesThatAreEqualInPairs) {
  Random random;
  for (const Boundary& boundary : {plain, qvgen::inverse::boundary_of_loops()})
    for (int i = 0; i < 20000; ++i) {
      const double side = random(0.1, 1.5), turned = random(0.1, 1.5), at = random(-3, 3);
      const double end = std::pow(10, random(-9, 0));
      const double by = at + (i % 3 == 0 ? end : i % 3 == 1 ? std::acos(-1) - end : random(-3, 3));
      const bool is_kite = (i & 1) != 0;  // the arm is as long as the constant side
      const double arm = is_kite ? side : turned, other = is_kite ? turned : side;
      const Rotor<double> straight = turn(is_kite ? at : by);
      const Rotor<double> from{side * std::cos(at) + turned * std::cos(by),
                               side * std::sin(at) + turned * std::sin(by)};
      const double length = std::hypot(from.cosine, from.sine);
      if (length < 1e-6) continue;
      const double near = (length - arm) * (length - arm), far = (length + arm) * (length + arm);
      const double sine = std::abs(from.cosine * straight.sine - from.sine * straight.cosine) / length;
      const double magnified = (side + turned) * (side + turned) / (std::max(sine, 1e-8) * length * arm);
      for (const double sign : {1.0, -1.0}) {
        Branch<double> branch, expected;
        const auto circle = free_circle_angle(other * other - near, far - other * other, from, 1e-28, turn(1),
                                              sign, boundary, expected);
        const auto found =
            folding_circle_angle(straight, from, arm * arm, 1e-28, turn(1), sign, boundary, branch);
        ASSERT_TRUE(branch.exists);
        ASSERT_EQ(branch.unsure, expected.unsure) << side << " " << turned << " " << at << " " << by;
        if (!expected.exists) continue;  // by rounding
        ASSERT_NEAR(found.cosine, circle.cosine, 4 * eps * magnified);
        ASSERT_NEAR(found.sine, circle.sine, 4 * eps * magnified);
      }
    }
}

TEST(FoldingCircleAngle, VanishingDirectionTakesTheChoice) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Branch<double> branch, invalid;
  const auto found = folding_circle_angle(turn(0.2), {0.0, 0.0}, 1.0, 1e-28, turn(0.7), -1.0, plain, branch);
  EXPECT_TRUE(branch.exists && branch.continuum);
  EXPECT_EQ(found.sine, -std::sin(0.7));
  folding_circle_angle(turn(0.2), {none, 0.0}, 1.0, 1e-28, turn(0.7), 1.0, plain, invalid);
  EXPECT_FALSE(invalid.exists);
}

TEST(FreeCircleAngle, VanishingDirectionTakesTheChoice) {
  Branch<double> branch;
  const Rotor<double> choice{std::cos(0.7), std::sin(0.7)};
  const auto plus = free_circle_angle(0.0, 0.0, {0.0, 0.0}, 1e-28, choice, 1.0, plain, branch);
  EXPECT_TRUE(branch.exists);
  EXPECT_TRUE(branch.continuum);
  EXPECT_EQ(plus.sine, choice.sine);
  Branch<double> impossible;
  free_circle_angle(-0.5, 0.5, {0.0, 0.0}, 1e-28, choice, 1.0, plain, impossible);
  EXPECT_TRUE(impossible.doubtful);
}

TEST(FactoredLineAngle, WhereAllButTheVectorVanishesItIsADirection) {
  // The vector is next to noise, and what it is compared with and the discriminant are rounded to zero.
  Branch<double> branch;
  const auto found = factored_line_angle(Rotor<double>{1e-10, 2e-10}, 0.0, 0.0, 0.8, 1e-29, {1, 0}, 1.0,
                                         Boundary::ends(1e-13), branch);
  EXPECT_TRUE(branch.exists);
  EXPECT_NEAR(std::hypot(found.cosine, found.sine), 1, 1e-15);
}

TEST(SignedRoot, KeepsSmallExactValuesAndDoubtsNoise) {
  Branch<double> exact;
  EXPECT_EQ(signed_root(1e-40, 0.0, 1e-60, -1.0, plain, exact), -1e-20);
  EXPECT_TRUE(exact.exists && !exact.doubtful);
  Branch<double> noise;
  EXPECT_EQ(signed_root(-1e-16, 1.0, 1e-60, 1.0, plain, noise), 0.0);
  EXPECT_TRUE(noise.doubtful);
  Branch<double> outside;
  signed_root(-1e-3, 1.0, 1e-60, 1.0, plain, outside);
  EXPECT_FALSE(outside.exists || outside.doubtful);
}

TEST(Span, MakesALengthGood) {
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const double angle = random(-3.14, 3.14);
    const double size = std::exp(random(-20, 20));
    const Rotor<double> v{size * std::cos(angle), size * std::sin(angle)};
    Branch<double> branch;
    double length;
    span_of_length(v, size * (1 + random(-1e-8, 1e-8)), 0.0, {brief_length, 0}, length, branch);
    ASSERT_NEAR(length / size, 1, 4 * eps);
    ASSERT_FALSE(branch.continuum);
  }
  Branch<double> branch;
  double length;
  EXPECT_EQ(span_of_length<double>({1e-20, 0}, 1e-20, 1e-30, {0, brief_length}, length, branch).sine,
            brief_length);
  EXPECT_EQ(length, brief_length);
  EXPECT_TRUE(branch.continuum);
}

TEST(Half, IsAccurateEverywhere) {
  for (double angle = -3.14159; angle < 3.14159; angle += 1e-3) {
    const auto found = half(Rotor<double>{std::cos(angle), std::sin(angle)});
    ASSERT_NEAR(found.cosine, std::cos(angle / 2), 4 * eps);
    ASSERT_NEAR(found.sine, std::sin(angle / 2), 4 * eps);
  }
}

TEST(Angles, StayInTheHalfOpenInterval) {
  EXPECT_GT(output_angle(-1.0, -0.0), 3.14);
  EXPECT_GT(output_angle(-1.0, -1e-30), 3.14);
  EXPECT_GT(opposite(0.0, pi<double>()), 3.14);
  EXPECT_EQ(opposite(pi<double>(), pi<double>()), 0.0);
  EXPECT_EQ(negative(pi<double>(), pi<double>()), pi<double>());
  EXPECT_GT(wrapped(-pi<double>(), pi<double>()), 3.14);
}

TEST(ConicCircle, FindsTheRootsAndNothingElse) {
  Random random;
  for (int i = 0; i < 20000; ++i) {
    const double angle = random(-3.14, 3.14);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Conic<double> conic{random(), random(), random(), random(), random(), 0};
    conic.one = -(conic.xx * c * c + conic.xy * c * s + conic.yy * s * s + conic.x * c + conic.y * s);
    const auto found = conic_circle(conic, careful, pi<double>());
    double nearest = 1;
    for (int k = 0; k < found.count; ++k) {
      const auto& u = found.root[static_cast<std::size_t>(k)];
      nearest = std::min(nearest, std::hypot(u.cosine - c, u.sine - s));
      const double value = conic.xx * u.cosine * u.cosine + conic.xy * u.cosine * u.sine +
                           conic.yy * u.sine * u.sine + conic.x * u.cosine + conic.y * u.sine + conic.one;
      ASSERT_LT(std::abs(value), 2e-14);
    }
    // Near a double root the angle is known to the root of the rounding only.
    ASSERT_LT(nearest, 1e-6);
  }
}

TEST(ConicCircle, AsManyRootsAsThereAreChangesOfSign) {
  Random random;
  for (int i = 0; i < 500; ++i) {
    const Conic<double> conic{random(), random(), random(), random(), random(), random()};
    const auto value = [&](double t) {
      return conic.xx * std::cos(t) * std::cos(t) + conic.xy * std::cos(t) * std::sin(t) +
             conic.yy * std::sin(t) * std::sin(t) + conic.x * std::cos(t) + conic.y * std::sin(t) + conic.one;
    };
    int changes = 0;
    constexpr int steps = 20000;
    for (int k = 0; k < steps; ++k)
      changes += (value(2 * pi<double>() * k / steps) < 0) != (value(2 * pi<double>() * (k + 1) / steps) < 0)
                     ? 1
                     : 0;
    ASSERT_EQ(conic_circle(conic, careful, pi<double>()).count, changes);
  }
}

TEST(ObliqueWrist, ItsTurnsAreItsAngles) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double a = random(0.1, 3) / 2, b = random(0.1, 3) / 2, delta = random(-3, 3), s = random(0, 1),
                 c = std::sqrt(1 - s * s);
    const WristShape<double> shape{std::cos(a + b), std::sin(a + b), std::cos(a - b), std::sin(b - a),
                                   std::sin(2 * a) * std::sin(2 * b)};
    const double u = std::hypot(shape.cosine_sum * c, shape.cosine_difference * s);
    const double v = std::hypot(shape.sine_difference * s, shape.sine_sum * c);
    const Rotor<double> along_u{std::cos(random(-3, 3)), 0.6}, along_v{0.3, random()};
    const Rotor<double> u11 = u / std::hypot(along_u.cosine, along_u.sine) * along_u;
    const Rotor<double> u12 = v / std::hypot(along_v.cosine, along_v.sine) * along_v;
    for (const double sign : {1.0, -1.0}) {
      Branch<double> branch, other;
      const auto angles = oblique_wrist(u11, u12, shape, sign, 0.0, plain, 3.14159265358979323846, branch);
      const auto turns = oblique_wrist_turns(u11, u12, shape, {std::cos(delta), std::sin(delta)}, {1, 0},
                                             sign, Boundary::plain(0), other);
      ASSERT_EQ(branch.exists, other.exists);
      ASSERT_EQ(branch.continuum, other.continuum);
      EXPECT_NEAR(std::remainder(angle(turns.first) - angles.first, 6.283185307179586), 0, 1e-14);
      EXPECT_NEAR(std::remainder(angle(turns.middle) - (angles.middle - delta), 6.283185307179586), 0, 1e-14);
      EXPECT_NEAR(std::remainder(angle(turns.last) - angles.last, 6.283185307179586), 0, 1e-14);
    }
  }
}

/// The conic that has these four angles on the unit circle: two lines, each through two of the points.
Conic<double> through(const std::array<double, 4>& angles) {
  const Rotor<double> m = turn((angles[0] + angles[1]) / 2), n = turn((angles[2] + angles[3]) / 2);
  const double d = std::cos((angles[0] - angles[1]) / 2), e = std::cos((angles[2] - angles[3]) / 2);
  return {m.cosine * n.cosine,
          m.cosine * n.sine + m.sine * n.cosine,
          m.sine * n.sine,
          -(d * n.cosine + e * m.cosine),
          -(d * n.sine + e * m.sine),
          d * e};
}

/// A double root with a simple one close beside it, where the extremum is flat: neither is taken for the
/// other.
TEST(ConicCircle, ADoubleRootNextToASimpleOne) {
  Random random;
  for (const double beside : {1e-2, 6e-3, 3e-3}) {
    for (int i = 0; i < 1000; ++i) {
      const double twice = random(-3, 3);
      const auto found = conic_circle(through({twice, twice, twice + beside, twice + random(0.1, 6)}),
                                      careful, pi<double>());
      const auto closest = [&](double wanted) {
        double least = 1;
        for (int k = 0; k < found.count; ++k) {
          const Rotor<double> off = found.root[static_cast<std::size_t>(k)] * inverse(turn(wanted));
          least = std::min(least, std::abs(angle(off)));
        }
        return least;
      };
      ASSERT_LT(closest(twice), 1e-5) << beside;
      ASSERT_LT(closest(twice + beside), 1e-8) << beside;
    }
  }
}

/// |(3, 0) + turned (1, 0)| may be between 2.5 and 3.5: some angle between what is too near and too far, not
/// at the ends.
TEST(ReachableDirection, IsTheChoiceOrWellInside) {
  const Rotor<double> point{3, 0}, offset{1, 0};
  const auto length = [&](double choice) {
    const auto u = reachable_direction(point, offset, 6.25, 12.25, turn(choice));
    return std::hypot(point.cosine + u.cosine, u.sine);
  };
  EXPECT_NEAR(length(1.6), std::hypot(3 + std::cos(1.6), std::sin(1.6)), 1e-15);
  for (const double choice : {0.0, 0.5, 2.9, -3.0}) {
    EXPECT_GT(length(choice), 2.55) << choice;
    EXPECT_LT(length(choice), 3.45) << choice;
  }
}

/// Angles between what is too near and too far are two ranges, mirror images; if nothing is too near or
/// nothing too far they are one.
TEST(ReachableDirection, IsInTheOtherRangeIfAskedFor) {
  const Rotor<double> point{3, 0}, offset{1, 0};
  const Boundary other = Boundary::chosen(default_tolerance).in_other_range();
  for (const double choice : {0.3, 1.6, 2.9, -0.4, -1.8}) {
    const auto one = reachable_direction(point, offset, 6.25, 12.25, turn(choice));
    const auto mirrored = reachable_direction(point, offset, 6.25, 12.25, turn(choice), other);
    EXPECT_NEAR(mirrored.cosine, one.cosine, 1e-15) << choice;
    EXPECT_NEAR(mirrored.sine, -one.sine, 1e-15) << choice;
    for (const auto& [inner, outer] : {std::pair{1.0, 12.25}, std::pair{6.25, 25.0}}) {
      const auto alone = reachable_direction(point, offset, inner, outer, turn(choice));
      const auto same = reachable_direction(point, offset, inner, outer, turn(choice), other);
      EXPECT_EQ(same.cosine, alone.cosine) << choice;
      EXPECT_EQ(same.sine, alone.sine) << choice;
    }
  }
}

}  // namespace
