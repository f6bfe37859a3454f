// SPDX-License-Identifier: MIT
// Right tables: every separator, unit and kind of header gives the same numbers.
#include <chrono>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read.h"

namespace measured_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr double degree = 3.14159265358979323846 / 180;

TEST(Table, UnitsOfTheHeaderAreConverted) {
  const TableResult result = read("q1 [deg], theta2 (mrad), x [mm], y\n90, 250, 1.5, 2\n-45,0,-1,+3e-1\n");
  ASSERT_EQ(mistakes(result), "");
  EXPECT_THAT(*result.table.find("q1"),
              ElementsAre(DoubleNear(90 * degree, 1e-15), DoubleNear(-45 * degree, 1e-15)));
  EXPECT_THAT(*result.table.find("q2"), ElementsAre(0.25, 0));
  EXPECT_THAT(*result.table.find("x"), ElementsAre(0.0015, -0.001));
  EXPECT_THAT(*result.table.find("y"), ElementsAre(2, 0.3));
  EXPECT_EQ(result.table.find("sigma"), nullptr);
  EXPECT_THAT(result.table.lines, ElementsAre(2, 3));
}

TEST(Table, DefaultUnitsHoldWhereTheHeaderStatesNone) {
  TableOptions options;
  options.angle_unit = degree;
  options.length_unit = 1e-3;
  const TableResult result = read("q1 q2 x y [m]\n1 2 3 4\n", options);
  ASSERT_EQ(mistakes(result), "");
  EXPECT_DOUBLE_EQ(result.table.find("q1")->front(), degree);
  EXPECT_DOUBLE_EQ(result.table.find("x")->front(), 3e-3);
  EXPECT_DOUBLE_EQ(result.table.find("y")->front(), 4);
}

TEST(Table, EverySeparatorGivesTheSame) {
  for (const std::string mark : {",", ";", "\t", " ", "   ", " , ", "\t "}) {
    const std::string text = "q1 [deg]" + mark + "q2" + mark + "x" + mark + "\"y [mm]\"\r\n" + "180" + mark +
                             "1" + mark + "2" + mark + "5\r\n";
    const TableResult result = read(text);
    ASSERT_EQ(mistakes(result), "") << text;
    EXPECT_DOUBLE_EQ(result.table.find("q1")->front(), 180 * degree) << text;
    EXPECT_DOUBLE_EQ(result.table.find("y")->front(), 5e-3) << text;
  }
}

TEST(Table, CommentsBlankLinesAndMarksAreNoRows) {
  const TableResult result =
      read("\xef\xbb\xbf# a tracker\n\n% May\nq1,q2,x,y,\n\n1,2,3,4, # good\n# 5,6,7,8\n  \n9,8,7,6,");
  ASSERT_EQ(mistakes(result), "");
  EXPECT_THAT(*result.table.find("q1"), ElementsAre(1, 9));
  EXPECT_THAT(result.table.lines, ElementsAre(6, 9));
}

TEST(Table, TheLastCommentMayBeTheHeader) {
  const TableResult result = read("# written by numpy\n# q1 q2 x [mm] y\n1 2 3 4\n");
  ASSERT_EQ(mistakes(result), "");
  EXPECT_DOUBLE_EQ(result.table.find("x")->front(), 3e-3);
}

TEST(Table, ColumnsComeInAnyOrderAndOthersCanBeIgnored) {
  TableOptions options;
  options.ignored = {"note"};
  const TableResult result = read("y,note,x,q2,q1\n1,hello,2,3,4\n", options);
  ASSERT_EQ(mistakes(result), "");
  EXPECT_EQ(result.table.find("q1")->front(), 4);
  options = {};
  options.others_are_mistakes = false;
  const TableResult noted = read("y,note,x,q2,q1\n1,hello,2,3,4\n", options);
  EXPECT_TRUE(noted.good());
  EXPECT_THAT(mistakes(noted), testing::HasSubstr("data.csv:1:3: note: column 'note' is not known"));
}

TEST(Table, WhatMayMissIsNan) {
  const TableResult result = read("q1,q2,x,y,sigma [mm]\n1,2,3,4,nan\n1,2,3,4,\n1,2,3,4,5\n");
  ASSERT_EQ(mistakes(result), "");
  const auto& sigma = *result.table.find("sigma");
  EXPECT_TRUE(std::isnan(sigma[0]) && std::isnan(sigma[1]));
  EXPECT_DOUBLE_EQ(sigma[2], 5e-3);
}

TEST(Table, NumbersComeBackToTheLastBit) {
  std::mt19937 random(1);
  std::normal_distribution<double> number;
  std::ostringstream text;
  text.precision(17);
  text << "q1,q2,x,y\n";
  std::vector<double> written;
  for (int i = 0; i < 1000; ++i) {
    written.push_back(number(random));
    text << written.back() << ",0,0,0\n";
  }
  EXPECT_EQ(*read(text.str()).table.find("q1"), written);
}

TEST(Table, AMillionRowsAreReadInSeconds) {
  std::string text = "q1 [deg],q2 [deg],x [mm],y [mm]\n";
  for (int i = 0; i < 1'000'000; ++i) text += "12.345678,-98.7654321,1234.5678,-0.001234\n";
  const auto start = std::chrono::steady_clock::now();
  const TableResult result = read(text);
  RecordProperty(
      "seconds",
      std::to_string(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
  ASSERT_EQ(mistakes(result), "");
  EXPECT_EQ(result.table.rows(), 1'000'000U);
}

}  // namespace
}  // namespace measured_test
