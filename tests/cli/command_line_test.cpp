// SPDX-License-Identifier: MIT
// The tool as its users meet it: exit codes, messages, files.
#include "command_line.h"

#include <sstream>
#include <vector>

namespace qvgen::test {
namespace {

TEST_F(CommandLine, HelpShowsExamplesAndExitCodes) {
  const ToolRun help = run("--help");
  EXPECT_EQ(help.code, 0);
  EXPECT_TRUE(has(help, "examples:"));
  EXPECT_TRUE(has(help, "exit codes:"));
  EXPECT_TRUE(has(help, "70 a check of qvgen itself"));
  EXPECT_EQ(run("generate --help").code, 0);
}

TEST_F(CommandLine, Version) {
  const ToolRun version = run("--version");
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.output.substr(0, 6), "qvgen ");
}

TEST_F(CommandLine, WrongArgumentsAreUsageErrors) {
  EXPECT_EQ(run("").code, 2);
  EXPECT_EQ(run("fly").code, 2);
  EXPECT_TRUE(has(run("generat x.toml"), "there is no command 'generat'; did you mean 'generate'?"));
  EXPECT_TRUE(has(run("x.toml"), "there is no command 'x.toml'; there are generate, "));
  EXPECT_TRUE(has(run("check x.toml --tpi=hand"), "'check' has no option '--tpi'; did you mean '--tip'?"));
  EXPECT_TRUE(has(run("check --nosuch"), "'check' has no option '--nosuch'; there are --"));
  const ToolRun seconds = run("generate ns --seconds 0");
  EXPECT_EQ(seconds.code, 2);
  EXPECT_LT(seconds.output.size(), 200U) << seconds.output;
  EXPECT_EQ(run("counts --format pdf").code, 2);
  EXPECT_EQ(run("generate --no-such-flag").code, 2);
}

TEST_F(CommandLine, GeneratesARobotFromAnEmptyFolder) {
  const std::string file = write("my_arm.toml", good_arm);
  const ToolRun first = run("generate " + file + " --output " + out());
  EXPECT_EQ(first.code, 0) << first.output;
  EXPECT_TRUE(has(first, "forward_kinematics"));
  for (const char* name : {"include/qvgen/robots/my_arm.h", "include/qvgen/robots/my_arm/kinematics.h",
                           "source/my_arm/kinematics.cpp", "operation_counts.json", "README.md"})
    EXPECT_TRUE(fs::exists(fs::path(out()) / name)) << name;
  const ToolRun second = run("generate " + file + " --output " + out());
  EXPECT_TRUE(has(second, ": 0 generated, 0 files changed, 0 removed")) << second.output;
}

TEST_F(CommandLine, ComparesFormulations) {
  const ToolRun table = run("compare ns --level textbook --formulations pairs,dh");
  EXPECT_EQ(table.code, 0) << table.output;
  EXPECT_TRUE(has(table, "0.656")) << "the thesis's ratio: " << table.output;
  EXPECT_FALSE(has(table, "specialised"));
  EXPECT_TRUE(has(run("compare " + write("my_arm.toml", good_arm) + " --level textbook --format csv"),
                  "my_arm,textbook,pairs,quaternion,"));
  EXPECT_TRUE(has(run("compare ns --formulations pears"), "did you mean 'pairs'?"));
  EXPECT_TRUE(has(run("compare ns --level textbook --formulations dh --time --rounds 1 --format csv"),
                  ",rank,ns,ns_lower,ns_upper,ns_ratio\n"));
  EXPECT_EQ(run("compare ns --formulations pears").code, 2);
  EXPECT_EQ(run("compare ns --level expert").code, 2);
  EXPECT_EQ(run("compare nss").code, 2);
  const ToolRun massless = run("compare scara --what dynamics");
  EXPECT_EQ(massless.code, 1);
  EXPECT_TRUE(has(massless, "it has no inertia")) << massless.output;
}

TEST_F(CommandLine, ShowsTheClassOfAnArm) {
  EXPECT_EQ(run("show ns --class").output,
            "joints 1 to 3: RRP, axes perpendicular, perpendicular\ncode: NS\n"
            "useful: yes, they move a point in all three directions\ndistinct: yes\nworkspace: spherical\n");
  EXPECT_TRUE(has(run("show nc --class"),
                  "distinct: no, a slide and what is parallel to it exchanged it is RC (RPR)"));
  EXPECT_TRUE(has(run("show rc --class"), "table 3.18 of the thesis: cylindrical, not spherical"));
  EXPECT_TRUE(has(run("show sn --class"), "table 3.17 of the thesis: PPR, not PRR"));
  EXPECT_TRUE(has(run("show planar_3r --class"), "code: none\nuseful: no"));
  EXPECT_EQ(run("show pan_tilt --class").code, 1);
  EXPECT_TRUE(has(run("show general_6r --class"), "a twist of its axes is a symbol"));
}

TEST_F(CommandLine, CountsOfSomeAndSinceBefore) {
  const std::string generated = std::string("--output ") + QVGEN_SOURCE_DIR + "/generated";
  const ToolRun some = run("counts ur5 --functions jacobian --columns mul --format csv " + generated);
  EXPECT_TRUE(has(some, "robot,function,mul\nur5,jacobian,")) << some.output;
  EXPECT_EQ(run("counts ur6 " + generated).code, 2);
  const std::string same = std::string(QVGEN_SOURCE_DIR) + "/generated/operation_counts.json";
  EXPECT_TRUE(has(run("counts --against " + same + " " + generated), "0 functions differ"));
  EXPECT_EQ(run("counts --against no_such.json " + generated).code, 1);
}

TEST_F(CommandLine, MakesBatchFormsOfThePartsThatAreNamed) {
  const std::string file = write("my_arm.toml", good_arm);
  EXPECT_TRUE(has(run("generate " + file + " --only batch --output " + out()),
                  "my_arm: no batch: name the parts whose batch forms are wanted too"));
  EXPECT_EQ(run("generate " + file + " --only kinematics,batch --require batch --output " + out()).code, 0);
  EXPECT_TRUE(fs::exists(fs::path(out()) / "include/qvgen/robots/my_arm/batch.h"));
  EXPECT_TRUE(fs::exists(fs::path(out()) / "source/my_arm/batch.cpp"));
  EXPECT_EQ(run("generate " + file + " --output " + out()).code, 0);
  EXPECT_FALSE(fs::exists(fs::path(out()) / "source/my_arm/batch.cpp"));
}

TEST_F(CommandLine, MakesAPluginOnlyForWhoAsksForIt) {
  const std::string file = write("my_arm.toml", good_arm);
  const std::string plugin = " --only moveit_plugin --output " + out();
  const ToolRun small = run("generate " + file + plugin);
  EXPECT_EQ(small.code, 0);
  EXPECT_TRUE(has(small, "my_arm: no moveit_plugin: it is for arms of six joints")) << small.output;
  EXPECT_EQ(run("generate " + file + plugin + " --require moveit_plugin").code, 1);
  EXPECT_TRUE(has(run("generate " + file + plugin + " --language c"), "it is written in C++"));
  EXPECT_FALSE(fs::exists(fs::path(out()) / "moveit"));
  const ToolRun unnamed = run("generate " + file + " --require moveit_plugin --output " + out());
  EXPECT_EQ(unnamed.code, 2);
  EXPECT_TRUE(has(unnamed, "it is made only if --only names it too")) << unnamed.output;
}

TEST_F(CommandLine, SaysOfWhichArmsNothingIsProven) {
  const ToolRun few =
      run("generate " + write("my_arm.toml", good_arm) + " --only certified --output " + out());
  EXPECT_EQ(few.code, 0);
  EXPECT_TRUE(has(few, "my_arm: no certified: proofs are for arms that poses leave six joints of"))
      << few.output;
  EXPECT_FALSE(fs::exists(fs::path(out()) / "include/qvgen/robots/my_arm/certified.h"));
}

TEST_F(CommandLine, SaysWhichIdealArmIsMissing) {
  const std::string measured =
      QVGEN_SOURCE_DIR "/tests/inverse/ur5_measured.toml --only from_ideal --output " + out();
  const ToolRun alone = run("generate " + measured);
  EXPECT_EQ(alone.code, 0);
  EXPECT_NE(alone.output.find("ur5_measured: its ideal arm ur5 is not in " + out() + ": name it too"),
            std::string::npos)
      << alone.output;
  const ToolRun both = run("generate ur5 " + measured);
  EXPECT_EQ(both.code, 0);
  EXPECT_EQ(both.output.find("ideal arm"), std::string::npos) << both.output;
}

TEST_F(CommandLine, SaysThatTheFormFromTheIdealArmIsLeftOut) {
  const std::string measured =
      "generate " QVGEN_SOURCE_DIR "/tests/inverse/ur5_measured.toml --output " + out();
  const ToolRun without = run(measured + " --only inverse");
  EXPECT_EQ(without.code, 0);
  EXPECT_TRUE(has(without, "ur5_measured: from_ideal.h is left out, since --only does not name from_ideal"))
      << without.output;
  EXPECT_FALSE(has(run(measured + " --only inverse,from_ideal"), "is left out"));
}

TEST_F(CommandLine, HelpNamesTheParts) {
  const ToolRun help = run("generate --help");
  for (const char* part : {"model", "kinematics", "inverse", "arm_angle", "jacobian", "from_ideal",
                           "dynamics", "batch", "c_inverse", "certified", "moveit_plugin"})
    EXPECT_TRUE(has(help, part)) << part;
}

TEST_F(CommandLine, ShowsATableOfDenavitAndHartenberg) {
  const ToolRun standard = run("show ur5 --dh");
  EXPECT_EQ(standard.code, 0);
  EXPECT_TRUE(has(standard, "convention = \"standard\"\n")) << standard.output;
  EXPECT_TRUE(has(standard, "theta = \"theta4\"\nd = 0.10915\nalpha = \"90 deg\"\n")) << standard.output;
  EXPECT_TRUE(has(run("show puma560 --dh modified"), "d = 0.4318\na = 0.0203\nalpha = \"-90 deg\"\n"));
  EXPECT_EQ(run("show ur5 --dh craig").code, 2);
  const ToolRun none = run("show general_6r --dh");
  EXPECT_EQ(none.code, 1);
  EXPECT_TRUE(has(none, "general_6r has no table of Denavit and Hartenberg")) << none.output;
}

TEST_F(CommandLine, GeneratesOnlyThePartsAskedFor) {
  const std::string file = write("my_arm.toml", good_arm);
  // The file may stand on either side of the parts.
  EXPECT_EQ(run("generate --only kinematics,inverse " + file + " --output " + out() + "/both").code, 0);
  EXPECT_TRUE(fs::exists(fs::path(out()) / "both/source/my_arm/inverse.cpp"));
  EXPECT_EQ(run("generate " + file + " --only kinematics --output " + out()).code, 0);
  EXPECT_TRUE(fs::exists(fs::path(out()) / "include/qvgen/robots/my_arm/model.h"));
  EXPECT_TRUE(fs::exists(fs::path(out()) / "source/my_arm/kinematics.cpp"));
  EXPECT_EQ(
      std::distance(fs::directory_iterator(fs::path(out()) / "source/my_arm"), fs::directory_iterator()), 1);
  EXPECT_TRUE(has(run("counts --forms --output " + out()), "  pair product"));
  const ToolRun none = run("generate " + file + " --only kinematic --output " + out());
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(has(none, "did you mean 'kinematics'?")) << none.output;
  // Parts that were generated before, and now are not, are gone.
  EXPECT_EQ(run("generate " + file + " --only inverse --output " + out()).code, 0);
  EXPECT_FALSE(fs::exists(fs::path(out()) / "source/my_arm/kinematics.cpp"));
  // An option takes one value: what follows is a file.
  EXPECT_TRUE(has(run("generate --only kinematics inverse --output " + out()), "no known robot 'inverse'"));
}

TEST_F(CommandLine, RequiresWhatItIsTold) {
  const std::string file = write("my_arm.toml", good_arm);
  EXPECT_EQ(run("generate --require inverse " + file + " --only inverse -o " + out()).code, 0);
  const ToolRun without = run("generate --require dynamics " + file + " -o " + out());
  EXPECT_EQ(without.code, 1);
  EXPECT_TRUE(has(without, "my_arm: no dynamics: the description gives no mass")) << without.output;
  EXPECT_TRUE(fs::exists(fs::path(out()) / "source/my_arm/kinematics.cpp")) << "the rest is written";
  EXPECT_EQ(run("generate --require regressor " + file + " -o " + out()).code, 1) << "nothing has changed";
  EXPECT_EQ(run("generate " + file + " -o " + out()).code, 0);
  const ToolRun unknown = run("generate --require inverze " + file + " -o " + out());
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(has(unknown, "did you mean 'inverse'?")) << unknown.output;
  EXPECT_EQ(run("generate --only kinematics --require inverse " + file + " -o " + out()).code, 2);
}

TEST_F(CommandLine, SaysInTheCodeWhatThereIsNot) {
  EXPECT_EQ(run("generate " + write("eight.toml", eight_joints()) + " --only inverse -o " + out()).code, 0);
  for (const char* name : {"eight.h", "eight/inverse.h"}) {
    std::ifstream file(fs::path(out()) / "include/qvgen/robots" / name);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find("8 joints: a pose in space fixes six"), std::string::npos) << name << text;
  }
  EXPECT_TRUE(has(run("counts --format json -o " + out()), "\"not derived\""));
}

