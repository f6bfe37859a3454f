// SPDX-License-Identifier: MIT
#include "pipeline/files.h"

#include <fstream>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using qvgen::pipeline::write_files;

class FilesTest : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) / "qvgen_files_test";
  void SetUp() override { fs::remove_all(folder); }
  void TearDown() override { fs::remove_all(folder); }
  std::string content(const char* name) {
    std::ifstream file(folder / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::ptrdiff_t files_in_folder() {
    return std::distance(fs::recursive_directory_iterator(folder), fs::recursive_directory_iterator());
  }
};

TEST_F(FilesTest, WritesOnlyWhatChanged) {
  EXPECT_EQ(write_files(folder, {{"a/b.h", "one"}, {"c.cpp", "two"}}), 2);
  const auto written = fs::last_write_time(folder / "a/b.h");
  EXPECT_EQ(write_files(folder, {{"a/b.h", "one"}, {"c.cpp", "three"}}), 1);
  EXPECT_EQ(fs::last_write_time(folder / "a/b.h"), written);
  EXPECT_EQ(content("c.cpp"), "three");
  EXPECT_EQ(files_in_folder(), 3) << "temporary files are left behind";
}

TEST_F(FilesTest, SaysWhatCannotBeWritten) {
  write_files(folder, {{"a", "a file, not a folder"}});
  try {
    write_files(folder, {{"a/b", "text"}});
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("qvgen_files_test/a/b"), std::string::npos) << error.what();
  }
}

}  // namespace
