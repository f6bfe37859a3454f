// SPDX-License-Identifier: MIT
// Freedoms, refusals and certificates: what is counted of mechanisms that are known, and the reason where
// there is no closed form.
#include <cmath>
#include <map>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "derive/inverse/lower.h"
#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "description/write.h"
#include "verify/certificate.h"
#include "verify/loops/certify_loops.h"
#include "verify/loops/mobility.h"
#include "verify/loops/six_rods.h"

namespace qvgen::test::loops_derivation {
namespace {

using testing::HasSubstr;

model::Mechanism mechanism_of(const std::string& text) {
  const auto result = description::read_text(text, "m.toml");
  if (!result.robot) throw std::runtime_error(description::to_string(result.diagnostics.front()));
  return {*result.robot, result.tips, result.loops};
}

model::Mechanism mechanism_of_file(const std::string& name) {
  const auto result = description::read_file(std::string(QVGEN_LOOP_ROBOTS) + "/" + name + ".toml");
  if (!result.robot) throw std::runtime_error(description::to_string(result.diagnostics.front()));
  return {*result.robot, result.tips, result.loops};
}

std::string joint(const std::string& variable, const std::string& more, const std::string& type = "revolute",
                  const std::string& axis = "+z") {
  return "[[joint]]\ntype = \"" + type + "\"\naxis = \"" + axis + "\"\nvariable = \"" + variable + "\"\n" +
         more;
}
std::string pin(const std::string& a, const std::string& at, const std::string& b, const std::string& bt) {
  return "[[loop]]\ntype = \"pin\"\nbetween = [\"" + a + "\", \"" + b + "\"]\nat = [" + at + ", " + bt +
         "]\n";
}
std::string head(const std::string& actuated) {
  return "name = \"m\"\ntitle = \"m\"\nactuated = [" + actuated + "]\n";
}
const std::string tip = "[[tip]]\nname = \"end\"\n";

std::string rod(const std::string& a, const std::string& at, const std::string& b, const std::string& bt,
                const std::string& length) {
  return "[[loop]]\ntype = \"rod\"\nbetween = [\"" + a + "\", \"" + b + "\"]\nat = [" + at + ", " + bt +
         "]\nlength = " + length + "\n";
}

/// A parallelogram whose second rod holds nothing more, and rules its mirror image out.
const std::string two_rods =
    head("\"a\"") + joint("a", "") + joint("b", "parent = \"base\"\norigin = [2, 0, 0]\n") + tip +
    rod("a", "[1, 0, 0]", "b", "[1, 0, 0]", "2") + rod("a", "[0.5, 0, 0]", "b", "[0.5, 0, 0]", "2");

TEST(Mobility, CountsPlanarLoopsThatGrueblerDoesNotSee) {
  const auto four_bar = verify::mobility_of(mechanism_of_file("four_bar"));
  EXPECT_TRUE(four_bar.assembled);
  EXPECT_EQ(four_bar.free, 1);
  EXPECT_EQ(four_bar.gruebler, -2);
  EXPECT_TRUE(four_bar.redundant.empty());
  EXPECT_TRUE(four_bar.still.empty());
  EXPECT_EQ(verify::mobility_of(mechanism_of_file("five_bar")).free, 2);
  EXPECT_EQ(verify::mobility_of(mechanism_of_file("palletiser")).free, 4);
  EXPECT_EQ(verify::mobility_of(mechanism_of_file("delta")).free, 3);
  EXPECT_EQ(verify::mobility_of(mechanism_of_file("ankle")).free, 2);
  EXPECT_EQ(verify::mobility_of(mechanism_of_file("planar_3rpr")).free, 3);
  EXPECT_EQ(verify::mobility_of(mechanism_of_file("../platforms/hexapod")).free, 6);
  EXPECT_EQ(verify::mobility_of(mechanism_of_file("../platforms/stewart")).free, 6);
  EXPECT_EQ(verify::mobility_of(mechanism_of_file("../platforms/three_rps")).free, 3);
}

/// Two turns about one axis: a rod tells their sum, which the driven slide tells as well.
TEST(Mobility, NamesJointsThatDrivenOnesLeaveLoose) {
  const auto text = [](const std::string& actuated) {
    return head(actuated) + joint("a", "") + joint("b", "") +
           joint("s", "parent = \"base\"\norigin = [0, 1, 0]\n", "prismatic", "+x") + tip +
           rod("s", "[0, 0, 0]", "b", "[0.5, 0, 0]", "0.8");
  };
  const auto slide_alone = verify::mobility_of(mechanism_of(text("\"s\"")));
  EXPECT_EQ(slide_alone.free, 2);
  const auto both = verify::mobility_of(mechanism_of(text("\"a\", \"s\"")));
  EXPECT_TRUE(both.loose.empty());
  EXPECT_EQ(slide_alone.loose, (std::vector<std::size_t>{0, 1}));
}

TEST(SixRodsOf, KnowsThePlatformWithItsEndsAsTheTipSeesThem) {
  const auto platform = verify::six_rods_of(mechanism_of_file("../platforms/stewart"));
  ASSERT_TRUE(platform);
  EXPECT_EQ(platform->lengths, (std::vector<std::size_t>{6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(platform->ends.base[1], (std::array<double, 3>{-0.1, 0.41, 0}));
  EXPECT_NEAR(platform->ends.platform[1][1], 0.22, 1e-15);
  EXPECT_NEAR(platform->ends.platform[1][2], -0.07, 1e-15);
  for (const char* other : {"../platforms/hexapod", "../platforms/three_rps", "delta", "four_bar"})
    EXPECT_FALSE(verify::six_rods_of(mechanism_of_file(other))) << other;
}

TEST(Mobility, SaysHowManyAreFreeAndDriven) {
  const auto mechanism = mechanism_of_file("four_bar");
  EXPECT_THAT(
      verify::text_of(verify::mobility_of(mechanism), mechanism).front(),
      HasSubstr("1 freedom, 1 driven; Gruebler's formula counts -2, since it does not see that axes are "
                "parallel"));
  // Rods are no pins: their axes are parallel, and yet only the redundant one is why.
  const auto rods = mechanism_of(two_rods);
  EXPECT_THAT(verify::text_of(verify::mobility_of(rods), rods).front(),
              HasSubstr("counts 0, since it does not see that loop 2 holds nothing more"));
}

TEST(Mobility, FindsJointsThatNeverMove) {
  // A triangle: three links with pins at all corners.
  const auto mechanism = mechanism_of(head("\"w\"") + joint("w", "") + joint("a", "origin = [1, 0, 0]\n") +
                                      joint("b", "parent = \"w\"\norigin = [3, 0, 0]\n") + tip +
                                      pin("a", "[1.5, 0, 0]", "b", "[1.2, 0, 0]"));
  const auto mobility = verify::mobility_of(mechanism);
  EXPECT_EQ(mobility.free, 1);
  EXPECT_EQ(mobility.still, (std::vector<std::size_t>{1, 2}));
  EXPECT_THAT(verify::text_of(mobility, mechanism).back(), HasSubstr("joint b never moves"));
}

TEST(Mobility, SaysThatLoopsDoNotClose) {
  const auto mechanism = mechanism_of(head("\"a\"") + joint("a", "link = [1, 0, 0]\n") + joint("c", "") +
                                      joint("b", "parent = \"base\"\norigin = [20, 0, 0]\n") + tip +
                                      pin("c", "[1, 0, 0]", "b", "[1, 0, 0]"));
  const auto mobility = verify::mobility_of(mechanism);
  EXPECT_FALSE(mobility.assembled);
  EXPECT_THAT(verify::text_of(mobility, mechanism).front(), HasSubstr("cannot be closed"));
}

std::string reasons_of(const model::Mechanism& mechanism) {
  const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  EXPECT_FALSE(plan.found);
  std::string text;
  for (const std::string& reason : plan.reasons) text += reason + "\n";
  return text;
}

TEST(AssemblyPlan, RefusesWhatItCannotDeriveWithTheReason) {
  EXPECT_THAT(reasons_of(mechanism_of_file("../platforms/hexapod")),
              HasSubstr("loop 1 has no closed form: its rod places one joint, and "));
  // Links in parallel planes that do not meet.
  EXPECT_THAT(reasons_of(mechanism_of(head("\"a\"") + joint("a", "link = [1, 0, 0]\n") + joint("c", "") +
                                      joint("b", "parent = \"base\"\norigin = [1, 0, 0.1]\n") + tip +
                                      pin("c", "[1, 0, 0]", "b", "[1, 0, 0]"))),
              HasSubstr("its ends move in parallel planes that do not meet"));
  // A joint that no loop holds and no motor drives.
  EXPECT_THAT(
      reasons_of(mechanism_of(head("\"a\"") + joint("a", "link = [1, 0, 0]\n") + joint("c", "") +
                              joint("loose", "") + joint("b", "parent = \"base\"\norigin = [1, 0, 0]\n") +
                              tip + pin("c", "[1, 0, 0]", "b", "[1, 0, 0]"))),
      HasSubstr("joint loose is on no loop and is not driven"));
}

/// A slide on a line that is parallel to another one's: its root reads nothing of that, and its value does.
/// The value is read behind the next fork alone, and stays with its root.
TEST(AssemblyPlan, ReadsResultsOfAStepWithinItAlone) {
  const std::string on_base = "parent = \"base\"\n";
  const auto mechanism = mechanism_of(head("\"a\"") + joint("a", "", "prismatic", "-y") +
                                      joint("b", on_base + "origin = [0.1, 0.2, 0]\n", "prismatic", "+x") +
                                      joint("c", on_base + "origin = [0.2, 0.5, 0]\n", "prismatic", "+x") +
                                      joint("d", on_base + "origin = [1, 1, 0]\nlink = [0.5, 0.1, 0]\n") +
                                      tip + rod("a", "[0, 0, 0]", "b", "[0, 0, 0]", "0.8") +
                                      rod("b", "[0, 0, 0]", "c", "[0, 0, 0]", "0.9") +
                                      rod("d", "[0, 0, 0]", "c", "[0, 0, 0]", "1.1"));
  const auto plan = derive::loops::assembly_plan(mechanism, {0}).plan;
  ASSERT_EQ(plan.steps.size(), 3U);
  for (const auto& step : plan.steps)
    for (const std::string& name : step.before.reads())
      EXPECT_EQ(name.find("result"), std::string::npos) << step.unknown << " reads " << name;
}

TEST(AssemblyPlan, FindsTheLoopThatIsRedundant) {
  const auto mechanism = mechanism_of(two_rods);
  const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  ASSERT_TRUE(plan.found);
  EXPECT_EQ(plan.used, std::vector<std::size_t>{0});
  EXPECT_EQ(plan.redundant, std::vector<std::size_t>{1});
  const auto mobility = verify::mobility_of(mechanism);
  EXPECT_EQ(mobility.free, 1);
  EXPECT_EQ(mobility.redundant, std::vector<std::size_t>{1});
  EXPECT_THAT(verify::text_of(mobility, mechanism).back(), HasSubstr("loop 2 is redundant"));
  // The second rod takes one of the two assemblies that the first one leaves.
  const auto certificate = verify::certify_loops(mechanism, plan, derive::inverse::lower(plan.plan), 3);
  EXPECT_EQ(certificate.assemblies, certificate.inputs);
}

/// Certifies a way through the loops, from some joints.
void expect_certificate(const model::Mechanism& mechanism, const std::vector<std::size_t>& given) {
  const auto assembly = derive::loops::assembly_plan(mechanism, given);
  ASSERT_TRUE(assembly.found) << mechanism.robot.name << testing::PrintToString(assembly.reasons);
  const auto certificate =
      verify::certify_loops(mechanism, assembly, derive::inverse::lower(assembly.plan), 3);
  EXPECT_EQ(certificate.inputs, 3) << mechanism.robot.name;
  EXPECT_GE(certificate.assemblies, 3) << mechanism.robot.name;
}

TEST(LoopCertificate, HoldsForEveryMechanismFromItsMotors) {
  for (const char* name : {"four_bar", "slider_crank", "five_bar", "palletiser", "excavator", "delta",
                           "ankle", "planar_3rrr", "planar_3rpr"})
    expect_certificate(mechanism_of_file(name), mechanism_of_file(name).loops.actuated);
}

TEST(LoopCertificate, HoldsForEveryPlatformFromItsPlace) {
  for (const char* name :
       {"ankle", "delta", "planar_3rrr", "planar_3rpr", "../platforms/hexapod", "../platforms/three_rps"})
    expect_certificate(mechanism_of_file(name), mechanism_of_file(name).loops.outputs);
}

std::string slide(const std::string& a, const std::string& b, const std::string& more) {
  return "[[loop]]\ntype = \"slide\"\nbetween = [\"" + a + "\", \"" + b + "\"]\n" + more;
}

const std::string crank_and_pin = head("\"a\"") + joint("a", "link = [0.3, 0, 0]\n") + joint("b", "");

/// A block on a crank's pin that slides along a rocker.
const std::string quick_return = crank_and_pin + joint("c", "parent = \"base\"\norigin = [0.7, 0, 0]\n") +
                                 tip + slide("c", "b", "axis = \"+x\"\nat = [[0, 0.05, 0], [0, 0, 0]]\n");

/// A slide between any two links is one of four kinds, by what is open and where.
TEST(LoopCertificate, HoldsForSlidesAndWelds) {
  const std::map<std::string, std::pair<std::string, int>> mechanisms{
      {"turns on both sides", {quick_return, 2}},
      {"turns on one side, turned by a right angle",
       {crank_and_pin + joint("c", "origin = [0.9, 0, 0]\n") + tip +
            slide("base", "c",
                  "axis = [\"3/5\", \"4/5\", 0]\nat = [[0, 0.1, 0], [0.05, 0, 0]]\n"
                  "rpy = [0, 0, \"90 deg\"]\n"),
        2}},
      {"a turn and a slide",
       {crank_and_pin + joint("s", "", "prismatic", "+x") + tip +
            slide("base", "s", "axis = \"+y\"\nat = [[0.2, 0, 0], [0, 0.1, 0]]\n"),
        1}},
      {"a weld behind a slide",
       {crank_and_pin + joint("c", "origin = [0.9, 0, 0]\n") + joint("s", "", "prismatic", "+x") + tip +
            "[[loop]]\ntype = \"weld\"\nbetween = [\"s\", \"base\"]\nat = [[0, 0, 0], [0.5, 0.2, 0]]\n"
            "rpy = [0, 0, 0.3]\n",
        2}}};
  for (const auto& [name, expected] : mechanisms) {
    SCOPED_TRACE(name);
    const auto mechanism = mechanism_of(expected.first);
    EXPECT_EQ(verify::mobility_of(mechanism).free, 1);
    expect_certificate(mechanism, mechanism.loops.actuated);
    EXPECT_EQ(derive::loops::assembly_plan(mechanism, {0}).plan.capacity, expected.second);
  }
}

/// A five-bar whose cranks have gears: one turns against half of the other.
TEST(LoopCertificate, HoldsForJointsThatFollowOthers) {
  const auto mechanism = mechanism_of(
      crank_and_pin +
      joint("c",
            "parent = \"base\"\norigin = [0.7, 0, 0]\nlink = [0.2, 0, 0]\nfollows = \"a\"\nratio = \"-1/2\"\n"
            "offset = 0.4\n") +
      joint("d", "") + tip + pin("b", "[0.6, 0, 0]", "d", "[0.5, 0, 0]"));
  ASSERT_EQ(mechanism.loops.gears.size(), 1U);
  EXPECT_TRUE(mechanism.robot.joints[2].follows.empty());
  EXPECT_EQ(verify::mobility_of(mechanism).free, 1);
  expect_certificate(mechanism, mechanism.loops.actuated);
  expect_certificate(mechanism, {2});  // the one that follows leads as well
  EXPECT_THAT(
      reasons_of(
          {mechanism.robot, mechanism.tips, {mechanism.loops.closures, mechanism.loops.gears, {1}, {}}}),
      HasSubstr("joints that follow each other have no closed form here: a, c are open"));
}

/// Ways in which a value cannot be told, each with the joint to drive.
TEST(AssemblyPlan, SaysWhyJointsThatFollowOthersAreOpen) {
  const std::string four_bar = crank_and_pin + joint("c", "parent = \"base\"\norigin = [0.7, 0, 0]\n") + tip +
                               pin("b", "[0.6, 0, 0]", "c", "[0.5, 0, 0]");
  const auto reason_of = [&](const std::string& follower) {
    const auto mechanism = mechanism_of(four_bar + follower);
    EXPECT_EQ(verify::mobility_of(mechanism).free, 1);
    const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
    return plan.found ? "" : plan.reasons.front();
  };
  const std::string on_base = "parent = \"base\"\n";
  EXPECT_EQ(reason_of(joint("w", on_base + "follows = \"-3 c + 2 a + 20 deg\"\n")), "");
  EXPECT_THAT(reason_of(joint("w", on_base + "follows = \"1/2 c\"\n")),
              HasSubstr("the value of w depends on whole turns, or the length, of c"));
  EXPECT_THAT(reason_of(joint("w", on_base + "follows = \"c\"\nratio = 0.1\n", "prismatic")),
              HasSubstr("which loops do not tell; drive what leads"));
  EXPECT_EQ(reason_of(joint("w", on_base + "follows = \"a\"\nratio = \"1/7\"\noffset = 1\n", "prismatic")),
            "");
}

/// Lengths by which slides are ahead may be symbols; angles are numbers, as those of frames.
TEST(LoopCertificate, HoldsForSlidesThatAreAheadByASymbol) {
  const auto text = [](const std::string& follower) {
    return head("\"a\"") + "[defaults]\nh = 0.1\n" + joint("a", "link = [0.3, 0, 0]\n") + joint("b", "") +
           joint("c", "parent = \"base\"\norigin = [0.7, 0, 0]\n") + tip +
           pin("b", "[0.6, 0, 0]", "c", "[0.5, 0, 0]") + follower;
  };
  const auto slides =
      mechanism_of(text(joint("s", "parent = \"base\"\nfollows = \"a\"\noffset = \"h\"\n", "prismatic")));
  expect_certificate(slides, slides.loops.actuated);
  const auto turns = mechanism_of(text(joint("w", "parent = \"base\"\nfollows = \"a\"\noffset = \"h\"\n")));
  EXPECT_THROW(derive::loops::assembly_plan(turns, turns.loops.actuated), std::domain_error);
}

/// Five-bars of random lengths: one crank follows the driven one by any factor, a wheel the joints that the
/// loop holds by whole ones, and leads a rod on.
TEST(LoopCertificate, HoldsForRandomGears) {
  std::mt19937 random(5);
  const auto among = [&](int low, int high) {
    return std::to_string(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  const auto length = [&] { return "0." + among(20, 60); };
  for (int k = 0; k < 12; ++k) {
    const std::string text =
        head("\"a\"") + joint("a", "link = [" + length() + ", 0, 0]\n") + joint("b", "") +
        joint("c", "parent = \"base\"\norigin = [0.3, 0, 0]\nlink = [" + length() + ", 0, 0]\nfollows = \"-" +
                       among(1, 9) + "/" + among(1, 9) + " a + " + among(-90, 90) + " deg\"\n") +
        joint("d", "") +
        joint("w", "parent = \"base\"\norigin = [2, 0, 0]\nlink = [0.3, 0, 0]\nfollows = \"" + among(1, 4) +
                       " b - " + among(1, 4) + " d + 0." + among(0, 9) + "\"\n") +
        joint("r", "parent = \"base\"\norigin = [2, 1, 0]\n") + tip +
        pin("b", "[" + length() + ", 0, 0]", "d", "[" + length() + ", 0, 0]") +
        rod("w", "[0, 0, 0]", "r", "[0.5, 0, 0]", "0.9");
    SCOPED_TRACE(text);
    const auto mechanism = mechanism_of(text);
    EXPECT_EQ(verify::mobility_of(mechanism).free, 1);
    expect_certificate(mechanism, mechanism.loops.actuated);
  }
}

/// A description with motors and offsets is written as it was read.
TEST(LoopCertificate, HoldsForMotorsOfADifferential) {
  const auto mechanism = mechanism_of_file("geared_five_bar");
  ASSERT_EQ(mechanism.robot.joints.size(), 6U);
  EXPECT_EQ(verify::mobility_of(mechanism).free, 2);
  expect_certificate(mechanism, mechanism.loops.actuated);
  const std::string text = description::write_text(mechanism);
  const auto again = mechanism_of(text);
  EXPECT_EQ(description::write_text(again), text);
  EXPECT_EQ(again.loops.gears.size(), 2U);
  EXPECT_EQ(verify::mobility_of(again).free, 2);
}

/// The equations of a slide, against the pin's place and angle in the plane.
TEST(Mobility, ClosesSlidesAlongTheirLine) {
  const verify::LoopNumbers numbers(mechanism_of(quick_return));
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto q = numbers.assembled(seed);
    ASSERT_TRUE(q.has_value());
    const double a = (*q)[0], b = (*q)[1], c = (*q)[2];
    const double x = 0.3 * std::cos(a) - 0.7, y = 0.3 * std::sin(a);
    EXPECT_NEAR(std::cos(c) * y - std::sin(c) * x, 0.05, 1e-10);
    EXPECT_NEAR(std::cos(a + b - c), 1, 1e-12);
  }
}

TEST(AssemblyPlan, SaysWhySlidesAndWeldsDoNotClose) {
  const auto turned =
      mechanism_of(crank_and_pin + joint("c", "parent = \"base\"\norigin = [0.7, 0, 0]\n") + tip +
                   slide("c", "b", "axis = \"+x\"\nat = [[0, 0, 0], [0, 0, 0]]\nrpy = [1, 0, 0]\n"));
  EXPECT_THROW(derive::loops::assembly_plan(turned, {0}), std::domain_error);
  const auto across = mechanism_of(crank_and_pin + joint("c", "parent = \"base\"\norigin = [0.7, 0, 0]\n") +
                                   tip + slide("c", "b", "axis = \"+z\"\nat = [[0, 0, 0], [0, 0, 0]]\n"));
  EXPECT_THROW(derive::loops::assembly_plan(across, {0}), std::domain_error);
  // A weld in space is counted, and one chain of six joints.
  const auto space = mechanism_of(
      head("\"a\"") + joint("a", "") + joint("b", "origin = [1, 0, 0]\n", "revolute", "+y") +
      joint("c", "origin = [1, 0, 0]\n", "revolute", "+x") + joint("d", "origin = [0, 1, 0]\n") +
      joint("m", "origin = [1, 0, 0.3]\n", "revolute", "+y") +
      joint("f", "origin = [0, 1, 0]\n", "revolute", "+x") + joint("k", "origin = [1, 0, 0.2]\n") + tip +
      "[[loop]]\ntype = \"weld\"\nbetween = [\"k\", \"base\"]\nat = [[0, 0, 0], [1, 0.5, 0.2]]\n");
  const auto mobility = verify::mobility_of(space);
  EXPECT_EQ(mobility.gruebler, 1);
  EXPECT_EQ(mobility.free, 1);
  const auto plan = derive::loops::assembly_plan(space, {0});
  EXPECT_TRUE(plan.found);
  ASSERT_EQ(plan.chains.size(), 1U);
  EXPECT_EQ(plan.chains[0].held(), (std::vector<std::size_t>{1, 2, 3, 4, 5, 6}));
}

TEST(LoopCertificate, RefutesAStepThatIsWrong) {
  const auto mechanism = mechanism_of_file("four_bar");
  auto assembly = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  auto other = mechanism_of_file("four_bar");
  other.loops.closures[0].points[0][0] = model::Expression::symbol("r3");
  const auto wrong = derive::loops::assembly_plan(other, other.loops.actuated);
  EXPECT_THROW(verify::certify_loops(mechanism, assembly, derive::inverse::lower(wrong.plan), 3),
               verify::CertificateError);
}

}  // namespace
}  // namespace qvgen::test::loops_derivation
