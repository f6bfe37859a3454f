// SPDX-License-Identifier: MIT
// No joints are missing silently: between right angles, next to them and next to singularities the sampled
// joints are a row, a marked row stands for them, or the status says that some may be missing.
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include <gtest/gtest.h>

#include "check.h"
#include "curves.h"

namespace qvgen::test {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Count {
  int poses = 0, told = 0, silent = 0;
};

/// Size of 10^-u, u in [1, 12], either sign.
double nearly_zero(Random& random) {
  return std::pow(10, uniform(random, -12, -1)) * (random() % 2 == 0 ? 1 : -1);
}

/// All joints at multiples of 45 degrees, or of 90.
Joints6 on_a_lattice(const Arm& arm, Random& random, int number) {
  const double unit = pi / 4 * (1 + number % 2);
  Joints6 q = arm.joints(random);
  for (double& value : q) value = unit * std::round(value / unit);
  return q;
}

/// One joint next to such a place, or all of them.
Joints6 next_to_a_lattice(const Arm& arm, Random& random, int number) {
  Joints6 q = on_a_lattice(arm, random, number);
  if (number / 2 % 2 == 1) {
    q[number / 4 % 6] += nearly_zero(random);
  } else {
    const double size = nearly_zero(random);
    for (double& value : q) value += size * uniform(random);
  }
  return q;
}

/// One joint or two at a multiple of 90 degrees, or next to it.
Joints6 with_right_angles(const Arm& arm, Random& random, int number) {
  Joints6 q = arm.joints(random);
  const int one = number % 6, other = (one + 1 + static_cast<int>(random() % 5)) % 6;
  const auto right = [&](int joint) { return pi / 2 * std::round(q[joint] / (pi / 2)); };
  q[one] = right(one) + (number / 6 % 2 == 1 ? nearly_zero(random) : 0);
  if (number / 12 % 2 == 1) q[other] = right(other);
  return q;
}

class SilentPoses : public testing::TestWithParam<Arm> {
 protected:
  /// `draw(random, i)`: joints, or none.
  template <class Draw>
  Count expect_none(const char* name, const Draw& draw) {
    const Arm& arm = GetParam();
    const auto setup = inverse::elimination::set_up(arm.description());
    Random random(41);
    Count count;
    for (int i = 0; i < pose_count(100); ++i) {
      const std::optional<Joints6> q = draw(random, i);
      if (!q) continue;
      const auto found = solve(setup, Pose<double>::from_isometry(arm.tool(*q)), instruction_sets[i % 3]);
      const bool told = found.status == Status::incomplete;
      ++count.poses;
      count.told += told ? 1 : 0;
      count.silent += told || is_covered(arm, setup, found, *q) ? 0 : 1;
    }
    std::printf("%s, %s: of %d poses %d are told to be incomplete, %d lack the sampled joints silently\n",
                arm.name.c_str(), name, count.poses, count.told, count.silent);
    EXPECT_LE(count.silent, count.poses / 2000);
    return count;
  }
};

TEST_P(SilentPoses, OnALattice) {
  expect_none("lattice",
              [this](Random& random, int i) { return std::optional(on_a_lattice(GetParam(), random, i)); });
}
TEST_P(SilentPoses, NextToALattice) {
  const Count count = expect_none("next to a lattice", [this](Random& random, int i) {
    return std::optional(next_to_a_lattice(GetParam(), random, i));
  });
  // Few of these are told, but for arms that slide and for one that is free in several ways at once.
  if (GetParam().name.rfind("along_axes", 0) != 0 && GetParam().name != "in_line") {
    EXPECT_LE(count.told, 0.08 * count.poses);
  }
}
TEST_P(SilentPoses, WithRightAngles) {
  expect_none("right angles", [this](Random& random, int i) {
    return std::optional(with_right_angles(GetParam(), random, i));
  });
}
TEST_P(SilentPoses, AtAndNextToSingularities) {
  expect_none("singular", [this](Random& random, int i) {
    std::optional<Joints6> q = at_a_singularity(GetParam(), random, 1 + i % 4);
    if (q && i / 16 % 2 == 1) (*q)[1 + i / 4 % 4] += nearly_zero(random);
    return q;
  });
}

struct Named {
  const char* what;
  Arm arm;
  std::array<double, 6> q;
};

/// Joints of these poses were missing silently.
TEST(NamedSilentPoses, AreFoundOrTold) {
  const double right = pi / 2, eighth = pi / 4;
  const Named all[] = {
      {"a root of a part that is no parabola",
       crx10ia(),
       {3 * eighth, pi, 0, -2.027813653938245e-08, -right, -eighth}},
      {"a double root taken for a simple one",
       crx10ia(),
       {3 * eighth, 0, -eighth, -pi, -2.3564927676629344, -3 * eighth}},
      {"roots told apart and taken for one",
       in_line(),
       {1.5707964335872793, 1.5707961349045638, 1.7636440206384707e-07, 1.5707960982929419,
        -1.5707965034959928, 1.846682549035155e-07}},
      {"the same",
       in_line(),
       {0.99121157435886031, -0.16602581683921125, 2.6964708923652561, -1.5707963262717455, -right,
        -0.17440011210109529}},
      {"four axes through a point, no solutions nearby",
       crx10ia(),
       {eighth, 3 * eighth, -right, 3 * eighth, 0, -3 * eighth}},
      {"the same",
       crx10ia(),
       {-2.6530558336766803, -3.0937169698393188, -right, -1.1965956659447461, -0.3821614663252198,
        -1.1099083743026024}},
      {"three solutions that meet in each of two rows", m10(), {0, 0, -pi, 0, pi, eighth}},
      {"a continuum of which another curve was known", crx10ia(), {-pi, 0, -right, pi, 0, pi}},
      {"a curve that crosses those that were known",
       crx10ia(),
       {1.6879234056118531e-10, -6.9196541092838726e-10, -1.5707963275185939, -3.141592653711077,
        -5.0259312716638156e-10, -3.141592653792701}},
      {"three solutions side by side, the middle one taken for a continuum of the others",
       m10(),
       {-right, 0, 0, -3.1493451027731934, pi, -right}},
      {"steps that leave a bent valley",
       miscalibrated(ur5(), 1e-4, 3),
       {1.3814656904553893, 2.5678599775989905, -1.7390013522089487, -2.0308946792449127, -3.1389990979823654,
        1.3783297060148179}},
      {"steps that end above the floor of a valley",
       miscalibrated(irb6640(), 1e-4, 4),
       {3.1415262286641608, -1.6019825441831508, -1.6160721335792052, -0.95665495077472418, 3.096837427823373,
        1.8333429231150558}},
      {"solutions next to a continuum, far from the others",
       in_line(),
       {-1.5707856213617841, -1.5707834817678756, 1.5707977875070214, 3.1416085378251921,
        -9.0524514264290382e-06, 1.5708123577392863}},
      {"solutions in valleys of rows, none of which is a stray",
       crx10ia(),
       {-2.3562256390407401, -3.1415685789407579, -1.5707692971156149, 2.3561951092350686,
        -1.5708005599109023, 3.1415698703128889}},
      {"solutions in a valley 1.5e-3 apart",
       crx10ia(),
       {1.5701849637648027, -3.1421703357981854, -1.5704873625459197, 0.00032179277451042628,
        1.5698935252792343, -1.5718063045959692}},
      {"solutions that nearly meet",
       crx10ia(),
       {-pi, -3 * eighth, 0.0019953690035652608, -pi, right, -right}},
      {"more valleys than strays that are remembered",
       crx10ia(),
       {-2.3562679402484048, -3.141686707901969, -1.5708251529540573, -2.3563291035503529,
        -1.5706748405832804, -2.3563388767600717}},
  };
  for (const Named& each : all) {
    const auto setup = inverse::elimination::set_up(each.arm.description());
    const Joints6 q = Eigen::Map<const Joints6>(each.q.data());
    for (const InstructionSet set : instruction_sets) {
      const auto found = solve(setup, Pose<double>::from_isometry(each.arm.tool(q)), set);
      EXPECT_TRUE(found.status == Status::incomplete || is_covered(each.arm, setup, found, q))
          << each.arm.name << ", " << each.what << ": " << q.transpose();
    }
  }
}

std::vector<Arm> arms() {
  std::vector<Arm> all = named_arms();
  all.push_back(in_line());
  for (const int slide : {2, 4, 5}) all.push_back(arm_along_axes(3000, slide, true));
  return all;
}

INSTANTIATE_TEST_SUITE_P(Named, SilentPoses, testing::ValuesIn(arms()), name_of);

}  // namespace
}  // namespace qvgen::test
