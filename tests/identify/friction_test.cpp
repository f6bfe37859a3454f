// SPDX-License-Identifier: MIT
// Friction beyond Coulomb's: exact data give it back, the bodies stay what they are, and who does not ask for
// it sees it in the residual. Spectra: noise has the density that it must have, a sine is where it is.
#include <fstream>

#include <gtest/gtest.h>

#include "identify/extra_columns.h"
#include "identify/identification.h"
#include "identify/log_table.h"
#include "identify/spectrum.h"
#include "random_arm.h"
#include "simulated.h"

namespace qvgen::test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using identify::Identification;
using identify::MotionLog;

class Friction : public testing::Test {
 protected:
  const std::string text = ArmWriter(31).text("RRR");
  const reference::Chain chain = reference::load_text(text);
  MotionLog log = simulated(chain, 4000, 5);
  static constexpr double strength = 2.5, viscous = -0.04, coulomb = 0.03;

  void SetUp() override {
    log.temperature.resize(log.samples(), 3);
    for (Index k = 0; k < log.samples(); ++k)
      for (Index i = 0; i < 3; ++i)
        log.temperature(k, i) = 25 + 10 * std::sin(0.001 * static_cast<double>(k) + static_cast<double>(i));
    const double mean = log.temperature.mean();
    for (Index i = 0; i < 3; ++i) {
      const double rate = 0.1 * log.qd.col(i).cwiseAbs().maxCoeff();
      for (Index k = 0; k < log.samples(); ++k) {
        const double qd = log.qd(k, i), sign = qd > 0 ? 1 : -1, warm = log.temperature(k, i) - mean;
        log.torque(k, i) +=
            strength * sign * std::exp(-qd * qd / (rate * rate)) + (viscous * qd + coulomb * sign) * warm;
      }
    }
  }
  [[nodiscard]] Identification found(bool stribeck, bool temperature) const {
    identify::Request request;
    request.stribeck = stribeck;
    request.temperature = temperature;
    request.standstill = 0;
    return identify::identify(read_arm(text), {log}, {}, request);
  }
};

TEST_F(Friction, IsFoundWithTheBodiesAsTheyAre) {
  const Identification all = found(true, true);
  const VectorXd truth = all.arm.combination.topRows(all.arm.plain()) * parameters_of(chain);
  EXPECT_LT((all.estimate.value.head(truth.size()) - truth).norm(), 1e-8 * truth.norm());
  ASSERT_EQ(all.arm.parameters(), all.arm.plain() + 9);
  for (Index i = 0; i < 3; ++i) {
    EXPECT_NEAR(all.estimate.value[truth.size() + i], strength, 1e-8);
    EXPECT_NEAR(all.estimate.value[truth.size() + 3 + i], viscous, 1e-8);
    EXPECT_NEAR(all.estimate.value[truth.size() + 6 + i], coulomb, 1e-8);
    EXPECT_LT(all.joints[static_cast<std::size_t>(i)].residual, 1e-8);
  }
  EXPECT_TRUE(all.full.exact);
  const VectorXd told = all.arm.combination.topRows(all.arm.plain()) * all.full.values;
  EXPECT_LT((told - truth).norm(), 1e-7 * truth.norm());
}

TEST_F(Friction, IsAResidualForWhoDoesNotAsk) {
  const Identification none = found(false, false), warm = found(false, true), low = found(true, false);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(none.joints[i].residual, 0.2);
    EXPECT_LT(warm.joints[i].residual, none.joints[i].residual);
    EXPECT_LT(low.joints[i].residual, none.joints[i].residual);
  }
}

TEST_F(Friction, RowsWithoutTemperatureAreLeftOut) {
  log.temperature(7, 1) = std::nan("");
  const Identification some = found(true, true);
  EXPECT_EQ(some.joints[1].rows, 3999);
  EXPECT_EQ(some.joints[0].rows, 4000);
}

/// Noise beside it: deviations hold for the extra columns, too.
TEST_F(Friction, DeviationsHold) {
  double squares = 0;
  constexpr int trials = 30;
  identify::ArmRegressor arm = identify::arm_regressor(read_arm(text), identify::all_drives());
  identify::add_extra_columns(arm, false, true);
  arm.temperature = log.temperature.mean();
  for (int trial = 0; trial < trials; ++trial) {
    MotionLog noisy = log;
    add_noise(noisy, Eigen::Vector3d::Constant(0.3), static_cast<unsigned>(trial + 1));
    MotionLog smooth = noisy;
    for (Index i = 0; i < 3; ++i) {  // without Stribeck's part, which is no column here
      const double rate = 0.1 * log.qd.col(i).cwiseAbs().maxCoeff();
      for (Index k = 0; k < log.samples(); ++k) {
        const double qd = log.qd(k, i);
        smooth.torque(k, i) -= strength * (qd > 0 ? 1 : -1) * std::exp(-qd * qd / (rate * rate));
      }
    }
    const auto estimate = identify::estimate(identify::equations_of(arm, smooth), arm.parameters());
    for (Index k = 0; k < 3; ++k) {
      const Index place = arm.plain() + k;
      squares += std::pow((estimate.value[place] - viscous) / estimate.deviation[place], 2) / (3 * trials);
    }
  }
  EXPECT_NEAR(squares, 1, 5 * std::sqrt(2.0 / (3 * trials)));
}

