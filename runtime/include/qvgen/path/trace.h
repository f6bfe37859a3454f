// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/path/newton.h>

/// One solution followed along its curve by small steps, with nothing else known: from one place on the path
/// to another, or to where the path coordinate turns back, because two branches meet, and back to the start.
namespace qvgen::path {

/// How the trace of a solution has ended.
struct Trace {
  enum class End {
    arrived,  ///< at the wanted place, with these joints
    met,      ///< another branch: where, and its joints at the place of the start
    lost      ///< steps became too short, or too many
  };
  End end = End::lost;
  Values q = Values::Zero();  ///< arrived: there; met: of the other branch, back at the start
  Point meeting{Values::Zero(), 0};
};

template <class Arm>
class Tracer {
 public:
  explicit Tracer(const Equations<Arm>& equations) : equations_(equations) {}

  /// Follows the solution `from` until the path coordinate is `to`.
  [[nodiscard]] Trace trace(const Point& from, double to) const {
    const int sense = to > from.u ? 1 : -1;
    Trace result;
    State state{from, equations_.direction(from, sense), 0.02};
    bool has_met = false;
    for (int i = 0; i < most_steps; ++i) {
      const State before = state;
      if (!step(state)) return {};
      const bool turned = (state.direction[6] > 0) != (before.direction[6] > 0);
      if (turned && has_met) return {};
      if (turned && !locate(before, state, result.meeting)) return {};
      has_met = has_met || turned;
      const Point& last = turned ? result.meeting : before.at;
      const double goal = has_met ? from.u : to;
      if ((goal - state.at.u) * state.direction[6] > 0) continue;
      result.end = has_met ? Trace::End::met : Trace::End::arrived;
      return arrive(last, state.at, turned, goal, result.q) ? result : Trace();
    }
    return {};
  }

 private:
  struct State {
    Point at;
    Direction direction;
    double way;  ///< of the next step
  };
  static constexpr int most_steps = 300;
  static constexpr double shortest = 1e-9, longest = 0.1;

  /// One step, as long as the curve allows.
  [[nodiscard]] bool step(State& state) const {
    for (; state.way > shortest; state.way *= 0.25) {
      Point next = equations_.moved(state.at, state.direction, state.way);
      if (!equations_.settle_across(next, state.direction)) continue;
      const Direction direction = equations_.direction(next, state.direction);
      const double cosine = direction.dot(state.direction);
      if (!(cosine > 0.95)) continue;
      state = {next, direction, cosine > 0.995 ? std::min(longest, 2 * state.way) : state.way};
      return true;
    }
    return false;
  }

  /// Finds where the direction's path coordinate vanishes between two points, by bisection and secants.
  [[nodiscard]] bool locate(const State& before, const State& behind, Point& meeting) const {
    double low = 0, high = (behind.at.q - before.at.q).dot(before.direction.template head<6>()) +
                           (behind.at.u - before.at.u) / equations_.scale() * before.direction[6];
    double at_low = before.direction[6], at_high = behind.direction[6];
    for (int i = 0; i < 60; ++i) {
      const double secant = low + (high - low) * at_low / (at_low - at_high);
      const double way = i % 3 == 2 ? 0.5 * (low + high) : secant;
      meeting = equations_.moved(before.at, before.direction, way);
      if (!equations_.settle_across(meeting, before.direction)) return false;
      const double value = equations_.direction(meeting, before.direction)[6];
      if (std::abs(value) < 1e-10 || high - low < 1e-13) return true;
      (value > 0) == (at_low > 0) ? (low = way, at_low = value) : (high = way, at_high = value);
    }
    return true;
  }

  /// Brings the solution between two points to the goal. Behind a meeting joints change as the root of the
  /// way.
  [[nodiscard]] bool arrive(const Point& a, const Point& b, bool is_meeting, double goal, Values& q) const {
    const double even = b.u == a.u ? 1 : std::min(1.0, std::max(0.0, (goal - a.u) / (b.u - a.u)));
    const double share = is_meeting ? std::sqrt(even) : even;
    Point at{a.q + share * (b.q - a.q), goal};
    const Values start = at.q;
    const double allowed = 1e-6 + (b.q - a.q).cwiseAbs().maxCoeff();
    const bool settled = equations_.settle(at);
    q = at.q;
    return settled && (q - start).cwiseAbs().maxCoeff() < allowed;
  }

  const Equations<Arm>& equations_;
};

}  // namespace qvgen::path
