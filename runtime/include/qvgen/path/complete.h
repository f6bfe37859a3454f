// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <qvgen/inverse/certified/complete.h>
#include <qvgen/path/newton.h>
#include <qvgen/path/place.h>
#include <qvgen/path/prove.h>

/// Proof that no other motion follows a path than the tracks of a record: every solution at every place lies
/// on one of them (inverse/certified/complete.h). The path is cut where tracks begin or end and after some
/// millimetres. A solution that is on no track is reported: following the path once more with a place there
/// (Options::extra) finds the motion, however short it is.
namespace qvgen::path {

/// Result of one walk along the path.
struct CompleteProof {
  double other = -1;    ///< place of a solution that is on no track; -1: the path was walked to its end
  double reached = -1;  ///< other: where the stretch begins that it is on
};

template <class Arm>
class Completer {
 public:
  static constexpr int capacity = Arm::capacity;

  /// `record` keeps joints at the samples.
  Completer(const Arm& arm, const inverse::certified::Arm& bounds, const Curve& curve,
            const Record<capacity>& record, const inverse::certified::CompleteEffort& effort = {})
      : arm_(arm), bounds_(bounds), curve_(curve), record_(record), effort_(effort) {}

  /// Proves the path from a place on; `take_gap(from, to)` is called with each stretch that is not proven.
  /// Stops at a solution that is on no track, unless it is before `known`.
  template <class TakeGap>
  CompleteProof run(double from, double known, const TakeGap& take_gap) const {
    for (double s = from; s < curve_.end();) {
      const double to = end_of_stretch(s), offset = static_cast<double>(curve_.piece_at(s));
      const inverse::certified::Completeness proof = prove(s, to);
      if (proof.has_other && offset + proof.other > known) return {offset + proof.other, s};
      for (std::size_t i = 0; i < proof.gap_count; ++i)
        take_gap(offset + proof.gaps[i].from, offset + proof.gaps[i].to);
      s = to;
    }
    return {};
  }

 private:
  using Joint = std::array<double, 6>;
  static constexpr double same_place = 1e-8;
  static constexpr double longest_way = 0.006, longest_turn = 0.012;  ///< of a stretch, m and rad
  static constexpr double longest_count = 32;                         ///< pieces

  /// Returns where the stretch from a place ends: where a track begins or ends, or at a sample.
  [[nodiscard]] double end_of_stretch(double s) const {
    double event = curve_.end();
    for (int i = 0; i < record_.tracks(); ++i)
      for (const double end : {record_.track(i).begin.s, record_.track(i).end.s})
        if (end > s + same_place) event = std::min(event, end);
    std::size_t i = curve_.piece_at(s);
    double way = 0, turn = 0;
    for (double to = static_cast<double>(i + 1);; ++to) {
      const Piece piece = curve_.piece(i++);
      way += piece.distance();
      turn += piece.angle();
      if (to >= event) return event;
      if (way > longest_way || turn > longest_turn || to - s > longest_count) return to;
    }
  }

  [[nodiscard]] inverse::certified::Completeness prove(double from, double to) const {
    const std::size_t first = curve_.piece_at(from);
    const auto last = std::max(first, static_cast<std::size_t>(std::ceil(to)) - 1);
    std::vector<inverse::certified::Way> ways;
    for (std::size_t i = first; i <= last; ++i) ways.push_back(proving::way_of(curve_, i));
    const std::vector<std::vector<Joint>> joints = joints_on(from, to, first, last);
    std::vector<const double(*)[6]> rows;
    for (const auto& each : joints) rows.push_back(reinterpret_cast<const double(*)[6]>(each.data()));
    const double offset = static_cast<double>(first);
    const Context context{this, offset};
    return inverse::certified::prove_complete(
        bounds_, {ways.data(), static_cast<int>(ways.size()), from - offset, to - static_cast<double>(last)},
        {rows.data(), static_cast<int>(rows.size())}, {&context, solve}, effort_);
  }

