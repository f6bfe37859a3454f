// SPDX-License-Identifier: MIT
#include "pipeline/output_folder.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pipeline/folder_state.h"
#include "pipeline/manifest.h"

namespace {

namespace fs = std::filesystem;
using namespace qvgen::pipeline;

class OutputFolder : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) / "qvgen_output_folder_test";
  void SetUp() override { fs::remove_all(folder); }
  void TearDown() override { fs::remove_all(folder); }
  std::string content(const fs::path& path) {
    std::ifstream file(folder / path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write(const fs::path& path, const std::string& text) {
    fs::create_directories((folder / path).parent_path());
    std::ofstream(folder / path) << text;
  }
  std::set<std::string> files() {
    std::set<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().string().find("/.qvgen/") == std::string::npos)
        found.insert(fs::relative(entry.path(), folder).string());
    return found;
  }
};

FolderUpdate::Robot robot(const std::string& name, const std::vector<std::string>& parts,
                          const std::string& text = "text", const std::string& description = "") {
  RobotOutput output{name, {}, {{"f", 1}}, {}};
  for (const std::string& part : parts)
    output.files.push_back({"source/" + name + "/" + part + ".cpp", text});
  return {output, description.empty() ? name + ".toml" : description, "key of " + text};
}

FolderUpdate update(const std::vector<FolderUpdate::Robot>& robots) {
  return {robots, {}, {{"README.md", "read me"}}};
}

const std::set<std::string> shared{"README.md", "operation_counts.json", "qvgen_manifest.json"};

std::set<std::string> with_shared(std::set<std::string> files) {
  files.insert(shared.begin(), shared.end());
  return files;
}

TEST_F(OutputFolder, WritesOnlyWhatChanged) {
  EXPECT_EQ(update_folder(folder, update({robot("a", {"one", "two"})})).written, 4);
  const auto time = fs::last_write_time(folder / "source/a/one.cpp");
  EXPECT_EQ(update_folder(folder, update({robot("a", {"one", "two"})})).written, 0);
  EXPECT_EQ(fs::last_write_time(folder / "source/a/one.cpp"), time);
  EXPECT_EQ(update_folder(folder, update({robot("a", {"one", "two"}, "other")})).written, 2);
  EXPECT_EQ(files(), with_shared({"source/a/one.cpp", "source/a/two.cpp"}));
}

TEST_F(OutputFolder, RemovesWhatIsNoLongerGenerated) {
  update_folder(folder, update({robot("a", {"one", "two"}), robot("b", {"one"})}));
  write("source/a/mine.cpp", "by hand");
  EXPECT_EQ(update_folder(folder, update({robot("a", {"one"})})).removed, 1);
  EXPECT_EQ(files(), with_shared({"source/a/one.cpp", "source/a/mine.cpp", "source/b/one.cpp"}));
  FolderUpdate removal = update({});
  removal.removed = {"a", "b"};
  update_folder(folder, removal);
  EXPECT_EQ(files(), with_shared({"source/a/mine.cpp"})) << "what is not ours stays";
  EXPECT_FALSE(fs::exists(folder / "source/b")) << "folders that are left empty go";
  EXPECT_EQ(content("operation_counts.json"), "{}\n");
}

TEST_F(OutputFolder, ARenamedRobotLeavesNothing) {
  update_folder(folder, update({robot("old", {"one"}, "text", "../arm.toml"), robot("b", {"one"})}));
  update_folder(folder, update({robot("new", {"one"}, "text", "../arm.toml")}));
  EXPECT_EQ(files(), with_shared({"source/new/one.cpp", "source/b/one.cpp"}));
  EXPECT_EQ(counts_in(folder).count("old"), 0U);
  EXPECT_EQ(counts_in(folder).size(), 2U);
}

