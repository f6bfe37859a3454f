// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>

#include <Eigen/SVD>
#include <qvgen/path/hidden.h>
#include <qvgen/path/on_limit.h>
#include <qvgen/path/record.h>

/// The tracks that are alive at a place of the path, row by row: which track each solution is on, its joints
/// with all turns that they have made, and the limits next to them. Steps are committed here.
namespace qvgen::path {

template <class Arm>
class Live {
 public:
  static constexpr std::size_t capacity = Place<Arm>::capacity;
  using Table = Record<Arm::capacity>;

  using Limits = LimitsOnTrack<typename Arm::Limited>;
  using Cell = typename Limits::Cell;

  Live(const Arm& arm, const Limits& limits, Table& record) : arm_(arm), limits_(limits), record_(record) {}

  [[nodiscard]] const Place<Arm>& place() const { return place_; }
  [[nodiscard]] bool is_open() const { return is_open_; }
  /// The rows stay, the place is the start of the next piece.
  void start_piece() { place_.u = 0; }
  /// Sets the path coordinate of the piece's start.
  void set_offset(double offset) { offset_ = offset; }
  [[nodiscard]] double offset() const { return offset_; }

  /// All rows of a place begin their tracks.
  void open(const Place<Arm>& place, double s, Cause cause) {
    place_ = place;
    is_open_ = true;
    for (int i = 0; i < place.found.size(); ++i)
      rows_[index(i)] = begun(place, i, end_of(s, cause, place.found[i].q));
  }

  /// All tracks end.
  void close(double s, Cause cause) {
    for (int i = 0; is_open_ && i < place_.found.size(); ++i)
      end(rows_[index(i)], end_of(s, cause, rows_[index(i)].u));
    is_open_ = false;
  }

  /// True if a value may touch a limit that no place of two steps shows.
  [[nodiscard]] bool touches(const Hidden<Arm>& hidden) const {
    for (int i = 0; limits_.some() && i < place_.found.size(); ++i)
      if (hidden.touch(i, rows_[index(i)].u, rows_[index(i)].cell)) return true;
    return false;
  }

  /// Sets the ways of all rows to the next place, and returns true if a value is nearer to a limit of its
  /// cell, at either end of a step, than the step is long.
  [[nodiscard]] bool nears_limits(const Place<Arm>& next, const Match<Arm>& match) {
    for (int i = 0; i < place_.found.size(); ++i) {
      const Row& row = rows_[index(i)];
      const Values& way = ways_[index(i)] =
          difference(next.found[match.to[index(i)]].q, row.u, arm_.revolute);
      if (!limits_.some()) continue;
      const auto& u = limits_.coupling().of(row.u);
      const Joints<Limits::count> room = (row.cell.above - u).cwiseMin(u - row.cell.below);
      if ((room.array() < 2 * limits_.coupling().ways(way).array().abs()).any()) return true;
    }
    return false;
  }

  /// Goes on to the next place by the ways that are set, where each row becomes one, none begins, and no
  /// limit is near.
  void leap(const Match<Arm>& match, const Place<Arm>& next) {
    for (int i = 0; i < place_.found.size(); ++i) {
      Row& row = rows_[index(i)];
      row.u += ways_[index(i)];
      if (row.track >= 0) widen(record_.track(row.track), row.u);
    }
    reorder(match, next);
    place_ = next;
  }

  /// Goes on to the next place by a step that is sure.
  void commit(const Equations<Arm>& equations, const Step<Arm>& step, const Place<Arm>& next) {
    end_meetings(equations, step, next);
    std::array<Row, capacity> rows;
    for (int j = 0; j < next.found.size(); ++j) {
      const int i = step.match.from[index(j)];
      if (i < 0) continue;
      rows[index(j)] = rows_[index(i)];
      move(equations, rows[index(j)], next.u, next.found[j].q);
    }
    begin_meetings(equations, step, next, rows);
    advance(next, rows);
  }

