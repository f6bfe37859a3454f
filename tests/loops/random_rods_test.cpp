// SPDX-License-Identifier: MIT
// Random descriptions of rods, all the way: read, counted, derived or refused with a reason, generated as C,
// compiled, loaded and solved. Freedoms are those of the rank of the reference's equations; assemblies are
// those that its Newton's steps find.
#include "random_rods.h"

#include <gtest/gtest.h>

#include "assembly_laws.h"
#include "compiled_loops.h"
#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "reference/linear_algebra.h"
#include "verify/loops/mobility.h"

namespace qvgen::test::loops {
namespace {

namespace fs = std::filesystem;

constexpr int starts = QVGEN_LOOP_RODS < 100 ? 60 : 4000;
constexpr Effort effort{QVGEN_LOOP_RODS < 100 ? 6 : 40, starts, QVGEN_LOOP_RODS < 100 ? 2 : 10};

/// Freedoms at an assembly while some joints are held, by the reference's equations.
Eigen::Index freedoms_at(const reference::LoopMechanism& of, const VectorXd& q,
                         const std::vector<Eigen::Index>& held) {
  const MatrixXd loops = reference::gap_jacobian(of, q);
  MatrixXd rows = MatrixXd::Zero(loops.rows() + static_cast<Eigen::Index>(held.size()), q.size());
  rows.topRows(loops.rows()) = loops;
  for (std::size_t i = 0; i < held.size(); ++i)
    rows(loops.rows() + static_cast<Eigen::Index>(i), held[i]) = 1;
  return q.size() - reference::rank(rows, 1e-9);
}

/// Expects `check` to count what the reference's equations leave at most of its assemblies, and to say
/// whether the driven joints hold all others. Returns whether there are as many of these, and they do.
bool expect_freedoms(const model::Mechanism& mechanism, const reference::LoopMechanism& of) {
  const auto count = static_cast<Eigen::Index>(of.chain.joints.size());
  const auto assembled = reference::assemblies(of, VectorXd::Zero(count), {}, 20, 1);
  const verify::Mobility mobility = verify::mobility_of(mechanism);
  EXPECT_FALSE(assembled.empty());
  EXPECT_TRUE(mobility.assembled);
  Eigen::Index free = count, loose = count;
  for (const VectorXd& q : assembled) {
    free = std::min(free, freedoms_at(of, q, {}));
    loose = std::min(loose, freedoms_at(of, q, of.driven));
  }
  EXPECT_EQ(mobility.free, free);
  EXPECT_EQ(mobility.loose.empty(), loose == 0);
  return free == static_cast<Eigen::Index>(of.driven.size()) && loose == 0;
}

struct Tried {
  int derived = 0, refused = 0, assemblies = 0;
};

/// Tries one way through the loops; `given` are its joints here and there.
void try_way(const std::string& function, const reference::LoopMechanism& of,
             const std::vector<Eigen::Index>& given, const Compiled& compiled, unsigned seed, Tried& tried) {
  ASSERT_TRUE(compiled.has("m_" + function)) << function;
  std::mt19937 random(seed);
  const auto dof = static_cast<Eigen::Index>(of.chain.joints.size());
  const auto solve = [&](const VectorXd& a) { return compiled.solve("m_" + function, a, dof); };
  ++tried.derived;
  tried.assemblies += compare(of, given, solve, effort, random);
}

void try_mechanism(unsigned seed, const fs::path& folder, Tried& tried) {
  const fs::path file = folder / "m.toml";
  const RandomRods rods(seed, file);
  SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + rods.text());
  const auto read = description::read_file(file.string());
  ASSERT_TRUE(read.robot) << description::to_string(read.diagnostics.front());
  const model::Mechanism mechanism{*read.robot, read.tips, read.loops};
  const reference::LoopMechanism of = reference::load_loops(file);
  const bool is_driven = expect_freedoms(mechanism, of);
  std::vector<std::pair<std::string, const std::vector<Eigen::Index>*>> ways;
  for (const auto& [function, joints, of_reference] :
       {std::tuple{"assemble", &mechanism.loops.actuated, &of.driven},
        std::tuple{"assemble_from_outputs", &mechanism.loops.outputs, &of.outputs}}) {
    if (joints->empty()) continue;
    const auto plan = derive::loops::assembly_plan(mechanism, *joints);
    if (plan.found && is_driven) {
      ways.emplace_back(function, of_reference);
      continue;
    }
    ++tried.refused;
    EXPECT_TRUE(!is_driven || !plan.reasons.empty());
    EXPECT_FALSE(is_driven && rods.is_chain()) << plan.reasons.front();
  }
  if (ways.empty()) return;
  const Compiled compiled(file, "assembly");
  for (const auto& [function, given] : ways) try_way(function, of, *given, compiled, seed, tried);
}

TEST(RandomRods, HaveAllAssembliesOrAReasonAndTheFreedomsOfTheirRank) {
  const Folder folder;
  Tried tried;
  for (unsigned seed = 1; seed <= QVGEN_LOOP_RODS && !HasFailure(); ++seed)
    try_mechanism(seed, folder.path, tried);
  EXPECT_GT(tried.assemblies, 0);
  EXPECT_GE(tried.derived, tried.refused);
  RecordProperty("derived", tried.derived);
  RecordProperty("refused", tried.refused);
}

}  // namespace
}  // namespace qvgen::test::loops
