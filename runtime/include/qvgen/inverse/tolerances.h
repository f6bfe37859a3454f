// SPDX-License-Identifier: MIT
#pragma once

// Tolerances near singular poses, each with its reason: the closed forms with their blocks, the quartic's and
// the elimination's careful forms take them from here. Rounding is 2e-16 of a number. Where two solutions
// meet it moves a root by its own root, about 1e-8: half the digits.
//
// C has its numbers from here, too: its blocks say tolerance_NAME where `double NAME = ...` stands below.

namespace qvgen::inverse::tolerance {

/// Marks a bound of what rounding may do. Float has one of as many of its own digits in C: 1e-7 is 8e-4.
constexpr double digits(double bound) { return bound; }

/// Marks a number near the end of what double can be, which in C is as near to the end of float.
constexpr double range(double number) { return number; }

// Callers.

/// How far beyond reach a pose is still solved, as a share of the arm's size, if nothing is said: see
/// `default_tolerance`.
inline constexpr double beyond_reach = digits(1e-13);
/// A joint so far outside its limits, rad or m, is on them: see `limit_tolerance`.
inline constexpr double on_limit = digits(1e-12);
/// Farther than any joint, and small enough to be added.
inline constexpr double farthest_joint = range(1e300);
/// A seed so far away has lost the digits of whole turns: it is none.
inline constexpr double lost_centre = digits(1e12);
/// More whole turns than this are not counted: a half is still a digit of their angle.
inline constexpr double most_turns = digits(5e8);
/// Squares of distances from a centre may be the same, computed in different ways: half the digits, and some.
inline constexpr double same_square = digits(1e-6);

// Reach, told before any branch is followed.

/// Rounding of a distance's square, as a share.
inline constexpr double reach_rounding = digits(1e-6);
/// Squares of distances per square of the size and tolerance: a wrist may be folded beyond reach, too.
inline constexpr double reach_per_tolerance = 80;

// Ends of the range of an equation, as shares of the range (`Boundary`).

/// Doubtful inside: so near to the end two roots differ by 3e-4, and steps that magnify rounding may swap
/// them.
inline constexpr double end_inside = digits(1e-7);
/// Doubtful outside: rounding of earlier steps puts an end no farther out.
inline constexpr double end_outside = digits(1e-10);
/// Outside by less before any branch is followed: a root before it that is double carries half the digits.
inline constexpr double swing_at_double_root = digits(1e-6);
/// Shares of a range per share of the arm's size: no equation's range is smaller than a hundredth of the arm.
inline constexpr double range_per_size = 100;
/// Followed from the end in careful passes: farther out Newton's steps do not come back.
inline constexpr double end_careful = 1e-3;
/// Beyond every range: the end is taken wherever the equation leads.
inline constexpr double end_anywhere = 1e3;
/// Places as far apart as two roots 1e-10 from the end, from which steps lead to two solutions.
inline constexpr double end_apart = digits(1e-10);
/// A wrist is folded: half of the 1e-12 that no solution may miss its pose by.
inline constexpr double least_fold = digits(5e-13);
/// A wrist is folded for steps of all joints: behind a double root, which carries half the digits, and some.
inline constexpr double fold_at_double_root = digits(1e-6);

// Squares of directions, as multiples of the square that is noise for sure.

/// Rounding can be seen: the direction has lost half its digits.
inline constexpr double blurred = digits(1e16);
/// Nearly free: a digit more, for what earlier steps have magnified.
inline constexpr double nearly_free = digits(1e18);
/// A row is marked, as a multiple of the largest noise that rounding leaves in a direction: an angle may be
/// half a milliradian from where the pose has it.
inline constexpr double marked = digits(1e7);
/// Chosen in place of a wrist's angle behind a double root, which carries half the digits.
inline constexpr double choosable_behind_double_root = digits(1e14);
/// Chosen in place of a wrist's angle elsewhere: Newton's steps have to make good what the choice turns away.
inline constexpr double choosable = digits(1e5);
/// The nearer end of a range: earlier equations at their own ends magnify rounding to four digits.
inline constexpr double magnified_end = digits(1e8);
/// An equation of a free direction holds: eight times the noise.
inline constexpr double gap = 64;
/// An equation of a nearly free direction holds: half the digits.
inline constexpr double gap_careful = digits(64e14);
/// An equation of a stretched arm is not asked for.
inline constexpr double gap_anything = digits(1e40);

// Squares of directions made of unit vectors.

/// Nothing but a choice: a product of two vectors of 1e-5, beside a double root.
inline constexpr double product_at_double_root = digits(1e-20);
/// The fourth power of 1e-5 over noise (16 eps): the same product, as a multiple of what is noise for sure.
inline constexpr double noise_at_double_root = digits(6.3e37);
/// Two digits are lost.
inline constexpr double two_digits = 1e-4;
/// A slide's direction of 1e-12: the slide is as near to the choice as its equation lets it.
inline constexpr double loose_slide = digits(1e-24);
/// A discriminant may be rounding: two thousand times the noise of its coefficients, squared.
inline constexpr double noisy_discriminant = digits(4e6);
/// A divisor, or a length as a share of the size, with six digits: below it a quartic falls apart.
inline constexpr double lost_divisor = digits(1e-6);

// Roots of a conic on the unit circle, whose coefficients add up to one.

/// A line's or a conic's direction is noise: the rest of the equation is without it.
inline constexpr double line_direction = digits(1e-12);
inline constexpr double conic_direction = digits(1e-13);
/// A line that misses the circle by less touches it.
inline constexpr double line_touches = 1e-3;
/// A root may be double where the slope is less, and steps follow the parabola.
inline constexpr double little_slope = 1e-3;
/// Steps go to the extremum if there is no root and the slope is less than this share of the curvature.
inline constexpr double slope_to_extremum = 1e-2;
/// A root is an extremum's two if the slope is less than this share of the curvature.
inline constexpr double slope_of_pair = 1e-4;
/// Extrema that are nearer are one.
inline constexpr double same_extremum = 1e-3;
/// The longest step, rad.
inline constexpr double longest_step = 0.1;
/// A candidate's value, as a share of how far outside a range a branch still exists.
inline constexpr double value_per_accepted = 1e-2;
/// A simple root's value: what the cubic and the pair of lines leave of the digits.
inline constexpr double simple_root_value = digits(3e-11);
/// Simple roots that are nearer are one.
inline constexpr double same_simple_root = digits(1e-9);

// Newton's steps. Misses are squares, as shares of the squared size.

/// Entries of a Jacobian, and parts of unit vectors, that rounding leaves, in epsilons.
inline constexpr double noise = 64;
/// Misses by half the digits squared: steps are not damped.
inline constexpr double undamped = digits(1e-12);
/// Damping as a share of the miss: a tenth keeps the speed and tames what is nearly idle.
inline constexpr double damping = 1e-1;
/// Columns with less beyond the others are idle: at a double root rounding leaves 1e-8, elsewhere they are
/// longer.
inline constexpr double idle = digits(1e-5);
/// Steps end here: eight times the rounding of a length.
inline constexpr double settled = 64;
/// Steps are stuck if they miss more: sixteen times the rounding of a length.
inline constexpr double stuck = 256;
/// Poses may be missed by so many epsilons.
inline constexpr double reached = 16;
/// A step at a double root leaves a sixteenth of the squared miss: between this share and the next it is
/// doubled.
inline constexpr double least_halved = 0.03;
inline constexpr double most_halved = 0.13;
/// May be a double root: farther off the curvature of the way tells nothing.
inline constexpr double double_root_miss = digits(1e-8);

// Solutions that are one. Distances are sums of squares of cosines' and sines' differences.

/// Rows that agree to half the digits are one, in epsilons: 2e-7 apart.
inline constexpr double same_rows = 180;
/// Asked if a continuum joins them: a tenth of a radian, over which a continuum is nearly straight.
inline constexpr double may_be_joined = 1e-2;
/// A place between two joined ones is no farther from either than this share of their distance.
inline constexpr double between = 0.6;
/// Place between two solutions at which it is asked if a continuum joins them, as a share of the way: the
/// golden section. Of three solutions side by side the middle of two is the third.
inline constexpr double way_between = 0.38196601125010515;
/// How far along an idle joint a continuum is looked for: far beyond half the digits, rad or share of the
/// size.
inline constexpr double way_along = 1e-2;
/// A continuum may bend sharply: a small loop is followed along this share of the way.
inline constexpr double sharp_bend = 0.1;
/// A row leaves its continuum by half the digits at most, and the pose by as much a radian along it: five
/// times that.
inline constexpr double off_continuum = digits(1e-6);
/// Steps that end no farther off, squared, may have been led astray by a joint that is nearly idle.
inline constexpr double held_miss = digits(1e-14);
/// Ways that are off by a hundred times what is allowed to first order are not followed: they may be curved.
inline constexpr double off_to_first_order = 100;
/// The squared miss a quick step leaves: next to a continuum steps converge at once.
inline constexpr double quick_gain = 1e-4;

// Continua of arms with a quartic, whose roots carry nine to eleven digits.

/// The squared miss of joint values that are nearly on a continuum.
inline constexpr double nearly_on_continuum = digits(1e-12);
/// The miss of a place `way_along` beside values next to a continuum: where two solutions merely meet it is
/// 1e-4.
inline constexpr double next_to_continuum = digits(1e-6);
/// Damping of the idle joint's own step, of which the others take nothing away.
inline constexpr double damping_along = 1e-2;
/// The farthest that an idle joint goes in a step, rad or share of the size: the way is curved.
inline constexpr double longest_along = 0.3;

// Rows of a task that has to reach more than its equations say.

/// How far a row may be off for Newton's steps to bring it there, as a share of the size: at regular poses.
inline constexpr double near_enough = 1e-4;
/// At singular poses, where a direction may have but two digits.
inline constexpr double near_enough_singular = 1e-2;
/// Per square root of the tolerance, which moves a double root.
inline constexpr double near_enough_by_tolerance = 30;
/// In any case: farther out steps lead anywhere.
inline constexpr double near_enough_at_most = 0.3;
/// Two starts nearer than this are one.
inline constexpr double same_start = digits(1e-6);
/// A direction leans away from an axis, as Eigen tells it in `Quaternion::FromTwoVectors`.
inline constexpr double leaning = digits(1e-12);
/// The square of the least part of a tool's direction across the axis that pitches it.
inline constexpr double pitched = digits(1e-20);

// Two coupled turns, by two equations whose largest coefficients are one.

/// The square of what tells the angle that two waves have in common.
inline constexpr double common_wave = digits(1e-14);
/// The square of a wave that has no angle.
inline constexpr double flat_wave = digits(1e-20);
/// Curves of both equations touch, as a share of their slopes: Newton's steps end.
inline constexpr double curves_touch = digits(1e-12);
/// Solutions meet, by the same share: half the digits, and some.
inline constexpr double curves_meet = digits(3e-6);
/// A step so long leads nowhere, rad.
inline constexpr double lost_turn = range(1e100);
/// An equation holds, in epsilons.
inline constexpr double equation_rounding = 4e3;
/// Rounding moves a solution, in epsilons, where curves cross at right angles.
inline constexpr double turn_rounding = 450;
/// Two solutions nearer than this are one: at least, and at most where curves touch.
inline constexpr double same_turn = digits(1e-9);
inline constexpr double same_turn_at_most = digits(1e-6);
/// The step to the root of an arc's polynomial that is the last, rad: its fourth power is left.
inline constexpr double next_to_root = digits(2e-3);
/// How much more than its square is left by Newton's step on both equations, as a root.
inline constexpr double step_to_rest = 8;

// Loops.

/// The least length of a row of the loops' Jacobian, as a share of the whole: less is rounding next to the
/// others.
inline constexpr double least_row = digits(1e-6);

// Rows next to a seed. Distances are squared angles and lengths.

/// The way along the seed's branch leads to the nearest of all rows, if that is no farther: 0.3 rad.
inline constexpr double nearest_by_forks = 0.09;
/// No other row needs to be asked for: 10 mrad.
inline constexpr double by_seed = 1e-4;
/// Newton's steps may have moved a row along a continuum: 2 mrad.
inline constexpr double by_seed_on_continuum = digits(4e-6);
/// Two solutions of a fork meet: their distances agree to half the digits.
inline constexpr double forks_meet = digits(1e-12);
/// A row on a continuum stands at the seed: steps that rounding makes would add up.
inline constexpr double at_seed = digits(1e-12);
/// Seed and row miss each other's pose by this share of the way between them, if nothing there is nearly
/// free.
inline constexpr double least_miss = 0.05;
/// A row of the equations misses the pose by rounding alone, in epsilons.
inline constexpr double row_rounding = 32;

// Rows at singular poses, brought inside limits along their continua.

/// The square of how far an axis is inclined to the next one; less is a parallel axis, which a turn leaves.
inline constexpr double inclined = digits(1e-6);
/// So far outside, rad or m, a joint may be put on its limit while the others follow.
inline constexpr double pressed = 1e-3;
/// Farther outside nothing is pressed at a pose that is not nearly singular: rounding moves no joint as far.
inline constexpr double pressed_by_rounding = digits(1e-7);
/// Step along a continuum, which bends: rad, or a share of the size.
inline constexpr double walk_step = 0.1;
/// The cosine of an angle by which no continuum bends in a step: another one is crossed.
inline constexpr double walk_turns_off = 0.7;
/// Limits leave so little of a continuum that its middle is taken.
inline constexpr double narrow_window = 1e-3;
/// A joint so slow along a continuum stays where it is.
inline constexpr double stands_still = digits(1e-9);

// Poses nearby, at which nothing is free.

/// How far off, as a share of the size and in radians: far beyond half the digits, near enough for Newton's
/// steps.
inline constexpr double nearby = 1e-4;

}  // namespace qvgen::inverse::tolerance