TEST_F(CommandLine, WhatTakesTooLongCostsOnePart) {
  const ToolRun result =
      run("generate general_6r my.toml --only kinematics,jacobian --seconds 1 -o " + out());
  EXPECT_EQ(result.code, 3);
  const ToolRun bounded =
      run("generate general_6r rr_planar --only kinematics,jacobian --seconds 1 -o " + out());
  EXPECT_EQ(bounded.code, 0) << bounded.output;
  EXPECT_TRUE(has(bounded, "general_6r: no jacobian: it takes more than 1 s of processor time"))
      << bounded.output;
  EXPECT_TRUE(fs::exists(fs::path(out()) / "source/rr_planar/jacobian.cpp"));
}

TEST_F(CommandLine, WritesIntoTheCurrentFolderAndRemovesARenamedRobot) {
  write("my_arm.toml", good_arm);
  const auto here = [&](const std::string& arguments) { return run_in(folder, arguments); };
  EXPECT_EQ(here("generate my_arm.toml --only kinematics").code, 0);
  EXPECT_TRUE(fs::exists(folder / "generated/source/my_arm/kinematics.cpp"));
  EXPECT_EQ(here("generate my_arm.toml -o '' --only kinematics").code, 2);
  std::string renamed = good_arm;
  renamed.replace(renamed.find("my_arm"), 6, "our_arm");
  write("my_arm.toml", renamed);
  EXPECT_EQ(here("generate my_arm.toml --only kinematics").code, 0);
  EXPECT_FALSE(fs::exists(folder / "generated/source/my_arm"));
  EXPECT_FALSE(has(here("counts"), "my_arm")) << "its counts are gone";
  EXPECT_EQ(here("remove my_arm").code, 1);
  EXPECT_EQ(here("remove our_arm").code, 0);
  EXPECT_FALSE(fs::exists(folder / "generated/source"));
}

