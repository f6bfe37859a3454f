// SPDX-License-Identifier: MIT
// Mechanisms whose loops close in several ways that differ: a scissor whose bars lie on each other moves more
// than one that stands, a third bar leaves one of a parallelogram's two, and a cylinder has no length below
// zero though its loop closes there, too.
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly_laws.h"
#include "compiled_loops.h"
#include "derive/inverse/lower.h"
#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "standing_functions.h"
#include "verify/loops/certify_loops.h"
#include "verify/loops/driven.h"
#include "verify/loops/mobility.h"

namespace qvgen::test::loop_kinds {
namespace {

model::Mechanism mechanism_of(const description::ReadResult& result) {
  if (!result.robot) throw std::runtime_error(description::to_string(result.diagnostics.front()));
  return {*result.robot, result.tips, result.loops};
}

void expect_certificate(const model::Mechanism& mechanism) {
  const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  ASSERT_TRUE(plan.found);
  constexpr int inputs = 40;
  const auto found = verify::certify_loops(mechanism, plan, derive::inverse::lower(plan.plan), inputs);
  EXPECT_EQ(found.inputs, inputs);
}

const std::string scissor = std::string(QVGEN_LOOP_ROBOTS) + "/../platforms/scissor.toml";

TEST(Kinds, AScissorsFootMovesAllBarsAlthoughTheyTurnByThemselvesWhereFeetMeet) {
  const auto mechanism = mechanism_of(description::read_file(scissor));
  const auto mobility = verify::mobility_of(mechanism);
  EXPECT_EQ(mobility.free, 1);
  EXPECT_TRUE(mobility.loose.empty());
  EXPECT_TRUE(mobility.still.empty());
  expect_certificate(mechanism);
}

/// Without named motors the bars on each other, which two motors would turn, are not taken for the scissor.
TEST(Kinds, AScissorWithoutMotorsHasOneFreedom) {
  std::ifstream file(scissor);
  std::string text(std::istreambuf_iterator<char>(file), {});
  const std::string driven = "actuated = [\"foot\"]\n";
  text.erase(text.find(driven), driven.size());
  const auto mechanism = mechanism_of(description::read_text(text, "scissor.toml"));
  ASSERT_TRUE(mechanism.loops.actuated.empty());
  EXPECT_EQ(verify::mobility_of(mechanism).free, 1);
  const auto found = verify::driven_choices(mechanism);
  EXPECT_EQ(found.free, 1U);
  EXPECT_EQ(found.choices, (std::vector<std::vector<std::size_t>>{{0}, {1}, {2}, {3}, {4}}));
}

/// Both stages open upwards or downwards, and move as multipliers say.
TEST(Kinds, AScissorThatStandsHasFourAssemblies) {
  const loops::Folder folder;
  const std::filesystem::path file = folder.path / "scissor.toml";
  std::filesystem::copy(scissor, file);
  const reference::LoopMechanism of = reference::load_loops(file);
  const loops::Compiled compiled(file, "dynamics,assembly");
  const loops::StandingFunctions functions(compiled, "scissor", of);
  for (double foot = -0.95; foot < 1; foot += 0.2) {
    const Eigen::VectorXd given = Eigen::VectorXd::Constant(1, foot);
    const loops::Set set = compiled.solve("scissor_assemble", given, 5);
    loops::expect_closed(of, set);
    EXPECT_EQ(set.rows.size(), 4U) << foot;
    for (const loops::Row& row : set.rows) {
      EXPECT_GT(functions.drive_measure(row.q), 1e-3);
      loops::expect_motion_laws(functions, of, row.q, 1);
    }
    const Eigen::VectorXd q = loops::with_values(of, of.driven, given);
    for (const Eigen::VectorXd& other : reference::assemblies(of, q, of.driven, 60, 1))
      EXPECT_TRUE(loops::has(of, set, other, 1e-6)) << other.transpose();
  }
}

/// A third bar in a parallelogram is in the way if its pins are two loops, and holds nothing more as a rod.
TEST(Kinds, AThirdBarOfAParallelogramIsARod) {
  const std::string joint = "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = ",
                    on_base = "parent = \"base\"\n";
  const std::string bars = "name = \"m\"\ntitle = \"m\"\nactuated = [\"a\"]\n" + joint +
                           "\"a\"\nlink = [0.3, 0, 0]\n" + joint + "\"b\"\n" + joint + "\"c\"\n" + on_base +
                           "origin = [1, 0, 0]\n";
  const std::string pin =
      "[[tip]]\nname = \"end\"\n[[loop]]\ntype = \"pin\"\nbetween = [\"b\", \"c\"]\n"
      "at = [[1, 0, 0], [0.3, 0, 0]]\n";
  const auto by_pins = mechanism_of(description::read_text(
      bars + joint + "\"d\"\n" + on_base + "origin = [0.5, 0, 0]\n" + pin +
          "[[loop]]\ntype = \"pin\"\nbetween = [\"b\", \"d\"]\nat = [[0.5, 0, 0], [0.3, 0, 0]]\n",
      "m.toml"));
  EXPECT_EQ(verify::mobility_of(by_pins).free, 1);
  const auto plan = derive::loops::assembly_plan(by_pins, by_pins.loops.actuated);
  ASSERT_FALSE(plan.found);
  EXPECT_THAT(plan.reasons.front(), testing::HasSubstr("write a link between two pins as a rod"));
  const auto by_rod =
      mechanism_of(description::read_text(bars + pin +
                                              "[[loop]]\ntype = \"rod\"\nbetween = [\"base\", \"b\"]\nat = "
                                              "[[0.5, 0, 0], [0.5, 0, 0]]\nlength = 0.3\n",
                                          "m.toml"));
  EXPECT_EQ(verify::mobility_of(by_rod).redundant, std::vector<std::size_t>{1});
  expect_certificate(by_rod);
}

/// A rack follows a cylinder that a crank stretches.
TEST(Kinds, ACylinderIsAboveZeroAndSoIsWhatFollowsIt) {
  const auto mechanism = mechanism_of(description::read_text(R"(
name = "m"
title = "m"
actuated = ["crank"]
[[joint]]
type = "revolute"
axis = "+z"
variable = "crank"
[[joint]]
type = "prismatic"
axis = "+x"
variable = "length"
parent = "base"
[[joint]]
type = "prismatic"
axis = "+y"
variable = "rack"
parent = "base"
follows = "2 length - 0.3"
[[tip]]
name = "end"
[[loop]]
type = "rod"
between = ["crank", "base"]
at = [[0.4, 0, 0], [1, 0.1, 0.2]]
length = "length"
)",
                                                             "m.toml"));
  const verify::LoopNumbers numbers(mechanism);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto q = numbers.assembled(seed);
    ASSERT_TRUE(q.has_value());
    EXPECT_GT((*q)[1], 0);
    EXPECT_NEAR((*q)[2], 2 * (*q)[1] - 0.3, 1e-10);
  }
  expect_certificate(mechanism);
}

}  // namespace
}  // namespace qvgen::test::loop_kinds