  /// Goes on over a singular pose at `at`, path coordinate, as far as rows are continuous there.
  void commit_across(const Equations<Arm>& equations, const Place<Arm>& next, double at) {
    const Match<Arm> match = matched_across(arm_, place_, next, 0.05);
    std::array<Row, capacity> rows;
    for (int i = 0; i < place_.found.size(); ++i)
      if (match.to[index(i)] < 0) end(rows_[index(i)], flip(at, rows_[index(i)].u));
    for (int j = 0; j < next.found.size(); ++j) {
      const int i = match.from[index(j)];
      if (i < 0) {
        rows[index(j)] = begun(next, j, flip(at, next.found[j].q));
        continue;
      }
      rows[index(j)] = rows_[index(i)];
      cross(place_, i, next, j, at);
      move(equations, rows[index(j)], next.u, next.found[j].q);
    }
    advance(next, rows);
  }

  /// Writes the joints at a sample.
  void keep(std::size_t sample) {
    if (!record_.keeps_samples()) return;
    const int count = is_open_ ? place_.found.size() : 0;
    for (std::size_t i = 0; i < capacity; ++i)
      record_.keep(sample, i, i < index(count) ? rows_[i].track : -1, rows_[i].u);
  }

 private:
  struct Row {
    int track = -1;
    Values u = Values::Zero();
    Cell cell;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  /// Brings the rows in the order of the next place.
  void reorder(const Match<Arm>& match, const Place<Arm>& next) {
    int same = 0;
    while (same < next.found.size() && match.from[index(same)] == same) ++same;
    if (same == next.found.size()) return;
    std::array<Row, capacity> rows;
    for (int j = 0; j < next.found.size(); ++j) rows[index(j)] = rows_[index(match.from[index(j)])];
    rows_ = rows;
  }
  static End end_of(double s, Cause cause, const Values& q, int partner = -1) {
    End end;
    end.s = s;
    end.cause = cause;
    end.q = q;
    end.partner = partner;
    return end;
  }

  void advance(const Place<Arm>& next, const std::array<Row, capacity>& rows) {
    place_ = next;
    rows_ = rows;
  }

  Row begun(const Place<Arm>& place, int row, const End& end) {
    Row result;
    result.u = place.found[row].q;
    result.cell = limits_.around(result.u);
    result.track = record_.begin_track();
    if (result.track < 0) return result;
    Track& track = record_.track(result.track);
    track.begin = end;
    track.lowest = track.highest = result.u;
    track.first_branch = track.last_branch = arm_.stable_branches ? place.found[row].branch : -1;
    widen(track, end.q);
    return result;
  }

  static void widen(Track& track, const Values& u) {
    track.lowest = track.lowest.cwiseMin(u);
    track.highest = track.highest.cwiseMax(u);
  }

  void end(const Row& row, const End& end) {
    if (row.track < 0) return;
    record_.track(row.track).end = end;
    widen(record_.track(row.track), end.q);
  }

  /// The joints of a row at the next place, and the limits on the way.
  void move(const Equations<Arm>& equations, Row& row, double to, const Values& q) {
    const Values u = row.u + difference(q, row.u, arm_.revolute);
    if (limits_.some())
      see_limits(
          row, u,
          [&](double place, const Values& guess) {
            Point at{guess, place};
            return equations.settle(at) ? at.q : guess;
          },
          place_.u, to, &equations);
    row.u = u;
    if (row.track >= 0) widen(record_.track(row.track), u);
  }

