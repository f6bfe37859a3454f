// SPDX-License-Identifier: MIT
// Products that one language of a run has left are taken by the next that is made of C, and by no other.
#include <gmock/gmock.h>

#include "description/reader.h"
#include "pipeline/pipeline.h"

namespace qvgen::pipeline {
namespace {

const char* const two_links = R"(
name = "arm"
title = "two links"
[[joint]]
type = "revolute"
axis = "+z"
variable = "a"
link = [0.5, 0, 0]
[[joint]]
type = "revolute"
axis = "+z"
variable = "b"
link = [0.25, 0, 0]
)";

std::vector<std::string> lacks_of(const RobotOutput& output) {
  std::vector<std::string> reasons;
  for (const Missing& each : output.missing) reasons.push_back(each.part + ": " + each.reason);
  return reasons;
}

TEST(KeptProducts, AreTakenByLanguagesMadeOfC) {
  const model::Robot robot = description::read_text(two_links, "arm.toml").robot.value();
  KeptProducts kept;
  const auto made = [&](Language language) {
    return generate({robot}, {"kinematics", "inverse"}, {}, {}, language, {}, &kept).front();
  };
  EXPECT_THAT(lacks_of(made(Language::c)), testing::IsEmpty());
  ASSERT_EQ(kept.count({"arm", "kinematics"}), 1U);
  ASSERT_EQ(kept.count({"arm", "inverse"}), 1U);
  kept[{"arm", "inverse"}] = {false, "as it was kept"};
  const auto as_kept = testing::ElementsAre("inverse: as it was kept");
  for (const Language language :
       {Language::c_in_float, Language::rust, Language::javascript, Language::octave})
    EXPECT_THAT(lacks_of(made(language)), as_kept) << row_of(language).name;
  EXPECT_THAT(lacks_of(made(Language::cxx)), testing::IsEmpty());
  // C++ has not replaced them.
  EXPECT_THAT(lacks_of(made(Language::c)), as_kept);
}

}  // namespace
}  // namespace qvgen::pipeline
