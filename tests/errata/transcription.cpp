// SPDX-License-Identifier: MIT
#include "transcription.h"

#include <toml++/toml.h>

namespace qvgen::test::sources {
namespace {

std::string text(const toml::table& table, const char* key) { return table[key].value_or(std::string()); }

Printed printed(const toml::table& table) {
  Printed result{text(table, "number"),
                 text(table, "printed"),
                 text(table, "right"),
                 text(table, "reading"),
                 text(table, "note"),
                 text(table, "definition"),
                 text(table, "excluded"),
                 text(table, "evidence"),
                 table["local"].value_or(false),
                 {}};
  if (const toml::array* indices = table["i"].as_array())
    for (const toml::node& index : *indices) result.indices.push_back(index.value<int>().value());
  return result;
}

std::vector<double> numbers(const toml::table& table, const char* key) {
  std::vector<double> result;
  if (const toml::array* array = table[key].as_array())
    for (const toml::node& node : *array) result.push_back(node.value<double>().value());
  return result;
}

NumbersOfExample numbers_of_example(const toml::table& table) {
  NumbersOfExample result{
      {}, numbers(table, "positions"), numbers(table, "rates"), table["tolerance"].value_or(0.0)};
  if (const toml::table* lengths = table["lengths"].as_table())
    for (const auto& entry : *lengths)
      result.lengths[std::string(entry.first.str())] = entry.second.value<double>().value();
  return result;
}

void number_lines(Section& section) {
  for (std::size_t i = 0; i < section.equations.size(); ++i)
    if (section.equations[i].number.empty())
      section.equations[i].number = section.label + ", line " + std::to_string(i + 1);
}

Section section(const toml::table& table) {
  Section result{text(table, "title"),
                 text(table, "pages"),
                 text(table, "label"),
                 text(table, "robot"),
                 text(table, "description"),
                 table["dynamics"].value_or(false),
                 table["frames"].value_or(false),
                 text(table, "screws"),
                 table["inverse"].value_or(false),
                 numbers_of_example(table),
                 {}};
  for (const toml::node& node : *table["equation"].as_array())
    result.equations.push_back(printed(*node.as_table()));
  if (!result.label.empty()) number_lines(result);
  return result;
}

Chapter chapter(const std::string& file) {
  const toml::table table = toml::parse_file(QVGEN_SOURCE_DIR "/tests/errata/printed/" + file);
  Chapter result{text(table, "title"), text(table, "prefix"), table["count"].value_or(0), {}};
  for (const toml::node& node : *table["section"].as_array())
    result.sections.push_back(section(*node.as_table()));
  return result;
}

}  // namespace

bool is_judged(const Printed& equation) {
  return equation.definition.empty() && equation.excluded.empty() && equation.evidence.empty();
}

std::vector<Chapter> transcriptions() {
  std::vector<Chapter> result;
  for (const char* file : {"thesis_1.toml", "thesis_2.toml", "thesis_3.toml", "thesis_4.toml",
                           "thesis_5.toml", "jacobian.toml", "planar_3r.toml", "paden_kahan.toml"})
    result.push_back(chapter(file));
  return result;
}

}  // namespace qvgen::test::sources
