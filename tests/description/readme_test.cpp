// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "description/reader.h"

namespace qvgen::description {
namespace {

namespace fs = std::filesystem;

/// A block of TOML, and the page that has it.
struct Example {
  std::string page;
  std::string text;
};

/// Pages of the reference of descriptions: the entry and those of docs/.
std::vector<fs::path> pages() {
  const fs::path folder = QVGEN_SOURCE_DIR "/generator/robots";
  std::vector<fs::path> found{folder / "README.md"};
  for (const auto& entry : fs::directory_iterator(folder / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

void append_examples(const fs::path& page, std::vector<Example>& examples) {
  std::ifstream file(page);
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "```toml") {
      examples.push_back({page.filename().string(), ""});
      inside = true;
    } else if (line == "```") {
      inside = false;
    } else if (inside) {
      examples.back().text += line + "\n";
    }
  }
}

/// The reference shows some parts alone; they are completed to a file.
std::string completed(std::string example) {
  if (example.find("title =") == std::string::npos) example = "name = \"a\"\ntitle = \"A\"\n" + example;
  if (example.find("variable =") == std::string::npos) {
    example += "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"t1\"\n";
  }
  return example;
}

TEST(Readme, ExamplesAreRight) {
  std::vector<Example> examples;
  for (const fs::path& page : pages()) append_examples(page, examples);
  EXPECT_GE(examples.size(), 15U);
  for (const auto& [page, text] : examples) {
    const ReadResult result = read_text(completed(text), page, {.strict = true});
    for (const auto& diagnostic : result.diagnostics) ADD_FAILURE() << to_string(diagnostic) << "\n" << text;
  }
}

}  // namespace
}  // namespace qvgen::description
