// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "description/context.h"

namespace qvgen::description {

/// A TOML table under examination: typed access in which every mistake becomes a diagnostic.
///
/// An absent optional key and a wrong one both give nullopt; `has` tells them apart.
class Table {
 public:
  /// `title` is how messages call it, e.g. "[[joint]]".
  Table(Context& context, const toml::table& table, std::string title)
      : context_(&context), table_(&table), title_(std::move(title)) {}

  /// Reports every key that is not among these.
  void allow_only(const std::vector<std::string>& keys) const;
  [[nodiscard]] bool has(const std::string& key) const { return find(key) != nullptr; }
  [[nodiscard]] const toml::node* find(const std::string& key) const;
  /// Returns the table as if these keys had these values; null: as if they were absent.
  [[nodiscard]] Table with(std::map<std::string, const toml::node*> values) const;
  /// Like find, and a missing key is reported.
  const toml::node* require(const std::string& key, const std::string& example) const;

  [[nodiscard]] std::optional<std::string> text(const std::string& key) const;
  [[nodiscard]] std::optional<bool> boolean(const std::string& key) const;
  [[nodiscard]] std::optional<Table> table(const std::string& key) const;
  [[nodiscard]] std::vector<Table> tables(const std::string& key) const;

  [[nodiscard]] Context& context() const { return *context_; }
  [[nodiscard]] const toml::table& node() const { return *table_; }
  [[nodiscard]] Place place() const { return begin_of(table_->source()); }
  [[nodiscard]] Place place_of(const std::string& key) const;
  [[nodiscard]] Place key_place(const std::string& key) const;

 private:
  Context* context_;
  const toml::table* table_;
  std::string title_;
  std::map<std::string, const toml::node*> in_place_;  ///< of what the table itself has
};

/// "a number", "an array", ... for messages.
std::string type_name(const toml::node& node);
/// The only complaint about a value of the wrong type.
void report_type(Context& context, const toml::node& node, const std::string& what,
                 const std::string& wanted);

}  // namespace qvgen::description
