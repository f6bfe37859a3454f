// SPDX-License-Identifier: MIT
#include "pipeline/lines_of_json.h"

#include <gtest/gtest.h>

namespace qvgen::pipeline {
namespace {

using nlohmann::ordered_json;

TEST(LinesOfJson, WhatHoldsNothingFurtherIsALine) {
  const auto json =
      ordered_json::parse(R"({"b": {"x": 1, "a": [1, 2]}, "a": {}, "c": [{"k": "\n"}], "d": 2.5})");
  EXPECT_EQ(lines_of_json(json),
            "{\n \"b\": {\n  \"x\": 1,\n  \"a\": [1,2]\n },\n \"a\": {},\n \"c\": [\n  {\"k\":\"\\n\"}\n ],\n"
            " \"d\": 2.5\n}\n");
}

TEST(LinesOfJson, IsTheSameValue) {
  for (const char* text :
       {"{}", "[]", "3", "\"a\"", "null", R"([[], [[1]], {"z": {"y": {}}, "x": "\u00e4\""}])"}) {
    const auto json = ordered_json::parse(text);
    EXPECT_EQ(ordered_json::parse(lines_of_json(json)), json) << text;
  }
}

}  // namespace
}  // namespace qvgen::pipeline
