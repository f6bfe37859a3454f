// SPDX-License-Identifier: MIT
// Arms of four joints whose axes cross as people make them: along x, y and z, with many offsets of zero. If
// turns and slides move the tool in four ways, the poses that they reach have a plan.
#include <algorithm>
#include <array>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "derive/inverse/inverse.h"
#include "description/reader.h"
#include "reference/chain.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"
#include "verify/inverse/certify.h"

namespace qvgen::derive::inverse {
namespace {

class Arm {
 public:
  Arm(std::uint32_t seed, int slides) : random_(seed) {
    std::ostringstream text;
    text << "name = \"four\"\ntitle = \"four joints at right angles\"\n";
    std::array<bool, 4> slide{};
    std::fill_n(slide.begin(), slides, true);
    std::shuffle(slide.begin(), slide.end(), random_);
    for (std::size_t i = 0; i < 4; ++i) {
      text << "[[joint]]\ntype = \"" << (slide.at(i) ? "prismatic" : "revolute") << "\"\naxis = \""
           << "+-"[below(2)] << "xyz"[below(3)] << "\"\nvariable = \"q" << i + 1 << "\"\nlink = [";
      for (int k = 0; k < 3; ++k)
        text << (k > 0 ? ", " : "") << (below(10) < 7 ? 0 : 0.001 * (below(800) - 400));
      text << "]\n";
    }
    text_ = text.str();
  }

  [[nodiscard]] const std::string& text() const { return text_; }

  /// True if the four velocities are independent at one of three places.
  [[nodiscard]] bool moves_in_four_ways() {
    const reference::Chain chain = reference::load_text(text_);
    for (int place = 0; place < 3; ++place) {
      reference::VectorXd q(4);
      for (double& each : q) each = std::uniform_real_distribution<double>(-1, 1)(random_);
      if (reference::smallest_singular_value(reference::jacobian(chain, q)) > 1e-4) return true;
    }
    return false;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }

  std::mt19937 random_;
  std::string text_;
};

/// True if Newton's steps end a plan, as they must where slides follow from turns: near a singular pose these
/// lose digits.
bool takes_newtons_steps(const Plan& plan) {
  return std::any_of(plan.steps.begin(), plan.steps.end(),
                     [](const Step& step) { return step.is<kind::Newton>(); });
}

class FourJoints : public testing::TestWithParam<int> {};

TEST_P(FourJoints, ThatMoveTheToolInFourWaysAreSolved) {
  int arms = 0;
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    Arm arm(seed, GetParam());
    if (!arm.moves_in_four_ways()) continue;
    ++arms;
    auto read = description::read_text(arm.text(), "four.toml");
    ASSERT_TRUE(read.robot) << arm.text();
    read.robot->inverse.task = model::Task::pose;
    const Derivation derivation = derive(*read.robot);
    EXPECT_TRUE(derivation.found) << arm.text()
                                  << (derivation.reasons.empty() ? "" : derivation.reasons.front());
    if (!derivation.found) continue;
    if (derivation.plan.structure.starts_with("two joints turn the tool")) {
      EXPECT_TRUE(takes_newtons_steps(derivation.plan)) << arm.text();
    }
    EXPECT_NO_THROW(verify::certify_inverse(derivation.problem, lower(derivation.plan), 1)) << arm.text();
  }
  EXPECT_GT(arms, 30);
}

INSTANTIATE_TEST_SUITE_P(Slides, FourJoints, testing::Range(0, 4));

}  // namespace
}  // namespace qvgen::derive::inverse
