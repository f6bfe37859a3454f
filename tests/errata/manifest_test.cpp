// SPDX-License-Identifier: MIT
// The transcriptions have all that the manifest counts: a row of a table or a line of a lecture that is lost,
// or comes twice, fails.
#include <set>

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include "inverse_formulas.h"
#include "printed_tables.h"
#include "transcription.h"

namespace qvgen::test::sources {
namespace {

const toml::table& manifest() {
  static const toml::table file = toml::parse_file(QVGEN_SOURCE_DIR "/tests/errata/printed/manifest.toml");
  return file;
}

std::string text(const toml::table& table, const char* key) {
  return table[key].value<std::string>().value();
}

/// The rows of a section's table by their numbers: "table 3.2, row 4" is 4.
std::multiset<int> table_rows(const Section& section) {
  std::multiset<int> rows;
  for (const Printed& equation : section.equations) {
    const std::size_t row = equation.number.find(", row ");
    if (row != std::string::npos) rows.insert(std::stoi(equation.number.substr(row + 6)));
  }
  return rows;
}

void expect_section(const toml::table& counted, const Section& section) {
  EXPECT_EQ(section.title, text(counted, "title"));
  EXPECT_EQ(static_cast<int>(section.equations.size()), counted["rows"].value<int>().value())
      << section.title;
  std::multiset<int> rows;
  for (int i = 1; i <= counted["table"].value_or(0); ++i) rows.insert(i);
  EXPECT_EQ(table_rows(section), rows) << section.title << ": the rows of its table";
}

TEST(Manifest, EveryRowOfEveryDocument) {
  const std::vector<Chapter> chapters = transcriptions();
  const toml::array& documents = *manifest()["document"].as_array();
  ASSERT_EQ(documents.size(), chapters.size());
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    const toml::table& document = *documents[i].as_table();
    EXPECT_EQ(chapters[i].title, text(document, "title"));
    EXPECT_EQ(chapters[i].count, document["numbers"].value<int>().value()) << chapters[i].title;
    const toml::array& sections = *document["sections"].as_array();
    ASSERT_EQ(sections.size(), chapters[i].sections.size()) << chapters[i].title;
    for (std::size_t k = 0; k < sections.size(); ++k)
      expect_section(*sections[k].as_table(), chapters[i].sections[k]);
  }
}

TEST(Manifest, EveryEquationOfAJoint) {
  for (const toml::node& node : *manifest()["joints"].as_array()) {
    const toml::table& counted = *node.as_table();
    const toml::table& arms = *counted["arms"].as_table();
    const std::vector<Arm> loaded = load_inverse_formulas(text(counted, "file"));
    EXPECT_EQ(loaded.size(), arms.size()) << text(counted, "file");
    for (const Arm& arm : loaded)
      EXPECT_EQ(static_cast<int>(arm.formulas.size()), arms[arm.robot].value_or(0)) << arm.robot;
  }
}

TEST(Manifest, EveryCellOfTheTables) {
  const PrintedTables printed = printed_tables();
  const toml::table& counted = *manifest()["tables"].as_table();
  const auto expect = [&](const char* key, std::size_t rows) {
    EXPECT_EQ(static_cast<int>(rows), counted[key].value<int>().value()) << key;
  };
  expect("captions", printed.captions.size());
  expect("classes", printed.classes.size());
  expect("times", printed.times.size());
  expect("sentences", printed.sentences.size());
  std::set<std::string> arms;
  for (const ClassRow& row : printed.classes) arms.insert(row.robot);
  for (const TimeRow& row : printed.times) EXPECT_EQ(arms.count(row.robot), 1U) << row.robot;
  EXPECT_EQ(arms.size(), printed.classes.size());
}

}  // namespace
}  // namespace qvgen::test::sources