TEST_F(CommandLine, DoesNothingForWhatHasNotChanged) {
  const std::string file = write("my_arm.toml", good_arm);
  const std::string command = "generate " + file + " rr_planar --only kinematics -o " + out();
  EXPECT_TRUE(has(run(command), ": 2 generated"));
  EXPECT_TRUE(has(run(command), ": 0 generated"));
  EXPECT_TRUE(has(run(command + " --force"), ": 2 generated, 0 files changed"));
  write("my_arm.toml", std::string(good_arm) + "limits = [-1, 1]\n");
  EXPECT_TRUE(has(run(command), ": 1 generated"));
  fs::remove(fs::path(out()) / "source/my_arm/kinematics.cpp");
  EXPECT_TRUE(has(run(command), ": 1 generated, 1 files changed"));
}

/// An MJCF with an <include> and a mesh: the depfile names all of them, and a change of any makes the robot
/// anew.
TEST_F(CommandLine, FilesThatADescriptionNamesCountAsItsOwn) {
  const std::string mesh =
      write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const std::string part = write("part.xml",
                                 "<mujocoinclude><body name=\"b\"><joint/><geom type=\"mesh\" "
                                 "mesh=\"box\"/></body></mujocoinclude>");
  const std::string file =
      write("arm.xml",
            "<mujoco model=\"arm\"><asset><mesh file=\"box.obj\"/></asset><worldbody><include "
            "file=\"part.xml\"/></worldbody></mujoco>");
  const std::string depfile = (folder / "arm.d").string();
  const std::string arguments =
      "generate " + file + " --only kinematics --output " + out() + " --depfile " + depfile;
  EXPECT_EQ(run(arguments).code, 0);
  std::stringstream written;
  written << std::ifstream(depfile).rdbuf();
  for (const std::string& each : {file, part, mesh})
    EXPECT_NE(written.str().find(" " + each + (each == part ? "\n" : " \\\n")), std::string::npos)
        << written.str();
  EXPECT_TRUE(has(run(arguments), ": 0 generated, 0 files changed"));
  std::ofstream(part) << "<mujocoinclude><body name=\"b\"><joint axis=\"1 0 0\"/><geom type=\"mesh\" "
                         "mesh=\"box\"/></body></mujocoinclude>";
  EXPECT_TRUE(has(run(arguments), ": 1 generated, "));
  EXPECT_TRUE(has(run(arguments), ": 0 generated, 0 files changed"));
  std::ofstream(mesh, std::ios::app) << "# larger\n";
  EXPECT_TRUE(has(run(arguments), ": 1 generated, "));
}

