// SPDX-License-Identifier: MIT
// Both signs of a fork side by side, in lanes and by compilers without them, against one sign after the
// other: the same bits and marks, next to the ends of ranges and at free angles too.
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/assembly.h>
#include <qvgen/detail/no_contraction.h>
#include <qvgen/inverse/both_signs.h>
#include <qvgen/inverse/roots.h>
#include <qvgen/inverse/two_numbers.h>

namespace qvgen::test::both_signs {
namespace {

using inverse::Branch;
using inverse::Rotor;

/// A circle about the origin and a distance from (x, y), and what is noise.
struct Circle {
  double x, y, radius, distance, tiny;
};

/// The two angles of a fork, the angle of a direction behind it, and the branch's marks.
template <class Scalar>
struct Found {
  Scalar angle, behind;
  Branch<Scalar> branch;
};

template <class Scalar>
Found<Scalar> solve(const Circle& c, const Scalar& sign) {
  using std::sqrt;
  Found<Scalar> found;
  const Scalar x(c.x), y(c.y), r(c.radius), d(c.distance);
  const Scalar centre = sqrt(Scalar(x * x + y * y));
  const Scalar low = (r + centre) * (r + centre) - d * d, high = d * d - (r - centre) * (r - centre);
  const Rotor<Scalar> turn =
      inverse::free_circle_angle<Scalar>(low, high, {-x, -y}, Scalar(c.tiny), {Scalar(1), Scalar(0)}, sign,
                                         inverse::boundary_of_loops(), found.branch);
  const Rotor<Scalar> way{x + r * turn.cosine, y + r * turn.sine};
  const Rotor<Scalar> towards =
      inverse::direction<Scalar>(way, Scalar(c.tiny), {Scalar(0), Scalar(1)}, found.branch);
  found.angle = inverse::output_angle(turn.cosine, turn.sine);
  found.behind = inverse::output_angle(towards.cosine, towards.sine);
  return found;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

template <class Scalar>
void expect_that_of_each_sign(const Circle& circle) {
  const Found<Scalar> both = solve<Scalar>(circle, Scalar(1, -1));
  double angles[2], behind[2];
  both.angle.store(angles);
  both.behind.store(behind);
  for (unsigned k = 0; k < 2; ++k) {
    const Found<double> one = solve<double>(circle, k == 0 ? 1.0 : -1.0);
    const auto mark = [k](const inverse::Mask<Scalar>& mask) { return (bits(mask) >> k & 1U) != 0; };
    ASSERT_EQ(mark(both.branch.exists), one.branch.exists);
    if (!one.branch.exists) continue;  // the rest is of no use
    EXPECT_TRUE(same_bits(angles[k], one.angle)) << angles[k] << " " << one.angle;
    EXPECT_TRUE(same_bits(behind[k], one.behind)) << behind[k] << " " << one.behind;
    EXPECT_EQ(mark(both.branch.continuum), one.branch.continuum);
    EXPECT_EQ(mark(both.branch.unsure), one.branch.unsure);
    EXPECT_EQ(mark(both.branch.doubtful), one.branch.doubtful);
  }
}

void expect_same_bits(const Circle& circle) {
  expect_that_of_each_sign<inverse::BothSigns>(circle);
  expect_that_of_each_sign<inverse::TwoNumbers>(circle);
}

TEST(BothSigns, HaveTheBitsOfOneAfterTheOther) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1, 1), length(0.1, 1.5);
  for (int k = 0; k < 20000; ++k)
    expect_same_bits({place(random), place(random), length(random), length(random), 1e-29});
}

TEST(BothSigns, HaveThemWhereBothMeet) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> place(-1, 1), length(0.1, 0.5), power(-17, -3);
  for (int k = 0; k < 20000; ++k) {
    const double x = place(random), y = place(random), r = length(random), off = std::pow(10, power(random));
    const double farthest = std::hypot(x, y) + r, nearest = std::abs(std::hypot(x, y) - r);
    expect_same_bits({x, y, r, k % 2 == 0 ? farthest - off : nearest + off, 1e-29});
  }
}

TEST(BothSigns, HaveThemAtFreeAngles) {
  for (const double off : {0.0, 1e-17, 1e-15, 1e-14, 1e-10}) {
    expect_same_bits({off, 0, 0.3, 0.3, 1e-29});
    expect_same_bits({off, -off, 0.3, 0.3 + off, 1e-29});
    expect_same_bits({0.3, off, 0.3, off, 1e-29});  // the direction behind is free
  }
}

TEST(BothSigns, MarkBranches) {
  const Circle at_centre{0, 0, 0.3, 0.3, 1e-29}, apart{1, 0, 0.2, 0.3, 1e-29};
  EXPECT_TRUE(solve<double>(at_centre, 1.0).branch.continuum);
  EXPECT_FALSE(solve<double>(apart, 1.0).branch.exists);
  const auto both = solve<inverse::BothSigns>(at_centre, {1, -1});
  EXPECT_TRUE(inverse::of_sign(both.branch, 1).continuum);
  EXPECT_FALSE(any(solve<inverse::BothSigns>(apart, {1, -1}).branch.exists));
}

template <class Scalar>
void expect_regular_without_marks() {
  using Mark = inverse::Mask<Scalar> Branch<Scalar>::*;
  const Branch<double> around;
  const Branch<Scalar> plain;
  EXPECT_TRUE(inverse::are_regular(around, plain, plain));
  for (const Mark mark : {&Branch<Scalar>::exists, &Branch<Scalar>::continuum, &Branch<Scalar>::unsure})
    for (const bool first : {false, true}) {
      // The mark of one of both solutions is not that of a regular branch.
      Branch<Scalar> marked;
      const bool usual = mark == &Branch<Scalar>::exists;
      marked.*mark = Scalar(first == usual ? 0 : 1, first == usual ? 1 : 0) == Scalar(1);
      EXPECT_FALSE(inverse::are_regular(around, marked, plain));
      EXPECT_FALSE(inverse::are_regular(around, plain, marked));
    }
  for (const auto mark : {&Branch<double>::exists, &Branch<double>::continuum, &Branch<double>::unsure}) {
    Branch<double> marked;
    marked.*mark = !(marked.*mark);
    EXPECT_FALSE(inverse::are_regular(marked, plain));
  }
}

TEST(BothSigns, AreRegularWithoutMarks) {
  expect_regular_without_marks<inverse::BothSigns>();
  expect_regular_without_marks<inverse::TwoNumbers>();
}

TEST(BothSigns, AreFiniteIfAllValuesAre) {
  double two[2] = {1, -2}, four[4] = {1e300, -1e300, 0, 3};
  EXPECT_TRUE(inverse::are_finite(two, four));
  for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (double* value : {&two[0], &two[1], &four[0], &four[3]}) {
      const double before = *value;
      *value = wrong;
      EXPECT_FALSE(inverse::are_finite(two, four));
      *value = before;
    }
}

}  // namespace
}  // namespace qvgen::test::both_signs
