// SPDX-License-Identifier: MIT
#pragma once

// Tolerances near singular poses, each with its reason: the closed forms with their blocks, the quartic's and
// the elimination's careful forms take them from here. Rounding is 2e-16 of a number. Where two solutions
// meet it moves a root by its own root, about 1e-8: half the digits.

namespace qvgen::inverse::tolerance {

// Ends of the range of an equation, as shares of the range (`Boundary`).

/// Doubtful inside: so near to the end two roots differ by 3e-4, and steps that magnify rounding may swap
/// them.
inline constexpr double end_inside = 1e-7;
/// Doubtful outside: rounding of earlier steps puts an end no farther out.
inline constexpr double end_outside = 1e-10;
/// Shares of a range per share of the arm's size: no equation's range is smaller than a hundredth of the arm.
inline constexpr double range_per_size = 100;
/// Followed from the end in careful passes: farther out Newton's steps do not come back.
inline constexpr double end_careful = 1e-3;
/// Beyond every range: the end is taken wherever the equation leads.
inline constexpr double end_anywhere = 1e3;
/// Places as far apart as two roots 1e-10 from the end, from which steps lead to two solutions.
inline constexpr double end_apart = 1e-10;
/// A wrist is folded: half of the 1e-12 that no solution may miss its pose by.
inline constexpr double least_fold = 5e-13;

// Squares of directions, as multiples of the square that is noise for sure.

/// Rounding can be seen: the direction has lost half its digits.
inline constexpr double blurred = 1e16;
/// Nearly free: a digit more, for what earlier steps have magnified.
inline constexpr double nearly_free = 1e18;
/// Chosen in place of a wrist's angle behind a double root, which carries half the digits.
inline constexpr double choosable_behind_double_root = 1e14;
/// Chosen in place of a wrist's angle elsewhere: Newton's steps have to make good what the choice turns away.
inline constexpr double choosable = 1e5;
/// The nearer end of a range: earlier equations at their own ends magnify rounding to four digits.
inline constexpr double magnified_end = 1e8;
/// An equation of a free direction holds: eight times the noise.
inline constexpr double gap = 64;
/// An equation of a nearly free direction holds: half the digits.
inline constexpr double gap_careful = 64e14;
/// An equation of a stretched arm is not asked for.
inline constexpr double gap_anything = 1e40;

// Squares of directions made of unit vectors.

/// Nothing but a choice: a product of two vectors of 1e-5, beside a double root.
inline constexpr double product_at_double_root = 1e-20;
/// The fourth power of 1e-5 over noise (16 eps): the same product, as a multiple of what is noise for sure.
inline constexpr double noise_at_double_root = 6.3e37;
/// Two digits are lost.
inline constexpr double two_digits = 1e-4;
/// A slide's direction of 1e-12: the slide is as near to the choice as its equation lets it.
inline constexpr double loose_slide = 1e-24;
/// A discriminant may be rounding: two thousand times the noise of its coefficients, squared.
inline constexpr double noisy_discriminant = 4e6;
/// A divisor, or a length as a share of the size, with six digits: below it a quartic falls apart.
inline constexpr double lost_divisor = 1e-6;

// Newton's steps. Misses are squares, as shares of the squared size.

/// Entries of a Jacobian, and parts of unit vectors, that rounding leaves, in epsilons.
inline constexpr double noise = 64;
/// Misses by half the digits squared: steps are not damped.
inline constexpr double undamped = 1e-12;
/// Damping as a share of the miss: a tenth keeps the speed and tames what is nearly idle.
inline constexpr double damping = 1e-1;
/// Columns with less beyond the others are idle: at a double root rounding leaves 1e-8, elsewhere they are
/// longer.
inline constexpr double idle = 1e-5;
/// Steps end here: eight times the rounding of a length.
inline constexpr double settled = 64;
/// Steps are stuck if they miss more: sixteen times the rounding of a length.
inline constexpr double stuck = 256;
/// Poses may be missed by so many epsilons.
inline constexpr double reached = 16;
/// A step at a double root leaves a sixteenth of the squared miss: between these shares it is doubled.
inline constexpr double least_halved = 0.03, most_halved = 0.13;
/// May be a double root: farther off the curvature of the way tells nothing.
inline constexpr double double_root_miss = 1e-8;

// Solutions that are one. Distances are sums of squares of cosines' and sines' differences.

/// Rows that agree to half the digits are one, in epsilons: 2e-7 apart.
inline constexpr double same_rows = 180;
/// Asked if a continuum joins them: a tenth of a radian, over which a continuum is nearly straight.
inline constexpr double may_be_joined = 1e-2;
/// A place between two joined ones is no farther from either than this share of their distance.
inline constexpr double between = 0.6;
/// How far along an idle joint a continuum is looked for: far beyond half the digits, rad or share of the
/// size.
inline constexpr double way_along = 1e-2;
/// Ways that are off by a hundred times what is allowed to first order are not followed: they may be curved.
inline constexpr double off_to_first_order = 100;
/// The squared miss a quick step leaves: next to a continuum steps converge at once.
inline constexpr double quick_gain = 1e-4;

// Continua of arms with a quartic, whose roots carry nine to eleven digits.

/// The squared miss of joint values that are nearly on a continuum.
inline constexpr double nearly_on_continuum = 1e-12;
/// The miss of a place `way_along` beside values next to a continuum: where two solutions merely meet it is
/// 1e-4.
inline constexpr double next_to_continuum = 1e-6;
/// Damping of the idle joint's own step, of which the others take nothing away.
inline constexpr double damping_along = 1e-2;
/// The farthest that an idle joint goes in a step, rad or share of the size: the way is curved.
inline constexpr double longest_along = 0.3;

// Rows next to a seed. Distances are squared angles and lengths.

/// No other row needs to be asked for: 10 mrad.
inline constexpr double by_seed = 1e-4;
/// Newton's steps may have moved a row along a continuum: 2 mrad.
inline constexpr double by_seed_on_continuum = 4e-6;
/// Two solutions of a fork meet: their distances agree to half the digits.
inline constexpr double forks_meet = 1e-12;
/// A row on a continuum stands at the seed: steps that rounding makes would add up.
inline constexpr double at_seed = 1e-12;

// Poses nearby, at which nothing is free.

/// How far off, as a share of the size and in radians: far beyond half the digits, near enough for Newton's
/// steps.
inline constexpr double nearby = 1e-4;

}  // namespace qvgen::inverse::tolerance
