// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dag/graph.h"

namespace qvgen::dag {

/// Operations of a function by the one counting rule of the project: an n-term product is n-1
/// multiplications, a square is one, an n-term sum n-1 additions; sign changes are free; the pair (sin, cos)
/// of an angle is one sine_cosine, and sums and halvings inside the angle are not counted.
struct OperationCounts {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;
  int roots = 0;
  int sine_cosines = 0;
  int arctangents = 0;

  friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// Tells the symbols on which arithmetic is done once, in a set-up function, and therefore not counted.
using IsFree = std::function<bool(const std::string& symbol)>;

/// True if an angle is made of free symbols and constants alone.
bool is_free(const Angle& angle, const IsFree& is_free_symbol);
/// Returns, for every node of a function's graph, if it is free; empty without `is_free`.
std::vector<bool> free_nodes(const Function& function, const IsFree& is_free);

/// Counts what the outputs reach; with `is_free`, nodes that depend on free symbols and constants alone cost
/// nothing.
OperationCounts count(const Function& function, const IsFree& is_free = {});

}  // namespace qvgen::dag