  /// Notes each limit between the row's joints and others; `solve` brings joints to the path. With equations
  /// the way has no meeting at its ends.
  template <class Solve>
  void see_limits(Row& row, const Values& u, const Solve& solve, double from, double to,
                  const Equations<Arm>* equations = nullptr) {
    const auto& last = limits_.coupling().of(u);
    for (int i = 0; i < Limits::count; ++i) {
      for (int k = 0; k < 64 && is_beyond(row.cell, i, last[i]); ++k) {
        const bool rises = last[i] > row.cell.above[i];
        const double value = rises ? row.cell.above[i] : row.cell.below[i];
        Point at{row.u, from};
        if (equations == nullptr || !settle_on(*equations, limits_.coupling(), row.u, u, i, value, to, at)) {
          const double place = place_on(limits_.coupling(), row.u, u, i, value, solve, from, to);
          at = {solve(place, row.u + (place - from) / (to - from) * (u - row.u)), place};
        }
        note(row, i, value, rises, at.u, at.q);
        limits_.enclose(row.cell, i, value + (rises ? limit_slack : -limit_slack));
      }
    }
  }

  static bool is_beyond(const Cell& cell, int i, double u) {
    return u > cell.above[i] + limit_slack || u < cell.below[i] - limit_slack;
  }

  void note(const Row& row, int limited, double value, bool rises, double place, const Values& q) {
    for (const bool upper : {false, true}) {
      if (!limits_.is_on(limited, upper, value)) continue;
      Event event;
      event.s = offset_ + place;
      event.track = row.track;
      event.limited = limited;
      event.is_upper = upper;
      event.rises = rises;
      event.value = value;
      event.q = q;
      limits_.coupling().put(limited, value, event.q);
      record_.add(event);
    }
  }

  /// Returns a function that solves for a place between a meeting and another point: joints change as the
  /// root of the way from the meeting.
  static auto next_to(const Equations<Arm>& equations, const Point& meeting, const Point& other) {
    return [&equations, meeting, other](double place, const Values&) {
      const Values way = other.q - meeting.q;
      const double share = std::sqrt(std::max(0.0, (place - meeting.u) / (other.u - meeting.u)));
      const Values guess = meeting.q + share * way;
      Point at{guess, place};
      return equations.settle(at) && (at.q - guess).norm() < 0.5 * way.norm() + 1e-9 ? at.q : guess;
    };
  }

  /// Goes on to a meeting, past limits.
  void move_to_meeting(const Equations<Arm>& equations, Row& row, const Meeting& meeting) {
    const Values u = row.u + difference(meeting.at.q, row.u, arm_.revolute);
    const auto solve = next_to(equations, {u, meeting.at.u}, {row.u, place_.u});
    if (limits_.some()) see_limits(row, u, solve, place_.u, meeting.at.u);
    row.u = u;
  }

  static constexpr double same_place = 1e-9;

  /// Rows that go on from the start of a step to its end.
  static int passing_rows(const Step<Arm>& step, const Place<Arm>& next) {
    return next.found.size() - step.match.begun(next.found.size());
  }

  /// True if a row that ends on a step is still there at a place, or one that begins is there already.
  static bool are_alive(const Step<Arm>& step, double u) {
    for (std::size_t k = 0; k < step.ended_count; ++k)
      if (step.ended[k].at.u > u) return true;
    for (std::size_t k = 0; k < step.begun_count; ++k)
      if (step.begun[k].at.u < u) return true;
    return false;
  }

  void end_meetings(const Equations<Arm>& equations, const Step<Arm>& step, const Place<Arm>& next) {
    const int passing = passing_rows(step, next);
    for (std::size_t k = 0; k < step.ended_count; ++k) {
      const Meeting& meeting = step.ended[k];
      const bool others = passing > 0 || are_alive(step, meeting.at.u + same_place);
      const Cause cause = others ? Cause::meeting : Cause::boundary;
      for (const bool second : {false, true}) {
        Row& row = rows_[index(second ? meeting.second : meeting.first)];
        const Row& other = rows_[index(second ? meeting.first : meeting.second)];
        move_to_meeting(equations, row, meeting);
        end(row, end_of(offset_ + meeting.at.u, cause, row.u, other.track));
      }
    }
  }

