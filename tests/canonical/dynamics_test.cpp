// SPDX-License-Identifier: MIT
// Dynamics of right-angled arms cost the same in any notation, and are certified against the plain recursion
// over the description that they are written for.
#include <cstdlib>

#include <gtest/gtest.h>

#include "canonical/right_angles.h"
#include "dag/counts.h"
#include "description/reader.h"
#include "model/arithmetic.h"
#include "optimise/dynamics_derivatives.h"
#include "other_notation.h"
#include "pipeline/pipeline.h"

namespace qvgen {
namespace {

using optimise::DynamicsModel;
using optimise::Optimised;

/// Settings of a short search: its counts are not the best, but equal for equal arms.
constexpr optimise::DynamicsEffort little{.trial_steps = 500, .final_steps = 5'000, .certificate_points = 1};

/// Every function of dynamics; each is certified as it is made.
std::vector<Optimised> all_functions(const model::Robot& robot) {
  const DynamicsModel model = optimise::dynamics_model(robot, little);
  std::vector<optimise::DynamicsQuantity> quantities = optimise::dynamics_quantities();
  for (const auto& loaded : optimise::loaded_quantities()) quantities.push_back(loaded.quantity);
  std::vector<Optimised> functions;
  for (const auto& quantity : quantities) {
    try {
      functions.push_back(optimise::generate_dynamics(model, quantity, little));
    } catch (const derive::dynamics::MasslessLink&) {
      EXPECT_EQ(quantity.name.find("forward_dynamics"), 0U);
    }
  }
  functions.push_back(optimise::inverse_dynamics_derivatives(model, functions.front(), little));
  functions.push_back(
      optimise::regressor_function(model, derive::dynamics::regressor(model.arm.robot), little));
  return functions;
}

void expect_equal_counts(const model::Robot& robot, const model::Robot& other) {
  const std::vector<Optimised> own = all_functions(robot);
  const std::vector<Optimised> theirs = all_functions(other);
  ASSERT_EQ(own.size(), theirs.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(own[i].counts, theirs[i].counts) << own[i].name;
    // Signs and zeros cost nothing on the way back to the description.
    for (const Optimised* function : {&own[i], &theirs[i]})
      EXPECT_EQ(dag::count(function->function, derive::dynamics::is_constant_symbol), function->counts)
          << function->name;
  }
}

model::Robot random_arm(test::InertiasIn kind, std::mt19937& random) {
  model::Robot robot = test::random_right_angled_robot(random);
  robot.joints.resize(std::min<std::size_t>(robot.joints.size(), 4));
  return test::with_random_inertias(std::move(robot), kind, random);
}

/// Arms of each kind. An arm and its other notation differ in the zero, the sense and the frame of every
/// joint, so that few arms show what depends on them; long runs have more.
int arm_count() {
  const char* wanted = std::getenv("QVGEN_ARMS");
  return wanted == nullptr ? 1 : std::atoi(wanted);
}

class Inertias : public ::testing::TestWithParam<test::InertiasIn> {};

TEST_P(Inertias, OfRandomArmsGiveEqualCountsInAnyNotation) {
  std::mt19937 random(GetParam() == test::InertiasIn::numbers ? 7 : 10);
  for (int k = 0; k < arm_count(); ++k) {
    const model::Robot robot = random_arm(GetParam(), random);
    expect_equal_counts(robot, test::in_another_notation(robot, random));
    if (HasFailure()) FAIL() << "arm " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Inertias,
                         ::testing::Values(test::InertiasIn::numbers, test::InertiasIn::symbols),
                         [](const auto& test) {
                           return test.param == test::InertiasIn::numbers ? "Numbers" : "Symbols";
                         });

/// Another author names what he measures in his own link frames, so that the symbols are not those of the
/// first in other places: neither names nor signs of free inertias count.
TEST(DynamicsNotation, DoesNotDependOnTheNamesOfFreeInertias) {
  std::mt19937 random(8);
  for (int k = 0; k < arm_count(); ++k) {
    const model::Robot robot = test::with_free_inertias(random_arm(test::InertiasIn::numbers, random));
    expect_equal_counts(robot, test::with_free_inertias(test::in_another_notation(robot, random)));
    if (HasFailure()) FAIL() << "arm " << k;
  }
}

/// Keeps the description's frames if right angles do not say it all.
TEST(DynamicsNotation, KeepsTheFramesOfLinksThatAreTurnedByOtherAngles) {
  std::mt19937 random(9);
  model::Robot robot = random_arm(test::InertiasIn::numbers, random);
  EXPECT_FALSE(canonical::whatever_notation_with_links(robot).front().reversed.empty());
  const auto turned = [](const cln::cl_RA& radians) {
    return model::Displacement{{{model::unit_vector(0), model::Expression(radians)}}, {}};
  };
  model::Joint& first = robot.joints.front();
  model::Displacement& next = robot.joints.size() > 1 ? robot.joints[1].before : robot.tool;
  first.after = model::compose(first.after, turned(1));
  next = model::compose(turned(-1), next);
  EXPECT_FALSE(canonical::right_angled_models(robot).empty());
  const std::vector<canonical::Arm> arms = canonical::whatever_notation_with_links(robot);
  ASSERT_EQ(arms.size(), 1U);
  EXPECT_FALSE(arms.front().has_phases());
  EXPECT_TRUE(arms.front().reversed.empty());
}

nlohmann::json counts_of(const model::Robot& robot, pipeline::Language language) {
  return pipeline::generate({robot}, {"dynamics_derivatives", "dynamics_loads", "regressor"}, {}, {},
                            language)
      .front()
      .counts;
}

/// A robot in another notation has the counts that it is given.
void expect_counts(const model::Robot& robot, const nlohmann::json& own, pipeline::Language language) {
  std::mt19937 random(3);
  model::Robot other = test::in_another_notation(robot, random);
  other.name += "_written_otherwise";
  const nlohmann::json theirs = counts_of(other, language);
  ASSERT_EQ(theirs.size(), 16U);
  for (const auto& [function, entry] : theirs.items())
    EXPECT_EQ(entry.at("emitted"), own.at(function).at("emitted")) << function;
}

model::Robot robot_of_library(const std::string& name) {
  const auto described =
      description::read_file(std::string(QVGEN_SOURCE_DIR) + "/generator/robots/" + name + ".toml");
  if (!described.robot) throw std::runtime_error("not read: " + name);
  return *described.robot;
}

class RobotsOfLibrary : public ::testing::TestWithParam<const char*> {};

/// Random arms stand for these in usual runs.
TEST_P(RobotsOfLibrary, HaveEqualCountsInAnyNotation) {
  if (!test::is_long_run()) GTEST_SKIP() << "long runs have it";
  expect_counts(robot_of_library(GetParam()), test::committed_counts(GetParam()), pipeline::Language::cxx);
}

INSTANTIATE_TEST_SUITE_P(Robots, RobotsOfLibrary, ::testing::Values("puma560", "irb6640", "stanford"),
                         [](const auto& test) { return std::string(test.param); });

TEST(DynamicsNotation, GivesEqualCountsInC) {
  const model::Robot robot = robot_of_library("ns_arm");
  expect_counts(robot, counts_of(robot, pipeline::Language::c), pipeline::Language::c);
}

}  // namespace
}  // namespace qvgen
