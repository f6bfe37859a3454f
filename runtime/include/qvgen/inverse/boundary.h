// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/scalar_traits.h>
#include <qvgen/inverse/tolerances.h>

/// Tolerances of one pass over the branches: how an equation treats the ends of its range, where two
/// solutions meet and rounding decides whether they exist. Regular poses have `plain`; the passes of
/// near_singular.h and quartic/care.h, for poses near singular ones, each have theirs.
namespace qvgen::inverse {

/// If true, branches next to a singular pose are only marked as doubtful, and another solver follows them.
/// Regular branches, which are nearly all, need no steps for it.
template <typename Scalar>
inline constexpr bool leaves_singular_poses = false;

/// Two roots closer than this share of their range are one double root: the distance of the roots is then the
/// root of this number, about 6e-8, while the pose that their mean reaches is off by 4e-15 relative.
template <typename Scalar>
Scalar merge_share() {
  return Scalar(18) * epsilon<Scalar>();
}

/// How far off a pose the nearest joints may leave the arm's point and still count as a solution, as a share
/// of the arm's size: what a pose at the boundary of reach needs, since rounding puts every second one
/// outside.
inline constexpr double default_tolerance = tolerance::beyond_reach;

/// How blocks treat the ends of their range, where two solutions meet and rounding decides whether they
/// exist. `plain` is for regular poses: equations are taken at their word, and what should not be trusted is
/// said. The others are for poses near singular ones: whatever might exist is followed, and Newton steps and
/// the pose they reach decide; near_singular.h shows when each is used.
struct Boundary {
  double accept = 0;  ///< so far outside, as a share of the range, a branch still exists and is taken to the
                      ///< end of the range
  double doubt = 0;   ///< nearer to an end than this share, inside, the branch is doubtful
  double beyond = 0;  ///< as near outside it is doubtful, too; farther out it does not exist
  double unsure = tolerance::end_inside;  ///< nearer to an end than this share Newton steps judge what the
                                          ///< branch leads to
  double floor = 0;     ///< least share of the range: what is nearer to the end is moved away from it
  bool to_end = false;  ///< what is outside a range is at its end, however far: a regular pose is not so far
  double near = tolerance::nearly_free;  ///< a direction whose square is below this multiple of noise is
                                         ///< nearly free, and accepted at any share
  bool wide = true;                      ///< what is nearly free is doubtful, even if no pass would choose it
  bool choose = false;                   ///< what is nearly free is chosen as if it were free
  bool take = false;            ///< places on a continuum are taken where nothing has been chosen, too
  double gap = tolerance::gap;  ///< a free direction's equation holds if the square of what is left is below
                                ///< this multiple of noise
  double miss = 0;  ///< how far off the pose polished joints may leave the arm, as a share of its size
  double fold = 0;  ///< so far outside a wrist at the end of the arm's joints still exists, folded

  /// A choice that joints can follow in two separate ranges is in the other one.
  bool opposite = false;

  /// A share of a range, and what the caller allows beyond reach, a share of the arm's size.
  static constexpr double widened(double share, double allowed) {
    return share + tolerance::range_per_size * allowed;
  }

  static constexpr Boundary plain(double allowed) {
    Boundary boundary;
    boundary.doubt = widened(tolerance::end_inside, allowed);
    boundary.beyond = widened(tolerance::end_outside, allowed);
    boundary.miss = allowed;
    boundary.fold = allowed;
    return boundary;
  }

  // The passes of near_singular.h.

  /// From the ends of the ranges. What polishing leaves in the joints of an arm near a singular place of its
  /// own reaches the wrist magnified: half of the 1e-12 that no solution may miss its pose by.
  static constexpr Boundary ends(double allowed) {
    Boundary boundary = careful(allowed);
    boundary.unsure = widened(tolerance::end_inside, allowed);
    boundary.wide = false;
    boundary.miss = allowed;
    return boundary;
  }
  /// Pass `ends` with a choice where an angle is nearly free.
  static constexpr Boundary chosen(double allowed) {
    Boundary boundary = ends(allowed);
    boundary.choose = true;
    return boundary;
  }
  /// Pass `chosen` with a choice wherever a wrist's direction has lost half its digits.
  static constexpr Boundary blurred(double allowed) {
    Boundary boundary = chosen(allowed);
    boundary.wide = true;
    return boundary;
  }
  /// Pass `chosen` for a choice that leaves the joints after it out of reach: they are stretched to where it
  /// would be, and Newton's steps turn the chosen joint until they reach.
  static constexpr Boundary stretched(double allowed) {
    Boundary boundary = chosen(allowed);
    boundary.accept = tolerance::end_anywhere;
    boundary.gap = tolerance::gap_anything;
    return boundary;
  }

  /// Returns this boundary, that of a pass that chooses, with the choice in the other of two ranges.
  [[nodiscard]] constexpr Boundary in_other_range() const {
    Boundary boundary = *this;
    boundary.opposite = true;
    return boundary;
  }

  /// Returns this boundary with wrists folded that are as far outside.
  [[nodiscard]] constexpr Boundary folded_by(double most) const {
    Boundary boundary = *this;
    boundary.fold = most > fold ? most : fold;
    return boundary;
  }

  // The passes of quartic/care.h.

  /// From the ends of the ranges, taking no miss but rounding.
  static constexpr Boundary careful(double allowed) {
    Boundary boundary;
    boundary.accept = widened(tolerance::end_careful, allowed);
    boundary.to_end = true;
    boundary.gap = tolerance::gap_careful;
    boundary.fold = allowed > tolerance::least_fold ? allowed : tolerance::least_fold;
    return boundary;
  }
  /// Pass `careful` with a choice where an angle is nearly free.
  static constexpr Boundary choosing(double allowed) {
    Boundary boundary = careful(allowed);
    boundary.choose = true;
    boundary.take = true;
    return boundary;
  }
  /// Pass `choosing` for a choice that leaves the joints after it out of reach.
  static constexpr Boundary reaching(double allowed) {
    Boundary boundary = choosing(allowed);
    boundary.accept = tolerance::end_anywhere;
    return boundary;
  }
  /// From the ends once more, for places on a continuum to which no choice has led.
  static constexpr Boundary taking(double allowed) {
    Boundary boundary = careful(allowed);
    boundary.take = true;
    return boundary;
  }
  /// From two places apart.
  static constexpr Boundary apart(double allowed) {
    Boundary boundary = choosing(allowed);
    boundary.floor = tolerance::end_apart;
    return boundary;
  }
  /// From the ends again, for poses that are out of reach by no more than what is allowed.
  static constexpr Boundary tolerant(double allowed) {
    Boundary boundary = taking(allowed);
    boundary.miss = allowed;
    return boundary;
  }

  /// True if this is the pass of a regular pose.
  [[nodiscard]] constexpr bool is_plain() const { return doubt > 0; }
};

}  // namespace qvgen::inverse
