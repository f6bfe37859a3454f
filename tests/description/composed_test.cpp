// SPDX-License-Identifier: MIT
// Universal, spherical and planar joints of TOML: their parts, what names them, and every mistake with its
// place. tests/dynamics has random trees of them.
#include <gtest/gtest.h>

#include "description/reader.h"
#include "description/write.h"

namespace qvgen::description {
namespace {

const std::string head = "name = \"a\"\ntitle = \"A\"\n";

std::string messages(const ReadResult& result) {
  std::string text;
  for (const Diagnostic& diagnostic : result.diagnostics) text += to_string(diagnostic) + "\n";
  return text;
}

std::string refusal(const std::string& text) {
  const ReadResult result = read_text(head + text, "r.toml");
  EXPECT_FALSE(result.robot);
  return messages(result);
}

std::string model_of(const std::string& text) {
  const ReadResult result = read_text(head + text, "r.toml");
  EXPECT_TRUE(result.robot) << messages(result);
  EXPECT_EQ(messages(result), "");
  return result.robot ? write_text(model::Mechanism{*result.robot, result.tips}) : "";
}

TEST(ComposedJoint, HasLimitsAndDrivesForEachPart) {
  const std::string one =
      "[[joint]]\ntype = \"universal\"\nvariable = \"hip\"\norigin = [0, 0, 0.5]\n"
      "limits = [[\"-30 deg\", \"30 deg\"], []]\nvelocity_limit = [2, \"90 deg\"]\neffort_limit = [5, 6]\n"
      "rotor_inertia = [0.01, 0.02]\ncoulomb_friction = [1, 2]\nlink = [0, 0, 0.3]\nmass = 2\n";
  const std::string parts =
      "[[joint]]\ntype = \"revolute\"\naxis = \"+x\"\nvariable = \"hip_x\"\norigin = [0, 0, 0.5]\n"
      "limits = [\"-30 deg\", \"30 deg\"]\nvelocity_limit = 2\neffort_limit = 5\nrotor_inertia = 0.01\n"
      "coulomb_friction = 1\n"
      "[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable = \"hip_y\"\nvelocity_limit = \"90 deg\"\n"
      "effort_limit = 6\nrotor_inertia = 0.02\ncoulomb_friction = 2\nlink = [0, 0, 0.3]\nmass = 2\n";
  EXPECT_EQ(model_of(one), model_of(parts));
}

/// Inertia that is free belongs to the link, drives that are free to each part.
TEST(ComposedJoint, HasFreeParameters) {
  const ReadResult result = read_text(
      head + "inertia = \"free\"\ndrives = \"free\"\n[[joint]]\ntype = \"spherical\"\nvariable = \"s\"\n",
      "r.toml");
  ASSERT_TRUE(result.robot) << messages(result);
  std::string names;
  for (const model::Parameter& parameter : result.robot->inertia_parameters) names += parameter.name + " ";
  EXPECT_EQ(names, "Ia1 Fv1 Fc1 Ia2 Fv2 Fc2 m3 c3x c3y c3z I3xx I3yy I3zz I3xy I3yz I3xz Ia3 Fv3 Fc3 ");
}

/// The joint's own name stands for its last part.
TEST(ComposedJoint, IsNamedByJointsAndTips) {
  const auto tree = [](const std::string& carrier) {
    return "[[joint]]\ntype = \"planar\"\nvariable = \"p\"\nmass = 1\n[[joint]]\ntype = \"revolute\"\n"
           "axis = \"+x\"\nvariable = \"one\"\nparent = \"" +
           carrier +
           "\"\nmass = 1\n[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable = \"two\"\nparent = \"" +
           carrier + "\"\nmass = 1\n[[tip]]\nname = \"body\"\njoint = \"" + carrier +
           "\"\n[[tip]]\nname = \"end\"\n";
  };
  EXPECT_EQ(model_of(tree("p")), model_of(tree("p_z")));
}

TEST(ComposedJoint, MistakesAreReportedWithTheirPlace) {
  const std::string hip = "[[joint]]\ntype = \"universal\"\nvariable = \"hip\"\n";
  EXPECT_EQ(
      refusal(hip + "axis = \"+z\"\n"),
      "r.toml:6:1: error: 'axis' of a universal joint; its axes are those of its own frame, which 'rpy' "
      "or 'turns' rotates\n");
  EXPECT_EQ(refusal(hip + "limits = [-1, 1]\n"),
            "r.toml:6:10: error: 'limits' of a universal joint has an entry for each of its 2 parts; write "
            "limits = [[lower, upper], [lower, upper]], with [] for none\n");
  EXPECT_EQ(refusal(hip + "limits = [[1, -1], []]\n"),
            "r.toml:6:11: error: the limits are reversed: the lower is not below the upper; write [lower, "
            "upper]\n");
  EXPECT_EQ(refusal(hip + "viscous_friction = 0.1\n"),
            "r.toml:6:20: error: 'viscous_friction' of a universal joint has an entry for each of its 2 "
            "parts; write viscous_friction = [1, 1]\n");
  EXPECT_EQ(refusal("[[joint]]\ntype = \"planar\"\n"),
            "r.toml:3:1: error: missing key 'variable' in [[joint]]; add a name, e.g. variable = \"hip\"\n");
  EXPECT_NE(refusal(hip + "follows = \"b\"\n").find("r.toml:6:1: error: unknown key 'follows' in [[joint]]"),
            std::string::npos);
  EXPECT_NE(refusal(hip + hip).find("r.toml:8:12: error: the variable 'hip_x' is used twice"),
            std::string::npos);
  EXPECT_EQ(refusal("[[joint]]\ntype = \"spherica\"\naxis = \"+z\"\nvariable = \"s\"\n"),
            "r.toml:4:8: error: unknown joint type 'spherica'; did you mean \"spherical\"?\n");
  EXPECT_NE(refusal("[[joint]]\ntype = \"planar\"\nvariable = \"p\"\nlimits = [[0, 1], [0, \"x\"], []]\n")
                .find("r.toml:6:24: error: undefined symbol 'x'"),
            std::string::npos);
}

}  // namespace
}  // namespace qvgen::description
