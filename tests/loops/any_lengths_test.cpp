// SPDX-License-Identifier: MIT
// 200 random linkages of each family, many inputs each: every length of a mechanism's description is another
// one (family.py). Every fourth linkage has the description's, with its symmetries.
#include <ankle_any.h>
#include <excavator_any.h>
#include <palletiser_any.h>
#include <planar_3rpr_any.h>
#include <planar_3rrr_any.h>
#include <rccc_any.h>
#include <seven_turns_any.h>
#include <stewart_any.h>
#include <three_rps_any.h>

#include "assembly_laws.h"

namespace qvgen::test::loops {
namespace {

constexpr Effort effort{QVGEN_LOOP_INPUTS, 4000, 100};

template <class Found>
Set set_of(const Found& found) {
  Set set{found.status, {}};
  for (const auto& row : found) set.rows.push_back({row.q, row.branch, row.continuum, found.meets(row)});
  return set;
}

template <class Any>
class Linkages {
 public:
  explicit Linkages(const std::string& name) : file_(std::string(QVGEN_FAMILIES) + name + ".toml") {}

  /// `solve` has the assemblies for values of joints and a geometry; `given` chooses the joints.
  template <class Solve>
  void compare(const Solve& solve, std::vector<Eigen::Index> reference::LoopMechanism::*given) {
    int assemblies = 0;
    for (int k = 0; k < QVGEN_LINKAGES; ++k) {
      Values values = Any::usual;
      reference::Values named;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (k % 4 != 0) values[i] *= std::uniform_real_distribution<double>(0.6, 1.4)(random_);
        named[Any::names[i]] = values[i];
      }
      const auto of = reference::load_loops(file_, named);
      const auto geometry = Any::geometry(values);
      const auto of_values = [&](const VectorXd& a) { return set_of(solve(a, geometry)); };
      assemblies += loops::compare(of, of.*given, of_values, effort, random_);
      ASSERT_FALSE(testing::Test::HasFailure()) << "linkage " << k << " of " << file_;
    }
    EXPECT_GT(assemblies, QVGEN_LINKAGES * QVGEN_LOOP_INPUTS / 20);
  }

 private:
  using Values = std::decay_t<decltype(Any::usual)>;
  std::string file_;
  std::mt19937 random_{29};
};

#define QVGEN_LINKAGES_TEST(Name, family, function, joints)                                         \
  TEST(AnyLengths, Name) {                                                                          \
    Linkages<Any_##family>(#family "_any")                                                          \
        .compare([](const auto& a, const auto& g) { return robots::family##_any::function(a, g); }, \
                 &reference::LoopMechanism::joints);                                                \
  }

QVGEN_LINKAGES_TEST(Ankles, ankle, assemble, driven)
QVGEN_LINKAGES_TEST(AnklesFromTheirFeet, ankle, assemble_from_outputs, outputs)
QVGEN_LINKAGES_TEST(Excavators, excavator, assemble, driven)
QVGEN_LINKAGES_TEST(Palletisers, palletiser, assemble, driven)
QVGEN_LINKAGES_TEST(PlatformsOnCranks, planar_3rrr, assemble, driven)
QVGEN_LINKAGES_TEST(PlatformsOnCranksFromTheirPlaces, planar_3rrr, assemble_from_outputs, outputs)
QVGEN_LINKAGES_TEST(PlatformsOnCylinders, planar_3rpr, assemble, driven)
QVGEN_LINKAGES_TEST(PlatformsOnCylindersFromTheirPlaces, planar_3rpr, assemble_from_outputs, outputs)
QVGEN_LINKAGES_TEST(PlatformsOnSwingingLegs, three_rps, assemble_from_outputs, outputs)
QVGEN_LINKAGES_TEST(CylindricalLoops, rccc, assemble, driven)
QVGEN_LINKAGES_TEST(CylindricalLoopsFromTheirEnds, rccc, assemble_from_outputs, outputs)
QVGEN_LINKAGES_TEST(WeldedTurns, seven_turns, assemble, driven)
QVGEN_LINKAGES_TEST(GoughStewartPlatforms, stewart, assemble_from_outputs, outputs)

}  // namespace
}  // namespace qvgen::test::loops
