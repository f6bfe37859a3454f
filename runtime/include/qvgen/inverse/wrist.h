// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/roots.h>

namespace qvgen::inverse {

/// The three angles of a spherical wrist, first + last and first - last being what the equations give.
template <typename Scalar>
struct WristAngles {
  Scalar first, middle, last;
};

/// Below this share of the whole length of U11 and U12 an argument is noise: the angle is free, and the
/// middle angle taken as exactly singular turns the orientation by no more than twice this, 8e-15. Where
/// first and last axis are in line rounding alone leaves half an epsilon in the median and stays below this
/// on 95 to 100 % of the poses; the rest are poses whose position is ill-conditioned: there the middle angle
/// is as regular as the rounded pose says.
template <typename Scalar>
Scalar wrist_noise() {
  return Scalar(18) * epsilon<Scalar>();
}

/// Largest noise of a wrist behind an ill-conditioned arm, as a multiple of the square of `wrist_noise`: no
/// rounding leaves more, and turning by it is 4e-13 at most.
template <typename Scalar>
Scalar widest_wrist_noise() {
  return Scalar(1024);
}

/// Which of two complex numbers, given by their squares, is noise next to the other: its argument is free.
template <typename Scalar>
struct Vanishing {
  Mask<Scalar> u, v;
  Scalar noise;  ///< square below which it is
};

template <typename Scalar>
Vanishing<Scalar> vanishing(const Scalar& u_square, const Scalar& v_square) {
  const Scalar noise = wrist_noise<Scalar>() * wrist_noise<Scalar>() * (u_square + v_square);
  return {u_square <= noise, v_square <= noise, noise};
}

/// Says which vectors vanish at a wrist before further joints. If one is nearly free, the further joints
/// decide the angles: they may be at the end of their reach.
template <typename Scalar>
Vanishing<Scalar> vanishing_before_joints(const Scalar& u_square, const Scalar& v_square,
                                          const Boundary& boundary, Branch<Scalar>& branch) {
  const Scalar noise = wrist_noise<Scalar>() * wrist_noise<Scalar>() * (u_square + v_square);
  const Scalar little = Scalar(boundary.near) * noise;
  // Narrower than where doubt begins: Newton steps have to make good what the choice turns away. Behind a
  // double root, which carries half the digits, more may be noise.
  const Scalar choosable =
      select(branch.unsure | Mask<Scalar>(boundary.wide), Scalar(tolerance::choosable_behind_double_root),
             Scalar(tolerance::choosable));
  const Scalar doubtful = boundary.wide ? little : Scalar(choosable * noise);
  branch.unsure = branch.unsure | (u_square <= little) | (v_square <= little);
  branch.doubt((u_square <= doubtful) | (v_square <= doubtful));
  branch.continuum = branch.continuum | (branch.exists & ((u_square <= noise) | (v_square <= noise)));
  const Scalar least = boundary.choose ? Scalar(choosable * noise) : noise;
  return {u_square <= least, v_square <= least, noise};
}

/// How far the argument of the smaller number, whose square is `least`, is to be turned: next to where it is
/// free it may be rounding's, and then the first angle is to come as near to the choice as that allows, or to
/// the opposite direction, which is the other branch's. Zero elsewhere.
template <typename Scalar>
Scalar turn_to_choice(const Scalar& first, const Scalar& choice, const Scalar& least, const Scalar& noise,
                      const Scalar& pi) {
  using std::sqrt;
  const Mask<Scalar> blurred = is_blurred(least, noise);
  const Scalar quarter = Scalar(0.5) * pi;
  const Scalar most =
      quarter *
      sqrt(Scalar(widest_wrist_noise<Scalar>() * noise / select(blurred, larger(least, noise), Scalar(1))));
  const Scalar off = wrapped(Scalar(choice - first), pi);
  const Scalar nearer = off + select(off > quarter, Scalar(-pi), select(off <= -quarter, pi, Scalar(0)));
  return select(blurred, smaller(larger(nearer, Scalar(-most)), most), Scalar(0));
}

/// Arguments of the two complex numbers; one that vanishes gets what makes their sum equal to `first`.
template <typename Scalar>
void arguments(const Rotor<Scalar>& u, const Rotor<Scalar>& v, const Scalar& u_square, const Scalar& v_square,
               const Vanishing<Scalar>& is_free, const Scalar& first, const Scalar& pi, Scalar& u_argument,
               Scalar& v_argument, Branch<Scalar>& branch) {
  const Scalar u_angle = angle(u);
  const Scalar v_angle = angle(v);
  const Scalar least = smaller(u_square, v_square);
  const Mask<Scalar> blurred = is_blurred(least, is_free.noise);
  if constexpr (leaves_singular_poses<Scalar>) {
    branch.doubt(blurred);
    u_argument = u_angle;
    v_argument = v_angle;
    return;
  }
  u_argument = select(is_free.u, Scalar(first - v_angle), u_angle);
  v_argument = select(is_free.v, Scalar(first - u_angle), v_angle);
  if (!any(blurred)) return;
  branch.doubt(blurred & is_nobodys(first));
  const Scalar turn =
      select(is_free.u | is_free.v, Scalar(0),
             turn_to_choice(wrapped(Scalar(u_angle + v_angle), pi), first, least, is_free.noise, pi));
  u_argument = u_argument + select(u_square < v_square, turn, Scalar(0));
  v_argument = v_argument + select(u_square < v_square, Scalar(0), turn);
  branch.continuum =
      branch.continuum | (branch.exists & is_marked(least, widest_wrist_noise<Scalar>(), is_free.noise));
}

/// A wrist's two branches: (first, middle, last) and (first + pi, -middle, last + pi).
template <typename Scalar>
struct WristBranches {
  WristAngles<Scalar> one, other;
};

template <typename Scalar>
WristBranches<Scalar> wrist_branches(const Opposites<Scalar>& first, const Scalar& middle,
                                     const Opposites<Scalar>& last, const Scalar& pi) {
  return {{first.one, middle, last.one}, {first.other, negative(middle, pi), last.other}};
}

/// Returns an angle and the one of the opposite direction, or `other` where nothing is free.
template <typename Scalar>
Opposites<Scalar> aligned_opposites(const Scalar& angle, const Scalar& other, const Mask<Scalar>& any_free,
                                    const Scalar& pi) {
  return {angle, select(any_free, opposite(angle, pi), other)};
}

/// Sets the branches where u or v vanishes: the first angle is the choice, the last follows from the other
/// number, the middle angle is 0 or pi. Other branches stay unchanged.
template <typename Scalar>
WristBranches<Scalar> aligned_wrist(const WristBranches<Scalar>& regular, const Rotor<Scalar>& u,
                                    const Rotor<Scalar>& v, const Vanishing<Scalar>& is_free, bool swapped,
                                    const Scalar& choice, const Scalar& pi) {
  const Mask<Scalar> any_free = is_free.u | is_free.v;
  const Scalar half = arctangent(select(is_free.u, v.sine, u.sine), select(is_free.u, v.cosine, u.cosine));
  const Scalar rest = Scalar(2) * half - choice;
  const Scalar first = select(any_free, wrapped(choice, pi), regular.one.first);
  const Scalar last = select(any_free, wrapped(select(is_free.u, Scalar(-rest), rest), pi), regular.one.last);
  const Scalar straight = select(swapped ? is_free.u : is_free.v, Scalar(0), pi);
  return wrist_branches(aligned_opposites(first, regular.other.first, any_free, pi),
                        select(any_free, straight, regular.one.middle),
                        aligned_opposites(last, regular.other.last, any_free, pi), pi);
}

/// Turns an angle and the one of the opposite direction; they stay as they are where that is by zero.
template <typename Scalar>
Opposites<Scalar> turned_opposites(const Scalar& one, const Scalar& other, const Scalar& by,
                                   const Scalar& pi) {
  const Scalar there = wrapped(Scalar(one + by), pi);
  const Mask<Scalar> stays = by == Scalar(0);
  return {select(stays, one, there), select(stays, other, opposite(there, pi))};
}

/// The argument of u, or else of v, turned; angles stay as they are where that is by zero.
template <typename Scalar>
WristBranches<Scalar> turned_wrist(const WristBranches<Scalar>& regular, const Scalar& turn,
                                   const Mask<Scalar>& is_u, const Scalar& pi) {
  const Scalar other_turn = select(is_u, turn, Scalar(-turn));
  return wrist_branches(turned_opposites(regular.one.first, regular.other.first, turn, pi),
                        regular.one.middle,
                        turned_opposites(regular.one.last, regular.other.last, other_turn, pi), pi);
}

/// Wrist with right angles between neighbouring axes: the thesis's Euler wrist in half-angle form.
///
/// u, v: the entries of the wrist's SU(2) matrix, of any length, turned so that first = arg u + arg v, last =
/// arg u - arg v and middle = 2 atan2(|v|, |u|), in [0, pi] (with `swapped` the other way round). Accurate at
/// middle = 0 and pi, where v or u vanishes: there first - last or first + last is free.
template <typename Scalar>
WristBranches<Scalar> right_wrist(const Rotor<Scalar>& u, const Rotor<Scalar>& v, bool swapped,
                                  const Scalar& seed, const Scalar& pi, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar u_square = u.cosine * u.cosine + u.sine * u.sine;
  const Scalar v_square = v.cosine * v.cosine + v.sine * v.sine;
  // |u v|, of which all three angles' tangents are made: sums of arguments are the arguments of products.
  const Scalar length = sqrt(Scalar(u_square * v_square));
  const Scalar gap = swapped ? Scalar(v_square - u_square) : Scalar(u_square - v_square);
  const Scalar sum = u_square + v_square;
  const Scalar cc = u.cosine * v.cosine;
  const Scalar ss = u.sine * v.sine;
  const Scalar cs = u.cosine * v.sine;
  const Scalar sc = u.sine * v.cosine;
  const Opposites<Scalar> first = output_angles(Rotor<Scalar>{cc - ss, sc + cs}, length, pi);
  const Opposites<Scalar> last = output_angles(Rotor<Scalar>{cc + ss, sc - cs}, length, pi);
  const Scalar middle = arctangent(length, Scalar(Scalar(0.5) * gap), Scalar(Scalar(0.5) * sum));
  const WristBranches<Scalar> regular = wrist_branches(first, middle, last, pi);
  const Vanishing<Scalar> is_free = vanishing(u_square, v_square);
  const Scalar least = smaller(u_square, v_square);
  const Mask<Scalar> blurred = is_blurred(least, is_free.noise);
  if constexpr (leaves_singular_poses<Scalar>) {
    branch.doubt(blurred);
    return regular;
  }
  if (!any(blurred)) return regular;
  branch.doubt(blurred & is_nobodys(seed));
  branch.continuum =
      branch.continuum | (branch.exists & is_marked(least, widest_wrist_noise<Scalar>(), is_free.noise));
  const Scalar turn = turn_to_choice(regular.one.first, seed, least, is_free.noise, pi);
  return aligned_wrist(turned_wrist(regular, turn, u_square < v_square, pi), u, v, is_free, swapped, seed,
                       pi);
}

/// A wrist's angles as cosines and sines, for arms that go on from there.
template <typename Scalar>
struct WristTurns {
  Rotor<Scalar> first, middle, last;
};

template <typename Scalar>
struct RotorPair {
  Rotor<Scalar> u, v;
};

template <typename Scalar>
Rotor<Scalar> either_rotor(const Mask<Scalar>& condition, const Rotor<Scalar>& yes, const Rotor<Scalar>& no) {
  return {select(condition, yes.cosine, no.cosine), select(condition, yes.sine, no.sine)};
}

/// Returns a number's direction, or the number itself if that is free.
template <typename Scalar>
Rotor<Scalar> unit_of(const Rotor<Scalar>& z, const Mask<Scalar>& is_free) {
  using std::sqrt;
  const Scalar square = z.cosine * z.cosine + z.sine * z.sine;
  return Scalar(Scalar(1) / sqrt(select(is_free, Scalar(1), square))) * z;
}

/// The directions of the two numbers. One of them vanishes at most: what it leaves free makes the first angle
/// the choice.
template <typename Scalar>
RotorPair<Scalar> turns(const RotorPair<Scalar>& z, const Vanishing<Scalar>& is_free,
                        const Rotor<Scalar>& choice) {
  const Rotor<Scalar> along_u = unit_of(z.u, is_free.u);
  const Rotor<Scalar> along_v = unit_of(z.v, is_free.v);
  return {either_rotor<Scalar>(is_free.u, choice * inverse(along_v), along_u),
          either_rotor<Scalar>(is_free.v, choice * inverse(along_u), along_v)};
}

/// Both branches of `right_wrist`, by sign, without any arctangent.
template <typename Scalar>
WristTurns<Scalar> right_wrist_turns(const Rotor<Scalar>& u, const Rotor<Scalar>& v, bool swapped,
                                     const Rotor<Scalar>& choice, const Scalar& sign,
                                     const Boundary& boundary, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar u_square = u.cosine * u.cosine + u.sine * u.sine;
  const Scalar v_square = v.cosine * v.cosine + v.sine * v.sine;
  const Scalar sum = u_square + v_square;
  const Vanishing<Scalar> is_free = vanishing_before_joints(u_square, v_square, boundary, branch);
  const Scalar both =
      select(is_free.u | is_free.v, Scalar(0), Scalar(Scalar(2) * sqrt(Scalar(u_square * v_square))));
  const Scalar gap = swapped ? Scalar(v_square - u_square) : Scalar(u_square - v_square);
  const RotorPair<Scalar> z{u, v};
  const RotorPair<Scalar> along = turns(z, is_free, choice);
  const Rotor<Scalar> first = along.u * along.v;
  const Rotor<Scalar> last = along.u * inverse(along.v);
  const Scalar scale = Scalar(1) / sum;
  return {{sign * first.cosine, sign * first.sine},
          {gap * scale, sign * both * scale},
          {sign * last.cosine, sign * last.sine}};
}

/// Constants of a wrist with any angles α, α' between its axes: cosine and sine of (α+α')/2 and (α-α')/2,
/// product = sin α sin α', and the angle between the normals. Exact zeros make the limits exact.
template <typename Scalar>
struct WristShape {
  Scalar cosine_sum, sine_sum, cosine_difference, sine_difference, product;
};

/// Squares of sine and cosine of half the middle angle θ of a wrist with oblique axes, U = F4ᵀ R F6, θ
/// counted from the normals' coincidence: |U11|² = cos²((α+α')/2) + sin α sin α' sin²(θ/2), and so on.
template <typename Scalar>
struct ObliqueSquares {
  Scalar u11, u12;
  Scalar sine, cosine;
  /// Then sine or cosine vanishes where an angle is free, else at a double root.
  Mask<Scalar> right_sum, right_difference;
};

template <typename Scalar>
ObliqueSquares<Scalar> oblique_squares(const Rotor<Scalar>& first, const Rotor<Scalar>& second,
                                       const WristShape<Scalar>& shape) {
  const Scalar u11 = first.cosine * first.cosine + first.sine * first.sine;
  const Scalar u12 = second.cosine * second.cosine + second.sine * second.sine;
  return {u11,
          u12,
          (u11 - shape.cosine_sum * shape.cosine_sum) / shape.product,
          (u12 - shape.sine_difference * shape.sine_difference) / shape.product,
          shape.cosine_sum == Scalar(0),
          shape.sine_difference == Scalar(0)};
}

/// Two complex numbers from sine and cosine of half the middle angle: first = arg z1 + arg z2, last = arg z1
/// - arg z2. z1 = M11 conj(U11), z2 = M12 conj(U12); at a right sum or difference the limit direction is
/// kept.
template <typename Scalar>
RotorPair<Scalar> oblique_products(const Rotor<Scalar>& u11, const Rotor<Scalar>& u12,
                                   const WristShape<Scalar>& shape, const ObliqueSquares<Scalar>& square,
                                   const Scalar& s, const Scalar& c, const Scalar& sign) {
  const Scalar m11_real = shape.cosine_sum * c;
  const Scalar m11_imaginary =
      -sign * select(square.right_sum, Scalar(1), Scalar(shape.cosine_difference * s));
  const Scalar m12_real = -sign * (shape.sine_difference * s);
  const Scalar m12_imaginary = -select(square.right_difference, Scalar(1), Scalar(shape.sine_sum * c));
  return {Rotor<Scalar>{m11_real, m11_imaginary} * inverse(u11),
          Rotor<Scalar>{m12_real, m12_imaginary} * inverse(u12)};
}

/// Beyond the end of its range by less than `Boundary::fold` it is folded; by less than `Boundary::beyond`
/// doubtful.
template <typename Scalar>
WristAngles<Scalar> oblique_wrist(const Rotor<Scalar>& u11, const Rotor<Scalar>& u12,
                                  const WristShape<Scalar>& shape, const Scalar& sign, const Scalar& seed,
                                  const Boundary& boundary, const Scalar& pi, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar zero(0);
  const ObliqueSquares<Scalar> square = oblique_squares(u11, u12, shape);
  const Vanishing<Scalar> is_free = vanishing(square.u11, square.u12);
  const Scalar margin = smaller(square.sine, square.cosine);
  // If the first or last angle is free, the middle one is 0 or pi, which with a right sum or difference is no
  // double root.
  const Mask<Scalar> sine_twin = ((square.sine <= merge_share<Scalar>()) & (!square.right_sum)) | is_free.u;
  const Mask<Scalar> cosine_twin =
      ((square.cosine <= merge_share<Scalar>()) & (!square.right_difference)) | is_free.v;
  const Mask<Scalar> is_near = margin >= Scalar(-boundary.fold);
  branch.doubt((!is_near) & (margin > Scalar(-boundary.beyond)));
  branch.exists = branch.exists & is_near & !((sine_twin | cosine_twin) & (sign < zero));
  const Scalar s = select(sine_twin, zero, sqrt(not_negative(square.sine)));
  const Scalar c = select(cosine_twin, zero, sqrt(not_negative(square.cosine)));
  const RotorPair<Scalar> z = oblique_products(u11, u12, shape, square, s, c, sign);
  Scalar first_argument;
  Scalar second_argument;
  arguments(z.u, z.v, square.u11, square.u12, is_free, seed, pi, first_argument, second_argument, branch);
  return {wrapped(Scalar(first_argument + second_argument), pi), Scalar(2) * sign * acute_arctangent(s, c),
          wrapped(Scalar(first_argument - second_argument), pi)};
}

/// Returns sine or cosine of half the middle angle by its square, at least the floor's root where it folds.
template <typename Scalar>
Scalar half_angle_part(const Scalar& square, const Mask<Scalar>& is_right, const Mask<Scalar>& is_free,
                       const Boundary& boundary) {
  using std::sqrt;
  const Scalar least = select(is_right, Scalar(0), Scalar(boundary.floor));
  return select(is_free, Scalar(0), sqrt(larger(square, least)));
}

/// Returns the angles of an oblique wrist as cosines and sines, `delta` the angle between the normals.
template <typename Scalar>
WristTurns<Scalar> oblique_wrist_turns(const Rotor<Scalar>& u11, const Rotor<Scalar>& u12,
                                       const WristShape<Scalar>& shape, const Rotor<Scalar>& delta,
                                       const Rotor<Scalar>& choice, const Scalar& sign,
                                       const Boundary& boundary, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar one(1);
  const ObliqueSquares<Scalar> square = oblique_squares(u11, u12, shape);
  const Vanishing<Scalar> is_free = vanishing_before_joints(square.u11, square.u12, boundary, branch);
  const Scalar margin = smaller(select(square.right_sum, one, square.sine),
                                select(square.right_difference, one, square.cosine));
  admit(margin, limits_of<Scalar>(boundary), Mask<Scalar>(false), branch);
  const Scalar s = half_angle_part(square.sine, square.right_sum, is_free.u, boundary);
  const Scalar c = half_angle_part(square.cosine, square.right_difference, is_free.v, boundary);
  const RotorPair<Scalar> z = oblique_products(u11, u12, shape, square, s, c, sign);
  const RotorPair<Scalar> along = turns(z, is_free, choice);
  const Scalar scale = one / (c * c + s * s);
  const Rotor<Scalar> middle{(c - s) * (c + s) * scale, sign * (Scalar(2) * c * s * scale)};
  return {along.u * along.v, middle * inverse(delta), along.u * inverse(along.v)};
}

}  // namespace qvgen::inverse