  /// Joints of all tracks of a stretch: at its begin, at the samples in it, and at its end.
  [[nodiscard]] std::vector<std::vector<Joint>> joints_on(double from, double to, std::size_t first,
                                                          std::size_t last) const {
    std::vector<std::vector<Joint>> all;
    for (int number = 0; number < record_.tracks(); ++number) {
      const Track& track = record_.track(number);
      if (track.begin.s > from + same_place || track.end.s < to - same_place) continue;
      std::vector<Joint> joints{joints_at(number, from)};
      for (std::size_t i = first + 1; i <= last; ++i)
        joints.push_back(joints_at(number, static_cast<double>(i)));
      joints.push_back(joints_at(number, to));
      all.push_back(joints);
    }
    return all;
  }

  [[nodiscard]] Joint joints_at(int number, double s) const {
    const Values q = values_at(number, s);
    Joint joints;
    std::copy(q.data(), q.data() + 6, joints.begin());
    return joints;
  }

  /// Joints of a track; between the samples by Newton's steps from what is known on both sides.
  [[nodiscard]] Values values_at(int number, double s) const {
    const Track& track = record_.track(number);
    Values q;
    if (s <= track.begin.s) return track.begin.q;
    if (s >= track.end.s) return track.end.q;
    if (s == std::floor(s) && record_.at(static_cast<std::size_t>(s), number, q)) return q;
    const std::size_t i = curve_.piece_at(s);
    const double below = std::max(track.begin.s, static_cast<double>(i)),
                 above = std::min(track.end.s, static_cast<double>(i + 1));
    if (!(below < s && s < above)) return track.begin.q;
    const Values from = values_at(number, below), to = values_at(number, above);
    const Equations<Arm> equations(arm_, curve_.piece(i));
    Point at{from + (s - below) / (above - below) * (to - from), s - static_cast<double>(i)};
    static_cast<void>(equations.settle(at));
    return at.q;
  }

  /// The inverse kinematics as the proof asks for it.
  struct Context {
    const Completer* self;
    double offset;
  };
  static int solve(const void* data, double s, double (*rows)[6]) {
    const auto& context = *static_cast<const Context*>(data);
    const auto found = context.self->arm_.solve(context.self->curve_.at(context.offset + s));
    if (found.status == Status::singular) return 0;
    for (int i = 0; i < found.size(); ++i) std::copy(found[i].q.data(), found[i].q.data() + 6, rows[i]);
    return found.size();
  }

  const Arm& arm_;
  const inverse::certified::Arm& bounds_;
  Curve curve_;
  const Record<capacity>& record_;
  inverse::certified::CompleteEffort effort_;
};

using Stretches = std::vector<std::pair<double, double>>;

/// Proves that a record has all motions; returns the stretches that are not proven, in rising order. Where
/// the proof meets a solution that is on no track, its place is added to `extra`, and `follow()` fills the
/// record anew with these places (Options::extra).
template <class Arm, class Follow>
Stretches prove_complete(const Arm& arm, const inverse::certified::Arm& bounds, const Curve& curve,
                         const Record<Arm::capacity>& record, std::vector<double>& extra,
                         const Follow& follow, const inverse::certified::CompleteEffort& effort = {}) {
  constexpr std::size_t most_extra = 64;
  constexpr double near = 1e-6;
  Stretches gaps;
  const auto take_gap = [&](double from, double to) {
    if (!gaps.empty() && from <= gaps.back().second)
      gaps.back().second = std::max(gaps.back().second, to);
    else
      gaps.emplace_back(from, to);
  };
  const Completer<Arm> completer(arm, bounds, curve, record, effort);
  double from = 0, known = -1;
  for (CompleteProof proof; from >= 0; from = proof.reached) {
    proof = completer.run(from, known, take_gap);
    const bool is_new = proof.other >= 0 && extra.size() < most_extra;
    known = is_new ? proof.other + near : curve.end();
    if (!is_new) continue;
    extra.insert(std::upper_bound(extra.begin(), extra.end(), proof.other), proof.other);
    follow();
  }
  return gaps;
}

}  // namespace qvgen::path
