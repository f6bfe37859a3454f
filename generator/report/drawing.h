// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/chain.h"
#include "report/linkage.h"

namespace qvgen::report {

/// Title of a drawing, and its text for those who do not see it.
struct Caption {
  std::string id;  ///< unique on its page
  std::string title;
  std::string description;
  bool names = true;    ///< of joints and offsets beside them
  bool frames = false;  ///< those of the links in place of the joints
};

/// The arm as an SVG: turns as cylinders on their axes, slides as boxes, constant pieces as lines.
std::string drawing(const Chain& chain, const std::vector<double>& q, const Caption& caption);

/// Draws a whole robot by its limbs; joints that they share are drawn once.
std::string drawing(const std::vector<Chain>& limbs, const Caption& caption);

/// Draws a mechanism with closed loops at joint values, and the same small and without names.
std::string drawing(const Linkage& linkage, const std::vector<double>& q, const Caption& caption);
std::string thumbnail(const Linkage& linkage, const std::vector<double>& q, const Caption& caption);

/// Draws an arm, or the limbs of a whole robot, small and without names, for lists.
std::string thumbnail(const std::vector<Chain>& limbs, const Caption& caption);

}  // namespace qvgen::report
