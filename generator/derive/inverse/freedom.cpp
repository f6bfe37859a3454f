// SPDX-License-Identifier: MIT
#include "derive/inverse/freedom.h"

#include <algorithm>
#include <utility>

namespace qvgen::derive::inverse {

using GiNaC::ex;
using GiNaC::numeric;
using symbolic::cross;
using symbolic::Vector;

namespace {

using Column = std::vector<numeric>;

/// The chain in numbers: the symbols at a sample point, the joints at rational points of the circle.
class Placed {
 public:
  Placed(const Attempt& attempt, long place) : scope_(attempt.scope) {
    for (const Screw& screw : attempt.chain.screws) {
      screws_.push_back(at_sample(screw));
      const long i = static_cast<long>(screws_.size());
      const ex t = ex(37 * i + 11 * place + 5) / ex(53 * i * place + 71);
      values_.push_back(screw.revolute ? std::pair<ex, ex>((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))
                                       : std::pair<ex, ex>(t, 0));
    }
    tool_ = carried(at_sample(attempt.chain.home.p), screws_.size());
  }

  /// Velocity of the tool point, then the angular velocity.
  [[nodiscard]] Column column(std::size_t joint) const { return column(joint, tool_); }
  /// Velocity of the tool point, then the part of the angular velocity across a direction of the base.
  [[nodiscard]] Column column_across(std::size_t joint, const Vector& up) const {
    Column all = column(joint);
    const Column across = numbers(Vector{0, 0, 0}, cross(at_sample(up), Vector{all[3], all[4], all[5]}));
    std::copy(across.begin() + 3, across.end(), all.begin() + 3);
    return all;
  }
  /// Returns the column of a tool point that joint `k` and those after it do not move; with joints at zero it
  /// is at `point`.
  [[nodiscard]] Column column_about(std::size_t joint, std::size_t k, const Vector& point) const {
    return column(joint, carried(at_sample(point), k));
  }

 private:
  [[nodiscard]] Column column(std::size_t joint, const Vector& at) const {
    const Screw& screw = screws_[joint];
    const Vector point = carried(screw.point, joint);
    const Vector axis = carried(screw.point + screw.axis, joint) - point;
    return screw.revolute ? numbers(cross(axis, at - point), axis) : numbers(axis, Vector{0, 0, 0});
  }
  [[nodiscard]] Vector at_sample(const Vector& v) const {
    return {scope_.value(v.x), scope_.value(v.y), scope_.value(v.z)};
  }
  [[nodiscard]] Screw at_sample(const Screw& screw) const {
    Screw result = screw;
    for (Vector Screw::*part : {&Screw::axis, &Screw::first, &Screw::second, &Screw::point})
      result.*part = at_sample(screw.*part);
    return result;
  }
  /// A point that moves with the joints before `count`.
  [[nodiscard]] Vector carried(Vector point, std::size_t count) const {
    while (count-- > 0) point = apply(screws_[count], values_[count].first, values_[count].second, point);
    return point;
  }
  [[nodiscard]] static Column numbers(const Vector& linear, const Vector& angular) {
    Column result;
    for (const Vector& v : {linear, angular})
      for (const ex& value : {v.x, v.y, v.z}) result.push_back(GiNaC::ex_to<numeric>(value));
    return result;
  }

  const Scope& scope_;
  std::vector<Screw> screws_;
  std::vector<std::pair<ex, ex>> values_;
  Vector tool_;
};

/// Elimination with the largest pivot; the columns' numbers have 60 digits.
bool independent(std::vector<Column> columns, std::size_t rows) {
  const numeric nothing = GiNaC::pow(numeric(10), numeric(-45));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::size_t pivot = 0;
    for (std::size_t r = 1; r < rows; ++r)
      if (GiNaC::abs(columns[k][r]) > GiNaC::abs(columns[k][pivot])) pivot = r;
    if (GiNaC::abs(columns[k][pivot]) < nothing) return false;
    for (std::size_t j = k + 1; j < columns.size(); ++j) {
      const numeric share = columns[j][pivot] / columns[k][pivot];
      for (std::size_t r = 0; r < rows; ++r) columns[j][r] = columns[j][r] - share * columns[k][r];
    }
  }
  return true;
}

}  // namespace

std::string dependent_joints(const Attempt& attempt, const std::vector<std::size_t>& joints,
                             bool position_only) {
  // Three places: a rational one may happen to be singular.
  for (const long place : {1, 2, 3}) {
    const Placed placed(attempt, place);
    std::vector<Column> columns;
    for (const std::size_t joint : joints) columns.push_back(placed.column(joint));
    if (independent(std::move(columns), position_only ? 3 : 6)) return "";
  }
  return std::string("at every pose some joints can move without moving the tool") +
         (position_only ? " point" : "") + ": the Jacobian's determinant vanishes everywhere";
}

std::string dependent_joints_of_pitch(const Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  for (const long place : {1, 2, 3}) {
    const Placed placed(attempt, place);
    std::vector<Column> columns;
    for (std::size_t joint = 0; joint < 4; ++joint) {
      Column column = placed.column(joint);
      const bool turns = joint > 0 && screws[joint].revolute;
      column[3] = turns ? attempt.scope.value(symbolic::dot(screws[joint].axis, screws[3].axis)) : numeric(0);
      columns.push_back(column);
    }
    if (independent(std::move(columns), 4)) return "";
  }
  return "at every pose some joints can move without moving the tool point or changing the pitch";
}

std::string dependent_joints_of_inclination(const Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  const Vector up = screws[0].axis;
  for (const long place : {1, 2, 3}) {
    const Placed placed(attempt, place);
    std::vector<Column> columns;
    for (std::size_t joint = 0; joint < screws.size(); ++joint)
      columns.push_back(placed.column_across(joint, up));
    if (independent(std::move(columns), 6)) return "";
  }
  return "at every pose some joints can move without moving the tool point or inclining the tool";
}

std::string dependent_joints_about(const Attempt& attempt, std::size_t k, const Vector& point) {
  for (const long place : {1, 2, 3}) {
    const Placed placed(attempt, place);
    std::vector<Column> columns;
    for (std::size_t joint = 0; joint < 4; ++joint)
      if (joint != k) columns.push_back(placed.column_about(joint, k, point));
    if (independent(std::move(columns), 3)) return "";
  }
  return "at every pose they can move without moving it";
}

std::string dependent_joints_of_level(const Attempt& attempt) {
  for (const long place : {1, 2, 3}) {
    const Placed placed(attempt, place);
    std::vector<Column> columns;
    for (std::size_t joint = 0; joint < 3; ++joint)
      columns.push_back(placed.column_about(joint, 3, attempt.chain.screws[3].point));
    if (independent(std::move(columns), 3)) return "";
  }
  return "at every pose some joints can move without moving the last axis";
}

}  // namespace qvgen::derive::inverse
