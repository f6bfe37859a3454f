// SPDX-License-Identifier: MIT
// Output folders with C++, with C, and with C in float.
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "command_line.h"

namespace qvgen::test {
namespace {

TEST_F(CommandLine, BothLanguagesShareAFolder) {
  const std::string file = write("my_arm.toml", good_arm);
  const std::string arguments = "generate " + file + " --only kinematics --output " + out();
  EXPECT_EQ(run(arguments).code, 0);
  const ToolRun c = run(arguments + " --language c");
  EXPECT_EQ(c.code, 0) << c.output;
  EXPECT_TRUE(has(run(arguments), ": 0 generated, 0 files changed, 0 removed"));
  EXPECT_TRUE(has(run(arguments + " --language c"), ": 0 generated, 0 files changed, 0 removed"));
  EXPECT_TRUE(fs::exists(fs::path(out()) / "source/my_arm/kinematics.cpp"));
  EXPECT_EQ(run("remove my_arm --output " + out()).code, 0);
  EXPECT_FALSE(fs::exists(fs::path(out()) / "source"));
  EXPECT_TRUE(fs::exists(fs::path(out()) / "c/qvgen_my_arm.c"));
  EXPECT_EQ(run("generate " + file + " --language c --require inverse --output " + out()).code, 0);
  EXPECT_TRUE(fs::exists(fs::path(out()) / "c/qvgen_my_arm_inverse.h"));
  const ToolRun elimination =
      run("generate crx10ia --only inverse --language c --require inverse --output " + out());
  EXPECT_NE(elimination.code, 0);
  EXPECT_TRUE(has(elimination, "it is by elimination, which is written in C++")) << elimination.output;
  EXPECT_FALSE(fs::exists(fs::path(out()) / "c/qvgen_crx10ia_inverse.h"));
  EXPECT_EQ(run("remove c/my_arm --output " + out()).code, 0);
  EXPECT_FALSE(fs::exists(fs::path(out()) / "c/qvgen_my_arm_inverse.h"));
  EXPECT_EQ(run("generate " + file + " --language fortran --output " + out()).code, 2);
}

TEST_F(CommandLine, RustAndJavaScriptHaveFoldersOfTheirOwn) {
  const std::string file = write("my_arm.toml", good_arm);
  const std::string arguments = "generate " + file + " --only kinematics,inverse --output " + out();
  for (const std::string language : {"rust", "javascript", "c"})
    EXPECT_EQ(run(arguments + " --language " + language).code, 0) << language;
  EXPECT_TRUE(has(run(arguments + " --language rust"), ": 0 generated, 0 files changed, 0 removed"));
  const fs::path crate = fs::path(out()) / "rust/qvgen_my_arm";
  for (const char* path :
       {"Cargo.toml", "README.md", "src/lib.rs", "src/math.rs", "src/inverse.rs", "src/metrics.rs"})
    EXPECT_TRUE(fs::exists(crate / path)) << path;
  const fs::path module = fs::path(out()) / "javascript/qvgen_my_arm";
  for (const char* path : {"package.json", "README.md", "qvgen_my_arm.mjs", "qvgen_my_arm.d.mts"})
    EXPECT_TRUE(fs::exists(module / path)) << path;
  // Without the part its file goes, and no other robot's or language's.
  EXPECT_EQ(run("generate " + file + " --only kinematics --language rust --output " + out()).code, 0);
  EXPECT_FALSE(fs::exists(crate / "src/inverse.rs"));
  EXPECT_EQ(run("remove rust/my_arm --output " + out()).code, 0);
  EXPECT_FALSE(fs::exists(crate));
  EXPECT_TRUE(fs::exists(module / "qvgen_my_arm.mjs"));
  EXPECT_TRUE(fs::exists(fs::path(out()) / "c/qvgen_my_arm.c"));
  EXPECT_EQ(run(arguments + " --language rust --scalar float").code, 2);
  EXPECT_EQ(run(arguments + " --language javascript --only certified --require certified").code, 1);
}

TEST_F(CommandLine, SeveralLanguagesAreWhatEachIsAlone) {
  const std::string arguments =
      "generate " + write("my_arm.toml", good_arm) + " --only kinematics,inverse,certified --output ";
  const std::string alone = out() + "/alone", together = out() + "/together";
  for (const std::string language : {"cxx", "c", "rust", "cuda"})
    ASSERT_EQ(run(arguments + alone + " --language " + language).code, 0) << language;
  const ToolRun made = run(arguments + together + " --language cxx,c,rust,cuda");
  ASSERT_EQ(made.code, 0) << made.output;
  EXPECT_EQ(std::system(("diff -r " + alone + " " + together).c_str()), 0);
  // A part that one language lacks fails the run.
  EXPECT_EQ(run(arguments + together + " --language cxx,rust --require certified").code, 1);
  EXPECT_EQ(run(arguments + together + " --language c,rust --list-outputs " + out() + "/list").code, 2);
  EXPECT_EQ(run(arguments + together + " --language c,rust --scalar float").code, 2);
}

TEST_F(CommandLine, ACrateWhoseNumbersAreBeyondFloatHasNoF32AndSaysWhy) {
  const auto crate = [&](const std::string& length) {
    std::string text = good_arm;
    text.replace(text.rfind("\"l2\""), 4, "\"" + length + "\"");
    const std::string made = out() + std::to_string(length.size());
    EXPECT_EQ(
        run("generate " + write("my_arm.toml", text) + " --only kinematics --language rust --output " + made)
            .code,
        0);
    return fs::path(made) / "rust/qvgen_my_arm/src";
  };
  EXPECT_TRUE(fs::exists(crate("1/4") / "f32/math.rs"));
  const fs::path source = crate("1e-60");
  EXPECT_FALSE(fs::exists(source / "f32.rs"));
  std::ifstream root(source / "lib.rs");
  const std::string text{std::istreambuf_iterator<char>(root), {}};
  EXPECT_NE(text.find("//! f32: the number 1e-60 has no place in float"), std::string::npos) << text;
  EXPECT_EQ(text.find("pub mod f32"), std::string::npos);
}

TEST_F(CommandLine, TheTableOfLanguagesSaysWhatIsMissingAndWhy) {
  const ToolRun table = run("languages");
  EXPECT_EQ(table.code, 0);
  for (const char* line : {"part                    cxx     c       rust    javascript",
                           "inverse                 yes     yes     yes     yes",
                           "linuxcnc                no (4)  yes     no (4)  no (4)",
                           "certified               yes     no (2)  no (2)  no (2)",
                           "(2) it is written in C++", "rust: a crate in rust/"})
    EXPECT_TRUE(has(table, line)) << line << "\n" << table.output;
}

TEST_F(CommandLine, LanguagesMadeOfCSayThatTheyHaveNoAssembly) {
  const std::string robot =
      "generate " QVGEN_SOURCE_DIR "/tests/loops/robots/four_bar.toml --only kinematics,assembly ";
  for (const std::string language : {"rust", "javascript"}) {
    const ToolRun made = run(robot + "--language " + language + " --output " + out() + language);
    EXPECT_EQ(made.code, 0) << made.output;
    EXPECT_TRUE(has(
        made, language + "/four_bar: no assembly: assemblies are in C++, and in C (double): --language c"))
        << made.output;
  }
  for (const std::string language : {"c", "cxx"}) {
    const ToolRun made = run(robot + "--language " + language + " --output " + out() + language);
    EXPECT_EQ(made.code, 0) << made.output;
    EXPECT_FALSE(has(made, "no assembly")) << made.output;
  }
  EXPECT_TRUE(fs::exists(fs::path(out() + "c") / "c" / "qvgen_four_bar_loops.c"));
}

TEST_F(CommandLine, CInFloatIsInFloatAlone) {
  const std::string file = write("my_arm.toml", good_arm);
  const std::string arguments = "generate " + file + " --language c --output " + out();
  EXPECT_EQ(run(arguments + " --only kinematics").code, 0);
  const ToolRun single = run(arguments + " --only kinematics,inverse --scalar float");
  EXPECT_EQ(single.code, 0) << single.output;
  EXPECT_FALSE(has(single, "no inverse")) << single.output;
  for (const char* part : {".h", ".c"}) {
    std::ifstream generated(fs::path(out()) / "c" / (std::string("qvgen_my_arm") + part));
    bool has_float = false;
    for (std::string line; std::getline(generated, line);) {
      if (line.rfind("//", 0) == 0) continue;  // what is not generated, and why
      has_float = has_float || line.find("float") != std::string::npos;
      EXPECT_EQ(line.find("double"), std::string::npos) << line;
    }
    EXPECT_TRUE(has_float) << part;
  }
  // The next run knows what the folder has.
  EXPECT_TRUE(
      has(run(arguments + " --only kinematics,inverse --scalar float"), ": 0 generated, 0 files changed"));
  EXPECT_EQ(run(arguments + " --only inverse --scalar float --require inverse").code, 0);
  const ToolRun cxx = run("generate " + file + " --scalar float --output " + out());
  EXPECT_EQ(cxx.code, 2);
  EXPECT_TRUE(has(cxx, "--scalar float: it is for --language c")) << cxx.output;
}
}  // namespace
}  // namespace qvgen::test
