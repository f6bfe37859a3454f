// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/arctangent.h>

namespace qvgen::inverse {

/// Cosine and sine of an angle: solved angles stay algebraic, the arctangent is taken for the output alone.
template <typename Scalar>
struct Rotor {
  Scalar cosine;
  Scalar sine;
};

template <typename Scalar>
Rotor<Scalar> operator*(const Rotor<Scalar>& a, const Rotor<Scalar>& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

template <typename Scalar>
Rotor<Scalar> operator*(const Scalar& factor, const Rotor<Scalar>& a) {
  return {factor * a.cosine, factor * a.sine};
}

template <typename Scalar>
Rotor<Scalar> inverse(const Rotor<Scalar>& a) {
  return {a.cosine, -a.sine};
}

/// A small turn, by 2 atan(angle/2): exact in length; far ones end at half a turn.
template <typename Scalar>
Rotor<Scalar> turned_by(const Rotor<Scalar>& u, const Scalar& angle) {
  const Scalar t = angle / Scalar(2);
  const Scalar scale = Scalar(1) / (Scalar(1) + t * t);
  return Rotor<Scalar>{(Scalar(1) - t) * (Scalar(1) + t) * scale, Scalar(2) * t * scale} * u;
}

/// Angle in [-pi, pi], rad, of a pair that need not be normalised.
template <typename Scalar>
Scalar angle(const Rotor<Scalar>& rotor) {
  return arctangent(rotor.sine, rotor.cosine);
}

template <typename Scalar>
Scalar pi() {
  return Scalar(constant::pi);
}

/// Angle in (-pi, pi], rad, of a pair of the given length: -pi, which a negative zero or a rounded sine would
/// give, is pi.
template <typename Scalar>
Scalar output_angle(const Rotor<Scalar>& rotor, const Scalar& length, const Scalar& pi) {
  const Scalar value = arctangent(rotor.sine, rotor.cosine, length);
  return select(value <= -pi, pi, value);
}

/// Returns the angle of a direction and the angle of the opposite direction, both in (-pi, pi].
template <typename Scalar>
Opposites<Scalar> output_angles(const Rotor<Scalar>& u, const Scalar& length, const Scalar& pi) {
  const Opposites<Scalar> value = opposite_arctangents(u.sine, u.cosine, length, pi);
  return {select(value.one <= -pi, pi, value.one), select(value.other <= -pi, pi, value.other)};
}

template <typename Scalar>
Scalar output_angle(const Scalar& cosine, const Scalar& sine, const Scalar& length = Scalar(1)) {
  return output_angle(Rotor<Scalar>{cosine, sine}, length, pi<Scalar>());
}

/// Returns, of all directions that a vector may have after rounding, the one nearest to `choice`. Rounding
/// may move the vector's end within a disc. `unit` is the vector's direction, the squares are those of its
/// length and of the disc's radius. Near a place where the vector vanishes and its direction is free this
/// goes over from the choice to the direction without a jump. `opposites`: the opposite direction is another
/// branch, which the opposite of the choice is near to.
template <typename Scalar, bool opposites>
Rotor<Scalar> turned_to(const Rotor<Scalar>& preferred, const Rotor<Scalar>& unit, const Scalar& square,
                        const Scalar& disc) {
  using std::sqrt;
  Rotor<Scalar> choice = preferred;
  Rotor<Scalar> off = choice * inverse(unit);
  if constexpr (opposites) {
    const Mask<Scalar> is_other = off.cosine < Scalar(0);
    choice = {negated(is_other, choice.cosine), negated(is_other, choice.sine)};
    off = {negated(is_other, off.cosine), negated(is_other, off.sine)};
  }
  const Scalar share = smaller(Scalar(disc / square), Scalar(1));
  const Scalar sine = sqrt(share);
  const Mask<Scalar> within = (off.cosine > Scalar(0)) & (magnitude(off.sine) <= sine);
  const Rotor<Scalar> moved =
      Rotor<Scalar>{sqrt(Scalar(Scalar(1) - share)), with_sign(sine, off.sine)} * unit;
  return {select(within, choice.cosine, moved.cosine), select(within, choice.sine, moved.sine)};
}

/// Below this multiple of what is noise for sure rounding can be seen in a direction.
template <typename Scalar>
Mask<Scalar> is_blurred(const Scalar& square, const Scalar& noise) {
  return square <= Scalar(tolerance::blurred) * noise;
}

/// True if nobody prefers an angle, see `Preference::nobodys`: what is nearly free is then doubtful.
template <typename Scalar>
Mask<Scalar> is_nobodys(const Scalar& angle) {
  return angle >= Scalar(tolerance::farthest_joint);
}

/// How much larger than what is noise for sure the square of a disc is that no rounding leaves: 8 times the
/// radius.
template <typename Scalar>
Scalar widest_blur() {
  return Scalar(64);
}

/// True if a direction may be so far from where the pose has it that rows have to be marked: half a
/// milliradian or more. `square` is that of its vector's length, `widest` how many times what is noise for
/// sure rounding leaves at most, `noise` that square.
template <typename Scalar>
Mask<Scalar> is_marked(const Scalar& square, const Scalar& widest, const Scalar& noise) {
  return square <= Scalar(tolerance::marked) * widest * noise;
}

/// A pair brought to length one. Where its squared length is below `tiny`, any direction will do: the
/// caller's choice is taken; what the other signs then lead to may be the same. Where it is not much longer
/// the direction may be noise. The branch is marked in either case.
template <typename Scalar, bool opposites = false>
Rotor<Scalar> direction(const Rotor<Scalar>& v, const Scalar& tiny, const Rotor<Scalar>& choice,
                        Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar square = v.cosine * v.cosine + v.sine * v.sine;
  const Mask<Scalar> is_free = square <= tiny;
  const Mask<Scalar> blurred = is_blurred(square, tiny);
  branch.doubt(blurred);
  if constexpr (leaves_singular_poses<Scalar>) return (Scalar(1) / sqrt(square)) * v;
  const Scalar scale = Scalar(1) / sqrt(select(is_free, Scalar(1), square));
  const Rotor<Scalar> unit = scale * v;
  if (!any(blurred)) return unit;
  branch.continuum = branch.continuum | (branch.exists & is_marked(square, widest_blur<Scalar>(), tiny));
  const Rotor<Scalar> near = turned_to<Scalar, opposites>(choice, unit, select(is_free, tiny, square),
                                                          Scalar(widest_blur<Scalar>() * tiny));
  const Rotor<Scalar> seen{select(blurred, near.cosine, unit.cosine), select(blurred, near.sine, unit.sine)};
  return {select(is_free, choice.cosine, seen.cosine), select(is_free, choice.sine, seen.sine)};
}

/// Length of a choice that takes the place of a direction without length: as good as zero, and far from
/// underflow.
inline constexpr double brief_length = tolerance::digits(0x1p-100);

/// A pair left as long as it is. A free one is the caller's choice, of `brief_length`: what is computed from
/// its length is then as good as zero, as it should be, and its direction is still exact. `length` is known
/// for the others.
template <typename Scalar, bool opposites = false>
Rotor<Scalar> chosen_if_free(const Rotor<Scalar>& v, const Scalar& square, const Scalar& tiny,
                             const Rotor<Scalar>& brief_choice, Scalar& length, Branch<Scalar>& branch) {
  const Mask<Scalar> blurred = is_blurred(square, tiny);
  if constexpr (leaves_singular_poses<Scalar>) {
    branch.doubt(blurred);
    return v;
  }
  if (!any(blurred)) return v;
  // A choice without length is nobody's.
  branch.doubt(blurred & (magnitude(brief_choice.cosine) + magnitude(brief_choice.sine) == Scalar(0)));
  const Mask<Scalar> is_free = square <= tiny;
  branch.continuum = branch.continuum | (branch.exists & is_marked(square, widest_blur<Scalar>(), tiny));
  const Scalar safe = select(is_free, Scalar(1), length);
  const Scalar unbrief(1 / brief_length);
  const Rotor<Scalar> near = safe * turned_to<Scalar, opposites>(
                                        unbrief * brief_choice, Scalar(Scalar(1) / safe) * v,
                                        select(is_free, tiny, square), Scalar(widest_blur<Scalar>() * tiny));
  const Rotor<Scalar> seen{select(blurred, near.cosine, v.cosine), select(blurred, near.sine, v.sine)};
  length = select(is_free, Scalar(brief_length), length);
  return {select(is_free, brief_choice.cosine, seen.cosine), select(is_free, brief_choice.sine, seen.sine)};
}

/// Returns the direction of a vector and its length.
template <typename Scalar, bool opposites = false>
Rotor<Scalar> span(const Rotor<Scalar>& v, const Scalar& tiny, const Rotor<Scalar>& brief_choice,
                   Scalar& length, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar square = v.cosine * v.cosine + v.sine * v.sine;
  length = sqrt(square);
  return chosen_if_free<Scalar, opposites>(v, square, tiny, brief_choice, length, branch);
}

/// Returns the direction of a vector whose length is known but for rounding: a Newton step corrects it
/// without waiting for a root.
template <typename Scalar, bool opposites = false>
Rotor<Scalar> span_of_length(const Rotor<Scalar>& v, const Scalar& about, const Scalar& tiny,
                             const Rotor<Scalar>& brief_choice, Scalar& length, Branch<Scalar>& branch) {
  const Scalar square = v.cosine * v.cosine + v.sine * v.sine;
  length = Scalar(0.5) * about + square * (Scalar(0.5) / about);
  return chosen_if_free<Scalar, opposites>(v, square, tiny, brief_choice, length, branch);
}

/// Cosine and sine of half the angle (in (-pi/2, pi/2]) from a normalised pair, accurate near 0 and near pi.
template <typename Scalar>
Rotor<Scalar> half(const Rotor<Scalar>& u) {
  using std::sqrt;
  const Mask<Scalar> acute = u.cosine >= Scalar(0);
  const Scalar longer = sqrt((Scalar(1) + magnitude(u.cosine)) / Scalar(2));
  const Scalar other = u.sine / (Scalar(2) * longer);
  return {select(acute, longer, magnitude(other)), select(acute, other, with_sign(longer, u.sine))};
}

/// The direction of half the angle of a pair of the given length, without root and quotient: its squared
/// length is between 2 and 4 times the pair's. For wrists, to which the length of their matrix does not
/// matter.
template <typename Scalar>
Rotor<Scalar> half_direction(const Rotor<Scalar>& u, const Scalar& length) {
  const Mask<Scalar> acute = u.cosine >= Scalar(0);
  const Scalar longer = length + magnitude(u.cosine);
  return {select(acute, longer, magnitude(u.sine)), select(acute, u.sine, with_sign(longer, u.sine))};
}

/// (-pi, pi] of an angle in (-3 pi, 3 pi].
template <typename Scalar>
Scalar wrapped(const Scalar& angle, const Scalar& pi) {
  const Scalar up = select(angle <= -pi, Scalar(Scalar(2) * pi), Scalar(0));
  return angle + select(angle > pi, Scalar(Scalar(-2) * pi), up);
}

/// The opposite direction: angle + pi for an angle in (-pi, pi], again in (-pi, pi]. A positive angle may be
/// so small that the difference rounds to -pi.
template <typename Scalar>
Scalar opposite(const Scalar& angle, const Scalar& pi) {
  const Scalar turned = angle + select(angle > Scalar(0), Scalar(-pi), pi);
  return select(turned <= -pi, pi, turned);
}

/// -angle for an angle in [0, pi], again in (-pi, pi].
template <typename Scalar>
Scalar negative(const Scalar& angle, const Scalar& pi) {
  return select(angle >= pi, pi, Scalar(-angle));
}

}  // namespace qvgen::inverse
