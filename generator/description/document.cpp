// SPDX-License-Identifier: MIT
#include "description/document.h"

#include <algorithm>

#include "description/names.h"

namespace qvgen::description {
namespace {

std::string list_of(const std::vector<std::string>& keys) {
  std::string text;
  for (const std::string& key : keys) text += (text.empty() ? "" : ", ") + key;
  return text;
}

}  // namespace

std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a truth value";
    default:
      return "a date or time";
  }
}

void report_type(Context& context, const toml::node& node, const std::string& what,
                 const std::string& wanted) {
  context.error(begin_of(node.source()), what + " is " + type_name(node), "write " + wanted);
}

void Table::allow_only(const std::vector<std::string>& keys) const {
  for (const auto& [key, value] : *table_) {
    const std::string name(key.str());
    if (std::find(keys.begin(), keys.end(), name) != keys.end()) continue;
    const std::string near = nearest(name, keys);
    context_->error(begin_of(key.source()), "unknown key '" + name + "' in " + title_,
                    near.empty() ? "the keys are " + list_of(keys) : "did you mean '" + near + "'?");
  }
}

const toml::node* Table::find(const std::string& key) const {
  const auto other = in_place_.find(key);
  return other == in_place_.end() ? table_->get(key) : other->second;
}

Table Table::with(std::map<std::string, const toml::node*> values) const {
  Table result = *this;
  result.in_place_ = std::move(values);
  return result;
}

const toml::node* Table::require(const std::string& key, const std::string& example) const {
  const toml::node* node = find(key);
  if (node == nullptr) context_->error(place(), "missing key '" + key + "' in " + title_, "add " + example);
  return node;
}

std::optional<std::string> Table::text(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (auto value = node->value_exact<std::string>()) return value;
  report_type(*context_, *node, "'" + key + "'", "a text in quotes");
  return std::nullopt;
}

std::optional<bool> Table::boolean(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (auto value = node->value_exact<bool>()) return value;
  report_type(*context_, *node, "'" + key + "'", "true or false");
  return std::nullopt;
}

std::optional<Table> Table::table(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const toml::table* value = node->as_table()) return Table(*context_, *value, "[" + key + "]");
  report_type(*context_, *node, "'" + key + "'", "a table [" + key + "]");
  return std::nullopt;
}

std::vector<Table> Table::tables(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const std::string title = "[[" + key + "]]";
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    report_type(*context_, *node, "'" + key + "'", "one " + title + " for each");
    return {};
  }
  std::vector<Table> result;
  for (const toml::node& element : *array) {
    if (const toml::table* table = element.as_table()) {
      result.emplace_back(*context_, *table, title);
    } else {
      report_type(*context_, element, "an entry of '" + key + "'", "one " + title + " for each");
    }
  }
  return result;
}

Place Table::place_of(const std::string& key) const {
  const toml::node* node = find(key);
  return node == nullptr ? place() : begin_of(node->source());
}

Place Table::key_place(const std::string& key) const {
  const auto found = table_->find(key);
  return found == table_->end() ? place() : begin_of(found->first.source());
}

}  // namespace qvgen::description
