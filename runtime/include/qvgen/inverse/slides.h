// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/roots.h>

/// Blocks for prismatic joints whose directions depend on the pose: at some poses an equation loses them, and
/// they are free.
namespace qvgen::inverse {

/// A part of a unit vector whose square is below this has no direction: it vanishes but for rounding, or, in
/// a pass that chooses what is nearly free, it is next to nothing.
template <typename Scalar>
Scalar blind_square(const Boundary& boundary) {
  const Scalar noise = Scalar(tolerance::noise) * epsilon<Scalar>();
  return boundary.choose ? Scalar(tolerance::product_at_double_root) : Scalar(noise * noise);
}

/// A part of a unit vector of the given square may cost digits that matter: two in a first pass; later only
/// what a choice may have to replace is doubtful, though what it leads to is unsure.
template <typename Scalar>
void doubt_digits(const Scalar& square, const Boundary& boundary, Branch<Scalar>& branch) {
  branch.doubt(square <=
               Scalar(boundary.is_plain() ? tolerance::two_digits : tolerance::product_at_double_root));
  branch.unsure = branch.unsure | (square <= Scalar(tolerance::two_digits));
}

/// Chord of the line point + t along in a circle about the origin: t = foot ± half, half = 0 if it does not.
template <typename Scalar>
struct Chord {
  Mask<Scalar> is_point;  ///< along = 0
  Scalar foot, half;
};

template <typename Scalar>
Chord<Scalar> chord(const Rotor<Scalar>& point, const Rotor<Scalar>& along, const Scalar& square) {
  using std::sqrt;
  const Scalar speed = along.cosine * along.cosine + along.sine * along.sine;
  const Mask<Scalar> is_point = speed == Scalar(0);
  const Scalar divisor = select(is_point, Scalar(1), speed);
  const Scalar across = point.cosine * along.sine - point.sine * along.cosine;
  return {is_point, -(point.cosine * along.cosine + point.sine * along.sine) / divisor,
          sqrt(not_negative(Scalar((square - across * across / divisor) / divisor)))};
}

/// A free slide t with inner <= |point + t along|² <= outer, so that the joints after it stay in reach:
/// nearest to `value`, or, if `spread` is turned, that share of the way from the foot of the perpendicular.
/// Without any such t, the least wrong.
template <typename Scalar>
Scalar slide_between(const Rotor<Scalar>& point, const Rotor<Scalar>& along, const Scalar& inner,
                     const Scalar& outer, const Scalar& value, const Rotor<Scalar>& spread) {
  const Chord<Scalar> near = chord(point, along, inner);
  const Scalar far = chord(point, along, outer).half;
  const Scalar shared = near.half + magnitude(spread.cosine) * (far - near.half);
  const Scalar wanted = value - near.foot;
  const Scalar closest = smaller(larger(magnitude(wanted), near.half), far);
  const Mask<Scalar> is_spread = !(spread.sine == Scalar(0));
  const Scalar off = with_sign(select(is_spread, shared, closest), select(is_spread, spread.cosine, wanted));
  return select(near.is_point, value, Scalar(near.foot + off));
}

/// Returns a place of the slide without an outer end: the turned `spread` is the direction of the slide as
/// seen from beside its foot, at the distance of the arm's size.
template <typename Scalar>
Scalar slide_beyond(const Rotor<Scalar>& point, const Rotor<Scalar>& along, const Scalar& inner,
                    const Scalar& size_square, const Scalar& value, const Rotor<Scalar>& spread) {
  using std::sqrt;
  const Chord<Scalar> near = chord(point, along, inner);
  const Mask<Scalar> is_spread = !(spread.sine == Scalar(0));
  const Scalar shared = sqrt(size_square) * (spread.cosine / select(is_spread, spread.sine, Scalar(1)));
  const Scalar wanted = select(is_spread, shared, Scalar(value - near.foot));
  const Scalar off = with_sign(larger(magnitude(wanted), near.half), wanted);
  return select(near.is_point, value, Scalar(near.foot + off));
}

/// t with t along = rhs in a plane. Where the pose makes `along` vanish, whose length is at most 1, t is free
/// if rhs vanishes too: then it is the caller's choice. Where `along` is so small that rounding decides about
/// t, it is as near to the choice as the equation lets it; where it is merely small, t has lost digits.
template <typename Scalar>
Scalar slide_on_line(const Rotor<Scalar>& along, const Rotor<Scalar>& rhs, const Scalar& tiny,
                     const Scalar& choice, const Boundary& boundary, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar square = along.cosine * along.cosine + along.sine * along.sine;
  const Scalar gap = rhs.cosine * rhs.cosine + rhs.sine * rhs.sine;
  const Mask<Scalar> is_free = square <= blind_square<Scalar>(boundary);
  const Mask<Scalar> is_loose = square <= Scalar(tolerance::loose_slide);
  Branch<Scalar> regular = branch;
  doubt_digits(square, boundary, regular);
  branch.take(is_free, gap <= Scalar(boundary.gap) * tiny, regular);
  branch.continuum = branch.continuum | (branch.exists & is_loose);
  const Scalar divisor = select(is_free, Scalar(1), square);
  const Scalar middle = (along.cosine * rhs.cosine + along.sine * rhs.sine) / divisor;
  const Scalar width = select(is_loose, sqrt(Scalar(tiny / divisor)), Scalar(0));
  const Scalar least = larger(choice, Scalar(middle - width));
  return select(is_free, choice, smaller(least, Scalar(middle + width)));
}

/// Returns how far v goes across `other`, as a pair beside zero; v itself where `other` has no direction.
template <typename Scalar>
Rotor<Scalar> across(const Rotor<Scalar>& v, const Rotor<Scalar>& other, const Scalar& scale,
                     const Mask<Scalar>& is_alone) {
  const Scalar area = (v.cosine * other.sine - v.sine * other.cosine) * scale;
  return {select(is_alone, v.cosine, area), select(is_alone, v.sine, Scalar(0))};
}

/// t with t along + s other = rhs in a plane, s the value of another slide, to be found later. Where the pose
/// makes `other` vanish both components are for t.
template <typename Scalar>
Scalar slide_beside(const Rotor<Scalar>& along, const Rotor<Scalar>& other, const Rotor<Scalar>& rhs,
                    const Scalar& tiny, const Scalar& choice, const Boundary& boundary,
                    Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar square = other.cosine * other.cosine + other.sine * other.sine;
  const Mask<Scalar> is_alone = square <= blind_square<Scalar>(boundary);
  doubt_digits(square, boundary, branch);
  const Scalar scale = Scalar(1) / sqrt(select(is_alone, Scalar(1), square));
  return slide_on_line(across(along, other, scale, is_alone), across(rhs, other, scale, is_alone), tiny,
                       choice, boundary, branch);
}

/// The root t of a t² + 2 b t + c = 0, a length, at which a t + b has the sign given. What rounding may do to
/// b is a root of `tiny`, what it may do to c is that times the size; less than a thousandfold of that it may
/// decide. Where a vanishes one root lies at infinity: there is no such branch. For sign 0 it is the root
/// nearer to 0.
template <typename Scalar>
Scalar quadratic_root(const Scalar& a, const Scalar& b, const Scalar& c, const Scalar& tiny,
                      const Scalar& size_square, const Scalar& sign, const Boundary& boundary,
                      Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar scale = b * b + magnitude(Scalar(a * c));
  const Scalar discriminant = b * b - a * c;
  const Scalar noise = Scalar(tolerance::noisy_discriminant) * tiny * (b * b + a * a * size_square);
  admit(discriminant, limits_in_range(boundary, scale), discriminant * discriminant <= noise, branch);
  const Scalar root = sqrt(larger(discriminant, Scalar(boundary.floor) * scale));
  // Both summands have one sign.
  const Scalar sum = b + with_sign(root, b);
  const Mask<Scalar> wants_large = with_sign(sign, b) < Scalar(0);
  const Mask<Scalar> is_far = wants_large & (a * a <= blind_square<Scalar>(boundary));
  doubt_digits(Scalar(a * a), boundary, branch);
  branch.exists = branch.exists & !is_far;
  const Scalar divisor = select(wants_large, a, sum);
  const Scalar value = select(wants_large, sum, c);
  return select(divisor == Scalar(0), Scalar(0),
                Scalar(-value / select(divisor == Scalar(0), Scalar(1), divisor)));
}

/// Two slides (s, t) that an equation binds and a quadratic one: a s - b t = k, s² + 2 g s - t² - 2 f t + gap
/// = 0, (a, b) parts of unit vectors. Where both vanish one is free, if k vanishes too: s is what is chosen,
/// as far as t can follow.
template <typename Scalar>
Rotor<Scalar> two_slides(const Rotor<Scalar>& ab, const Scalar& k, const Rotor<Scalar>& gf, const Scalar& gap,
                         const Scalar& tiny, const Scalar& size_square, const Scalar& choice,
                         const Rotor<Scalar>& spread, const Scalar& sign, const Boundary& boundary,
                         Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar g = gf.cosine;
  const Scalar f = gf.sine;
  const Scalar square = ab.cosine * ab.cosine + ab.sine * ab.sine;
  const Mask<Scalar> is_free = square <= blind_square<Scalar>(boundary);
  const Scalar scale = Scalar(1) / sqrt(select(is_free, Scalar(1), square));
  // The line of the first equation: its foot from (0, 0) and its direction.
  const Scalar inner = g * g - gap - f * f;
  const Scalar free_foot =
      slide_beyond<Scalar>({g, Scalar(0)}, {Scalar(1), Scalar(0)}, inner, size_square, choice, spread);
  const Scalar foot = select(is_free, free_foot, Scalar(k * scale));
  const Rotor<Scalar> normal{select(is_free, Scalar(1), Scalar(ab.cosine * scale)),
                             select(is_free, Scalar(0), Scalar(-ab.sine * scale))};
  const Rotor<Scalar> along{-normal.sine, normal.cosine};
  Branch<Scalar> regular = branch;
  doubt_digits(square, boundary, regular);
  branch.take(is_free, k * k <= Scalar(boundary.gap) * tiny, regular);
  const Scalar by = quadratic_root<Scalar>(
      along.cosine * along.cosine - along.sine * along.sine,
      foot * (normal.cosine * along.cosine - normal.sine * along.sine) + g * along.cosine - f * along.sine,
      foot * foot * (normal.cosine * normal.cosine - normal.sine * normal.sine) +
          Scalar(2) * foot * (g * normal.cosine - f * normal.sine) + gap,
      tiny, size_square, sign, boundary, branch);
  return {foot * normal.cosine + by * along.cosine, foot * normal.sine + by * along.sine};
}

}  // namespace qvgen::inverse
