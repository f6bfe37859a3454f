// SPDX-License-Identifier: MIT
// A mechanism with closed loops in numbers, for pictures: its joints are a tree, and ties close the loops.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/mechanism.h"
#include "report/chain.h"
#include "report/view.h"

namespace qvgen::report {

struct Linkage {
  Chain chain;                       ///< all joints, each behind its parent in place of the one before
  std::vector<std::size_t> parents;  ///< by joints; model::base_link: the base carries it
  /// A closure between two links, at a point of each, m, in the links' frames.
  struct Tie {
    bool is_apart = false;  ///< the points have a distance: a rod, or links that slide along each other
    std::array<std::size_t, 2> links{};
    std::array<Vector, 2> points;
  };
  std::vector<Tie> ties;
  struct Tip {
    std::string name;
    std::size_t link = 0;
    Motion placement = Motion::Identity();
  };
  std::vector<Tip> tips;
  std::vector<std::size_t> driven;  ///< joints with motors
};

/// Returns a mechanism with the values of its description.
Linkage linkage_of(const model::Mechanism& mechanism);

/// Places of a linkage's parts, in the world.
struct PlacedLinkage {
  std::vector<Posture::Joint> joints;
  struct Line {
    Vector from, to;
    bool is_base = false;
  };
  std::vector<Line> lines;   ///< from joints to what their links carry, and rods
  std::vector<Vector> ties;  ///< the ends of closures
  std::vector<Motion> tips;
};
PlacedLinkage placed(const Linkage& linkage, const std::vector<double>& q);

/// Diagonal of the box around all lines, m.
double extent_of(const PlacedLinkage& at);

/// Returns where a linkage is seen from: somewhat beside the direction of most of its turns, so that its
/// links are seen in their whole lengths; the usual side where turns do not share a direction.
Sight sight_of(const Linkage& linkage, const PlacedLinkage& at);

/// Radius of the joints' symbols, m: a share of the whole, less where joints are close to each other in the
/// picture.
double symbol_radius(const PlacedLinkage& at, const Sight& sight);

/// Returns a linkage as the scripts draw it, first at joint values `start`.
nlohmann::json linkage_data(const Linkage& linkage, const std::vector<double>& start);

}  // namespace qvgen::report
