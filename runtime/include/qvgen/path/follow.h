// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <qvgen/path/live.h>

/// All solutions followed along a path. Every stretch is halved until each solution at one end belongs to one
/// at the other, by short ways, or meets another on the way at a place that is located. This is no proof: a
/// branch that begins and ends between two places, at most twice `Options::longest_way` apart, can be missed;
/// the proof of complete.h finds it.
namespace qvgen::path {

/// Numbers that bound the work.
struct Options {
  double longest_step = 0.25;     ///< of a joint between two places, rad or m
  double longest_way = 0.01;      ///< of the tool between two places that are solved without need, m
  double longest_turn = 0.02;     ///< likewise, rad
  int most_places = 20000;        ///< solved on one piece of the path; beyond it the record is doubtful
  const double* extra = nullptr;  ///< path coordinates, rising, at which solutions are computed in any case
  std::size_t extra_count = 0;
};

/// Follows all solutions of an arm along a path; needs no heap.
template <class Arm>
class Follower {
 public:
  using Table = Record<Arm::capacity>;

  /// `limits`: of the values that have limits (coupling.h), as a rule the joints.
  Follower(const Arm& arm, const Curve& curve, const JointLimits<Arm::Limited::values>& limits, Table& record,
           const Options& options = {})
      : arm_(arm),
        curve_(curve),
        limits_(limits, arm.revolute, arm.coupling),
        record_(record),
        options_(options),
        live_(arm, limits_, record) {}

  void run() {
    if (curve_.samples() == 0) return;
    start();
    for (std::size_t i = 0; i < curve_.pieces(); ++i) {
      piece_ = curve_.piece(i);
      if (!piece_.is_point()) follow(static_cast<double>(i));
      live_.keep(i + 1);
    }
    live_.close(curve_.end(), Cause::path_end);
  }

  /// Poses for which all solutions were computed.
  [[nodiscard]] long places() const { return places_; }

 private:
  static constexpr double shortest = 1e-10;

  /// The first sample; if a joint is free there, tracks begin behind it.
  void start() {
    Place<Arm> place;
    place.found = arm_.solve(curve_.sample(0));
    ++places_;
    add_signs(arm_, place);
    if (place.is_clear()) live_.open(place, 0, Cause::path_end);
    live_.keep(0);
  }

  void follow(double offset) {
    const Equations<Arm> equations(arm_, piece_);
    const Stepper<Arm> stepper(arm_, equations, options_.longest_step);
    equations_ = &equations;
    stepper_ = &stepper;
    live_.set_offset(offset);
    left_ = options_.most_places;
    Place<Arm> right;
    if (!enter(offset, right)) {
      live_.close(offset, Cause::flip);
      return;
    }
    walk(right);
    is_exact_ = right.u == 1;
  }

  /// Goes to the first clear place of the piece, and finds the last one; false if there are none.
  bool enter(double offset, Place<Arm>& right) {
    const bool goes_on = live_.is_open() && is_exact_;
    Place<Arm> left;
    if (!goes_on && !clear_from(0, 1, left)) return false;
    if (!clear_from(1, goes_on ? 0 : left.u, right)) return false;
    if (goes_on)
      live_.start_piece();
    else if (live_.is_open())
      live_.commit_across(*equations_, left, offset);
    else
      live_.open(left, offset, offset == 0 ? Cause::path_end : Cause::flip);
    return true;
  }

  /// Finds the clear place nearest to `from` on the way to `to`.
  bool clear_from(double from, double to, Place<Arm>& place) {
    evaluate(from, place);
    for (double away = 1e-9; !place.is_clear() && away < std::abs(to - from); away *= 8)
      evaluate(from < to ? from + away : from - away, place);
    return place.is_clear();
  }

  void evaluate(double u, Place<Arm>& place) {
    ++places_;
    --left_;
    place.u = u;
    place.found = arm_.solve(piece_.at(u));
    add_signs(arm_, place);
    record_.is_doubtful = record_.is_doubtful || place.found.status == Status::incomplete;
  }

  /// In stretches that are short enough to begin with.
  void walk(const Place<Arm>& right) {
    const double from = live_.place().u, way = right.u - from;
    const double count = std::ceil(std::max(way * piece_.distance() / (2 * options_.longest_way),
                                            way * piece_.angle() / (2 * options_.longest_turn)));
    const int stretches = static_cast<int>(std::min(std::max(count, 1.0), 1e4));
    const double *extra = options_.extra, *const end = extra + options_.extra_count;
    extra = std::upper_bound(extra, end, curve_offset() + from);
    for (int i = 1; i <= stretches; ++i) {
      const double to = from + way * i / stretches;
      for (; extra != end && *extra < curve_offset() + to; ++extra) visit(*extra - curve_offset());
      if (i < stretches) visit(to);
    }
    Place<Arm> last = right;
    go_to(last);
  }

  void visit(double u) {
    Place<Arm> next;
    evaluate(u, next);
    if (next.is_clear()) go_to(next);
  }

  void go_to(Place<Arm>& next) {
    if (!leap(next)) go_by_halves(next);
  }

  /// Goes to the next place at once, if nothing can be hidden on the way.
  bool leap(const Place<Arm>& next) {
    const Match<Arm> match = matched(arm_, live_.place(), next, options_.longest_step);
    if (!is_calm(arm_, live_.place(), next, match) || live_.nears_limits(next, match)) return false;
    live_.leap(match, next);
    return true;
  }

  void go_by_halves(Place<Arm>& next) {
    const double from = live_.place().u;
    if (next.u - from < shortest || left_ < 0) {
      record_.is_doubtful = record_.is_doubtful || left_ < 0;
      live_.commit_across(*equations_, next, curve_offset() + 0.5 * (from + next.u));
      return;
    }
    Place<Arm> middle;
    evaluate(0.5 * (from + next.u), middle);
    if (!middle.is_clear()) return go_around(middle.u, next);
    const Step<Arm> first = stepper_->step(live_.place(), middle);
    const Step<Arm> second = first.is_sure ? stepper_->step(middle, next) : Step<Arm>();
    if (second.is_sure && !is_hiding(middle, next, first, second)) {
      live_.commit(*equations_, first, middle);
      live_.commit(*equations_, second, next);
      return;
    }
    go_to(middle);
    go_to(next);
  }

  [[nodiscard]] bool is_hiding(const Place<Arm>& middle, const Place<Arm>& next, const Step<Arm>& first,
                               const Step<Arm>& second) const {
    const Hidden<Arm> hidden(arm_, live_.place(), middle, next, first, second);
    return hidden.meeting() || live_.touches(hidden);
  }

  /// Past a place where a joint is free.
  void go_around(double at, Place<Arm>& next) {
    Place<Arm> before, behind;
    const bool has_both = clear_from(at, live_.place().u, before) && clear_from(at, next.u, behind);
    if (has_both) {
      go_to(before);
      live_.commit_across(*equations_, behind, curve_offset() + at);
      go_to(next);
      return;
    }
    live_.commit_across(*equations_, next, curve_offset() + at);
  }

  [[nodiscard]] double curve_offset() const { return live_.offset(); }

  const Arm& arm_;
  Curve curve_;
  LimitsOnTrack<typename Arm::Limited> limits_;
  Table& record_;
  Options options_;
  Live<Arm> live_;
  Piece piece_;
  const Equations<Arm>* equations_ = nullptr;
  const Stepper<Arm>* stepper_ = nullptr;
  bool is_exact_ = true;
  int left_ = 0;
  long places_ = 0;
};

}  // namespace qvgen::path
