// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/angles.h>

namespace qvgen::inverse {

/// The three angles of a spherical wrist, first + last and first - last being what the equations give.
template <typename Scalar>
struct WristAngles {
  Scalar first, middle, last;
};

/// Below this share of the whole length of U11 and U12 an argument is noise: the angle is free, and the middle angle taken as
/// exactly singular turns the orientation by no more than twice this, 8e-15. Where first and last axis are in line rounding
/// alone leaves half an epsilon in the median and stays below this on 95 to 100 % of the poses; the rest are poses whose
/// position is ill-conditioned: there the middle angle is as regular as the rounded pose says.
template <typename Scalar>
Scalar wrist_noise() {
  return Scalar(18) * epsilon<Scalar>();
}

/// Which of two complex numbers, given by their squares, is noise next to the other: its argument is free.
template <typename Scalar>
struct Vanishing {
  Mask<Scalar> u, v;
};

template <typename Scalar>
Vanishing<Scalar> vanishing(const Scalar& u_square, const Scalar& v_square) {
  const Scalar noise = wrist_noise<Scalar>() * wrist_noise<Scalar>() * (u_square + v_square);
  return {u_square <= noise, v_square <= noise};
}

/// Arguments of the two complex numbers; one that vanishes gets what makes their sum equal to `first`.
template <typename Scalar>
void arguments(const Rotor<Scalar>& u, const Rotor<Scalar>& v, const Vanishing<Scalar>& is_free, const Scalar& first,
               Scalar& u_argument, Scalar& v_argument, Branch<Scalar>& branch) {
  const Scalar u_angle = angle(u);
  const Scalar v_angle = angle(v);
  u_argument = select(is_free.u, Scalar(first - v_angle), u_angle);
  v_argument = select(is_free.v, Scalar(first - u_angle), v_angle);
  branch.continuum = branch.continuum | (branch.exists & (is_free.u | is_free.v));
}

/// Wrist with right angles between neighbouring axes: the thesis's Euler wrist in half-angle form.
///
/// u, v: the entries of the wrist's SU(2) matrix, of any length, turned so that first = arg u + arg v, last = arg u - arg v and
/// middle = 2 atan2(|v|, |u|), in [0, pi] (with `swapped` the other way round). The second branch is (first + pi, -middle, last + pi). Accurate at
/// middle = 0 and pi, where v or u vanishes: there first - last or first + last is free.
template <typename Scalar>
WristAngles<Scalar> right_wrist(const Rotor<Scalar>& u, const Rotor<Scalar>& v, bool swapped, const Scalar& seed,
                                const Scalar& pi, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar u_square = u.cosine * u.cosine + u.sine * u.sine;
  const Scalar v_square = v.cosine * v.cosine + v.sine * v.sine;
  const Vanishing<Scalar> is_free = vanishing(u_square, v_square);
  // What is noise is zero to the middle angle too, or the chosen first angle would turn about a slanting axis.
  const Scalar u_length = select(is_free.u, Scalar(0), sqrt(u_square));
  const Scalar v_length = select(is_free.v, Scalar(0), sqrt(v_square));
  Scalar u_argument;
  Scalar v_argument;
  arguments(u, v, is_free, seed, u_argument, v_argument, branch);
  return {wrapped(Scalar(u_argument + v_argument), pi), Scalar(2) * (swapped ? acute_arctangent(u_length, v_length) : acute_arctangent(v_length, u_length)),
          wrapped(Scalar(u_argument - v_argument), pi)};
}

/// A wrist's angles as cosines and sines, for arms that go on from there.
template <typename Scalar>
struct WristTurns {
  Rotor<Scalar> first, middle, last;
};

/// Both branches of `right_wrist`, by sign, without any arctangent.
template <typename Scalar>
WristTurns<Scalar> right_wrist_turns(const Rotor<Scalar>& u, const Rotor<Scalar>& v, bool swapped,
                                     const Rotor<Scalar>& choice, const Scalar& sign, const Boundary& boundary,
                                     Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar u_square = u.cosine * u.cosine + u.sine * u.sine;
  const Scalar v_square = v.cosine * v.cosine + v.sine * v.sine;
  const Scalar sum = u_square + v_square;
  const Scalar noise = wrist_noise<Scalar>() * wrist_noise<Scalar>() * sum;
  const Vanishing<Scalar> is_free = vanishing(u_square, v_square);
  const Scalar product = select(is_free.u | is_free.v, Scalar(0), Scalar(Scalar(2) * sqrt(Scalar(u_square * v_square))));
  const Scalar gap = swapped ? Scalar(v_square - u_square) : Scalar(u_square - v_square);
  // One of the two vanishes at most: what it leaves free makes the first angle the choice.
  const Rotor<Scalar> v_or_choice = direction(v, noise, choice, branch);
  const Rotor<Scalar> along_u = direction(u, noise, Rotor<Scalar>(choice * inverse(v_or_choice)), branch);
  const Rotor<Scalar> rest = choice * inverse(along_u);
  // Nearly free: what the angles are is for the joints between to say, and those may be at the end of their reach.
  const Scalar little = Scalar(boundary.near) * noise;
  const Mask<Scalar> nearly_free = ((u_square <= little) & (u_square > noise)) | ((v_square <= little) & (v_square > noise));
  branch.doubtful = branch.doubtful | (branch.exists & nearly_free);
  const Rotor<Scalar> along_v{select(is_free.v, rest.cosine, v_or_choice.cosine), select(is_free.v, rest.sine, v_or_choice.sine)};
  const Rotor<Scalar> first = along_u * along_v;
  const Rotor<Scalar> last = along_u * inverse(along_v);
  const Scalar scale = Scalar(1) / sum;
  return {{sign * first.cosine, sign * first.sine},
          {gap * scale, sign * product * scale},
          {sign * last.cosine, sign * last.sine}};
}

/// Constants of a wrist with any angles α, α' between its axes: cosine and sine of (α+α')/2 and (α-α')/2,
/// product = sin α sin α', and the angle between the normals. Exact zeros make the limits exact.
template <typename Scalar>
struct WristShape {
  Scalar cosine_sum, sine_sum, cosine_difference, sine_difference, product;
};

/// What both forms of an oblique wrist start from: cosine and sine of half the middle angle θ >= 0, and two complex numbers
/// with first = arg z1 + arg z2, last = arg z1 - arg z2.
template <typename Scalar>
struct ObliqueHalf {
  Scalar cosine, sine;
  Rotor<Scalar> z1, z2;
  Vanishing<Scalar> is_free;
};

/// Wrist with oblique axes, U = F4ᵀ R F6: |U11|² = cos²((α+α')/2) + sin α sin α' sin²(θ/2) and so on, θ the middle
/// angle from the normals' coincidence.
template <typename Scalar>
ObliqueHalf<Scalar> oblique_half(const Rotor<Scalar>& u11, const Rotor<Scalar>& u12, const WristShape<Scalar>& shape,
                                 const Scalar& sign, const Scalar& tolerance, Branch<Scalar>& branch) {
  using std::sqrt;
  const Scalar zero(0);
  const Scalar u11_square = u11.cosine * u11.cosine + u11.sine * u11.sine;
  const Scalar u12_square = u12.cosine * u12.cosine + u12.sine * u12.sine;
  const Scalar sine2 = (u11_square - shape.cosine_sum * shape.cosine_sum) / shape.product;
  const Scalar cosine2 = (u12_square - shape.sine_difference * shape.sine_difference) / shape.product;
  const Vanishing<Scalar> is_free = vanishing(u11_square, u12_square);
  const Scalar margin = smaller(sine2, cosine2);
  // Where the first or last angle is free the middle one is 0 or pi, which with a right sum or difference is no double root.
  const Mask<Scalar> right_sum = shape.cosine_sum == zero;
  const Mask<Scalar> right_difference = shape.sine_difference == zero;
  const Mask<Scalar> sine_twin = ((sine2 <= merge_share<Scalar>()) & (!right_sum)) | is_free.u;
  const Mask<Scalar> cosine_twin = ((cosine2 <= merge_share<Scalar>()) & (!right_difference)) | is_free.v;
  branch.exists = branch.exists & (margin >= -tolerance) & !((sine_twin | cosine_twin) & (sign < zero));
  const Scalar s = select(sine_twin, zero, sqrt(not_negative(sine2)));
  const Scalar c = select(cosine_twin, zero, sqrt(not_negative(cosine2)));
  // z1 = M11 conj(U11), z2 = M12 conj(U12); at a right sum or difference the limit direction is kept.
  const Scalar m11_real = shape.cosine_sum * c;
  const Scalar m11_imaginary = -sign * select(right_sum, Scalar(1), Scalar(shape.cosine_difference * s));
  const Scalar m12_real = -sign * (shape.sine_difference * s);
  const Scalar m12_imaginary = -select(right_difference, Scalar(1), Scalar(shape.sine_sum * c));
  return {c, s, Rotor<Scalar>{m11_real, m11_imaginary} * inverse(u11), Rotor<Scalar>{m12_real, m12_imaginary} * inverse(u12), is_free};
}

template <typename Scalar>
WristAngles<Scalar> oblique_wrist(const Rotor<Scalar>& u11, const Rotor<Scalar>& u12, const WristShape<Scalar>& shape,
                                  const Scalar& sign, const Scalar& seed, const Scalar& tolerance, const Scalar& pi,
                                  Branch<Scalar>& branch) {
  const ObliqueHalf<Scalar> half = oblique_half(u11, u12, shape, sign, tolerance, branch);
  Scalar first_argument;
  Scalar second_argument;
  arguments(half.z1, half.z2, half.is_free, seed, first_argument, second_argument, branch);
  return {wrapped(Scalar(first_argument + second_argument), pi), Scalar(2) * sign * acute_arctangent(half.sine, half.cosine),
          wrapped(Scalar(first_argument - second_argument), pi)};
}

/// The same as cosines and sines, `delta` the angle between the normals.
template <typename Scalar>
WristTurns<Scalar> oblique_wrist_turns(const Rotor<Scalar>& u11, const Rotor<Scalar>& u12, const WristShape<Scalar>& shape,
                                       const Rotor<Scalar>& delta, const Rotor<Scalar>& choice, const Scalar& sign,
                                       const Scalar& tolerance, Branch<Scalar>& branch) {
  using std::sqrt;
  const ObliqueHalf<Scalar> half = oblique_half(u11, u12, shape, sign, tolerance, branch);
  const Mask<Scalar>& u_free = half.is_free.u;
  const Mask<Scalar>& v_free = half.is_free.v;
  branch.continuum = branch.continuum | (branch.exists & (u_free | v_free));
  const auto unit = [](const Rotor<Scalar>& z, const Mask<Scalar>& is_free) {
    const Scalar square = z.cosine * z.cosine + z.sine * z.sine;
    return Scalar(Scalar(1) / sqrt(select(is_free, Scalar(1), square))) * z;
  };
  // One of the two vanishes at most: what it leaves free makes the first angle the choice.
  const Rotor<Scalar> along_1 = unit(half.z1, u_free);
  const Rotor<Scalar> along_2 = unit(half.z2, v_free);
  const Rotor<Scalar> rest_1 = choice * inverse(along_2);
  const Rotor<Scalar> rest_2 = choice * inverse(along_1);
  const Rotor<Scalar> z1{select(u_free, rest_1.cosine, along_1.cosine), select(u_free, rest_1.sine, along_1.sine)};
  const Rotor<Scalar> z2{select(v_free, rest_2.cosine, along_2.cosine), select(v_free, rest_2.sine, along_2.sine)};
  const Scalar scale = Scalar(1) / (half.cosine * half.cosine + half.sine * half.sine);
  const Rotor<Scalar> middle{(half.cosine - half.sine) * (half.cosine + half.sine) * scale,
                             sign * (Scalar(2) * half.cosine * half.sine * scale)};
  return {z1 * z2, middle * inverse(delta), z1 * inverse(z2)};
}

}  // namespace qvgen::inverse
