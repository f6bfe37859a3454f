// SPDX-License-Identifier: MIT
#pragma once

#include "description/document.h"

namespace qvgen::description {

/// Names and numbers that an entry may hold.
struct Scope {
  Role role = Role::geometry;
  /// The joint variable that may stand in this entry (a table's theta or d); empty: none.
  std::string variable = {};
};

/// Reads a number or a quoted expression; reports and gives nullopt if it is neither.
std::optional<Entry> read_entry(Context& context, const toml::node& node, const Scope& scope,
                                const std::string& what);
/// The entry of a key; absent: the number 0.
Entry entry_or_zero(const Table& table, const std::string& key, const Scope& scope);
/// An array of that many entries; wrong ones are reported and become 0.
std::optional<std::vector<Entry>> read_entries(const Table& table, const std::string& key, const Scope& scope,
                                               const std::vector<std::size_t>& lengths,
                                               const std::string& wanted);
/// Converts the numbers of a length from the file's unit to metres; terms with names are in metres already.
Entry in_metres(const Context& context, Entry entry);
/// Likewise those of an angle to radians, unless it says `deg` or `rad` itself.
Entry in_radians(const Context& context, Entry entry);
/// Reports an angle where a length, a mass or the like is wanted.
void check_no_angle(Context& context, const Entry& entry, const std::string& key);
/// Reports what cannot be a length: an angle, or a number of metres that no arm has.
void check_length(Context& context, const Entry& entry, const std::string& key);
/// Three lengths; absent: zero.
model::Vector3 vector_or_zero(const Table& table, const std::string& key, const Scope& scope);

/// Warns of a number that is more than a full turn in radians: degrees were meant, most likely; and of one
/// that is a multiple of 15 degrees but for rounding.
void check_angle(Context& context, const Entry& angle);

}  // namespace qvgen::description
