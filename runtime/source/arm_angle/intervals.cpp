// SPDX-License-Identifier: MIT
#include "intervals.h"

#include <algorithm>
#include <cmath>

namespace qvgen::inverse::arm_angle {

namespace {

constexpr double half_turn = 3.14159265358979323846;

/// Arm angles at which something may begin or end, of one half of the arm.
class Marks {
 public:
  void append(double angle) { angles_[static_cast<std::size_t>(count_++)] = without_turns(angle); }
  /// Appends the angles at which the wave is zero.
  void append_zeros(const Swivel::Wave& wave) {
    const double height = std::hypot(wave.cosine, wave.sine);
    if (!(std::abs(wave.constant) <= height)) return;
    const double crest = std::atan2(wave.sine, wave.cosine);
    const double aside =
        std::atan2(std::sqrt((height - wave.constant) * (height + wave.constant)), -wave.constant);
    append(crest + aside);
    append(crest - aside);
  }
  [[nodiscard]] const double* begin() const { return angles_.data(); }
  [[nodiscard]] const double* end() const { return angles_.data() + count_; }

 private:
  int count_ = 0;
  // Two for each limit of three joints, two for each end of oblique axes, two where the middle joint is
  // straight.
  std::array<double, 18> angles_{};
};

Rotor<double> rotor(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Marks of three joints: `wave(p, q, value)` has p . rotation q - value over the arm angle.
template <class WaveOf>
void append_limits(const ThreeTurns& three, const Ranges& ranges, const WaveOf& wave, Marks& marks) {
  const Vector3<double>&a = three.first(), &b = three.middle(), &c = three.last();
  for (const double limit : {ranges.first.lower, ranges.first.upper})
    if (ranges.first.cuts()) marks.append_zeros(wave(turned(a, rotor(limit), b), c, b.dot(c)));
  for (const double limit : {ranges.middle.lower, ranges.middle.upper})
    if (ranges.middle.cuts()) marks.append_zeros(wave(a, c, a.dot(turned(b, rotor(limit), c))));
  for (const double limit : {ranges.last.lower, ranges.last.upper})
    if (ranges.last.cuts()) marks.append_zeros(wave(a, turned(c, rotor(-limit), b), a.dot(b)));
}

/// Appends the ends of a swivel whose outer axes are in line all around the circle, along or opposite: there
/// both outer joints are at a limit.
template <class WaveOf>
void append_shared_limits(const ThreeTurns& three, const Ranges& ranges, bool opposite, const WaveOf& wave,
                          Marks& marks) {
  if (!ranges.first.cuts() || !ranges.last.cuts()) return;
  const Vector3<double>& a = three.first();
  for (const double first : {ranges.first.lower, ranges.first.upper})
    for (const double last : {ranges.last.lower, ranges.last.upper}) {
      const Vector3<double> image = three.with_axes_in_line(three.across_last(), first, last, opposite);
      marks.append_zeros(wave(a.cross(image), three.across_last(), 0));
    }
}

template <class WaveOf>
void append_marks(const ThreeTurns& three, const Ranges& ranges, const WaveOf& wave, Marks& marks) {
  const Swivel::Wave between = wave(three.first(), three.last(), 0);
  const double height = std::hypot(between.cosine, between.sine);
  const double most = std::abs(between.constant) + height;
  if (height < in_line && most > 1 - in_line)
    return append_shared_limits(three, ranges, between.constant < 0, wave, marks);
  append_limits(three, ranges, wave, marks);
  // Oblique axes come to an end.
  for (const double cosine : {three.least_cosine(), three.most_cosine()})
    if (std::abs(cosine) < 1 - 1e-12)
      marks.append_zeros({between.cosine, between.sine, between.constant - cosine});
  // The outer joints jump where the outer axes come into line, and there alone they are free: a point that
  // may be within the limits while both sides are not.
  if (most < 1 - 1e-9) return;
  const double crest = std::atan2(between.sine, between.cosine);
  const double place = between.constant < 0 ? crest + half_turn : crest;
  marks.append(place);
  marks.append(place);
}

}  // namespace

Circle::Circle(const Solver& solver, const Swivel& swivel, const JointLimits<7>& limits) {
  Marks marks;
  append_marks(
      solver.shoulder(), ranges_of(limits, 0),
      [&](const auto& p, const auto& q, double value) { return swivel.wave(p, q, value); }, marks);
  Marks of_wrist;
  const Vector3<double>& axis = solver.arm().axes[3];
  const auto wrist_wave = [&](const auto& p, const auto& q, double value) {
    return swivel.wave(solver.goal().rotation * q, turned(axis, swivel.elbow.turn, p), value);
  };
  append_marks(solver.wrist(), ranges_of(limits, 4), wrist_wave, of_wrist);
  for (const double mark : marks) marks_[static_cast<std::size_t>(count_++)] = {mark, false};
  for (const double mark : of_wrist) marks_[static_cast<std::size_t>(count_++)] = {mark, true};
  std::sort(marks_.begin(), marks_.begin() + count_,
            [](const Mark& a, const Mark& b) { return a.angle < b.angle; });
}

double Circle::begin(int arc) const {
  constexpr double turn = 2 * half_turn;
  if (count_ == 0) return arc * turn - half_turn;
  return marks_[static_cast<std::size_t>(arc % count_)].angle + (arc / count_) * turn;
}

namespace {

/// Which branches are within the limits, of every arc: bit 2 s + w for shoulder s and wrist w.
using Masks = std::array<unsigned, 36>;

/// Which ways to turn shoulder or wrist are within the limits at an arm angle.
class Halved {
 public:
  Halved(const Solver& solver, const Swivel& swivel, const JointLimits<7>& limits)
      : solver_(solver), swivel_(swivel), shoulder_(ranges_of(limits, 0)), wrist_(ranges_of(limits, 4)) {}

