// SPDX-License-Identifier: MIT
// Platforms on six rods whose lengths are driven (Gough and Stewart), and all complex places of one for
// random complex lengths: where paths to its real places begin (qvgen/inverse/six_rods/places.h). They are
// counted, not known beforehand. No such platform has more than 40 isolated places (Ronga and Vust 1992;
// Lazard 1992; Mourrain 1993). A platform of no special shape has 40, which loops in the space of lengths
// find. Its 40 places are then followed while its ends move to those of the platform that is asked for. Some
// leave for infinity if that has a special shape; the others are all there are (parameter continuation), in
// two runs the same number.
#pragma once

#include <optional>
#include <vector>

#include <qvgen/inverse/six_rods/equations.h>

#include "model/mechanism.h"

namespace qvgen::verify {

/// A platform with the frame of a tip. Numbers are of the description; ends are in metres.
struct SixRods {
  std::size_t tip = 0;               ///< index of the tip in whose frame the ends on the platform are
  std::vector<std::size_t> lengths;  ///< joints whose values are the rods' lengths
  inverse::six_rods::Ends<double> ends{};
};

/// Returns the platform that a mechanism is, if it is one: six rods of driven lengths from the base to a link
/// with a tip, which six joints named in `outputs` carry, and numbers in place of parameters.
std::optional<SixRods> six_rods_of(const model::Mechanism& mechanism);

/// All places for some complex lengths, in the form that `inverse::six_rods::Start` has.
struct CountedPlaces {
  double unit = 1;  ///< m, a power of two
  std::array<double, 3> base_centre{}, platform_centre{};
  inverse::six_rods::Ends<double> ends{};
  inverse::six_rods::PerRod<inverse::six_rods::Complex> squares{};
  std::array<inverse::six_rods::Complex, 4> patch{};
  std::vector<inverse::six_rods::Point> points;
};

/// Counts the places of a platform. Throws std::domain_error if it has none (it moves though its rods are
/// held) or if two runs disagree.
CountedPlaces count_places(const inverse::six_rods::Ends<double>& ends);

}  // namespace qvgen::verify