TEST_F(CommandLine, KnowsRobotsByName) {
  EXPECT_EQ(run("check puma560").code, 0);
  for (const char* command : {"check", "generate", "show"}) {
    const ToolRun unknown = run(std::string(command) + " pumma560");
    EXPECT_EQ(unknown.code, 2);
    EXPECT_TRUE(has(unknown, "did you mean 'puma560'?")) << unknown.output;
    EXPECT_TRUE(has(run(std::string(command) + " puma"), "did you mean 'puma560'?"));
    EXPECT_TRUE(has(run(std::string(command) + " ur"), "did you mean 'ur5'?"));
  }
}

TEST_F(CommandLine, AnOutputThatCannotBeWrittenIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  EXPECT_EQ(run("show ns >/dev/full").code, 1);
  EXPECT_EQ(run("counts >/dev/full").code, 1);
}

TEST_F(CommandLine, WhatIsNotQvgensIsNeverTouched) {
  const std::string file = write("my_arm.toml", good_arm);
  fs::create_directories(out());
  std::ofstream(fs::path(out()) / "README.md") << "mine";
  const ToolRun result = run("generate " + file + " --only kinematics -o " + out());
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(has(result, "out/README.md")) << result.output;
  EXPECT_EQ(std::distance(fs::directory_iterator(out()), fs::directory_iterator()), 1);
}

