// SPDX-License-Identifier: MIT
// Four configurations at once: each lane is the function of doubles.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/pack.h>
#include <qvgen/robots/puma560/dynamics_definitions.h>
#if defined(QVGEN_ALL_ARMS)
#include <qvgen/robots/iiwa14/dynamics_definitions.h>
#endif

namespace {

using qvgen::Pack;

template <int N>
using Packs = Eigen::Matrix<Pack, N, 1>;
template <int N>
using Numbers = Eigen::Matrix<double, N, 1>;

template <int N>
Packs<N> random_packs(std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-3, 3);
  Packs<N> result;
  for (Pack& pack : result.reshaped())
    for (int lane = 0; lane < Pack::size; ++lane) pack.set(lane, number(random));
  return result;
}

template <int N>
Numbers<N> lane_of(const Packs<N>& packs, int lane) {
  return packs.unaryExpr([lane](const Pack& pack) { return pack[lane]; });
}

template <class Found, class Expected>
void expect_lane(const Found& found, int lane, const Expected& expected, double tolerance = 1e-13) {
  const double size = 1 + expected.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found(i)[lane], expected(i), tolerance * size);
}

TEST(PacksOfConfigurations, GiveWhatEachConfigurationGives) {
  namespace arm = qvgen::robots::puma560;
  std::mt19937_64 random(1);
  for (int k = 0; k < 50; ++k) {
    const auto q = random_packs<6>(random), qd = random_packs<6>(random), qdd = random_packs<6>(random);
    const auto torque = arm::inverse_dynamics(q, qd, qdd);
    const auto mass = arm::mass_matrix(q), coriolis = arm::coriolis_matrix(q, qd);
    const auto found = arm::forward_dynamics(q, qd, torque);
    for (int lane = 0; lane < Pack::size; ++lane) {
      const auto x = lane_of<6>(q, lane), v = lane_of<6>(qd, lane), a = lane_of<6>(qdd, lane);
      expect_lane(torque, lane, arm::inverse_dynamics(x, v, a));
      expect_lane(mass, lane, arm::mass_matrix(x));
      expect_lane(coriolis, lane, arm::coriolis_matrix(x, v));
      expect_lane(found, lane, a, 1e-9);  // times the condition of M, some thousands
    }
  }
}

#if defined(QVGEN_ALL_ARMS)
TEST(PacksOfConfigurations, TakeSevenJoints) {
  namespace arm = qvgen::robots::iiwa14;
  std::mt19937_64 random(2);
  for (int k = 0; k < 50; ++k) {
    const auto q = random_packs<7>(random), qd = random_packs<7>(random), qdd = random_packs<7>(random);
    const auto torque = arm::inverse_dynamics(q, qd, qdd);
    for (int lane = 0; lane < Pack::size; ++lane)
      expect_lane(torque, lane,
                  arm::inverse_dynamics(lane_of<7>(q, lane), lane_of<7>(qd, lane), lane_of<7>(qdd, lane)));
  }
}
#endif

}  // namespace