  void begin_meetings(const Equations<Arm>& equations, const Step<Arm>& step, const Place<Arm>& next,
                      std::array<Row, capacity>& rows) {
    const int passing = passing_rows(step, next);
    for (std::size_t k = 0; k < step.begun_count; ++k) {
      const Meeting& meeting = step.begun[k];
      const bool others = passing > 0 || are_alive(step, meeting.at.u - same_place);
      const Cause cause = others ? Cause::meeting : Cause::boundary;
      const double s = offset_ + meeting.at.u;
      const auto start = [&](int j) {
        Place<Arm> place;
        place.found.append() = next.found[j];
        place.found[0].q = next.found[j].q + difference(meeting.at.q, next.found[j].q, arm_.revolute);
        return begun(place, 0, end_of(s, meeting.second < 0 ? Cause::unclear : cause, place.found[0].q));
      };
      for (const int j : {meeting.first, meeting.second})
        if (j >= 0) rows[index(j)] = start(j);
      if (meeting.second >= 0) pair(rows[index(meeting.first)].track, rows[index(meeting.second)].track);
      record_.is_doubtful = record_.is_doubtful || meeting.second < 0;
    }
    finish_begun(equations, step, next, rows);
  }

  void pair(int first, int second) {
    if (first >= 0) record_.track(first).begin.partner = second;
    if (second >= 0) record_.track(second).begin.partner = first;
  }

  /// From the meeting on to the next place.
  void finish_begun(const Equations<Arm>& equations, const Step<Arm>& step, const Place<Arm>& next,
                    std::array<Row, capacity>& rows) {
    for (std::size_t k = 0; k < step.begun_count; ++k) {
      const Meeting& meeting = step.begun[k];
      for (const int j : {meeting.first, meeting.second}) {
        if (j < 0) continue;
        Row& row = rows[index(j)];
        const Values u = row.u + difference(next.found[j].q, row.u, arm_.revolute);
        const auto solve = next_to(equations, {row.u, meeting.at.u}, {u, next.u});
        if (limits_.some()) see_limits(row, u, solve, meeting.at.u, next.u);
        row.u = u;
        if (row.track >= 0) widen(record_.track(row.track), u);
      }
    }
  }

  /// A row that passes a singular pose, if it does.
  void cross(const Place<Arm>& a, int i, const Place<Arm>& b, int j, double at) {
    const int before = a.found[i].branch, behind = b.found[j].branch;
    const bool crosses =
        arm_.stable_branches ? before != behind : a.positive[index(i)] != b.positive[index(j)];
    const int track = rows_[index(i)].track;
    if (!crosses || track < 0) return;
    Event event;
    event.s = at;
    event.track = track;
    event.kind = Event::Kind::crossing;
    event.branch_before = arm_.stable_branches ? before : -1;
    event.branch_behind = arm_.stable_branches ? behind : -1;
    record_.add(event);
    ++record_.track(track).crossings;
    record_.track(track).last_branch = event.branch_behind;
  }

  /// A stop at a singular pose, with the joints that are free there.
  End flip(double at, const Values& q) const {
    End end = end_of(at, Cause::unclear, q);
    const Eigen::JacobiSVD<Eigen::Matrix<double, 6, 6>> svd(arm_.jacobian(q), Eigen::ComputeFullV);
    if (!(svd.singularValues()[5] < 1e-3 * svd.singularValues()[0])) return end;
    end.cause = Cause::flip;
    const Values null = svd.matrixV().col(5).cwiseAbs();
    for (int i = 0; i < 6; ++i)
      if (null[i] > 0.3 * null.maxCoeff()) end.free |= 1U << static_cast<unsigned>(i);
    return end;
  }

  const Arm& arm_;
  const Limits& limits_;
  Table& record_;
  Place<Arm> place_;
  std::array<Row, capacity> rows_;
  std::array<Values, capacity> ways_;  ///< to the next place
  double offset_ = 0;
  bool is_open_ = false;
};

}  // namespace qvgen::path
