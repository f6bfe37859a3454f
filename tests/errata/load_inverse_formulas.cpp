// SPDX-License-Identifier: MIT
#include <stdexcept>

#include <toml++/toml.h>

#include "inverse_formulas.h"

namespace qvgen::test::sources {
namespace {

std::string text(const toml::table& table, const char* key) { return table[key].value_or(std::string()); }

std::vector<std::string> list(const toml::table& table, const char* key) {
  std::vector<std::string> result;
  if (const toml::array* array = table[key].as_array())
    for (const toml::node& node : *array) result.push_back(node.value<std::string>().value());
  return result;
}

Formula formula(const toml::table& table) {
  Formula result{
      text(table, "number"), text(table, "of"),   {list(table, "where"), text(table, "printed")}, {},
      text(table, "note"),   list(table, "signs")};
  result.right =
      table.contains("right") ? Text{list(table, "right_where"), text(table, "right")} : result.printed;
  return result;
}

Arm arm(const toml::table& table) {
  Arm result{text(table, "robot"), text(table, "title"), {}};
  for (const toml::node& node : *table["formula"].as_array())
    result.formulas.push_back(formula(*node.as_table()));
  return result;
}

}  // namespace

std::vector<Arm> load_inverse_formulas(const std::string& file) {
  const toml::table table = toml::parse_file(QVGEN_SOURCE_DIR "/tests/errata/printed/" + file);
  std::vector<Arm> arms;
  for (const toml::node& node : *table["arm"].as_array()) arms.push_back(arm(*node.as_table()));
  return arms;
}

}  // namespace qvgen::test::sources
