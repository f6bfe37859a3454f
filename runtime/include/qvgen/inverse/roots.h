// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/angles.h>

namespace qvgen::inverse {

/// A boundary in the units of an equation's range, what is outside negative.
template <typename Scalar>
struct Limits {
  Scalar doubt, beyond, accept, unsure;
  bool wide;
};

template <typename Scalar>
Limits<Scalar> limits_of(const Boundary& boundary) {
  return {Scalar(boundary.doubt), Scalar(-boundary.beyond), Scalar(-boundary.accept), Scalar(boundary.unsure),
          boundary.wide};
}

template <typename Scalar>
Limits<Scalar> limits_in_range(const Boundary& boundary, const Scalar& range) {
  const Scalar doubt = Scalar(boundary.doubt) * range;
  return {doubt, Scalar(-boundary.beyond) * range, Scalar(-boundary.accept) * range,
          boundary.is_plain() ? doubt : Scalar(Scalar(boundary.unsure) * range), boundary.wide};
}

/// True if a branch exists that is `margin` from the end of a range; `nearly_free` as for `Boundary::near`.
template <typename Scalar>
void admit(const Scalar& margin, const Limits<Scalar>& limits, const Mask<Scalar>& nearly_free,
           Branch<Scalar>& branch) {
  const Mask<Scalar> close = ((margin < limits.doubt) & (margin > limits.beyond));
  branch.doubt(limits.wide ? Mask<Scalar>(close | nearly_free) : close);
  branch.unsure = branch.unsure | (margin < limits.unsure) | nearly_free;
  branch.exists = branch.exists & ((margin >= limits.accept) | nearly_free);
}

/// Returns the angle of `circle_angle`, which exists wherever it is nearly free. There a range that is next
/// to nothing may be left by many times its own length, because an earlier double root carries half the
/// digits.
template <typename Scalar>
Rotor<Scalar> circle_from(const Scalar& low, const Scalar& high, const Scalar& scale, const Scalar& sign,
                          const Boundary& boundary, const Mask<Scalar>& nearly_free, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar sine2 = low * scale;
  const Scalar cosine2 = high * scale;
  admit(smaller(sine2, cosine2), limits_of<Scalar>(boundary), nearly_free, branch);
  const Scalar least(boundary.floor);
  // The root of low * high, which need not wait for the shares.
  const bool is_apart = boundary.to_end && boundary.floor > 0;
  const Scalar height = sqrt(larger(Scalar(low * high), is_apart ? Scalar(least / (scale * scale)) : least));
  const Rotor<Scalar> turn{larger(cosine2, least) - larger(sine2, least),
                           (Scalar(2) * sign * magnitude(scale)) * height};
  if (!boundary.to_end) return turn;
  return {smaller(larger(turn.cosine, Scalar(-1)), Scalar(1)), turn.sine};
}

/// cos φ = (high - low) / (high + low), the two angles ±φ at which a line or circle meets a circle; scale = 1
/// / (low + high).
///
/// For a·x = d, |x| = r: low = r|a| - d, high = r|a| + d, φ counted from a. For |v + x| = δ:
/// low = (|v|+r)² - δ², high = δ² - (|v|-r)², φ counted from v. Both tell sin² and cos² of φ/2 without
/// cancellation, so the angle is exact to rounding at φ = 0 and φ = pi; both may have their signs flipped.
template <typename Scalar>
Rotor<Scalar> circle_angle(const Scalar& low, const Scalar& high, const Scalar& scale, const Scalar& sign,
                           const Boundary& boundary, Branch<Scalar>& branch) {
  return circle_from(low, high, scale, sign, boundary, Mask<Scalar>(false), branch);
}

/// True if a direction of the given square is nearly free, or the nearer end of its range so near that
/// earlier equations, which magnify rounding where they are at their own ends, may have moved it across.
template <typename Scalar>
Mask<Scalar> nearly_free(const Scalar& square, const Scalar& low, const Scalar& high, const Scalar& tiny,
                         const Boundary& boundary) {
  const Scalar end = smaller(magnitude(low), magnitude(high));
  return (square <= Scalar(boundary.near) * tiny) | (end * end <= Scalar(tolerance::magnified_end) * tiny);
}

/// The angle ±φ from a direction (x, y) that the pose gives, low and high as for `circle_angle`. Where the
/// direction's squared length is below `tiny`, low + high vanishes too: the angle is free if high - low is as
/// small.
template <typename Scalar>
Rotor<Scalar> free_circle_angle(const Scalar& low, const Scalar& high, const Rotor<Scalar>& from,
                                const Scalar& tiny, const Rotor<Scalar>& choice, const Scalar& sign,
                                const Boundary& boundary, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar square = from.cosine * from.cosine + from.sine * from.sine;
  const Scalar gap = high - low;
  const Mask<Scalar> is_free = square <= tiny;
  Branch<Scalar> regular = branch;
  const Rotor<Scalar> turn = circle_from(low, high, Scalar(Scalar(1) / (low + high)), sign, boundary,
                                         nearly_free(square, low, high, tiny, boundary), regular);
  const Scalar scale = Scalar(1) / sqrt(select(is_free, Scalar(1), square));
  const Rotor<Scalar> found = turn * Rotor<Scalar>{from.cosine * scale, from.sine * scale};
  if (!any(is_free)) {
    branch = regular;
    return found;
  }
  branch.take(is_free, gap * gap <= Scalar(boundary.gap) * tiny, regular);
  return {select(is_free, Scalar(sign * choice.cosine), found.cosine),
          select(is_free, Scalar(sign * choice.sine), found.sine)};
}

/// The angle ±φ from a direction v = (x, y) that the pose gives, where one of both values is known without a
/// root: `straight`, of length one. The other is its mirror image about v. Squares of lengths: `arm_square`,
/// of the circle's radius. Where |v|² is below `tiny` the angle is free.
///
/// With φ the angle between v and `straight`, sin² φ / 4 is the share of the range's nearer end that
/// `circle_angle` has, next to the ends: both values meet where it vanishes.
template <typename Scalar>
Rotor<Scalar> folding_circle_angle(const Rotor<Scalar>& straight, const Rotor<Scalar>& from,
                                   const Scalar& arm_square, const Scalar& tiny, const Rotor<Scalar>& choice,
                                   const Scalar& sign, const Boundary& boundary, Branch<Scalar>& branch) {
  const Scalar square = from.cosine * from.cosine + from.sine * from.sine;
  const Mask<Scalar> is_free = square <= tiny;
  const Scalar along = from.cosine * straight.cosine + from.sine * straight.sine;
  const Scalar across = from.cosine * straight.sine - from.sine * straight.cosine;
  const Scalar across_square = across * across;
  const Scalar scale = Scalar(1) / select(is_free, Scalar(1), square);
  // The square of the nearer end, radius across²/|v|, against noise, as `nearly_free` has it.
  const Scalar end_square = arm_square * across_square * (across_square * scale);
  const Mask<Scalar> is_near =
      (square <= Scalar(boundary.near) * tiny) | (end_square <= Scalar(tolerance::magnified_end) * tiny);
  Branch<Scalar> regular = branch;
  admit(Scalar(Scalar(0.25) * across_square * scale), limits_of<Scalar>(boundary), is_near, regular);
  const Rotor<Scalar> mirrored{(from.cosine * along + from.sine * across) * scale,
                               (from.sine * along - from.cosine * across) * scale};
  const Mask<Scalar> is_straight = sign * across >= Scalar(0);
  const Rotor<Scalar> found{select(is_straight, straight.cosine, mirrored.cosine),
                            select(is_straight, straight.sine, mirrored.sine)};
  if (!any(is_free)) {
    branch = regular;
    return found;
  }
  branch.take(is_free, Mask<Scalar>(true), regular);
  return {select(is_free, Scalar(sign * choice.cosine), found.cosine),
          select(is_free, Scalar(sign * choice.sine), found.sine)};
}

/// The angle ±φ from a direction v = (x, y) that the pose gives, with v·u = rhs for the unit vector u: sin φ
/// |v| is the root of |v|² - rhs², known as the product low * high of two lengths, and so exact where the
/// difference would not be. Where |v|² is below `tiny` the angle is free if rhs is as small.
template <typename Scalar>
Rotor<Scalar> factored_line_angle(const Rotor<Scalar>& v, const Scalar& rhs, const Scalar& low,
                                  const Scalar& high, const Scalar& tiny, const Rotor<Scalar>& choice,
                                  const Scalar& sign, const Boundary& boundary, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar square = v.cosine * v.cosine + v.sine * v.sine;
  const Mask<Scalar> is_free = square <= tiny;
  const Scalar range = low + high;
  const Scalar scale = Scalar(1) / range;
  const Scalar low_share = low * scale;
  const Scalar high_share = high * scale;
  Branch<Scalar> regular = branch;
  admit(smaller(low_share, high_share), limits_of<Scalar>(boundary),
        nearly_free(square, low, high, tiny, boundary), regular);
  branch.take(is_free, rhs * rhs <= Scalar(boundary.gap) * tiny, regular);
  const Scalar least(boundary.floor);
  const Scalar height =
      sign * magnitude(range) * sqrt(Scalar(larger(low_share, least) * larger(high_share, least)));
  const Scalar length_square = rhs * rhs + height * height;
  // If all three vanish but for rounding, Newton's steps may begin with any direction.
  const Mask<Scalar> is_nothing = length_square == Scalar(0);
  const Scalar length = sqrt(select(is_nothing, Scalar(1), length_square));
  const Scalar unit = Scalar(1) / (length * sqrt(select(is_free, Scalar(1), square)));
  const Rotor<Scalar> found = Rotor<Scalar>{select(is_nothing, unit, Scalar(rhs * unit)), height * unit} * v;
  return {select(is_free, Scalar(sign * choice.cosine), found.cosine),
          select(is_free, Scalar(sign * choice.sine), found.sine)};
}

/// Returns `choice`, or a direction near it, among the directions u with inner <= |point + u offset|² <=
/// outer (u turns the offset): a free angle that keeps the joints after it in reach. It avoids the very end
/// of their reach, where they would be singular, too. Without any such direction, it is the least wrong one.
/// Such directions are one range or two, mirror images; `Boundary::opposite` asks for the other one.
template <typename Scalar>
Rotor<Scalar> reachable_direction(const Rotor<Scalar>& point, const Rotor<Scalar>& offset,
                                  const Scalar& inner, const Scalar& outer, const Rotor<Scalar>& choice,
                                  const Boundary& boundary = {}) {
  using std::sqrt;
  const Rotor<Scalar> both = inverse(point) * offset;
  const Scalar square = both.cosine * both.cosine + both.sine * both.sine;
  const Mask<Scalar> is_round = square == Scalar(0);
  const Scalar length = sqrt(select(is_round, Scalar(1), square));
  const Rotor<Scalar> along{select(is_round, Scalar(1), Scalar(both.cosine / length)),
                            select(is_round, Scalar(0), Scalar(both.sine / length))};
  const Rotor<Scalar> now = choice * along;
  const Scalar sum = point.cosine * point.cosine + point.sine * point.sine + offset.cosine * offset.cosine +
                     offset.sine * offset.sine;
  const Scalar least = (inner - sum) / (Scalar(2) * length);
  const Scalar most = (outer - sum) / (Scalar(2) * length);
  const Scalar low = larger(least, Scalar(-1));
  const Scalar high = smaller(most, Scalar(1));
  const Scalar inside = not_negative(Scalar(high - low)) / Scalar(16);
  const Scalar above = select(now.cosine < low, Scalar(low + inside), now.cosine);
  const Scalar within = select(above > high, Scalar(high - inside), above);
  const Scalar cosine = smaller(larger(within, Scalar(-1)), Scalar(1));
  Scalar side = now.sine;
  Mask<Scalar> stays = (cosine == now.cosine) | is_round;
  if constexpr (!leaves_singular_poses<Scalar>) {
    if (boundary.opposite) {
      const Mask<Scalar> crosses = (least > Scalar(-1)) & (most < Scalar(1)) & !is_round;
      side = negated<Scalar>(crosses, side);
      stays = stays & !crosses;
    }
  }
  const Rotor<Scalar> moved{
      cosine, with_sign(sqrt(not_negative(Scalar((Scalar(1) - cosine) * (Scalar(1) + cosine)))), side)};
  const Rotor<Scalar> found = moved * inverse(along);
  return {select(stays, choice.cosine, found.cosine), select(stays, choice.sine, found.sine)};
}

/// The direction of v, a product of two vectors that are at most unit vectors and vanish together: then it is
/// free. What is left of vectors of 1e-5, next to a double root that carries half the digits, may be noise.
template <typename Scalar>
Rotor<Scalar> chosen_direction(const Rotor<Scalar>& v, const Rotor<Scalar>& choice, const Boundary& boundary,
                               Branch<Scalar>& branch) {
  const Scalar noise = Scalar(16) * epsilon<Scalar>();
  const Scalar little(tolerance::product_at_double_root);
  const Scalar square = v.cosine * v.cosine + v.sine * v.sine;
  branch.doubt(square <= little);
  return direction(v, boundary.choose ? little : Scalar(noise * noise * noise * noise), choice, branch);
}

/// Noise in v, a product of two vectors that vanish together if an earlier equation has a double root. Such a
/// root carries half the digits, so a pass that chooses takes more of v for noise. `tiny`: the fourth power
/// of what is noise for sure.
template <typename Scalar>
Scalar tiny_at_double_root(const Rotor<Scalar>& v, const Scalar& tiny, const Boundary& boundary,
                           Branch<Scalar>& branch) {
  const Scalar little = Scalar(tolerance::noise_at_double_root) * tiny;
  branch.doubt(v.cosine * v.cosine + v.sine * v.sine <= little);
  return boundary.choose ? little : tiny;
}

/// ±sqrt(square), where `square` = r² - m² may be negative by rounding, `scale` = m² telling how much that
/// is. With scale 0 it is a sum of squares, and noise is what lies below `tiny`, the square of a length.
template <typename Scalar>
Scalar signed_root(const Scalar& square, const Scalar& scale, const Scalar& tiny, const Scalar& sign,
                   const Boundary& boundary, Branch<Scalar>& branch) {
  using std::sqrt;
  const Mask<Scalar> close = magnitude(square) <= Scalar(boundary.near) * tiny;
  admit(square, limits_in_range(boundary, larger(scale, magnitude(square))), close, branch);
  return sign * sqrt(larger(square, Scalar(boundary.floor) * (scale + tiny)));
}

/// Requires an equation that the pose must satisfy for the arm to reach it at all (a planar arm's plane,
/// say).
template <typename Scalar>
void require_zero(const Scalar& residual, const Scalar& scale, const Scalar& tolerance,
                  Branch<Scalar>& branch) {
  branch.exists = branch.exists & (residual <= tolerance * scale) & (residual >= -tolerance * scale);
}

/// True if a `circle_angle` that comes before all other branches, or behind one of two signs, has no solution
/// whatever the sign: its share low / (low + high) is `middle` ± √`swing`. Told without a root. If the swing
/// is rounding its root carries half the digits: poses that are out of reach by less are left to the
/// branches.
template <typename Scalar>
[[gnu::always_inline]] inline bool is_out_of_range(const Scalar& middle, const Scalar& swing,
                                                   const Boundary& boundary) {
  const Scalar off = magnitude(Scalar(middle - Scalar(0.5)));
  const Scalar to_end = Scalar(0.5 + tolerance::swing_at_double_root) + Scalar(boundary.beyond);
  const Scalar same_end = off - to_end;
  const Scalar both_ends = off + to_end;
  return (same_end > Scalar(0) && same_end * same_end > swing) || both_ends * both_ends < swing;
}

}  // namespace qvgen::inverse
