// SPDX-License-Identifier: MIT
// Which forks of loops are solved apart from each other: counted by hand for mechanisms whose legs are known
// to be independent, and a law for all of them: whatever is solved early reads only what is known there.
#include "emit/inverse/early_forks.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "derive/inverse/schedule.h"
#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "emit/cpp/printer.h"
#include "emit/inverse/every_assembly.h"

namespace qvgen::test::early_forks {
namespace {

using derive::inverse::Plan;
using emit::EarlyFork;
using testing::ElementsAre;
using testing::IsEmpty;

const std::filesystem::path folder = QVGEN_LOOP_ROBOTS;

model::Mechanism mechanism_of(const std::filesystem::path& file) {
  const auto result = description::read_file(file.string());
  if (!result.robot) throw std::runtime_error(description::to_string(result.diagnostics.front()));
  return {*result.robot, result.tips, result.loops};
}

Plan plan_from_motors(const std::string& name) {
  const model::Mechanism mechanism = mechanism_of(folder / (name + ".toml"));
  return derive::loops::assembly_plan(mechanism, mechanism.loops.actuated).plan;
}
Plan plan_from_outputs(const std::string& name) {
  const model::Mechanism mechanism = mechanism_of(folder / (name + ".toml"));
  return derive::loops::assembly_plan(mechanism, mechanism.loops.outputs).plan;
}

/// Depths of the forks of a plan that are solved early.
std::vector<int> depths(const Plan& plan, bool all = true) {
  std::vector<int> result;
  for (const EarlyFork& fork : emit::early_forks(plan, all)) result.push_back(fork.depth);
  return result;
}

/// Numbers of the forks over whose values those of a plan go.
std::vector<int> over(const Plan& plan, bool all = true) {
  std::vector<int> result;
  for (const EarlyFork& fork : emit::early_forks(plan, all)) result.push_back(fork.over);
  return result;
}

TEST(EarlyForks, TheArmsOfADeltaReadNothingOfEachOther) {
  EXPECT_THAT(depths(plan_from_outputs("delta")), ElementsAre(0, 0, 0));
  EXPECT_THAT(depths(plan_from_outputs("delta"), false), ElementsAre(0, 0));
}

TEST(EarlyForks, TheRodsOfAnAnkleReadNothingOfEachOther) {
  EXPECT_THAT(depths(plan_from_outputs("ankle")), ElementsAre(0, 0));
}

TEST(EarlyForks, LegsOfThePlatformReadItsTurnAlone) {
  const Plan plan = plan_from_outputs("../platforms/three_rps");
  EXPECT_THAT(depths(plan), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(over(plan), ElementsAre(-1, 0, 0, 0));
  EXPECT_THAT(depths(plan, false), ElementsAre(1, 1));
  for (const EarlyFork& leg : emit::early_forks(plan, false)) {
    ASSERT_EQ(leg.behind.size(), 1U);  // the turn of the leg follows from its length
    EXPECT_THAT(leg.handed, IsEmpty());
  }
}

TEST(EarlyForks, TheLastRodOfAPalletiserGoesOverTheOneBefore) {
  const Plan plan = plan_from_motors("palletiser");
  EXPECT_THAT(depths(plan), ElementsAre(0, 0, 1));
  EXPECT_THAT(over(plan), ElementsAre(-1, -1, 1));
  EXPECT_THAT(over(plan, false), ElementsAre(-1));
}

TEST(EarlyForks, TheRockerOfAnExcavatorReadsItsCylinderAlone) {
  const Plan plan = plan_from_motors("excavator");
  EXPECT_THAT(depths(plan), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(over(plan), ElementsAre(-1, -1, -1, 2));
}

/// True if rows of a plan are appended without marks where all forks are solved side by side.
bool has_regular_rows(const Plan& plan, bool as_found = true, emit::Signs signs = emit::Signs::side_by_side) {
  const auto statements = emit::every_assembly(derive::inverse::lower(plan), signs, as_found);
  const emit::ast::Lines lines = emit::CppPrinter("Lanes").body({"t", "q", "found"}, statements);
  return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find("append_regular") != std::string::npos;
  });
}

TEST(EarlyForks, RowsNeedNoMarksWhereAllForksAreStored) {
  EXPECT_TRUE(has_regular_rows(plan_from_outputs("delta")));
  EXPECT_TRUE(has_regular_rows(plan_from_motors("palletiser")));
  EXPECT_TRUE(has_regular_rows(plan_from_motors("excavator")));
  EXPECT_FALSE(has_regular_rows(plan_from_motors("excavator"), false));
  EXPECT_FALSE(has_regular_rows(plan_from_motors("excavator"), true, emit::Signs::in_turn));
  EXPECT_FALSE(has_regular_rows(plan_from_motors("ankle")));  // eight roots, no forks
}

/// Names that steps leave in so many loops, those of the fork itself, and of one over whose values it goes.
std::set<std::string> known(const Plan& plan, const EarlyFork& fork) {
  const std::vector<EarlyFork> all = emit::early_forks(plan, true);
  std::set<std::string> names;
  int forks = 0;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    forks += plan.steps[i].branches > 1 ? 1 : 0;
    const bool is_over = std::any_of(all.begin(), all.end(), [&](const EarlyFork& each) {
      return each.number == fork.over && each.has(i);
    });
    if (forks <= fork.depth || fork.has(i) || is_over)
      for (const std::string& name : derive::inverse::writes(plan.steps[i])) names.insert(name);
  }
  return names;
}

void expect_reads_what_is_known(const Plan& plan) {
  std::set<std::string> all;
  for (const derive::inverse::Step& step : plan.steps)
    for (const std::string& name : derive::inverse::writes(step)) all.insert(name);
  for (const EarlyFork& fork : emit::early_forks(plan, true)) {
    EXPECT_LE(fork.depth, fork.number);
    EXPECT_LT(fork.over, fork.number);
    const std::set<std::string> names = known(plan, fork);
    std::vector<std::size_t> steps = fork.behind;
    steps.push_back(fork.step);
    for (const std::size_t i : steps)
      for (const std::string& name : derive::inverse::reads(plan.steps[i]))
        EXPECT_TRUE(all.count(name) == 0 || names.count(name) != 0) << name;
  }
}

/// Values are named where they are first known: behind a step stand only those that read it.
void expect_is_hoisted(const Plan& plan) {
  for (const derive::inverse::Step& step : plan.steps) {
    std::set<std::string> own = {"cos_result", "sin_result", "result", "result_1", "result_2"};
    for (const auto& value : step.after.steps()) {
      derive::inverse::Step alone;
      alone.after.output(value.name, value.value);
      const std::vector<std::string> reads = derive::inverse::reads(alone);
      const bool reads_own = std::any_of(reads.begin(), reads.end(),
                                         [&](const std::string& name) { return own.count(name) != 0; });
      const bool is_joint = std::any_of(plan.joints.begin(), plan.joints.end(), [&](const auto& joint) {
        return joint.cosine == value.name.get_name() || joint.sine == value.name.get_name();
      });
      EXPECT_TRUE(reads_own || is_joint) << value.name.get_name();
      own.insert(value.name.get_name());
    }
  }
}

TEST(EarlyForks, ReadWhatIsKnownAtTheirDepth) {
  int plans = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const model::Mechanism mechanism = mechanism_of(entry.path());
    for (const auto& given : {mechanism.loops.actuated, mechanism.loops.outputs}) {
      if (given.empty()) continue;
      const auto assembly = derive::loops::assembly_plan(mechanism, given);
      if (!assembly.found) continue;
      SCOPED_TRACE(entry.path().string());
      expect_reads_what_is_known(assembly.plan);
      expect_is_hoisted(assembly.plan);
      ++plans;
    }
  }
  EXPECT_GT(plans, 15);
}

}  // namespace
}  // namespace qvgen::test::early_forks
