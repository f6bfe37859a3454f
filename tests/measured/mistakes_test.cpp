// SPDX-License-Identifier: MIT
// Wrong tables: every mistake has its line, several come at once, and no input is read without an end.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read.h"

namespace measured_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Mistakes, OfTheHeader) {
  EXPECT_EQ(mistakes("q1,theta2,xx,y [kg],z\n1,2,3,4,5\n"),
            "data.csv:1:11: error: column 'xx' is not known; did you mean 'x'?\n"
            "data.csv:1:14: error: 'y' is a length, which is not measured in kg; write m, cm, mm, um or in\n"
            "data.csv:1:21: error: column 'z' is not known; did you mean 'x'?\n"
            "data.csv:1:1: error: there is no column 'x'; add it to the header; it holds a length\n");
  EXPECT_THAT(mistakes("q1 [furlong],q2,x,y\n"),
              HasSubstr("'furlong' is no unit that is known; write rad, mrad or deg"));
  EXPECT_THAT(mistakes("q1,q2,x,y,theta1\n"), HasSubstr("data.csv:1:11: error: two columns are 'q1'"));
}

TEST(Mistakes, OfRowsComeTogetherWithTheirLines) {
  EXPECT_EQ(
      mistakes(
          "# c\nq1,q2,x,y\n1,2,3,4\n1,2,3\n1,nan,3,4\n1,2,three,4\n1,2,,4\n1,2,3,4,5\n1;2;3;4\n1,2,inf,4\n"),
      "data.csv:4:1: error: 3 cells where the header has 4 columns; write one number for each column\n"
      "data.csv:5:1: error: 'q2' is nan; leave the row out\n"
      "data.csv:6:5: error: 'three' of 'x' is no number; write a number such as 0.125\n"
      "data.csv:7:1: error: 'x' is empty; write a number, or leave the row out\n"
      "data.csv:8:1: error: 5 cells where the header has 4 columns; write one number for each column\n"
      "data.csv:9:1: error: 1 cells where the header has 4 columns; write one number for each column\n"
      "data.csv:10:1: error: 'x' is inf; leave the row out\n");
}

TEST(Mistakes, DecimalCommas) {
  EXPECT_THAT(mistakes("q1;q2;x;y\n0,5;1;2;3\n"),
              HasSubstr("'0,5' of 'q1' is no number; write decimals with a point"));
}

TEST(Mistakes, ManyAreCounted) {
  std::string text = "q1,q2,x,y\n";
  for (int i = 0; i < 100; ++i) text += "1,2,nan,4\n";
  const TableResult result = read(text);
  EXPECT_EQ(result.diagnostics.size(), most_mistakes + 1);
  EXPECT_THAT(mistakes(result), HasSubstr("and 80 more mistakes of rows"));
}

TEST(Mistakes, OfWholeFiles) {
  EXPECT_THAT(mistakes(""), HasSubstr("data.csv:1:1: error: the table has no rows"));
  EXPECT_THAT(mistakes("# only a comment\n"), HasSubstr("the table has no rows"));
  EXPECT_THAT(mistakes("1,2,3,4\n"), HasSubstr("data.csv:1:1: error: the table has no header"));
  TableOptions options;
  options.fewest_rows = 3;
  EXPECT_THAT(mistakes("q1,q2,x,y\n1,2,3,4\n", options),
              HasSubstr("data.csv:2:1: error: 1 rows are too few; give at least 3"));
  EXPECT_THAT(mistakes("q1,q2,x,y\n1,2,3," + std::string(longest_line, '4')),
              HasSubstr("data.csv:2:1: error: a line of more than"));
  EXPECT_THAT(mistakes(read_table("/nowhere/data.csv", joints_and_position)),
              HasSubstr("cannot be read: No such file"));
  EXPECT_THAT(mistakes(read_table("/", joints_and_position)), HasSubstr("this is a folder"));
}

TEST(Mistakes, AnyTextIsReadOrRefused) {
  std::mt19937 random(7);
  const std::string letters = "q12xy,;\t \n#%[]()\"-+.e0nai\xc2\xb0\xff";
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text = trial % 2 == 0 ? "q1,q2,x,y\n" : "";
    for (auto i = random() % 60; i > 0; --i) text += letters[random() % letters.size()];
    const TableResult result = read(text);
    if (!result.good()) continue;
    for (const Column& column : result.table.columns)
      ASSERT_EQ(column.values.size(), result.table.rows()) << text;
  }
}

}  // namespace
}  // namespace measured_test
