// SPDX-License-Identifier: MIT
// Values with limits along a path: of the joints themselves, or of motors that move them.
//
// Solutions are followed in joints, whose whole turns are plain. Where motors move the joints, limits are
// those of motors, and of joints that have limits beside them. Both are sums of multiples of the joints'
// values. A whole turn of a joint moves several of these values at once: the shifts of a track are sums of
// motions (qvgen/inverse/motor_turns.h), and values that no motion moves together are in blocks, whose shifts
// are chosen one block after the other.
//
// Example: tilt = (ml + mr)/2 and roll = (ml - mr)/2. A turn of the tilt moves both motors by a turn.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <qvgen/inverse/motor_turns.h>
#include <qvgen/path/held.h>

namespace qvgen::path {

/// Some values with limits that whole turns move together.
struct Block {
  int first, count;         ///< values
  int first_level, levels;  ///< motions
  /// True if whole turns of one value are all there is.
  [[nodiscard]] bool is_alone() const { return count == 1 && levels <= 1; }
};

/// Joints that have limits themselves.
class Uncoupled {
 public:
  static constexpr int values = 6;         ///< with limits
  static constexpr int given = 6;          ///< how many of them the caller gives limits for
  static constexpr int most_choices = 17;  ///< of whole turns in a block
  using Shift = Values;

  /// Returns the values of joints.
  static const Values& of(const Values& q) { return q; }
  /// Returns the ways of the values where the joints go a way.
  static const Values& ways(const Values& way) { return way; }
  /// Returns the rates at which a value changes with the joints.
  static Values gradient(int value) { return Values::Unit(value); }
  /// Returns limits of the values from those that the caller gives.
  static const JointLimits<values>& limits(const JointLimits<values>& given) { return given; }
  /// Returns bounds of the values from bounds of the joints.
  static const Values& lowest(const Values& low, const Values& /*high*/) { return low; }
  static const Values& highest(const Values& /*low*/, const Values& high) { return high; }
  /// Puts joints to where a value is, which they are at but for rounding.
  static void put(int value, double to, Values& q) { q[value] = to; }
  /// Returns by how much a value moves at least in whole turns; 0 for none.
  static double turn(int value, const JointKinds<6>& revolute) {
    return revolute[static_cast<std::size_t>(value)] ? whole_turn : 0;
  }
  static int blocks() { return values; }
  static Block block(int number) { return {number, 1, number, 1}; }
  static Shift motion(int level) { return whole_turn * Values::Unit(level); }
  /// Returns the joints' turns of a shift of the values.
  static const Values& joints(const Shift& shift) { return shift; }
  /// Returns what the caller reads: values of the joints, ways of theirs, and the name of a value.
  static const Values& shown(const Values& q) { return q; }
  static const Values& shown_way(const Values& way) { return way; }
  static int shown_index(int value) { return value; }
};

/// Joints that motors move. `Map` is generated (`detail::MotorMap` of an arm).
template <class Map>
class Coupled {
 public:
  static constexpr int values = Map::bounded;
  static constexpr int most_choices = 128;
  static constexpr int motors = Map::dof;
  static constexpr int given = values - (motors - 6);
  using Limited = Eigen::Matrix<double, values, 1>;
  using Shift = Limited;

  Coupled() : Coupled(Held{-1, 0}, -1) {}
  /// `held`: of seven joints the one that stays; `held_motor`: the motor that it is.
  Coupled(const Held& held, int held_motor) : held_(held), held_motor_(held_motor) {
    constant_ = Map::values(all_motors(Values::Zero()));
    for (int i = 0; i < 6; ++i) {
      rates_.col(i) = Map::values(all_motors(Values::Unit(i))) - constant_;
      motor_rates_.col(i) = all_motors(Values::Unit(i)) - all_motors(Values::Zero());
    }
    for (int i = 0; i < values; ++i) turns_[static_cast<std::size_t>(i)] = least_turn(i);
    set_blocks();
    set_indices();
  }

  /// Returns all motors of joints.
  [[nodiscard]] Joints<motors> all_motors(const Values& q) const {
    if constexpr (motors == 6)
      return Map::motors(q);
    else
      return Map::motors(held_.with(q));
  }
  /// Returns the Jacobian by joints from the one by motors.
  [[nodiscard]] Eigen::Matrix<double, 6, 6> by_joints(
      const Eigen::Matrix<double, 6, motors>& jacobian) const {
    return jacobian * motor_rates_;
  }
  /// Returns limits of all values from those that the caller gives: of six motors, then of joints that have
  /// limits of their own.
  [[nodiscard]] JointLimits<values> limits(const JointLimits<values>& given) const {
    JointLimits<values> limits;
    for (int i = 0; i < values; ++i) {
      const int index = shown_index(i);
      limits.lower[i] = index < 0 ? constant_[i] : given.lower[index];
      limits.upper[i] = index < 0 ? constant_[i] : given.upper[index];
    }
    return limits;
  }