TEST_F(OutputFolder, NeverTouchesWhatItHasNotWritten) {
  for (const char* name : {"README.md", "operation_counts.json", "source/a/one.cpp"}) {
    fs::remove_all(folder);
    write(name, "{\"mine\": 1}");
    try {
      update_folder(folder, update({robot("a", {"one"})}));
      FAIL() << "no error";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
    EXPECT_EQ(files(), std::set<std::string>{name});
    EXPECT_EQ(content(name), "{\"mine\": 1}");
  }
}

TEST_F(OutputFolder, ABrokenManifestIsNamedAndNothingOutsideIsRemoved) {
  for (const char* text : {"", "[]", "{\"robots\": {}, \"shared\": [\"../precious\"]}",
                           "{\"robots\": {\"a\": {\"description\": \"a\", \"files\": [\"/precious\"]}}, "
                           "\"shared\": []}"}) {
    fs::remove_all(folder);
    write(manifest_name, text);
    EXPECT_THROW(update_folder(folder, update({robot("b", {"one"})})), std::runtime_error) << text;
    EXPECT_EQ(files(), std::set<std::string>{manifest_name});
  }
}

TEST_F(OutputFolder, BrokenCountsAreNamed) {
  update_folder(folder, update({robot("a", {"one"})}));
  write("operation_counts.json", "");
  try {
    update_folder(folder, update({robot("b", {"one"})}));
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("operation_counts.json"), std::string::npos) << error.what();
  }
}

TEST_F(OutputFolder, KnowsWhatIsCurrent) {
  using Keys = std::vector<std::pair<std::string, std::string>>;
  update_folder(folder, update({robot("a", {"one"}), robot("b", {"one"})}));
  const Keys keys{{"a", "key of text"}, {"b", "key of text"}};
  EXPECT_EQ(current_robots(folder, keys), (std::set<std::string>{"a", "b"}));
  EXPECT_TRUE(current_robots(folder, {{"a", "another key"}}).empty());
  write("source/a/one.cpp", "edited");
  EXPECT_EQ(current_robots(folder, keys), std::set<std::string>{"b"});
  fs::remove_all(work_folder(folder));
  EXPECT_TRUE(current_robots(folder, keys).empty()) << "nothing is remembered";
}

TEST_F(OutputFolder, ManyAtATimeLoseNothing) {
  fs::create_directories(folder);
  std::vector<pid_t> runs;
  for (int i = 0; i < 6; ++i) {
    runs.push_back(::fork());
    if (runs.back() != 0) continue;
    for (int k = 0; k < 5; ++k)
      update_folder(folder, update({robot("r" + std::to_string(i), {"one"}, std::to_string(k))}));
    ::_exit(0);
  }
  for (const pid_t run : runs) {
    int status = 0;
    ::waitpid(run, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(counts_in(folder).size(), 6U);
  EXPECT_EQ(manifest_from_text(content(manifest_name)).robots.size(), 6U);
}

TEST_F(OutputFolder, ARunThatIsKilledLeavesWholeFilesAndTheNextCleansUp) {
  update_folder(folder, update({robot("a", {"one"}, "old")}));
  const std::string fresh(1 << 20, 'x');
  for (int k = 0; k < 20; ++k) {
    const pid_t run = ::fork();
    if (run == 0) {
      for (;;) {
        update_folder(folder, update({robot("a", {"one"}, fresh)}));
        update_folder(folder, update({robot("a", {"one", "two"}, "old")}));
      }
    }
    ::usleep(static_cast<useconds_t>(2000 + 500 * k));
    ::kill(run, SIGKILL);
    ::waitpid(run, nullptr, 0);
    const std::string one = content("source/a/one.cpp");
    EXPECT_TRUE(one == "old" || one == fresh) << one.size();
    manifest_from_text(content(manifest_name));
    counts_in(folder);
  }
  update_folder(folder, update({robot("a", {"one"}, "new")}));
  EXPECT_EQ(files(), with_shared({"source/a/one.cpp"}));
  EXPECT_FALSE(fs::exists(temporary_in(folder)));
}

TEST_F(OutputFolder, SaysWhatCannotBeWritten) {
  update_folder(folder, update({robot("a", {"one"})}));
  write("source/b", "a file where a folder is needed");
  try {
    update_folder(folder, update({robot("b", {"one"})}));
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("source/b"), std::string::npos) << error.what();
  }
}

TEST_F(OutputFolder, OriginsSayNothingOfTheMachine) {
  EXPECT_EQ(origin_of(folder / "arm.toml", folder / "out", folder / "robots"), "../arm.toml");
  EXPECT_EQ(origin_of(folder / "robots/arm.toml", folder / "out", folder / "robots"), "robots:arm.toml");
}

}  // namespace
