// SPDX-License-Identifier: MIT
// Operation counts, exact: a change that makes a function cheaper or dearer shows here.
#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "description/reader.h"
#include "optimise/dynamics.h"

namespace qvgen::optimise {
namespace {

/// A row of a table after Khalil and Kleinfinger (modified Denavit-Hartenberg).
struct Row {
  char kind;  ///< R or P
  std::string alpha, a, d;
};
using Table = std::vector<Row>;

model::Robot robot_of(const Table& table) {
  std::string text = "name = \"x\"\ntitle = \"x\"\nconvention = \"modified\"\ninertia = \"free\"\n";
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Row& row = table[i];
    const std::string q = "\"q" + std::to_string(i + 1) + "\"";
    const bool turns = row.kind == 'R';
    text += "[[dh]]\ntype = \"" + std::string(turns ? "revolute" : "prismatic") + "\"\nvariable = " + q +
            (turns ? "\ntheta = " : "\nd = ") + q + "\nalpha = \"" + row.alpha + "\"\na = \"" + row.a +
            "\"\n" + (turns ? "d = \"" + row.d + "\"\n" : "");
  }
  return description::read_text(text, "table.toml").robot.value();
}

const Table puma = {{'R', "0", "0", "0"},         {'R', "-90 deg", "0", "0"}, {'R', "0", "a2", "d3"},
                    {'R', "-90 deg", "a3", "d4"}, {'R', "90 deg", "0", "0"},  {'R', "-90 deg", "0", "0"}};
const Table stanford = {{'R', "0", "0", "0"}, {'R', "-90 deg", "0", "d2"}, {'P', "90 deg", "0", "0"},
                        {'R', "0", "0", "0"}, {'R', "-90 deg", "0", "0"},  {'R', "90 deg", "0", "0"}};
const Table stanford_a3 = {{'R', "0", "0", "0"},  {'R', "-90 deg", "0", "d2"}, {'P', "90 deg", "0", "0"},
                           {'R', "0", "a3", "0"}, {'R', "-90 deg", "0", "0"},  {'R', "90 deg", "0", "0"}};
const Table elbowless = {{'R', "0", "0", "0"},         {'R', "90 deg", "0", "0"}, {'R', "0", "0", "0"},
                         {'R', "-90 deg", "D3", "R4"}, {'R', "90 deg", "0", "0"}, {'R', "-90 deg", "0", "0"}};

struct Case {
  std::string name, function;
  Table table;
  int multiplications, additions;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name << ", " << c.function; }

/// The arm of a table, which is found once for all of its functions.
const DynamicsModel& model_of(const Case& c) {
  static std::map<std::string, DynamicsModel> models;
  const auto known = models.find(c.name);
  return known != models.end() ? known->second
                               : models.emplace(c.name, dynamics_model(robot_of(c.table))).first->second;
}

class FreeInertias : public testing::TestWithParam<Case> {};

/// All inertias symbols, in base parameters. The fewest published: PUMA 560 301/240 and 247/163, Stanford arm
/// 262/211 and 147/105, multiplications/additions of inverse dynamics and mass matrix.
TEST_P(FreeInertias, TakesThatManyOperations) {
  const Case& c = GetParam();
  const auto& all = dynamics_quantities();
  const auto quantity =
      std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.name == c.function; });
  ASSERT_NE(quantity, all.end());
  const dag::OperationCounts counts = generate_dynamics(model_of(c), *quantity).counts;
  EXPECT_EQ(counts.multiplications, c.multiplications);
  EXPECT_EQ(counts.additions, c.additions);
  EXPECT_EQ(counts.divisions, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Tables, FreeInertias,
    testing::Values(Case{"PUMA 560", "inverse_dynamics", puma, 223, 203},
                    Case{"PUMA 560", "mass_matrix", puma, 117, 120},
                    Case{"Stanford", "inverse_dynamics", stanford, 196, 180},
                    Case{"Stanford", "mass_matrix", stanford, 86, 87},
                    Case{"Stanford, a3", "inverse_dynamics", stanford_a3, 200, 186},
                    Case{"Stanford, a3", "mass_matrix", stanford_a3, 94, 95},
                    Case{"6R of RX-90's twists, without forearm", "inverse_dynamics", elbowless, 190, 182},
                    Case{"6R of RX-90's twists, without forearm", "mass_matrix", elbowless, 87, 95}));

struct Generated {
  std::string robot, function;
  int multiplications, additions;
};
void PrintTo(const Generated& g, std::ostream* out) { *out << g.robot << ", " << g.function; }

class GeneratedCounts : public testing::TestWithParam<Generated> {};

TEST_P(GeneratedCounts, AreThese) {
  std::ifstream file(QVGEN_SOURCE_DIR "/generated/operation_counts.json");
  const auto emitted = nlohmann::json::parse(file)[GetParam().robot][GetParam().function]["emitted"];
  EXPECT_EQ(emitted["mul"], GetParam().multiplications);
  EXPECT_EQ(emitted["add"], GetParam().additions);
}

/// The fewest published or generated elsewhere, base parameters: RX-90 253/238 and 195/133, general 6R
/// 425/369. With numbers folded in: PUMA 560 347/260 and 192/152, Stanford arm 339/250.
INSTANTIATE_TEST_SUITE_P(Robots, GeneratedCounts,
                         testing::Values(Generated{"general_6r", "inverse_dynamics", 360, 307},
                                         Generated{"general_6r", "mass_matrix", 307, 258},
                                         Generated{"rx90", "inverse_dynamics", 215, 191},
                                         Generated{"rx90", "mass_matrix", 102, 104},
                                         Generated{"puma560", "inverse_dynamics", 144, 125},
                                         Generated{"puma560", "mass_matrix", 68, 67},
                                         Generated{"stanford", "inverse_dynamics", 114, 92},
                                         Generated{"stanford", "mass_matrix", 50, 46},
                                         Generated{"iiwa14", "inverse_dynamics", 189, 166},
                                         Generated{"iiwa14", "mass_matrix", 96, 95}));

}  // namespace
}  // namespace qvgen::optimise