  [[nodiscard]] Limited of(const Values& q) const { return rates_ * q + constant_; }
  [[nodiscard]] Values gradient(int value) const { return rates_.row(value).transpose(); }
  [[nodiscard]] Limited ways(const Values& way) const { return rates_ * way; }
  [[nodiscard]] Limited lowest(const Values& low, const Values& high) const {
    return constant_ + rates_.cwiseMax(0.0) * low + rates_.cwiseMin(0.0) * high;
  }
  [[nodiscard]] Limited highest(const Values& low, const Values& high) const { return lowest(high, low); }
  void put(int value, double to, Values& q) const {
    const Values gradient = this->gradient(value);
    const double square = gradient.squaredNorm();
    if (square > 0) q += (to - gradient.dot(q) - constant_[value]) / square * gradient;
  }
  [[nodiscard]] double turn(int value, const JointKinds<6>& /*revolute*/) const {
    return turns_[static_cast<std::size_t>(value)];
  }
  [[nodiscard]] int blocks() const { return block_count_; }
  [[nodiscard]] Block block(int number) const { return blocks_[static_cast<std::size_t>(number)]; }
  static Shift motion(int level) {
    Shift motion;
    for (int i = 0; i < values; ++i) motion[i] = Map::turns.motion[level][i];
    return motion;
  }
  [[nodiscard]] Values joints(const Shift& shift) const {
    Joints<motors> of_motors;
    for (int i = 0; i < values; ++i)
      if (motor_at(i) >= 0) of_motors[motor_at(i)] = shift[i];
    const Joints<motors> all = Map::joints(of_motors);
    if constexpr (motors == 6)
      return all;
    else
      return held_.without(all);
  }
  /// Returns the motors of joints without the one that is held.
  [[nodiscard]] Values shown(const Values& q) const { return moving(all_motors(q)); }
  [[nodiscard]] Values shown_way(const Values& way) const { return moving(motor_rates_ * way); }
  /// Returns the place of a value among what the caller gives limits for; -1 for the motor that is held.
  [[nodiscard]] int shown_index(int value) const { return indices_[static_cast<std::size_t>(value)]; }

 private:
  static int motor_at(int value) { return Map::motor_of[static_cast<std::size_t>(value)]; }

  [[nodiscard]] Values moving(const Joints<motors>& all) const {
    if constexpr (motors == 6)
      return all;
    else
      return Held{held_motor_, 0}.without(all);
  }

  /// The common measure of all motions of a value: a limit is met at these distances.
  static double least_turn(int value) {
    double common = 0;
    for (int level = 0; level < Map::turns.count; ++level)
      common = common_measure(common, std::abs(Map::turns.motion[level][value]));
    return common;
  }
  static double common_measure(double a, double b) {
    while (b > least_measure) {
      const double rest = std::abs(std::remainder(a, b));
      a = b;
      b = rest;
    }
    return a;
  }
  static constexpr double least_measure = 1e-5 * whole_turn;

  /// Values that never move come first.
  void set_blocks() {
    const int still = Map::turns.count > 0 ? Map::turns.pivot[0] : values;
    for (int i = 0; i < still; ++i) add_block({i, 1, 0, 0});
    for (int level = 0, first = 0; level < Map::turns.count; ++level) {
      if (!Map::turns.ends_block[level]) continue;
      const int value = Map::turns.pivot[first], end = Map::turns.pivot[level + 1];
      add_block({value, end - value, first, level + 1 - first});
      first = level + 1;
    }
  }
  void add_block(const Block& block) { blocks_[static_cast<std::size_t>(block_count_++)] = block; }

  /// Motors keep their order, joints with limits of their own come behind them in their order.
  void set_indices() {
    for (int i = 0; i < values; ++i) {
      int index = motor_at(i);
      if (index >= 0 && held_motor_ >= 0)
        index = index == held_motor_ ? -1 : index - (index > held_motor_ ? 1 : 0);
      if (motor_at(i) < 0) {
        index = 6;
        for (int k = 0; k < values; ++k)
          if (motor_at(k) < 0 && joint_of(k) < joint_of(i)) ++index;
      }
      indices_[static_cast<std::size_t>(i)] = index;
    }
  }
  /// The joint that a value which is no motor's is of.
  [[nodiscard]] int joint_of(int value) const {
    int joint = 0;
    rates_.row(value).cwiseAbs().maxCoeff(&joint);
    return joint;
  }

  Held held_;
  int held_motor_;
  Limited constant_;
  Eigen::Matrix<double, values, 6> rates_;
  Eigen::Matrix<double, motors, 6> motor_rates_;
  std::array<double, static_cast<std::size_t>(values)> turns_{};
  std::array<Block, static_cast<std::size_t>(values)> blocks_{};
  std::array<int, static_cast<std::size_t>(values)> indices_{};
  int block_count_ = 0;
};

}  // namespace qvgen::path
