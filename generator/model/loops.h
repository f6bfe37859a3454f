// SPDX-License-Identifier: MIT
// Closed loops of links: the joints of a mechanism are a tree, and closures tie two of its links together.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "model/robot.h"

namespace qvgen::model {

/// Kinds of closures.
enum class LoopType {
  pin,    ///< a point is common to both links, and an axis through it
  ball,   ///< a point is common to both links
  rod,    ///< two points keep their distance
  weld,   ///< the links are one
  slide,  ///< links that slide along each other: a line is common to both, and the links do not turn about it
  gear    ///< no closure of links: joints that move together (Gear)
};

/// A closure of a loop. A link is called by the index of the joint that moves it, or `base_link`.
struct Loop {
  LoopType type = LoopType::pin;
  std::array<std::size_t, 2> links{};
  std::array<Vector3, 2> points{};  ///< in the links' frames, m
  /// Unit vector of a pin or a slide in the first link's frame; none: a pin about the joints' axes.
  std::optional<Vector3> axis = {};
  std::vector<Turn> turns = {};  ///< of a weld or a slide: the second link's frame as seen from the first
  Expression length = {};        ///< of a rod, m
  std::optional<std::size_t> length_joint = {};  ///< slide whose value is the length of a rod
};

/// Joints that move together: the value of one is a constant and the sum of others, each times its factor. It
/// may be a polynomial of one leader, whose factor in the sum may then be 0.
struct Gear {
  std::size_t joint = 0;
  std::vector<std::pair<std::size_t, cln::cl_RA>> leaders = {};
  Expression offset = {};  ///< rad or m
  Powers powers = {};      ///< of the only leader
};

/// All closures of a mechanism, with the joints that are driven. Joints that follow by polynomials make a
/// mechanism without closures one of these.
struct Loops {
  std::vector<Loop> closures = {};         ///< in the order of the file
  std::vector<Gear> gears = {};            ///< of joints that follow others: among loops each has a value
  std::vector<std::size_t> actuated = {};  ///< joints with motors; the others are passive
  std::vector<std::size_t> outputs = {};   ///< joints that say where a platform is; may be empty

  [[nodiscard]] bool empty() const { return closures.empty() && gears.empty(); }
};

}  // namespace qvgen::model
