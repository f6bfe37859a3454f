// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "description/reader.h"
#include "description/source.h"

namespace qvgen::description {

/// Use of a symbol: it decides which struct of the generated code gets its field.
enum class Role { geometry, inertia, constant };

struct SymbolUse {
  std::string name;
  Place place;
  Role role = Role::geometry;
  bool automatic = false;  ///< named by the reader (free inertial parameters)
};

/// An expression and where it stands.
struct Entry {
  model::Expression value;
  Place place;
  bool has_unit = false;
};

struct Variable {
  std::string name;
  Place place;
};

/// Units of the numbers of a file; symbols and their values are always in metres and radians.
struct Units {
  cln::cl_RA length = 1;  ///< metres
  bool degrees = false;
};

/// A joint that is said to follow others.
struct Follower {
  std::size_t joint;
  model::Follows leaders;  ///< as the file calls them
  model::Expression offset;
  Place place;
  bool may_be_alone = false;  ///< without its leaders it is free, with a warning
  model::Powers powers = {};  ///< of the only leader
};

/// Shared state of the readers of one file's parts: the text, the mistakes so far, the names met so far.
struct Context {
  Context(std::string_view text, std::string file, const ReadOptions& read_options)
      : source(text, std::move(file)), options(read_options) {}

  void error(Place place, std::string message, std::string hint);
  void warning(Place place, std::string message, std::string hint);
  /// Notes what the reader did of its own accord; never an error.
  void note(Place place, std::string message, std::string hint);
  [[nodiscard]] Diagnostic diagnostic(Place place, std::string message, std::string hint) const;
  [[nodiscard]] const std::string& file_of(Place place) const;

  Source source;
  ReadOptions options;
  std::vector<std::string> files;  ///< that the description names, such as what an MJCF includes
  std::vector<Diagnostic> diagnostics;
  std::vector<SymbolUse> uses;
  std::vector<Variable> variables;  ///< of the joints, base to tool
  /// Symbols that stand where a moving row of a table has its variable.
  std::vector<Variable> constants_in_place_of_variables;
  std::vector<Entry> entries;  ///< every expression of the chain, for checks at the default values
  std::vector<Place> joint_places;
  std::map<std::string, std::size_t> composed;  ///< joints of several parts: index of the last part
  Place base_place;                             ///< of a base that floats
  std::vector<Follower> followers;
  std::vector<Place> motor_places;
  Units units;
  bool takes_units = false;            ///< the format has keys for them
  bool is_measured = false;            ///< an angle next to a right one is meant
  bool has_error = false;              ///< warnings apart, even if they count as errors
  bool has_broken_expression = false;  ///< then some symbols were not seen
};

}  // namespace qvgen::description
