// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "dag/counts.h"
#include "dag/graph.h"

namespace qvgen::passes {

/// A function and what of it can be computed beforehand.
struct ConstantSplit {
  dag::Function function;  ///< its maximal free subexpressions are symbols "$0", "$1", ... now
  dag::Function
      constants;  ///< output "$i" for each of them; those that are plain numbers are constants there
};

/// Splits a function into a set-up part (free symbols and numbers only) and the rest, node for node.
///
/// `meanings` has an output for some of the free symbols: the set-up part is written in terms of its symbols
/// instead, and what turns out to be a number there is one.
ConstantSplit split_constants(const dag::Function& function, const dag::Function& meanings,
                              const dag::IsFree& is_free);

}  // namespace qvgen::passes
