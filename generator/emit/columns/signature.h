// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/blocks/analysis.h"
#include "emit/blocks/unit.h"

/// A function of C as it is called for many configurations at once: arrays with a configuration a column,
/// constants behind them, and a result for each field of what C writes. `void arm_forward_kinematics(const
/// double q[6], const arm_geometry* g, arm_pose* result)` is in Octave
///
///     [orientation, position] = qvgen_arm.forward_kinematics(q, g)
namespace qvgen::emit::columns {

struct Input {
  enum class Kind { row, number, structure };
  Kind kind = Kind::row;
  std::string name;
  int size = 1;           ///< rows of a column; fields of a structure
  std::string structure;  ///< its type in C
  std::string usual;      ///< constant of C whose value it has if it is left out; empty if there is none
  bool may_lack = false;  ///< empty or left out: C gets the usual constant, or NULL
  std::size_t place = 0;  ///< among the parameters of C
};

/// A field of what C writes. Entries of `found.rows` have a column each.
struct Output {
  std::string name;
  std::string place;  ///< in C: "result.position", "found.rows[k].q"
  std::vector<int> sizes;
  bool is_whole = false;  ///< int in C
  bool is_in_rows = false;
};

struct Signature {
  const blocks::Function* function = nullptr;
  std::string name;
  std::vector<Input> inputs;  ///< in the order of a call; what all code has as numbers is left out
  std::vector<Output> outputs;
  int row_capacity = 0;   ///< of `found.rows`
  std::string row_count;  ///< how many there are: "found.count"
};

/// The signature of a public function; nothing if it takes or gives what a caller cannot hand over.
std::optional<Signature> signature_of(const blocks::Unit& unit, const blocks::Shapes& shapes,
                                      const blocks::Function& function);

}  // namespace qvgen::emit::columns