/// The usual mistakes of a log are said, and none of a good one.
TEST(Slips, AreNamed) {
  const std::string text = ArmWriter(12).text("RRR");
  MotionLog good = simulated(reference::load_text(text), 4000, 8);
  add_noise(good, Eigen::Vector3d::Constant(0.1), 1);
  const auto doubts = [&](const auto& spoil) {
    MotionLog log = good;
    spoil(log);
    const auto found = identify::identify(read_arm(text), {log});
    return found.doubts.empty() ? "" : found.doubts.front();
  };
  EXPECT_EQ(doubts([](MotionLog&) {}), "");
  EXPECT_EQ(doubts([](MotionLog& log) { log.torque.col(0).swap(log.torque.col(2)); }),
            "columns torque1 and torque3 seem to be swapped");
  EXPECT_EQ(doubts([](MotionLog& log) {
              for (Eigen::MatrixXd* part : {&log.q, &log.qd, &log.qdd}) part->col(1).swap(part->col(2));
            }),
            "columns q2 and q3 seem to be swapped");
  EXPECT_EQ(doubts([](MotionLog& log) { log.torque.col(1) *= -1; }), "torque2 seems to have the other sign");
}

/// Rates in another unit of time: what the links' weights and their inertias say of the same moments differs.
TEST(Slips, UnitsOfTimeAreNamed) {
  std::ifstream file(QVGEN_SOURCE_DIR "/generator/robots/puma560.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  MotionLog log = simulated(reference::load_text(text), 4000, 8);
  add_noise(log, VectorXd::Constant(6, 0.02), 1);
  log.qd /= 1000;
  log.qdd /= 1e6;
  const auto found = identify::identify(read_arm(text), {log});
  ASSERT_FALSE(found.doubts.empty());
  EXPECT_EQ(found.doubts.front(), "the times seem to be milliseconds: write time [ms]");
}

/// All torques with the other sign are explained, by friction that drives.
TEST(Slips, FrictionThatDrivesIsSaid) {
  const std::string text = ArmWriter(12).text("RRR");
  MotionLog log = simulated(reference::load_text(text), 4000, 8);
  add_noise(log, Eigen::Vector3d::Constant(0.1), 1);
  log.torque *= -1;
  const auto found = identify::identify(read_arm(text), {log});
  ASSERT_FALSE(found.doubts.empty());
  EXPECT_NE(found.doubts.front().find("friction that drives"), std::string::npos);
}

TEST(Temperature, IsReadOfTheArmOrOfEachJoint) {
  const model::Robot robot = read_arm(ArmWriter(3).text("RR"));
  std::string rows = "time, q1, q2, torque1, torque2, temp [degC]\n",
              none = "time, q1, q2, torque1, torque2\n";
  for (int i = 0; i < 30; ++i) {
    rows += fmt::format("{0}, {0}, {0}, 1, {0}, {1}\n", 0.01 * i, 20 + i);
    none += fmt::format("{0}, {0}, {0}, 1, {0}\n", 0.01 * i);
  }
  const identify::LogOptions options{{}, true, true};
  const auto read = [&](const std::string& text) {
    std::istringstream stream(text);
    return identify::log_of(measured::read_table(stream, "log.csv", identify::log_columns(robot, options)),
                            robot, options);
  };
  const identify::LogResult good = read(rows), bad = read(none);
  ASSERT_TRUE(good.good());
  EXPECT_EQ(good.log.temperature.cols(), 2);
  EXPECT_EQ(good.log.temperature(29, 1), 49);
  ASSERT_FALSE(bad.good());
  EXPECT_NE(to_string(bad.diagnostics.front()).find("temperature"), std::string::npos);
}

TEST(Spectrum, OfNoiseIsLevelAndOfASineIsALine) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 0.3);
  constexpr double step = 0.002;
  VectorXd noise(60000), sine(60000);
  for (Index k = 0; k < noise.size(); ++k) {
    noise[k] = normal(random);
    sine[k] = 2 * std::sin(2 * 3.14159265358979323846 * 40 * step * static_cast<double>(k));
  }
  double mean = 0;
  const auto flat = identify::spectrum(noise, step), line = identify::spectrum(sine, step);
  for (const auto& [frequency, density] : flat) mean += density * density / static_cast<double>(flat.size());
  EXPECT_NEAR(std::sqrt(mean), 0.3 * std::sqrt(2 * step), 0.005 * std::sqrt(2 * step));
  EXPECT_NEAR(identify::band_of_power(flat), 225, 10);
  double power = 0;
  for (const auto& [frequency, density] : line) power += density * density * line.front().first;
  EXPECT_NEAR(power, 2, 0.02);  // half of the square of its height
  EXPECT_NEAR(identify::band_of_power(line), 40, 1);
  noise[100] = std::nan("");
  EXPECT_FALSE(identify::spectrum(noise, step).empty());
  EXPECT_TRUE(identify::spectrum(VectorXd::Constant(10, 1), step).empty());
}

}  // namespace
}  // namespace qvgen::test
