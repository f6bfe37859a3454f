// SPDX-License-Identifier: MIT
#include "cli/report.h"

#include <gtest/gtest.h>

#include "cli/suggestion.h"
#include "cli/verdict.h"

namespace {

using namespace qvgen::cli;

const nlohmann::ordered_json counts = nlohmann::ordered_json::parse(R"({
  "arm": {"jacobian": {"emitted": {"mul": 12, "add": 3, "div": 0, "sqrt": 0, "sincos": 2, "atan2": 0},
                       "fewest_operations": {"mul": 10, "add": 2, "div": 0, "sqrt": 0, "sincos": 5, "atan2": 0},
                       "largest_error_ulp": 1.5}}})");

TEST(Report, TableAligns) {
  EXPECT_EQ(report(counts, ReportFormat::table),
            "robot  function  mul  add  div  sqrt  sincos  atan2  fewest mul+add  (sincos)  error/ulp\n"
            "arm    jacobian   12    3    0     0       2      0              12       (5)        1.5\n");
}

TEST(Report, Csv) {
  EXPECT_EQ(report(counts, ReportFormat::csv),
            "robot,function,mul,add,div,sqrt,sincos,atan2,fewest,fewest_sincos,error_ulp\n"
            "arm,jacobian,12,3,0,0,2,0,12,5,1.5\n");
}

TEST(Report, MarkdownHasARule) {
  const std::string text = report(counts, ReportFormat::markdown);
  EXPECT_EQ(text.substr(0, 16), "|robot|function|");
  EXPECT_NE(text.find("\n|-----|--------|--:|"), std::string::npos) << text;
}

TEST(Report, CsvQuotes) {
  EXPECT_EQ(text_of({{{"name", "n"}, {"a, \"b\"", "1"}}, 1}, ReportFormat::csv),
            "name,n\n\"a, \"\"b\"\"\",1\n");
}

TEST(Report, HasTheColumnsThatAreNamed) {
  EXPECT_EQ(report(counts, ReportFormat::csv, false, {"sincos", "mul"}),
            "robot,function,mul,sincos\narm,jacobian,12,2\n");
}

TEST(Report, FiltersByName) {
  auto two = counts;
  two["other"] = counts["arm"];
  two["arm"]["velocity"] = counts["arm"]["jacobian"];
  EXPECT_EQ(filtered(two, {}), two);
  EXPECT_EQ(filtered(two, {{"arm"}, {"jacobian"}, {}}), counts);
  EXPECT_NO_THROW(check({{"arm"}, {"velocity"}, {}}, two));
  EXPECT_THROW(check({{"arm2"}, {}, {}}, two), UsageError);
  try {
    check({{}, {"jacobain"}, {}}, two);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "--functions: there is no 'jacobain'; did you mean 'jacobian'?");
  }
}

TEST(Changes, AreTheFunctionsThatDiffer) {
  auto before = counts, after = counts;
  EXPECT_EQ(changes(before, after, ReportFormat::table), "0 functions differ\n");
  after["arm"]["jacobian"]["emitted"]["mul"] = 11;
  after["arm"]["velocity"] = counts["arm"]["jacobian"];
  before["gone"]["jacobian"] = counts["arm"]["jacobian"];
  EXPECT_EQ(changes(before, after, ReportFormat::table, {"mul"}),
            "robot  function  change        mul\n"
            "arm    jacobian  cheaper  12 -> 11\n"
            "arm    velocity  new            12\n"
            "gone   jacobian  gone           12\n"
            "\n3 functions differ, 1 cheaper, 1 new, 1 gone\n");
  EXPECT_EQ(changes(before, after, ReportFormat::csv, {"mul"}),
            "robot,function,change,mul_before,mul_after\narm,jacobian,cheaper,12,11\narm,velocity,new,,12\n"
            "gone,jacobian,gone,12,\n");
  const auto json = nlohmann::json::parse(changes(before, after, ReportFormat::json));
  EXPECT_EQ(json["arm"]["jacobian"]["after"]["emitted"]["mul"], 11);
  EXPECT_TRUE(json["gone"]["jacobian"]["after"].is_null());
  after["arm"]["jacobian"]["emitted"]["add"] = 9;
  EXPECT_NE(changes(counts, after, ReportFormat::markdown).find("|dearer|"), std::string::npos);
}

TEST(Report, JsonIsTheWhole) {
  EXPECT_EQ(nlohmann::ordered_json::parse(report(counts, ReportFormat::json)), counts);
}

/// A failed check of the tool itself outweighs whatever else is wrong, and its code says so to scripts.
TEST(Verdict, ADefectOfTheToolHasACodeOfItsOwn) {
  using qvgen::pipeline::Missing;
  const Missing not_derived{"inverse", Missing::Kind::not_derived, ""},
      refuted{"jacobian", Missing::Kind::refuted, ""};
  EXPECT_EQ(verdict_of({}), success);
  EXPECT_EQ(verdict_of({not_derived}), success);
  EXPECT_EQ(verdict_of({not_derived, refuted}), internal_error);
  EXPECT_EQ(static_cast<int>(internal_error), 70);
  EXPECT_EQ(worse(failure, verdict_of({refuted})), internal_error);
  EXPECT_EQ(worse(success, failure), failure);
}

}  // namespace
