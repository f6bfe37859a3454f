// SPDX-License-Identifier: MIT
// Motors of mechanisms with loops at the command line: found where there is no choice, else listed to copy.
#include "command_line.h"

namespace qvgen::test {
namespace {

std::string joint(const std::string& variable, const std::string& more, const std::string& type = "revolute",
                  const std::string& axis = "+z") {
  return "[[joint]]\ntype = \"" + type + "\"\naxis = \"" + axis + "\"\nvariable = \"" + variable + "\"\n" +
         more;
}

/// A four-bar that does not say what is driven; `more`: further joints.
std::string described(const std::string& more = "") {
  return "name = \"bar\"\ntitle = \"four-bar\"\n" + joint("a", "link = [1, 0, 0]\n") + joint("b", "") +
         joint("c", "parent = \"base\"\norigin = [2, 0, 0]\n") + more +
         "[[tip]]\nname = \"end\"\njoint = \"b\"\n" +
         "[[loop]]\ntype = \"pin\"\nbetween = [\"b\", \"c\"]\nat = [[2, 0, 0], [1.5, 0, 0]]\n";
}

TEST_F(CommandLine, ListsDrivenJointsAsLinesToCopy) {
  const ToolRun checked = run("check " + write("bar.toml", described()));
  EXPECT_EQ(checked.code, 3);
  EXPECT_TRUE(
      has(checked,
          "bar.toml:1:8: error: which joints have motors? The mechanism has 1 freedom; copy one of these\n"
          "  actuated = [\"a\"]  # in closed form\n"
          "  actuated = [\"b\"]  # in closed form\n"
          "  actuated = [\"c\"]  # in closed form\n"))
      << checked.output;
}

/// A slide that turns hold still cannot be driven; a triangle leaves the wheel on it alone.
TEST_F(CommandLine, TakesDrivenJointsWhereThereIsNoChoice) {
  const std::string triangle =
      "name = \"wheel\"\ntitle = \"a wheel on a triangle\"\n" + joint("a", "link = [1, 0, 0]\n") +
      joint("turn", "") + joint("b", "parent = \"base\"\norigin = [2, 0, 0]\n") +
      "[[tip]]\nname = \"end\"\njoint = \"turn\"\n" +
      "[[loop]]\ntype = \"pin\"\nbetween = [\"a\", \"b\"]\nat = [[0, 0, 0], [1.5, 0, 0]]\n";
  const ToolRun checked = run("check " + write("wheel.toml", triangle));
  EXPECT_EQ(checked.code, 0) << checked.output;
  EXPECT_TRUE(has(checked, "wheel: 1 freedom, 1 driven")) << checked.output;
}

const std::string mjcf = R"(<mujoco model="bar"><worldbody>
<body name="a"><joint name="a" axis="0 0 1"/><geom size="0.1"/>
<body name="b" pos="1 0 0"><joint name="b" axis="0 0 1"/><geom size="0.1"/></body></body>
<body name="c" pos="2 0 0"><joint name="c" axis="0 0 1"/><geom size="0.1"/></body>
</worldbody><equality><connect body1="b" body2="c" anchor="1.3 1.1 0"/></equality></mujoco>
)";

TEST_F(CommandLine, DrivesWhatAnOptionNamesInAnMjcf) {
  const std::string file = write("bar.xml", mjcf);
  const ToolRun open = run("check " + file);
  EXPECT_EQ(open.code, 3);
  EXPECT_TRUE(has(open, "  --actuated a  # in closed form\n")) << open.output;
  const ToolRun chosen = run("check " + file + " --actuated a");
  EXPECT_EQ(chosen.code, 0) << chosen.output;
  EXPECT_TRUE(has(chosen, "bar: assemble from a: 2 assemblies at most")) << chosen.output;
  const ToolRun wrong = run("check " + file + " --actuated aa");
  EXPECT_EQ(wrong.code, 3);
  EXPECT_TRUE(has(wrong, "there is no joint 'aa' that moves; did you mean 'a'?")) << wrong.output;
  // The written description is read again, with its loops.
  const ToolRun written = run("import " + file + " --actuated a > " + folder.string() + "/bar.toml");
  EXPECT_EQ(written.code, 0) << written.output;
  EXPECT_TRUE(
      has(run("check " + folder.string() + "/bar.toml"), "bar: assemble from a: 2 assemblies at most"));
}

}  // namespace
}  // namespace qvgen::test
