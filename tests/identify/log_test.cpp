// SPDX-License-Identifier: MIT
// Each mistake of a log is named with its line.
#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identify/log_table.h"
#include "simulated.h"

namespace qvgen::test {
namespace {

using identify::LogOptions;
using identify::LogResult;
using testing::HasSubstr;

const char* const two_joints = R"(name = "arm"
title = "arm"
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
limits = ["-170 deg", "170 deg"]
[[joint]]
type = "prismatic"
axis = "+z"
variable = "s"
)";

/// Rows of a slow motion; `change` may alter a row's text.
struct Writer {
  std::string header = "time [s], q1, q2 [mm], torque1, torque2";
  double time_step = 0.01, angle_unit = 1;
  int rows = 100, bad_row = -1;
  std::string bad_text;
  bool saturated = false, rates = false, swapped = false;

  [[nodiscard]] std::string text() const {
    std::ostringstream result;
    result.precision(17);
    result << header << "\n";
    for (int k = 0; k < rows; ++k) {
      if (k == bad_row)
        result << bad_text << "\n";
      else
        row(k, result);
    }
    return result.str();
  }

  void row(int k, std::ostream& to) const {
    const double t = time_step * k, q = std::sin(t), s = 50 * std::cos(2 * t);
    const double torque = saturated && k >= 20 && k < 40 ? 12.5 : 12 * std::sin(3 * t);
    to << t << "," << q / angle_unit << "," << s << "," << torque << "," << std::cos(t);
    const double rate = std::cos(t), slide = -0.1 * std::sin(2 * t);
    if (rates) to << "," << (swapped ? slide : rate) << "," << (swapped ? rate : slide);
    to << "\n";
  }
};

LogResult read(const std::string& text, const LogOptions& options = {}) {
  const model::Robot robot = read_arm(two_joints);
  std::istringstream stream(text);
  measured::TableOptions table;
  table.fewest_rows = 20;
  table.others_are_mistakes = false;
  return identify::log_of(
      measured::read_table(stream, "log.csv", identify::log_columns(robot, options), table), robot, options);
}

std::string mistakes(const LogResult& result) {
  std::string text;
  for (const auto& each : result.diagnostics) text += description::to_string(each) + "\n";
  return text;
}
std::string mistakes(const Writer& writer) { return mistakes(read(writer.text())); }

TEST(Log, GoodOnesAreReadInSI) {
  const LogResult result = read(Writer{}.text());
  EXPECT_EQ(mistakes(result), "");
  EXPECT_EQ(result.log.samples(), 100);
  EXPECT_NEAR(result.log.q(3, 1), 0.05 * std::cos(0.06), 1e-15);
  EXPECT_EQ(result.log.qd.rows(), 0);
  EXPECT_EQ(result.log.time.size(), 100U);
}

TEST(Log, CurrentsBecomeTorques) {
  Writer writer;
  writer.header = "time, theta1, s [mm], current1 [A], current2 [mA]";
  const LogResult result = read(writer.text(), {{10, 2000}, true});
  EXPECT_EQ(mistakes(result), "");
  EXPECT_NEAR(result.log.torque(5, 0), 120 * std::sin(0.15), 1e-12);
  EXPECT_NEAR(result.log.torque(5, 1), 2 * std::cos(0.05), 1e-12);
}

TEST(Log, TimeThatGoesBackHasItsLine) {
  Writer writer;
  writer.bad_row = 50;
  writer.bad_text = "0.3,0,0,0,0";
  EXPECT_THAT(mistakes(writer), HasSubstr("log.csv:52:1: error: time goes back: 0.3 s after 0.49 s"));
  writer.bad_text = "0.49,0,0,0,0";
  EXPECT_THAT(mistakes(writer), HasSubstr("log.csv:52:1: error: time stands still"));
}

TEST(Log, WhatIsNoNumberHasItsLine) {
  Writer writer;
  writer.bad_row = 7;
  writer.bad_text = "0.07,nan,0,0,0";
  EXPECT_THAT(mistakes(writer), HasSubstr("log.csv:9:"));
  writer.bad_text = "0.07,fast,0,0,0";
  EXPECT_THAT(mistakes(writer), HasSubstr("log.csv:9:"));
  writer.bad_text = "0.07,0,0,0";
  EXPECT_THAT(mistakes(writer), HasSubstr("log.csv:9:"));
}

TEST(Log, DegreesWithoutTheirUnitAreNamed) {
  Writer writer;
  writer.angle_unit = 3.14159265358979 / 180;
  writer.header = "time, q1, q2 [mm], torque1, torque2";
  EXPECT_THAT(mistakes(writer),
              HasSubstr("beyond the joint's limits; if the numbers are degrees, write q1 [deg]"));
  writer.header = "time, q1 [deg], q2 [mm], torque1, torque2";
  EXPECT_EQ(mistakes(writer), "");
}

TEST(Log, UnitsOfAnotherQuantityAreRefused) {
  Writer writer;
  writer.header = "time, q1 [mm], q2 [mm], torque1, torque2";
  EXPECT_THAT(mistakes(writer), HasSubstr("log.csv:1:"));
  writer.header = "time, q1, q2 [mm], torque1 [N], torque2";
  EXPECT_THAT(mistakes(writer), HasSubstr("log.csv:1:"));
}

TEST(Log, SwappedRatesAreNamed) {
  Writer writer;
  writer.rates = true;
  writer.header = "time, q1, q2 [mm], torque1, torque2, qd1, qd2";
  EXPECT_EQ(mistakes(writer), "");
  writer.swapped = true;
  EXPECT_THAT(mistakes(writer), HasSubstr("error: qd1 is not the rate of q1"));
  EXPECT_THAT(mistakes(writer), HasSubstr("error: qd2 is not the rate of q2"));
}

TEST(Log, TooFewRowsAndMissingColumnsAreNamed) {
  Writer writer;
  writer.rows = 10;
  EXPECT_THAT(mistakes(writer), HasSubstr("error"));
  writer = {};
  writer.header = "time, q1, q2 [mm], torque1, other";
  EXPECT_THAT(mistakes(writer), HasSubstr("torque2"));
  writer.header = "clock, q1, q2 [mm], torque1, torque2";
  EXPECT_THAT(mistakes(writer), HasSubstr("there is no column 'time'"));
}

TEST(Log, SaturatedTorquesAreLeftOutWithTheirLine) {
  Writer writer;
  writer.saturated = true;
  const LogResult result = read(writer.text());
  EXPECT_TRUE(result.good());
  EXPECT_THAT(mistakes(result),
              HasSubstr("log.csv:22:1: warning: torque1 stays at its greatest value 12.5 from here: 20 "
                        "rows of a motor at its bound are left out"));
  for (Eigen::Index k = 0; k < 100; ++k)
    EXPECT_EQ(std::isnan(result.log.torque(k, 0)), k >= 20 && k < 40) << k;
}

/// A wrist with bevel gears, whose tilt has limits of its own.
const char* const bevel_gears = R"(name = "arm"
title = "arm"
[[joint]]
type = "revolute"
axis = "+y"
variable = "tilt"
follows = "1/2 ml - 1/2 mr"
limits = [-0.3, 1]
[[joint]]
type = "revolute"
axis = "+z"
variable = "roll"
follows = "1/2 ml + 1/2 mr"
[[motor]]
variable = "ml"
[[motor]]
variable = "mr"
)";

