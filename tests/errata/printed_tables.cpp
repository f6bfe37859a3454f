// SPDX-License-Identifier: MIT
#include "printed_tables.h"

#include <toml++/toml.h>

namespace qvgen::test::sources {
namespace {

std::string text(const toml::table& table, const char* key) { return table[key].value_or(std::string()); }

/// A table of the file, row by row.
template <class Make>
auto rows(const toml::table& file, const char* key, const Make& make) {
  std::vector<decltype(make(file))> result;
  for (const toml::node& node : *file[key].as_array()) result.push_back(make(*node.as_table()));
  return result;
}

}  // namespace

PrintedTables printed_tables() {
  const toml::table file = toml::parse_file(QVGEN_SOURCE_DIR "/tests/errata/printed/tables.toml");
  return {rows(file, "caption",
               [](const toml::table& row) {
                 return Caption{text(row, "figure"), text(row, "robot"), text(row, "types")};
               }),
          rows(file, "class",
               [](const toml::table& row) {
                 return ClassRow{text(row, "robot"), text(row, "types"), text(row, "relations"),
                                 text(row, "by_joints"), text(row, "by_transformation")};
               }),
          rows(file, "time",
               [](const toml::table& row) {
                 return TimeRow{text(row, "robot"), text(row, "matrices"), text(row, "pairs"),
                                text(row, "difference"), text(row, "workspace")};
               }),
          rows(file, "sentence", [](const toml::table& row) {
            return Sentence{text(row, "robot"), text(row, "joints")};
          })};
}

}  // namespace qvgen::test::sources
