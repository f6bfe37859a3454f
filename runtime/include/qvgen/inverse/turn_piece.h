// SPDX-License-Identifier: MIT
// Numbers of whole turns of values that move along a line: limits leave a piece of it, on which the distance
// from a centre is a parabola. C has this header, too.
#pragma once

#include <qvgen/inverse/turn_range.h>

namespace qvgen::inverse {

/// Returns the least whole number that is no less than a value.
template <typename Scalar>
Scalar whole_above(const Scalar& value) {
  const Scalar whole = nearest_whole(value);
  return select(whole < value, whole + Scalar(1), whole);
}

/// Numbers with which values are inside, and the one, no whole number, at which they are nearest to a centre.
template <typename Scalar>
struct TurnPiece {
  Scalar least{-tolerance::farthest_joint};
  Scalar most{tolerance::farthest_joint};
  Scalar nearest{0};
  Mask<Scalar> inside{true};  ///< false: there is no number

  /// Leaves the numbers with which one more value is inside, which has so far to go to its limits.
  void cut_line(const Scalar& down, const Scalar& up, double per_motion) {
    least = larger(per_motion > 0 ? down * per_motion : up * per_motion, least);
    most = smaller(per_motion > 0 ? up * per_motion : down * per_motion, most);
  }
  /// Keeps whole numbers alone.
  void keep_whole_numbers() {
    least = whole_above(least);
    most = -whole_above(-most);
    inside = inside & (least <= most);
  }
  [[nodiscard]] Scalar nearest_inside() const { return smaller(most, larger(least, nearest_whole(nearest))); }
};

/// True if a square of a distance, computed in another way, may be less than the best.
template <typename Scalar>
Mask<Scalar> may_be_best(const Scalar& square, const Scalar& best) {
  return square < best * Scalar(1 + tolerance::same_square);
}

/// Numbers that are tried one after the other, outwards from the nearest.
template <typename Scalar>
struct Outwards {
  Scalar least;
  Scalar most;
  Scalar nearest;
  Scalar number;  ///< that is tried now
  Scalar up;      ///< the next ones to both sides
  Scalar down;

  /// Begins with the nearest number that is inside.
  void start_outwards(const TurnPiece<Scalar>& piece) {
    const Scalar farthest =
        select(piece.most - piece.least < Scalar(many_turns), Scalar(many_turns), Scalar(tried_turns));
    number = piece.nearest_inside();
    least = larger(piece.least, number - farthest);
    most = smaller(piece.most, number + farthest);
    nearest = piece.nearest;
    up = number + Scalar(1);
    down = number - Scalar(1);
  }
  /// Goes to the next number; false if there is none.
  Mask<Scalar> next_outwards() {
    const Mask<Scalar> goes_up = (down < least) | ((up <= most) & (up - nearest <= nearest - down));
    number = select(goes_up, up, down);
    up = select(goes_up, up + Scalar(1), up);
    down = select(goes_up, down, down - Scalar(1));
    return (number >= least) & (number <= most);
  }
  /// Returns the square of the distance beyond the least one. `square`: that of what a turn moves.
  [[nodiscard]] Scalar square_beyond_least(double square) const {
    const Scalar off = number - nearest;
    return square * (off * off);
  }
};

}  // namespace qvgen::inverse
