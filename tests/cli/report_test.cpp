// SPDX-License-Identifier: MIT
#include "cli/report.h"

#include <gtest/gtest.h>

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
            "robot,function,mul,add,div,sqrt,sincos,atan2,fewest mul+add,(sincos),error/ulp\n"
            "arm,jacobian,12,3,0,0,2,0,12,(5),1.5\n");
}

TEST(Report, MarkdownHasARule) {
  const std::string text = report(counts, ReportFormat::markdown);
  EXPECT_EQ(text.substr(0, 16), "|robot|function|");
  EXPECT_NE(text.find("\n|-----|--------|--:|"), std::string::npos) << text;
}

TEST(Report, JsonIsTheWhole) {
  EXPECT_EQ(nlohmann::ordered_json::parse(report(counts, ReportFormat::json)), counts);
}

}  // namespace