TEST(Log, OfMotorsHasTheirColumnsAndKeepsTheJointsLimits) {
  const model::Robot robot = read_arm(bevel_gears);
  const auto mistakes_of = [&](const std::string& header) {
    std::ostringstream text;
    text.precision(17);
    text << header << "\n";
    for (int k = 0; k < 100; ++k)
      text << 0.01 * k << "," << 90 + 0.01 * k << "," << 90 - 0.01 * k << "," << std::sin(k) << ","
           << std::cos(k) << "\n";
    std::istringstream stream(text.str());
    measured::TableOptions table;
    table.others_are_mistakes = false;
    return mistakes(identify::log_of(
        measured::read_table(stream, "log.csv", identify::log_columns(robot, {}), table), robot, {}));
  };
  EXPECT_EQ(mistakes_of("time, ml, mr, torque1, torque2"), "");
  EXPECT_EQ(mistakes_of("time, q1, q2, ml_torque, mr_torque"), "");
  EXPECT_THAT(
      mistakes_of("time, mr, ml, torque1, torque2"),
      HasSubstr("log.csv:53:1: error: 1/2 ml - 1/2 mr = -0.51 (rad, m), beyond the limits of the joint "
                "'tilt'; are columns of two motors swapped"));
  EXPECT_THAT(mistakes_of("time, ml, torque1, torque2, other"), HasSubstr("q2"));
}

}  // namespace
}  // namespace qvgen::test
