// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/path/place.h>
#include <qvgen/path/trace.h>

/// One step from a place of the path to the next: which solution becomes which, and for those that end or
/// begin on the way, where they meet another. Rows that the match leaves open are traced; a row that the
/// inverse kinematics has missed is found again so.
namespace qvgen::path {

/// Two solutions that meet, and are gone on one side.
struct Meeting {
  int first = -1, second = -1;  ///< rows, at the start for those that end, else at the goal
  Point at{Values::Zero(), 0};
};

/// The outcome of one step.
template <class Arm>
struct Step {
  static constexpr std::size_t most = Match<Arm>::capacity;
  bool is_sure = false;  ///< false: a shorter step is needed
  Match<Arm> match;
  std::array<Meeting, most> ended, begun;
  std::size_t ended_count = 0, begun_count = 0;
};

template <class Arm>
class Stepper {
 public:
  Stepper(const Arm& arm, const Equations<Arm>& equations, double longest)
      : arm_(arm), tracer_(equations), longest_(longest) {}

  /// `b` gains the rows that it lacks.
  [[nodiscard]] Step<Arm> step(const Place<Arm>& a, Place<Arm>& b) const {
    Step<Arm> step;
    step.match = matched(arm_, a, b, longest_);
    if (step.match.is_far) return step;
    const int ended = step.match.ended(a.found.size()), begun = step.match.begun(b.found.size());
    if (ended + begun == 0) {
      step.is_sure = true;
      return step;
    }
    if (ended + begun > most_open || !is_worth_tracing(a, b, step.match)) return step;
    step.is_sure = trace_ended(a, b, step) && trace_begun(a, b, step);
    return step;
  }

 private:
  static constexpr int most_open = 8;
  static constexpr double near = 1;  ///< rad or m, between solutions that may meet soon
  static constexpr double short_step = 1e-3;
  static constexpr double same = 1e-6;  ///< rad or m, between a traced row and a solved one

  /// Long traces cost more than halving the step.
  [[nodiscard]] bool is_worth_tracing(const Place<Arm>& a, const Place<Arm>& b,
                                      const Match<Arm>& match) const {
    return b.u - a.u < short_step || (have_neighbours(a, match.to) && have_neighbours(b, match.from));
  }
  [[nodiscard]] bool have_neighbours(const Place<Arm>& place,
                                     const std::array<int, Match<Arm>::capacity>& joined) const {
    for (int i = 0; i < place.found.size(); ++i) {
      if (joined[static_cast<std::size_t>(i)] >= 0) continue;
      bool has = false;
      for (int k = 0; k < place.found.size(); ++k)
        has = has || (k != i && joined[static_cast<std::size_t>(k)] < 0 &&
                      distance(place.found[i].q, place.found[k].q, arm_.revolute) < near);
      if (!has) return false;
    }
    return true;
  }

  [[nodiscard]] int row_at(const Place<Arm>& place, const Values& q) const {
    const Nearest nearest = Nearest::of(place.found, q, arm_.revolute);
    return nearest.first < same ? nearest.row : -1;
  }

  static bool is_in(const std::array<Meeting, Step<Arm>::most>& meetings, std::size_t count, int row) {
    for (std::size_t i = 0; i < count; ++i)
      if (meetings[i].first == row || meetings[i].second == row) return true;
    return false;
  }

  /// Takes a meeting, if the other row is open; false if it is not one of the place's.
  bool take(const Place<Arm>& place, const std::array<int, Match<Arm>::capacity>& joined, int row,
            const Trace& trace, std::array<Meeting, Step<Arm>::most>& meetings, std::size_t& count) const {
    const int other = row_at(place, trace.q);
    if (other < 0 || other == row || joined[static_cast<std::size_t>(other)] >= 0) return false;
    if (is_in(meetings, count, other)) return false;
    meetings[count++] = {row, other, trace.meeting};
    return true;
  }

  bool trace_ended(const Place<Arm>& a, Place<Arm>& b, Step<Arm>& step) const {
    for (int i = 0; i < a.found.size(); ++i) {
      if (step.match.to[static_cast<std::size_t>(i)] >= 0 || is_in(step.ended, step.ended_count, i)) continue;
      const Trace trace = tracer_.trace({a.found[i].q, a.u}, b.u);
      if (trace.end == Trace::End::lost) return false;
      if (trace.end == Trace::End::met) {
        if (!take(a, step.match.to, i, trace, step.ended, step.ended_count)) return false;
      } else if (!arrive(a, i, trace.q, b, step.match)) {
        return false;
      }
    }
    return true;
  }

  /// A traced row is one that was open, or one that has been missed.
  bool arrive(const Place<Arm>& a, int i, const Values& q, Place<Arm>& b, Match<Arm>& match) const {
    int j = row_at(b, q);
    if (j >= 0 && match.from[static_cast<std::size_t>(j)] >= 0) return false;
    if (j >= 0 && arm_.stable_branches && a.found[i].branch != b.found[j].branch) return false;
    if (j < 0) {
      if (b.found.size() == Arm::capacity) return false;
      j = b.found.size();
      auto& row = b.found.append();
      row = a.found[i];
      row.q = a.found[i].q + difference(q, a.found[i].q, arm_.revolute);
      b.positive[static_cast<std::size_t>(j)] = a.positive[static_cast<std::size_t>(i)];
    }
    match.join(i, j);
    return true;
  }

  bool trace_begun(const Place<Arm>& a, const Place<Arm>& b, Step<Arm>& step) const {
    for (int j = 0; j < b.found.size(); ++j) {
      if (step.match.from[static_cast<std::size_t>(j)] >= 0 || is_in(step.begun, step.begun_count, j))
        continue;
      const Trace trace = tracer_.trace({b.found[j].q, b.u}, a.u);
      if (trace.end == Trace::End::lost) return false;
      if (trace.end == Trace::End::met) {
        if (!take(b, step.match.from, j, trace, step.begun, step.begun_count)) return false;
      } else if (row_at(a, trace.q) >= 0) {
        return false;
      } else {
        step.begun[step.begun_count++] = {j, -1, {trace.q, a.u}};  // it was missed before
      }
    }
    return true;
  }

  const Arm& arm_;
  Tracer<Arm> tracer_;
  double longest_;
};

}  // namespace qvgen::path
