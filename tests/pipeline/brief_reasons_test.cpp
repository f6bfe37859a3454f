// SPDX-License-Identifier: MIT
#include "pipeline/products/brief_reasons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace qvgen::pipeline {
namespace {

using testing::ElementsAre;

TEST(BriefReasons, OneLineForAllJointsInARow) {
  EXPECT_THAT(brief_reasons({"joints 4, 5 and 6: their axes do not meet in one point",
                             "joints 1, 2 and 3: their axes do not meet in one point",
                             "joints 3, 4 and 5: their axes do not meet in one point",
                             "joints 2, 3 and 4: their axes do not meet in one point",
                             "joints 2, 3 and 4: their axes are not parallel", "too long"},
                            6),
              ElementsAre("no three axes in a row meet in one point",
                          "joints 2, 3 and 4: their axes are not parallel", "too long"));
}

TEST(BriefReasons, OneLineForWhicheverJointIsGiven) {
  EXPECT_THAT(brief_reasons(
                  {"with q1 given: joints 2, 3 and 4: their axes are not parallel",
                   "with q1 given: joints 3, 4 and 5: their axes are not parallel", "with q1 given: too long",
                   "with q5 given: joints 1, 2 and 3: their axes are not parallel",
                   "with q5 given: joints 2, 3 and 4: their axes are not parallel", "a pose fixes six"},
                  5),
              ElementsAre("with q1 or q5 given: no three axes in a row are parallel",
                          "with q1 given: too long", "a pose fixes six"));
}

TEST(BriefReasons, OneLineForWhicheverAxisIsLeft) {
  EXPECT_THAT(brief_reasons({"with the direction of the tool's axis z left: singular everywhere",
                             "with the direction of the tool's axis x left: singular everywhere",
                             "with the direction of the tool's axis y left: singular everywhere",
                             "by elimination: none"},
                            5),
              ElementsAre("with the direction of the tool's axis z, x or y left: singular everywhere",
                          "by elimination: none"));
  // The turn that is left is one joint more.
  std::vector<std::string> reasons;
  for (const char* joints : {"1, 2 and 3", "2, 3 and 4", "3, 4 and 5"})
    reasons.push_back(std::string("with the direction of the tool's axis x left: joints ") + joints +
                      ": their axes are not parallel");
  EXPECT_THAT(
      brief_reasons(reasons, 4),
      ElementsAre("with the direction of the tool's axis x left: no three axes in a row are parallel"));
}

TEST(BriefReasons, OtherReasonsStay) {
  EXPECT_THAT(brief_reasons({}, 3), ElementsAre());
  EXPECT_THAT(brief_reasons({"b", "a", "b"}, 4), ElementsAre("b", "a"));
}

}  // namespace
}  // namespace qvgen::pipeline
