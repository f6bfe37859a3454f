// SPDX-License-Identifier: MIT
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "description/reader.h"

namespace qvgen::description {
namespace {

std::vector<std::string> examples() {
  std::ifstream file(QVGEN_SOURCE_DIR "/generator/robots/README.md");
  std::vector<std::string> blocks;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "```toml") {
      blocks.emplace_back();
      inside = true;
    } else if (line == "```") {
      inside = false;
    } else if (inside) {
      blocks.back() += line + "\n";
    }
  }
  return blocks;
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
  const auto blocks = examples();
  EXPECT_GE(blocks.size(), 4U);
  for (const std::string& block : blocks) {
    const ReadResult result = read_text(completed(block), "README.md", {.strict = true});
    for (const auto& diagnostic : result.diagnostics) ADD_FAILURE() << to_string(diagnostic) << "\n" << block;
  }
}

}  // namespace
}  // namespace qvgen::description
