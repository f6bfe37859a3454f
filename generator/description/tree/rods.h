// SPDX-License-Identifier: MIT
// Links that are rods: a ball or a universal joint holds one end, a closure ties the other, and nothing else
// hangs on them. Such a link only keeps two points at their distance. Read so, it needs no joints of its own,
// and loops with it have closed forms.
#pragma once

#include <map>
#include <vector>

#include "description/tree/tree.h"

namespace qvgen::description::tree {

/// A tree without the links that are rods.
struct WithoutRods {
  std::vector<Node> nodes;                  ///< indices as before; rods hang on no link
  std::vector<Closure> closures;            ///< rods in place of the balls at their ends
  ReadSegment read;                         ///< with the rods' masses, as points at their ends
  std::map<std::size_t, Body> points = {};  ///< these masses, by the links that have them
};

/// Takes rods out of a tree, each with a note, and a warning if it has mass. Links whose joints are driven or
/// follow others, and those that --tips names, stay.
WithoutRods take_rods(Context& context, const std::vector<Node>& nodes, const ReadSegment& read,
                      const Loops& loops, const std::vector<Closure>& closures);

}  // namespace qvgen::description::tree
