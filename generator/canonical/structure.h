// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/robot.h"

namespace qvgen::canonical {

/// How two axes lie to each other, wherever they are.
enum class Relation { parallel, perpendicular, oblique };

/// The three joints that place an arm's wrist, by their types and the relations of their axes (Huang and
/// Milenkovic 1983; thesis, chapter 2). Behind a turn the third axis has no fixed relation to the first.
struct Structure {
  std::array<bool, 3> turns;          ///< revolute, or a slide
  std::array<Relation, 2> relations;  ///< of axes 1 and 2, of 2 and 3
  Relation ends = Relation::oblique;  ///< of axes 1 and 3, where the second joint is a slide
  friend bool operator==(const Structure&, const Structure&) = default;
};

/// Returns the structure of the first three joints; nothing if there are fewer, or if a twist is a symbol.
std::optional<Structure> structure_of(const model::Robot& robot);

/// "RRP"
std::string types_of(const Structure& structure);
/// "perpendicular, parallel": the relations in their order.
std::string pattern_of(const Structure& structure);

/// The two letters of the code: S a slide; C a turn parallel to a slide; N a turn perpendicular to a turn; R
/// a turn parallel to a turn or perpendicular to a slide. The first is joint 1 beside joint 2, the second
/// joint 3 beside joint 2. A slide at an end, parallel to a turn that is perpendicular to the other one, is C
/// as well: as S it would have the code of another structure. Nothing for structures that have no code:
/// useless ones, two slides around a turn, and oblique axes.
std::optional<std::string> code_of(const Structure& structure);

/// True if the joints move a point in all three directions, whatever the offsets.
bool is_useful(const Structure& structure);

/// The structures that move alike: a slide and what is parallel to it change places, and so do two slides.
std::vector<Structure> alike(const Structure& structure);
/// The one among them that the sources keep, the others being "not distinct": the slide in the middle if
/// there is one turn on each side, and between parallel axes else.
Structure representative(const Structure& structure);

enum class Workspace { none, prismatic, cylindrical, spherical };
/// By the joints: prismatic without a turn, cylindrical where all turns are parallel, else spherical; none
/// for those that are not useful.
Workspace workspace_of(const Structure& structure);
std::string to_string(Workspace workspace);

}  // namespace qvgen::canonical