  [[nodiscard]] unsigned shoulder(double psi) const {
    return fitting(solver_.shoulder(), shoulder_, swivel_.rotation(psi), 0, solver_.fold()).within;
  }
  [[nodiscard]] unsigned wrist(double psi) const {
    const Matrix3<double> rest =
        wrist_rotation(solver_.arm(), solver_.goal(), swivel_, swivel_.rotation(psi));
    return fitting(solver_.wrist(), wrist_, rest, 0, solver_.fold()).within;
  }

 private:
  const Solver& solver_;
  const Swivel& swivel_;
  Ranges shoulder_, wrist_;
};

Masks masks_of(const Circle& circle, const Solver& solver, const Swivel& swivel,
               const JointLimits<7>& limits) {
  const Halved halved(solver, swivel, limits);
  Masks masks{};
  const auto at = [&](int arc) -> unsigned& { return masks[static_cast<std::size_t>(arc % circle.arcs())]; };
  // Narrower intervals are looked at by themselves, and so is what follows them.
  constexpr double narrow = 1e-9;
  unsigned shoulder = 0, wrist = 0;
  bool known = false;
  for (int i = 0; i < circle.arcs(); ++i) {
    const double psi = circle.middle(i);
    const bool alone = circle.width(i) < narrow;
    if (!known || alone || !circle.is_of_wrist(i)) shoulder = halved.shoulder(psi);
    if (!known || alone || circle.is_of_wrist(i)) wrist = halved.wrist(psi);
    known = !alone;
    at(i) = ((shoulder & 1U) != 0 ? wrist : 0) | ((shoulder & 2U) != 0 ? wrist << 2U : 0);
  }
  // Between two arcs a single angle is within the limits, whatever rounding makes of it.
  constexpr double point = 1e-14;
  for (int i = 0; i < circle.arcs(); ++i)
    if (circle.width(i) < point) at(i) |= at(i + circle.arcs() - 1) & at(i + 1);
  return masks;
}

/// Appends the runs of arcs that have a bit, `branch` being what the solutions call it.
void append_runs(const Circle& circle, const Masks& masks, unsigned bit, int branch,
                 ArmAngleIntervals& found) {
  const int count = circle.arcs();
  const auto has = [&](int arc) { return (masks[static_cast<std::size_t>(arc % count)] & bit) != 0; };
  const auto widest = [&](int first, int last) {
    int best = first;
    for (int i = first; i <= last; ++i)
      if (circle.width(i) > circle.width(best)) best = i;
    return without_turns(circle.middle(best));
  };
  int gaps = 0;
  for (int first = 0; first < count; ++first) {
    if (has(first)) continue;
    ++gaps;
    if (!has(first + 1)) continue;
    int last = first + 1;
    while (has(last + 1)) ++last;
    const double lower = without_turns(circle.begin(first + 1));
    found.append(
        {lower, lower + (circle.begin(last + 1) - circle.begin(first + 1)), widest(first + 1, last), branch});
  }
  if (gaps == 0) found.append({-half_turn, half_turn, widest(0, count - 1), branch});
}

}  // namespace

ArmAngleIntervals intervals(const Solver& solver, const JointLimits<7>& limits) {
  ArmAngleIntervals found;
  for (int elbow = 0; elbow < solver.goal().elbows; ++elbow) {
    const Swivel swivel = solver.swivel(elbow);
    if (!range_of(limits, 3).admits(output_angle(swivel.elbow.turn.cosine, swivel.elbow.turn.sine))) continue;
    const Circle circle(solver, swivel, limits);
    const Masks masks = masks_of(circle, solver, swivel, limits);
    for (int i = 0; i < 4; ++i) append_runs(circle, masks, 1U << i, 4 * elbow + i, found);
  }
  found.status = found.empty() ? Status::unreachable : Status::solved;
  return found;
}

ArmAngleIntervals intervals(const Arm& arm, const Pose<double>& pose, const JointLimits<7>& limits,
                            const ArmAngleReference& reference, double tolerance) {
  const Solver solver(arm, pose, reference, tolerance);
  if (solver.goal().status == Status::solved) return intervals(solver, limits);
  ArmAngleIntervals none;
  none.status = solver.goal().status;
  return none;
}

}  // namespace qvgen::inverse::arm_angle