TEST_F(CommandLine, KeepsTheCountsOfOtherRobots) {
  const std::string mine = write("my_arm.toml", good_arm);
  EXPECT_EQ(run("generate " + mine + " rr_planar --output " + out()).code, 0);
  EXPECT_EQ(run("generate " + mine + " --output " + out()).code, 0);
  const ToolRun counts = run("counts --format csv --output " + out());
  EXPECT_TRUE(has(counts, "my_arm,forward_kinematics,"));
  EXPECT_TRUE(has(counts, "rr_planar,forward_kinematics,"));
}

TEST_F(CommandLine, MistakesAreReportedAndNothingIsWritten) {
  const std::string bad = write(
      "bad.toml", "name = \"bad\"\n[[joint]]\ntype = \"revolut\"\naxsi = \"+z\"\nvariable = \"theta1\"\n");
  const std::string good = write("good.toml", good_arm);
  const ToolRun result = run("generate " + good + " " + bad + " --output " + out());
  EXPECT_EQ(result.code, 3);
  EXPECT_TRUE(has(result, "bad.toml:3:")) << result.output;
  EXPECT_TRUE(has(result, "bad.toml:4:")) << result.output;
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(CommandLine, CheckSumsUpAGoodFile) {
  const ToolRun result = run("check " + write("my_arm.toml", good_arm));
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result, "my_arm: two links (RR), 2 geometric parameters"));
  EXPECT_EQ(run("check " + (folder / "missing.toml").string()).code, 3);
}

TEST_F(CommandLine, CheckSaysWhatGenerateWillLeaveOut) {
  const ToolRun result = run("check " + write("eight.toml", eight_joints()) + " puma560");
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result, "eight.toml:")) << result.output;
  EXPECT_TRUE(has(result, ": note: no inverse: 8 joints: a pose in space fixes six")) << result.output;
  EXPECT_FALSE(has(result, "puma560.toml:"));
  EXPECT_EQ(run("check --thorough " + write("my_arm.toml", good_arm)).code, 0);
}

TEST_F(CommandLine, CheckFindsWhatServesAMeasuredArm) {
  const ToolRun result = run("check " + write("measured.toml", measured_arm));
  EXPECT_EQ(result.code, 0);
  EXPECT_FALSE(has(result, "no inverse")) << result.output;
}

TEST_F(CommandLine, RobotsOfTheSameNameClash) {
  const ToolRun result = run("check " + write("a.toml", good_arm) + " " + write("b.toml", good_arm));
  EXPECT_EQ(result.code, 3);
  EXPECT_TRUE(has(result, "b.toml:1:")) << result.output;
}

TEST_F(CommandLine, CountsNeedAGeneratedFolder) {
  const ToolRun result = run("counts --output " + out());
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(has(result, "run `qvgen generate` first")) << result.output;
}

TEST_F(CommandLine, SaysWhyItCannotWrite) {
  const std::string file = write("my_arm.toml", good_arm);
  const ToolRun result = run("generate " + file + " --output " + file);
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(has(result, "cannot write")) << result.output;
}

}  // namespace
}  // namespace qvgen::test
