// SPDX-License-Identifier: MIT
// Every name in what `show --inverse` prints is one of the description or the pose, or stands to the left of
// an equation above: of all robots.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "emit/math/describe.h"
#include "emit/math/transforms.h"
#include "patterns.h"
#include "pipeline/products/inverse_derivation.h"

namespace qvgen::test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

Names words_of(const std::string& text) {
  Names words;
  for (const patterns::Match& word : patterns::all(text, "[A-Za-z_][A-Za-z0-9_]*"))
    words.insert(word.groups[0]);
  return words;
}

Names names_of(const fs::path& description) {
  std::ifstream file(description);
  return words_of({std::istreambuf_iterator<char>(file), {}});
}

/// Returns the names that are defined nowhere.
Names undefined(const std::vector<std::string>& lines, Names known) {
  for (const char* word : {"w",   "a",   "b", "c", "p_x", "p_y", "p_z",  "sqrt", "atan2",     "cos", "sin",
                           "phi", "arg", "u", "v", "pi",  "or",  "from", "the",  "direction", "r"})
    known.insert(word);
  Names missing;
  bool formulas = false;  // behind the scheme, which is in words
  for (const std::string& line : lines) {
    const std::size_t equals = line.find(" = ");
    if (line.find("In subproblems") == 0) break;
    const bool is_scheme = line.find("_i") != std::string::npos || line.find("N_1 =") != std::string::npos ||
                           line.find("M_x, M_y") != std::string::npos;
    const bool is_sentence = line.find("  from: ") != std::string::npos;
    if (equals == std::string::npos || is_scheme || is_sentence) continue;
    formulas = true;
    for (const std::string& name : words_of(line.substr(equals + 3)))
      if (known.count(name) == 0) missing.insert(name);
    for (const std::string& name : words_of(line.substr(0, equals))) known.insert(name);
  }
  EXPECT_TRUE(formulas || lines.empty());
  return missing;
}

TEST(Names, OfDerivationsAreDefined) {
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() != ".toml") continue;
    const auto robot = description::read_file(entry.path()).robot.value();
    for (const auto& form : pipeline::derive_inverse(robot).closed_forms) {
      const Names missing = undefined(emit::describe(form, emit::Notation::text), names_of(entry.path()));
      EXPECT_TRUE(missing.empty()) << robot.name << ": " << *missing.begin();
      ++seen;
    }
  }
  EXPECT_GT(seen, 30);
}

TEST(Names, WithoutADefinitionAreFound) {
  EXPECT_EQ(undefined({"x = y*cos(theta1)", "z = x"}, {"theta1"}), Names{"y"});
}

/// "2*0.0868" would be read as one number in print, where no sign of multiplication stands. Lines fit.
TEST(Transforms, AreReadable) {
  const std::string side_by_side = "(^|[^A-Za-z0-9_.])[0-9.]+\\*[0-9]";
  EXPECT_TRUE(patterns::occurs("l1 - 2*0.0868*cos(q)", side_by_side));
  for (const auto& entry : fs::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() != ".toml") continue;
    const auto robot = description::read_file(entry.path()).robot.value();
    for (const std::string& line : emit::transform_lines(robot, emit::Notation::text)) {
      EXPECT_FALSE(patterns::occurs(line, side_by_side)) << robot.name << ": " << line;
      EXPECT_LE(line.size(), 120U) << robot.name << ": " << line;
    }
  }
}

}  // namespace
}  // namespace qvgen::test
