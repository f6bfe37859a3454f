// SPDX-License-Identifier: MIT
#include <stdexcept>

#include <toml++/toml.h>

#include "errata.h"

namespace qvgen::test::errata {
namespace {

std::string text(const toml::table& table, const char* key) { return table[key].value_or(std::string()); }

std::vector<std::string> list(const toml::table& table, const char* key) {
  std::vector<std::string> result;
  if (const toml::array* array = table[key].as_array())
    for (const toml::node& node : *array) result.push_back(node.value<std::string>().value());
  return result;
}

Formula formula(const toml::table& table) {
  Formula result{text(table, "number"),
                 text(table, "of"),
                 {list(table, "where"), text(table, "printed")},
                 {},
                 text(table, "note")};
  result.right =
      table.contains("right") ? Text{list(table, "right_where"), text(table, "right")} : result.printed;
  return result;
}

Arm arm(const toml::table& table) {
  Arm result{text(table, "robot"), text(table, "title"), {}, {}};
  if (const toml::table* quaternion = table["quaternion"].as_table())
    result.quaternion = {text(*quaternion, "number"), list(*quaternion, "printed"),
                         list(*quaternion, "right")};
  for (const toml::node& node : *table["formula"].as_array())
    result.formulas.push_back(formula(*node.as_table()));
  return result;
}

}  // namespace

Source load(const std::filesystem::path& file) {
  const toml::table table = toml::parse_file(file.string());
  Source source{text(table, "source"), {}};
  for (const toml::node& node : *table["arm"].as_array()) source.arms.push_back(arm(*node.as_table()));
  return source;
}

std::vector<Source> sources() {
  const std::filesystem::path folder = std::filesystem::path(QVGEN_SOURCE_DIR) / "tests/inverse/errata";
  return {load(folder / "thesis.toml"), load(folder / "planar_3r.toml"), load(folder / "paden_kahan.toml")};
}

}  // namespace qvgen::test::errata
