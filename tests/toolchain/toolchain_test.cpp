// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "toolchain/build.h"
#include "toolchain/generated.h"
#include "toolchain/workshop.h"

namespace qvgen::toolchain {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

std::size_t entries_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(Run, GivesWhatAProgramPrintsAndHowItEnds) {
  const Workshop workshop;
  const Outcome good = run({"sh", "-c", "echo one; echo two >&2; pwd"}, workshop.folder());
  EXPECT_TRUE(good.done);
  EXPECT_EQ(good.said, "one\ntwo\n" + fs::canonical(workshop.folder()).string() + "\n");
  const Outcome bad = run({"sh", "-c", "echo no; exit 3"});
  EXPECT_FALSE(bad.done);
  EXPECT_EQ(bad.said, "no\n");
  EXPECT_FALSE(run({"sh", "-c", "kill -9 $$"}).done);
}

TEST(Run, SaysWhatDoesNotStart) {
  const Outcome nothing = run({"no-such-program-anywhere"});
  EXPECT_FALSE(nothing.done);
  EXPECT_THAT(nothing.said, HasSubstr("no-such-program-anywhere: No such file"));
  EXPECT_TRUE(is_program("sh"));
  EXPECT_FALSE(is_program("no-such-program-anywhere"));
  EXPECT_THAT(missing({"no-such-program-anywhere"}), HasSubstr("$CXX"));
}

TEST(Run, ReadsMoreThanAPipeHolds) {
  EXPECT_EQ(run({"sh", "-c", "head -c 300000 /dev/zero | tr '\\0' x"}).said.size(), 300000U);
}

TEST(Run, FeedsAProgramAndTakesWhatItPrints) {
  std::string taken;
  const auto take = [&](std::string_view some) { taken += some; };
  EXPECT_TRUE(run({"tr", "a-z", "A-Z"}, "some text", take).done);
  EXPECT_EQ(taken, "SOME TEXT");
  EXPECT_THAT(run({"sh", "-c", "exit 7"}, "", take).said, HasSubstr("exit code is 7"));
  EXPECT_THAT(run({"sh", "-c", "kill -9 $$"}, "", take).said, HasSubstr("signal 9"));
  EXPECT_THAT(run({"no-such-program-anywhere"}, "", take).said, HasSubstr("No such file"));
}

TEST(Run, EndsAProgramWhoseOutputIsNotTaken) {
  const auto refuse = [](std::string_view) { throw std::runtime_error("enough"); };
  EXPECT_THROW(run({"yes"}, "", refuse), std::runtime_error);
}

TEST(Workshop, IsGoneAtTheEnd) {
  fs::path folder;
  {
    const Workshop workshop;
    folder = workshop.folder();
    workshop.write("deep/file", "content");
    EXPECT_EQ(workshop.read("deep/file"), "content");
    EXPECT_EQ(workshop.read("no file"), "");
  }
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_THROW(Workshop("/no/such/folder"), std::runtime_error);
}

TEST(Build, CompilesEachSourceInItsOwnWayAndLinks) {
  const Workshop workshop;
  workshop.write("main.cpp", "int value();\nint main() { return value() - OF_ALL; }\n");
  workshop.write("value.cpp", "#ifndef OF_ONE\n#error\n#endif\nint value() { return OF_ALL; }\n");
  std::vector<std::string> told;
  const Program program{cxx_compiler(),
                        {"-DOF_ALL=42"},
                        {{workshop.folder() / "main.cpp"}, {workshop.folder() / "value.cpp", {"-DOF_ONE"}}}};
  const fs::path target = workshop.folder() / "made" / "program";
  const Outcome built = build(program, target, [&](const std::string& done) { told.push_back(done); });
  ASSERT_TRUE(built.done) << built.said;
  EXPECT_TRUE(run({target.string()}).done);
  EXPECT_THAT(told, UnorderedElementsAre("main.cpp", "value.cpp"));
  EXPECT_EQ(entries_in(target.parent_path()), 1U);
}

/// Programs by a compiler that counts its calls, one of which links.
TEST(Build, CompilesKeptObjectsOnlyWhereTheirTextCommandOrCompilerChanges) {
  const Workshop workshop;
  workshop.write("include/deep.h", "#define VALUE 42\n");
  workshop.write("include/value.h", " # include <deep.h>\nint value();\n");
  workshop.write("value.cpp", "#include \"value.h\"\nint value() { return VALUE; }\n");
  workshop.write("main.cpp", "#include <value.h>\nint main() { return value() - 42 - OTHER; }\n");
  const fs::path counter = workshop.folder() / "counter";
  const auto write_counter = [&](const std::string& version) {
    workshop.write("counter", "#!/bin/sh\n# " + version + "\necho >>calls\nexec \"$@\"\n");
    fs::permissions(counter, fs::perms::owner_all);
  };
  write_counter("1");
  std::vector<std::string> compiler{counter.string()};
  for (const std::string& word : cxx_compiler()) compiler.push_back(word);
  Program program{compiler, {"-Iinclude", "-DOTHER=0"}, {{"main.cpp"}, {"value.cpp"}}, {}, workshop.folder()};
  program.kept = workshop.folder() / "kept";
  std::size_t before = 0;
  const auto calls_of = [&](bool ends_well) {
    const fs::path target = workshop.folder() / "program";
    EXPECT_TRUE(build(program, target).done);
    EXPECT_EQ(run({target.string()}).done, ends_well);
    const std::size_t now = workshop.read("calls").size(), calls = now - before;
    before = now;
    return calls;
  };
  EXPECT_EQ(calls_of(true), 3U);
  EXPECT_EQ(calls_of(true), 1U);
  workshop.write("include/deep.h", "#define VALUE 43\n");
  EXPECT_EQ(calls_of(false), 3U);
  workshop.write("value.cpp", "#include \"value.h\"\nint value() { return VALUE - 1; }\n");
  EXPECT_EQ(calls_of(true), 2U);
  program.sources.back().options = {"-DMORE"};
  EXPECT_EQ(calls_of(true), 2U);
  program.options.back() = "-DOTHER=1";
  EXPECT_EQ(calls_of(false), 3U);
  EXPECT_EQ(entries_in(program.kept), 8U);
  write_counter("1.0.1");
  EXPECT_EQ(calls_of(false), 3U);
  EXPECT_EQ(entries_in(program.kept), 10U);
}

/// The program of an arm that needs all libraries of the runtime that there are.
Program whole_program(const Workshop& workshop) {
  workshop.write("inverse.cpp", "#include <qvgen/inverse/elimination.h>\n");
  Program program{cxx_compiler(), {}, {}};
  program.folder = workshop.folder();
  add_runtime(runtime_of(QVGEN_SOURCE_DIR), {"inverse.cpp", "arm_angle.cpp", "certified.cpp"}, program);
  return program;
}

#if defined(__x86_64__)
/// Options of instruction sets and contraction that a CMakeLists.txt gives a source alone, with semicolons
/// between them.
std::string options_in(const std::string& text, const std::string& source) {
  const std::size_t named = text.find("(source/" + source + " PROPERTIES");
  if (named == std::string::npos) return "";
  const std::string before = "COMPILE_OPTIONS \"";
  const std::size_t begin = text.find(before, named) + before.size();
  const std::string options = text.substr(begin, text.find('"', begin) - begin);
  return options.starts_with("-W") ? "" : options;
}

/// Tests compile no such program whole, since theirs link the libraries of the build.
TEST(Generated, SourcesOfTheRuntimeAreCompiledAsCMakeDoes) {
  ::unsetenv("QVGEN_LIBRARIES");
  const fs::path runtime = fs::path(QVGEN_SOURCE_DIR) / "runtime";
  std::ifstream stream(runtime / "CMakeLists.txt");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const Workshop workshop;
  std::set<std::string> given;
  int with_options = 0;
  for (const Source& source : whole_program(workshop).sources) {
    const std::string name = fs::relative(source.file, runtime / "source").string();
    std::string options;
    for (const std::string& option : source.options)
      if (!option.starts_with("-D")) options += (options.empty() ? "" : ";") + option;
    EXPECT_EQ(options, options_in(text, name)) << name;
    if (!options.empty()) ++with_options;
    given.insert(name);
  }
  EXPECT_EQ(with_options, 4);
  for (const std::string folder : {"core", "inverse", "elimination", "arm_angle", "certified"})
    for (const auto& entry : fs::directory_iterator(runtime / "source" / folder)) {
      const std::string name = folder + "/" + entry.path().filename().string();
      const bool is_needed = name.ends_with(".cpp") && name != "core/inverse_velocity.cpp";
      EXPECT_EQ(given.count(name), is_needed ? 1U : 0U) << name;
    }
}
#endif

TEST(Generated, LibrariesOfABuildAreLinkedIfAllAreThere) {
  const Workshop workshop;
  ::setenv("QVGEN_LIBRARIES", ("/no/such/folder:" + workshop.folder().string()).c_str(), 1);
  for (const std::string library : {"core", "inverse", "elimination", "arm_angle", "certified"}) {
    const Program before = whole_program(workshop);
    EXPECT_TRUE(before.libraries.empty() && !before.sources.empty()) << library;
    workshop.write("libqvgen_runtime_" + library + ".a", "");
  }
  const Program program = whole_program(workshop);
  ::unsetenv("QVGEN_LIBRARIES");
  EXPECT_TRUE(program.sources.empty());
  ASSERT_EQ(program.libraries.size(), 5U);
  EXPECT_EQ(program.libraries.front(), (workshop.folder() / "libqvgen_runtime_certified.a").string());
}

TEST(Build, SaysWhatTheCompilerSaysAndLeavesNothing) {
  const Workshop workshop;
  workshop.write("wrong.cpp", "int main() { return unheard_of; }\n");
  const fs::path target = workshop.folder() / "made" / "program";
  const Outcome compiled = build({cxx_compiler(), {}, {{workshop.folder() / "wrong.cpp"}}}, target);
  EXPECT_FALSE(compiled.done);
  EXPECT_THAT(compiled.said, HasSubstr("wrong.cpp"));
  EXPECT_THAT(compiled.said, HasSubstr("unheard_of"));
  workshop.write("half.cpp", "int value();\nint main() { return value(); }\n");
  const Outcome linked = build({cxx_compiler(), {}, {{workshop.folder() / "half.cpp"}}}, target);
  EXPECT_FALSE(linked.done);
  EXPECT_THAT(linked.said, HasSubstr("value()"));
  EXPECT_EQ(entries_in(target.parent_path()), 0U);
}

}  // namespace
}  // namespace qvgen::toolchain
