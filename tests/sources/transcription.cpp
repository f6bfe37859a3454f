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
                 table["local"].value_or(false),
                 {}};
  if (const toml::array* indices = table["i"].as_array())
    for (const toml::node& index : *indices) result.indices.push_back(index.value<int>().value());
  return result;
}

Section section(const toml::table& table) {
  Section result{text(table, "title"),
                 text(table, "robot"),
                 text(table, "description"),
                 table["dynamics"].value_or(false),
                 table["frames"].value_or(false),
                 text(table, "screws"),
                 table["inverse"].value_or(false),
                 {}};
  for (const toml::node& node : *table["equation"].as_array())
    result.equations.push_back(printed(*node.as_table()));
  return result;
}

Chapter chapter(const std::string& file) {
  const toml::table table = toml::parse_file(QVGEN_SOURCE_DIR "/tests/sources/printed/" + file);
  Chapter result{text(table, "title"), text(table, "prefix"), table["count"].value_or(0), {}};
  for (const toml::node& node : *table["section"].as_array())
    result.sections.push_back(section(*node.as_table()));
  return result;
}

}  // namespace

std::vector<Chapter> transcriptions() {
  std::vector<Chapter> result;
  for (const char* file : {"thesis_1.toml", "thesis_3.toml", "thesis_4.toml", "thesis_5.toml",
                           "jacobian.toml", "planar_3r.toml", "paden_kahan.toml"})
    result.push_back(chapter(file));
  return result;
}

}  // namespace qvgen::test::sources
