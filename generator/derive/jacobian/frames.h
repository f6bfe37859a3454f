// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "derive/jacobian/linkage.h"
#include "symbolic/program.h"

namespace qvgen::derive {

/// A vector in some frame of the linkage, and the first and second derivative of its components there by
/// time, at constant joint rates. Derivatives are literal zeros where nothing asks for them, and then cost
/// nothing.
struct Moving {
  symbolic::Vector value;
  symbolic::Vector rate;
  symbolic::Vector second;
};
Moving operator+(const Moving& a, const Moving& b);
/// s * v for a constant s.
Moving operator*(const GiNaC::ex& s, const Moving& v);

/// Velocity of the tool point and of the tool for the unit rate of one joint; or for all rates: a twist.
struct MovingTwist {
  Moving linear;
  Moving angular;
};

/// The frames of a linkage: frame 0 is the base, frame k lies behind the k-th group of pivots with parallel
/// axes. Everything is named in the program as it is computed.
class Frames {
 public:
  using RateOf = std::function<GiNaC::ex(std::size_t joint)>;
  /// `rate_of` gives the rates of the joint variables where rates are wanted.
  Frames(symbolic::Program& program, const Linkage& linkage, const RateOf& rate_of = {});

  [[nodiscard]] std::size_t last() const { return groups_.size(); }

  struct Column {
    std::size_t frame = 0;  ///< where it is given
    MovingTwist twist;
    symbolic::Vector reach;  ///< of a revolute joint: from it to the tool point, in the same frame
  };
  /// Column of each joint in front of its group of parallel joints, where its axis is a constant.
  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
  /// Columns behind the group.
  [[nodiscard]] const std::vector<Column>& columns_behind() const { return behind_; }

  /// From the base's origin to the tool point, in the base frame.
  [[nodiscard]] const Moving& position() const { return position_; }

  /// Returns a vector in another frame, one group's turn after the other.
  Moving move(Moving v, std::size_t from, std::size_t to);
  MovingTwist move(const MovingTwist& twist, std::size_t from, std::size_t to);
  /// A vector given behind the first pivots of the linkage.
  symbolic::Vector brought(std::size_t pivots, const symbolic::Vector& v, std::size_t to);
  /// From the last frame into the tool's.
  MovingTwist to_tool(const MovingTwist& twist);

 private:
  struct Group {
    symbolic::Vector axis;
    GiNaC::ex angle = 0;  ///< of all its pivots so far
    GiNaC::ex rate = 0;
  };
  struct Place {
    std::size_t group;
    GiNaC::ex angle;  ///< from the front of the group to behind this pivot
    GiNaC::ex rate;
    bool ends_group = false;
  };
  void group_pivots();
  void reach();
  void add_slides(const Linkage::Way& way, int pivot);
  void add_column(std::size_t pivot, const Moving& front, const Moving& back);
  Moving travelled(const Linkage::Way& way) const;
  Moving name(const Moving& v);
  Moving turned(const symbolic::Vector& axis, const GiNaC::ex& angle, const GiNaC::ex& rate, const Moving& v);

  symbolic::Program& program_;
  const Linkage& linkage_;
  RateOf rate_of_;
  std::vector<Group> groups_;
  std::vector<Place> places_;
  std::vector<Column> columns_;
  std::vector<Column> behind_;
  Moving position_;
};

}  // namespace qvgen::derive
