// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "toolchain/build.h"
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
