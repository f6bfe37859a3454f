// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "description/reader.h"

// Every kind of mistake with the exact text that the user sees. Each case has `head` before it, so that its
// own first line is line 3.
namespace qvgen::description {
namespace {

const std::string head = "name = \"a\"\ntitle = \"A\"\n";
/// Five lines: a chain that is right.
const std::string joint = "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"t1\"\n";

std::string report(const std::string& text, bool strict = false) {
  const ReadResult result = read_text(text, "r.toml", {.strict = strict});
  std::string all;
  bool is_error = false;
  for (const auto& diagnostic : result.diagnostics) {
    all += to_string(diagnostic) + "\n";
    is_error = is_error || diagnostic.severity == Diagnostic::error;
  }
  EXPECT_EQ(result.robot.has_value(), !is_error);
  return all;
}

std::string lines(const std::vector<std::string>& expected) {
  std::string all;
  for (const auto& line : expected) all += "r.toml:" + line + "\n";
  return all;
}

TEST(BadInput, UnreadableFiles) {
  const auto missing = read_file("/nonexistent/x.toml");
  ASSERT_EQ(missing.diagnostics.size(), 1U);
  EXPECT_EQ(to_string(missing.diagnostics[0]),
            "/nonexistent/x.toml:1:1: error: cannot read the file: No such file or directory; give the path "
            "of a robot "
            "description");
  const auto directory = read_file(std::filesystem::temp_directory_path());
  EXPECT_EQ(directory.diagnostics.at(0).message, "cannot read the file: it is a directory");
}

TEST(BadInput, OptionsOfOtherFormats) {
  const auto result = read_text(head + joint, "r.toml", {.tip = "tool0"});
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(to_string(result.diagnostics[0]),
            "r.toml:1:1: error: --base and --tip: this description has no links to choose from; they are for "
            "URDF and MJCF; here [base] and [tool] give the frames");
  EXPECT_EQ(read_text(head + joint, "r.toml", {.name = "B"}).diagnostics.at(0).message,
            "--name B: 'B' has capital letters");
}

TEST(BadInput, EmptyFiles) {
  EXPECT_EQ(report(""),
            lines({"1:1: error: the file is empty; begin with name = \"...\" and add [[joint]] tables"}));
  EXPECT_EQ(report(" \n\t\n"),
            lines({"1:1: error: the file is empty; begin with name = \"...\" and add [[joint]] tables"}));
}

TEST(BadInput, TomlSyntax) {
  const std::string hint = "; texts and expressions stand in quotes, arrays in [ ], one key = value per line";
  EXPECT_EQ(
      report(head + "type = revolute\n"),
      lines({"3:8: error: TOML syntax: Error while parsing value: could not determine value type" + hint}));
  EXPECT_EQ(report("name = \"a\"\nname = \"b\"\n"),
            lines({"2:8: error: TOML syntax: Error while parsing key-value pair: cannot redefine existing "
                   "string 'name'" +
                   hint}));
  EXPECT_EQ(report("\xff\xfe"),
            lines({"1:1: error: TOML syntax: Encountered invalid utf-8 sequence" + hint}));
}

TEST(BadInput, UnknownKeys) {
  EXPECT_EQ(report("titel = \"A\"\n" + head + joint),
            lines({"1:1: error: unknown key 'titel' in the file; did you mean 'title'?"}));
  EXPECT_EQ(report(head + joint + "orign = [0, 0, 0]\n"),
            lines({"7:1: error: unknown key 'orign' in [[joint]]; did you mean 'origin'?"}));
  EXPECT_EQ(report(head + joint + "[tool]\ncolour = 3\n"),
            lines({"8:1: error: unknown key 'colour' in [tool]; the keys are translation, rpy, turns"}));
}

TEST(BadInput, MissingKeys) {
  const std::string name = "add name = \"...\", the namespace of the generated code";
  EXPECT_EQ(report("[[joint]]\n"),
            lines({"1:1: error: missing key 'name' in the file; " + name,
                   "1:1: error: missing key 'title' in the file; add title = \"...\", one line of text",
                   "1:1: error: missing key 'type' in [[joint]]; add type = \"revolute\" or \"prismatic\"",
                   "1:1: error: missing key 'variable' in [[joint]]; add a name, e.g. variable = \"theta1\"",
                   "1:1: error: missing key 'axis' in [[joint]]; add a direction, e.g. axis = \"+z\""}));
  EXPECT_EQ(report(head + "[[dh]]\nvariable = \"t1\"\n"),
            lines({"1:1: error: missing key 'convention' in the file; add convention = \"standard\" or "
                   "\"modified\""}));
}

TEST(BadInput, WrongTypes) {
  EXPECT_EQ(report("name = 3\ntitle = \"A\"\n" + joint),
            lines({"1:8: error: 'name' is a number; write a text in quotes"}));
  EXPECT_EQ(report(head + joint + "origin = \"h1\"\n"),
            lines({"7:10: error: 'origin' is a text; write three entries [x, y, z]"}));
  EXPECT_EQ(report(head + joint + "origin = [0, 0]\n"),
            lines({"7:10: error: 'origin' has 2 entries; write three entries [x, y, z]"}));
  EXPECT_EQ(report(head + joint + "mass = true\n"),
            lines({"7:8: error: 'mass' is a truth value; write a number or an expression in quotes"}));
  EXPECT_EQ(report(head + joint + "mass = nan\n"),
            lines({"7:8: error: 'mass' is not finite; write a finite number"}));
  EXPECT_EQ(report(head + "joint = 3\n"),
            lines({"3:9: error: 'joint' is a number; write one [[joint]] for each"}));
  EXPECT_EQ(report(head + joint + "[[tool]]\n"),
            lines({"7:1: error: 'tool' is an array; write a table [tool]"}));
  EXPECT_EQ(report(head + joint + "inertia = [1, 2]\n"),
            lines({"7:11: error: 'inertia' has 2 entries; write [xx, yy, zz], [xx, yy, zz, xy, yz, xz] or "
                   "\"free\""}));
}

std::string with_axis(const std::string& axis) {
  return head + "[[joint]]\ntype = \"revolute\"\naxis = " + axis + "\nvariable = \"t1\"\n";
}

TEST(BadInput, Axes) {
  EXPECT_EQ(report(with_axis("[0, 0, 0]")),
            lines({"5:8: error: the axis has length zero; give a direction, e.g. \"+z\""}));
  EXPECT_EQ(report(with_axis("[1, 0, 1]")), lines({"5:8: error: the axis is not a unit vector: its length is "
                                                   "sqrt(2); divide its entries by sqrt(2)"}));
  // Twenty digits are not enough: the check is exact.
  EXPECT_NE(report(with_axis("[0.70710678118654752440, 0.70710678118654752440, 0]")), "");
  EXPECT_EQ(report(with_axis("[\"sqrt(2)/2\", \"cos(45 deg)\", 0]")), "");
  EXPECT_EQ(report(with_axis("\"+w\"")), lines({"5:8: error: '+w' is no axis; write \"+x\", \"-x\", \"+y\", "
                                                "\"-y\", \"+z\" or \"-z\", or three entries "
                                                "[x, y, z]"}));
  EXPECT_EQ(
      report(with_axis("[0, 1]")),
      lines({"5:8: error: the axis has 2 entries; write three entries [x, y, z], or \"+x\" ... \"-z\""}));
  EXPECT_EQ(report(with_axis("[\"h\", 0, 0]")),
            lines({"5:10: error: undefined symbol 'h'; only a constant can stand here"}));
}

TEST(BadInput, Names) {
  EXPECT_EQ(report("name = \"Arm\"\ntitle = \"A\"\n" + joint),
            lines({"1:8: error: 'Arm' has capital letters; write 'arm'"}));
  EXPECT_EQ(
      report("name = \"7axis\"\ntitle = \"A\"\n" + joint),
      lines({"1:8: error: '7axis' is not a C++ name; use letters, digits and '_', and begin with a letter"}));
  EXPECT_EQ(report(head + joint + "link = [\"class\", \"dof\", \"a__b\"]\n"),
            lines({"7:10: error: 'class' is a C++ keyword; choose another name, e.g. 'class1'",
                   "7:19: error: 'dof' has a meaning in the generated code; choose another name, e.g. 'dof1'",
                   "7:26: error: 'a__b' is reserved by C++; do not begin with '_' and do not use '__'"}));
  EXPECT_EQ(report(head + "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"q\"\n"),
            lines({"6:12: error: 'q' has a meaning in the generated code; choose another name, e.g. 'q1'"}));
}

TEST(BadInput, Variables) {
  EXPECT_EQ(report(head + joint + joint),
            lines({"10:12: error: the variable 't1' is used twice: joint 1 has it already; give each joint a "
                   "variable of its own"}));
  EXPECT_EQ(report(head + joint + "link = [0, \"2*t1\", 0]\n"),
            lines({"7:15: error: 't1' is the variable of joint 1, not a constant; rename the variable or the "
                   "symbol"}));
}

TEST(BadInput, AVariableWithTheNameOfAFreeMass) {
  EXPECT_EQ(
      report(
          "name = \"a\"\ntitle = \"t\"\ninertia = \"free\"\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\n"
          "variable = \"m1\"\nlink = [1, 0, 0]\n"),
      lines({"4:1: error: 'm1' is the variable of joint 1, and the name that free inertias and drives give a "
             "constant here; rename the variable, e.g. 'q1'"}));
}

TEST(BadInput, Symbols) {
  EXPECT_EQ(report(head + joint + "link = [\"d2\", \"d2 + h11\", 0]\n[defaults]\nd2 = 1\nh1 = 2\n"),
            lines({"7:21: error: undefined symbol 'h11'; did you mean 'h1'?",
                   "10:1: error: the symbol 'h1' occurs nowhere in the chain; did you mean 'h11'?"}));
  EXPECT_EQ(report(head + "symbols = [\"length\"]\n" + joint + "link = [\"length\", \"w\", 0]\n"),
            lines({"8:20: error: undefined symbol 'w'; add it to [defaults] or to 'symbols'"}));
  EXPECT_EQ(report(head + joint + "link = [\"a\", 0, 0]\n[defaults]\na = \"b\"\n"),
            lines({"9:6: error: undefined symbol 'b'; only a constant can stand here"}));
  EXPECT_EQ(report(head + "inertia = \"free\"\n" + joint + "link = [\"m1\", 0, 0]\n"),
            lines({"4:1: error: 'm1' is also the name of a free inertial parameter of this joint; rename the "
                   "symbol"}));
}

TEST(BadInput, Expressions) {
  EXPECT_EQ(report(head + joint + "link = [\"1/(2 - 2)\", \"h1 +\", \"2 h1\"]\n"),
            lines({"7:12: error: division by zero; the denominator must differ from 0",
                   "7:27: error: the expression ends too early; a number, a name or a '(' was due",
                   "7:33: error: unexpected 'h1'; an operator or the end of the expression was due"}));
  EXPECT_EQ(
      report(head + joint + "link = [\"1/(a - 0.5)\", 0, 0]\n[defaults]\na = 0.5\n"),
      lines({"7:9: error: division by zero at the default values: a - 1/2 is zero; choose other defaults"}));
  EXPECT_EQ(
      report(head + joint + "link = [\"é + 1\", 'λ', 0]\n"),
      lines({"7:10: error: 'é' cannot stand in an expression; expressions have numbers, names, + - * / ^, "
             "parentheses, "
             "sqrt, sin, cos, pi, deg",
             "7:19: error: 'λ' cannot stand in an expression; expressions have numbers, names, + - * / ^, "
             "parentheses, "
             "sqrt, sin, cos, pi, deg"}));
}

TEST(BadInput, JointCount) {
  EXPECT_EQ(report(head),
            lines({"1:1: error: no joints; add [[joint]] tables, or [[dh]] rows, or [[screw]] axes"}));
  EXPECT_EQ(report(head + "convention = \"standard\"\n[[dh]]\nd = 1\n"),
            lines({"4:1: error: no joints: no row of the table has a variable; "
                   "add variable = \"theta1\" to this row, and so on to every row that moves"}));
  std::string many = head;
  for (int i = 1; i <= 17; ++i) {
    many += "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"t" + std::to_string(i) + "\"\n";
  }
  EXPECT_EQ(report(many), lines({"67:1: error: 17 joints are too many; a robot has at most 16 joints"}));
}

TEST(BadInput, Tasks) {
  EXPECT_EQ(report(head + "task = \"positon\"\n" + joint),
            lines({"3:8: error: unknown task 'positon'; did you mean 'position'?"}));
  EXPECT_EQ(report(head + "given = \"t2\"\n" + joint),
            lines({"3:9: error: 'given' names no joint: 't2'; did you mean 't1'?"}));
  EXPECT_EQ(report(head + "given = \"t1, t1\"\n" + joint),
            lines({"3:9: error: 'given' names 't1' twice; leave one out"}));
  EXPECT_EQ(report(head + "given = \"\"\n" + joint),
            lines({"3:9: error: 'given' names no joint: ''; write one of \"t1\""}));
  EXPECT_EQ(report(head + "on_request = \"dynamics_load\"\n" + joint),
            lines({"3:14: error: 'on_request' names no such part: 'dynamics_load'; did you mean "
                   "'dynamics_loads'?"}));
  EXPECT_EQ(report(head + "tool_axis = \"+w\"\n" + joint),
            lines({"3:13: error: '+w' is no axis; write \"+x\", \"-x\", \"+y\", \"-y\", \"+z\" or \"-z\", or "
                   "three entries [x, y, z]"}));
}

TEST(BadInput, IdealArms) {
  EXPECT_EQ(report(head + "ideal = \"UR5\"\n" + joint),
            lines({"3:9: error: 'UR5' has capital letters; write the name of the robot that the arm would be "
                   "ideally"}));
  EXPECT_EQ(
      report(head + "ideal = \"a\"\n" + joint),
      lines({"3:9: error: 'ideal' names the robot itself; give the ideal arm a description and a name of "
             "its own"}));
  EXPECT_EQ(report(head + "ideal = \"ur5\"\n" + joint),
            lines({"3:9: error: 'ideal' is for arms of six joints that no other joint follows; leave it "
                   "out"}));
  // A measured angle is not taken for a rounded one.
  std::string measured = "convention = \"standard\"\n";
  for (int i = 1; i <= 6; ++i)
    measured += "[[dh]]\nvariable = \"t" + std::to_string(i) + "\"\ntheta = \"t" + std::to_string(i) +
                "\"\na = 0.2\nalpha = " + (i == 3 ? "1.5711" : "0.4") + "\n";
  EXPECT_NE(report(head + measured), "");
  EXPECT_EQ(report(head + "ideal = \"ur5\"\n" + measured), "");
}

TEST(BadInput, JointTypes) {
  EXPECT_EQ(report(head + "[[joint]]\ntype = \"revolut\"\naxis = \"+z\"\nvariable = \"t1\"\n"),
            lines({"4:8: error: unknown joint type 'revolut'; did you mean \"revolute\"?"}));
}

TEST(BadInput, Limits) {
  EXPECT_EQ(
      report(head + joint + "limits = [1, \"-90 deg\"]\n"),
      lines(
          {"7:10: error: the limits are reversed: the lower is not below the upper; write [lower, upper]"}));
  EXPECT_EQ(report(head + joint + "limits = [1]\n"),
            lines({"7:10: error: 'limits' has 1 entry; write two entries [lower, upper]"}));
}

TEST(BadInput, Forms) {
  EXPECT_EQ(report(head + joint + "[[screw]]\n"),
            lines({"7:3: error: [[screw]] beside [[joint]]; describe the chain in one form"}));
  EXPECT_EQ(report(head + "convention = \"standard\"\n" + joint),
            lines({"3:1: error: 'convention' without [[dh]]; it belongs to [[dh]] tables"}));
  EXPECT_EQ(report(head + "convention = \"modifed\"\n[[dh]]\nvariable = \"t1\"\n"),
            lines({"3:14: error: unknown convention 'modifed'; did you mean \"modified\"?"}));
}

std::string row(const std::string& entries) {
  return head + "convention = \"standard\"\n[[dh]]\nvariable = \"t1\"\n" + entries;
}

TEST(BadInput, Rows) {
  EXPECT_EQ(
      report(row("theta = \"2*t1\"\n")),
      lines({"6:9: error: 'theta' is not the variable plus a constant; write theta = \"t1 + constant\""}));
  EXPECT_EQ(
      report(row("type = \"revolute\"\nd = \"t1\"\n")),
      lines({"7:5: error: the variable 't1' of this revolute row must stand in 'theta' alone; write theta "
             "= \"t1\", with "
             "a constant added if need be"}));
  EXPECT_EQ(
      report(row("theta = \"t2\"\n")),
      lines({"6:9: error: the variable 't1' of this revolute row must stand in 'theta' alone; write theta "
             "= \"t1\", with "
             "a constant added if need be"}));
  EXPECT_EQ(report(row("a = \"t1\"\n")), lines({"6:6: error: 't1' is the variable of joint 1, not a "
                                                "constant; rename the variable or the symbol"}));
}

TEST(BadInput, AnglesThatLookLikeDegrees) {
  EXPECT_EQ(
      report(row("alpha = 90\n")),
      lines({"6:9: warning: the angle 90 is more than a full turn in radians; write '90 deg' for degrees, or "
             "angle_unit = \"deg\" for the whole file; '90 rad' if radians are meant"}));
  EXPECT_EQ(report(row("theta = \"t1 - 90\"\n"), true),
            "r.toml:6:9: error: the angle -90 is more than a full turn in radians; write '-90 deg' for "
            "degrees, or angle_unit = \"deg\" for the whole file; '-90 rad' if radians are meant\n");
  EXPECT_EQ(report(row("alpha = \"7 rad\"\n")), "");
  EXPECT_EQ(
      report(row("alpha = -1.5708\n")),
      lines({"6:9: warning: the angle -1.5708 is -90 degrees but for rounding, and kept as written; write "
             "'-90 deg' if that is meant: the arm has a simpler structure then"}));
}

TEST(BadInput, LengthsThatLookLikeMillimetres) {
  const std::string hint =
      "lengths are in metres; if 560 mm are meant, write unit = \"mm\" for the whole file";
  EXPECT_EQ(report(row("d = 345\na = 560\n")), lines({"4:1: warning: an offset of 560 metres; " + hint}));
  EXPECT_EQ(report(row("d = 345\na = 560\n"), true),
            "r.toml:4:1: error: an offset of 560 metres; " + hint + "\n");
  // A mast, a crane.
  EXPECT_EQ(report(row("d = 60\na = 80\n")), "");
}

TEST(BadInput, UnphysicalInertia) {
  const std::string definite =
      "3:1: warning: the inertia of link 1 is not positive definite; principal moments are positive, the "
      "order is [xx, yy, "
      "zz, xy, yz, xz]";
  const std::string hint =
      "; give it about the centre of mass, each principal moment at most the sum of the others";
  EXPECT_EQ(report(head + joint + "mass = -2\n"),
            lines({"3:1: warning: link 1 has the negative mass -2; masses are positive"}));
  EXPECT_EQ(report(head + joint + "inertia = [1, 1, 1]\n"),
            lines({"3:1: warning: link 1 has inertia but no mass; give its mass"}));
  EXPECT_EQ(report(head + joint + "mass = 1\ninertia = [0.1, 0.2, 0.4]\n"),
            lines({"3:1: warning: the inertia of link 1 breaks the triangle inequality: zz = 0.4 exceeds xx "
                   "+ yy = 0.3" +
                   hint}));
  EXPECT_EQ(report(head + joint + "mass = 1\ninertia = [1, 1, 1, 2, 0, 0]\n"),
            lines({definite,
                   "3:1: warning: the inertia of link 1 breaks the triangle inequality: a principal moment "
                   "exceeds the sum of "
                   "the other two" +
                       hint}));
  EXPECT_EQ(report(head + joint + "mass = \"m\"\n[defaults]\nm = -1\n", true),
            "r.toml:3:1: error: link 1 has the negative mass -1; masses are positive\n");
}

TEST(BadInput, AllMistakesOfAFileAtOnce) {
  EXPECT_EQ(
      report("name = \"int\"\ntitel = \"A\"\n[[joint]]\ntype = \"revolute\"\naxis = [2, 0, 0]\nvariable = "
             "\"t1\"\n"
             "origin = [0, \"1/0\", \"t1\"]\nlimits = [1, 0]\n"),
      lines(
          {"1:1: error: missing key 'title' in the file; add title = \"...\", one line of text",
           "1:8: error: 'int' is a C++ keyword; choose another name, e.g. 'int1'",
           "2:1: error: unknown key 'titel' in the file; did you mean 'title'?",
           "5:8: error: the axis is not a unit vector: its length is 2; divide its entries by 2",
           "7:17: error: division by zero; the denominator must differ from 0",
           "7:22: error: 't1' is the variable of joint 1, not a constant; rename the variable or the symbol",
           "8:10: error: the limits are reversed: the lower is not below the upper; write [lower, upper]"}));
}

}  // namespace
}  // namespace qvgen::description
