// SPDX-License-Identifier: MIT
// Wrists that are spherical but for an offset, from a nanometre to a centimetre: one law for all sizes.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "arms.h"

namespace qvgen::test {
namespace {

enum class Place { axis_4, axis_5, along_axis_5, axis_6 };

Arm nearly_spherical(Place place, double by) {
  const auto at = [&](Place here) { return place == here ? by : 0.0; };
  Arm arm = of_table("nearly_spherical", {{0.78, 0.32, -90},
                                          {0, 1.075, 0},
                                          {0, 0.2, -90},
                                          {1.1425, at(Place::axis_4), 90},
                                          {at(Place::along_axis_5), at(Place::axis_5), -90},
                                          {0.2, 0, 0}});
  // Beside right angles, axis 6 in two ways off.
  if (place == Place::axis_6) arm.links[4].translation() = Eigen::Vector3d(by, by / 2, -by / 3);
  return arm;
}

struct Count {
  int poses = 0, told = 0, silent = 0, unreachable = 0;
};

void count(const Arm& arm, const inverse::elimination::Setup& setup, const Joints6& q, Count& sum) {
  const Eigen::Isometry3d target = arm.tool(q);
  const auto found = solve(setup, Pose<double>::from_isometry(target), instruction_sets[sum.poses % 3]);
  EXPECT_EQ(fault(arm, target, found), "");
  const bool told = found.status == Status::incomplete;
  // Next to a singular pose joints are known to few digits.
  constexpr double close = 1e-3;
  ++sum.poses;
  sum.told += told ? 1 : 0;
  sum.unreachable += found.status == Status::unreachable ? 1 : 0;
  sum.silent += told || found.status == Status::singular || contains(arm, found, q, close) ? 0 : 1;
}

template <class Draw>
Count count_all(const Draw& draw) {
  Count sum;
  for (const Place place : {Place::axis_4, Place::axis_5, Place::along_axis_5, Place::axis_6})
    for (const double by : {1e-9, 1e-8, 2.4e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
      const Arm arm = nearly_spherical(place, by);
      const auto setup = inverse::elimination::set_up(arm.description());
      EXPECT_GT(setup.count, 0) << by;
      Random random(77);
      for (int i = 0; i < 10; ++i)
        if (const std::optional<Joints6> q = draw(arm, random, i)) count(arm, setup, *q, sum);
    }
  std::printf("of %d poses %d are told to be incomplete, %d lack the sampled joints silently\n", sum.poses,
              sum.told, sum.silent);
  EXPECT_GT(sum.poses, 200);
  EXPECT_EQ(sum.unreachable, 0);
  return sum;
}

TEST(NearlySpherical, RandomPosesAreSolved) {
  const Count sum =
      count_all([](const Arm& arm, Random& random, int) { return std::optional(arm.joints(random)); });
  EXPECT_EQ(sum.silent, 0);
  EXPECT_LE(sum.told, sum.poses / 100);
}

TEST(NearlySpherical, SingularPosesAreSolvedOrTold) {
  const Count sum = count_all([](const Arm& arm, Random& random, int number) {
    std::optional<Joints6> q = at_a_singularity(arm, random, 1 + number % 4);
    if (q) (*q)[1 + number / 4 % 4] += number % 5 == 0 ? 0 : std::pow(10, uniform(random, -10, -2));
    return q;
  });
  EXPECT_LE(sum.silent, sum.poses / 50);
}

}  // namespace
}  // namespace qvgen::test
