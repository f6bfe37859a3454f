// SPDX-License-Identifier: MIT
// Arms of four to six joints whose axes cross as people make them. If their joints move the tool in as many
// ways, the poses that they reach are solved.
#include <cstdlib>
#include <ostream>

#include <gtest/gtest.h>

#include "derive/inverse/inverse.h"
#include "description/reader.h"
#include "pipeline/products/inverse_derivation.h"
#include "right_angled.h"
#include "verify/inverse/certify.h"

namespace qvgen::test {
namespace {

struct Kind {
  int joints, slides, seeds, arms;
};
std::ostream& operator<<(std::ostream& out, const Kind& kind) {
  return out << kind.joints << " joints, " << kind.slides << " of which slide";
}

/// Returns how many times as many arms are tried as in a usual run: QVGEN_RIGHT_ANGLES, 1 without it.
int times() {
  const char* wanted = std::getenv("QVGEN_RIGHT_ANGLES");
  return wanted == nullptr ? 1 : std::atoi(wanted);
}

class RightAngles : public testing::TestWithParam<Kind> {};

TEST_P(RightAngles, ArmsThatMoveTheToolInAllWaysAreSolved) {
  const Kind& kind = GetParam();
  int arms = 0;
  for (int seed = 1; seed <= times() * kind.seeds; ++seed) {
    RightAngled arm(static_cast<std::uint32_t>(seed), kind.joints, kind.slides);
    if (!arm.moves_in_all_ways()) continue;
    ++arms;
    auto read = description::read_text(arm.text(), "arm.toml");
    ASSERT_TRUE(read.robot) << arm.text();
    read.robot->inverse.task = model::Task::pose;
    const pipeline::InverseDerivation derivation = pipeline::derive_inverse(*read.robot);
    EXPECT_TRUE(derivation.found()) << arm.text()
                                    << (derivation.reasons.empty() ? "" : derivation.reasons.front());
    for (const auto& form : derivation.closed_forms)
      EXPECT_NO_THROW(verify::certify_inverse(form.problem, lower(form.plan), 1)) << arm.text();
  }
  EXPECT_GE(arms, kind.arms);
}

INSTANTIATE_TEST_SUITE_P(Kinds, RightAngles,
                         testing::Values(Kind{4, 0, 150, 50}, Kind{4, 1, 150, 50}, Kind{4, 2, 150, 50},
                                         Kind{4, 3, 150, 30}, Kind{5, 0, 100, 20}, Kind{5, 1, 100, 20},
                                         Kind{5, 2, 100, 20}, Kind{6, 0, 100, 10}, Kind{6, 1, 100, 10},
                                         Kind{6, 2, 100, 10}, Kind{6, 3, 100, 10}));

}  // namespace
}  // namespace qvgen::test
