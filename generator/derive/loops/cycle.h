// SPDX-License-Identifier: MIT
// A closure and the joints around it. The two links that meet have a last common link; from it one side of
// the loop leads to either end. Points and directions are carried along a side, joint by joint, so that an
// equation can be written in the frame of whichever joint it is to be solved for.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "derive/inverse/scope.h"
#include "model/mechanism.h"

namespace qvgen::derive::loops {

/// One side of a loop: its joints, in order, and the point at its end in the last link's frame.
struct Side {
  std::vector<std::size_t> joints;
  symbolic::Vector point;
};

/// A closure with both of its sides. Expressions are in the names of `with_private_names`.
struct Cycle {
  std::size_t number = 0;  ///< in the order of the file, from 1
  model::LoopType type = model::LoopType::pin;
  std::array<Side, 2> sides;
  GiNaC::ex length = 0;                          ///< of a rod
  std::optional<std::size_t> length_joint = {};  ///< slide whose value the length is
  /// Unit vector that all axes of the loop are parallel to and all slides at right angles to, in the frame of
  /// the common link; nothing if the loop moves in space.
  std::optional<symbolic::Vector> normal = {};
  symbolic::Quaternion turn = {};  ///< of a weld or a slide: the second link as seen from the first
  /// Unit vectors that both links of a weld or a slide have, in the frame of each; that of a slide comes
  /// first. One across the normal, or three at right angles to each other.
  std::vector<std::array<symbolic::Vector, 2>> directions = {};
  /// Joints that gears tie: their values, each times its factor, sum up to the offset.
  std::vector<std::pair<std::size_t, cln::cl_RA>> gear = {};
  GiNaC::ex offset = 0;  ///< rad or m; the `turn` of an angle is about z by it
  /// Factors of the second power of the only leader's value less `powers_from`, of the third, and so on. The
  /// joint of `gear` that comes first follows, and the second leads.
  std::vector<cln::cl_RA> powers = {};
  GiNaC::ex powers_from = 0;  ///< rad or m

  /// Joints of both sides and that of the length, sorted.
  [[nodiscard]] std::vector<std::size_t> joints() const;
};

/// Returns how many equations a closure is.
std::size_t rows_of(const Cycle& cycle);

/// Returns how many closures and gears have a joint.
std::ptrdiff_t equations_with(const std::vector<Cycle>& cycles, std::size_t joint);

/// Returns two directions across a vector, at right angles to each other and of its length: coordinate axes
/// where the vector is one.
std::array<symbolic::Vector, 2> across(const symbolic::Vector& normal);

/// Returns the cycles of a mechanism, in the order of its closures, then its gears. `robot` is its robot with
/// private names and named angles. Throws std::domain_error if a closure does not let its loop's joints move
/// in their plane, and if an angle of gears is a symbol.
std::vector<Cycle> cycles_of(const model::Mechanism& mechanism, const model::Robot& robot,
                             const inverse::Scope& scope);

/// Values of joints, and what becomes of long expressions on the way along a side.
struct Carrier {
  const model::Robot& robot;
  /// Cosine and sine of a turn, or the length of a slide in `cosine`.
  std::function<inverse::Scope::Turn(std::size_t joint)> value;
  std::function<symbolic::Vector(const symbolic::Vector&)> name = {};

  /// From the frame in front of joint `from`'s motion (place in the side) to the frame behind that of joint
  /// `to`, an earlier one; -1: to the common link's frame.
  [[nodiscard]] symbolic::Vector lifted(const Side& side, int from, const symbolic::Vector& x, int to) const;
  [[nodiscard]] symbolic::Vector lifted_direction(const Side& side, int from, const symbolic::Vector& d,
                                                  int to) const;
  /// The way back.
  [[nodiscard]] symbolic::Vector lowered(const Side& side, int from, const symbolic::Vector& x, int to) const;
  [[nodiscard]] symbolic::Vector lowered_direction(const Side& side, int from, const symbolic::Vector& d,
                                                   int to) const;
  /// The side's point in the frame behind joint `to`'s motion; -1: in the common link's frame.
  [[nodiscard]] symbolic::Vector end(const Side& side, int to) const;
  /// Likewise a direction of the side's last link.
  [[nodiscard]] symbolic::Vector end_direction(const Side& side, const symbolic::Vector& d, int to) const;
  /// From the frame behind the motion of joint `from` to that of the side's last link.
  [[nodiscard]] symbolic::Vector at_end(const Side& side, int from, const symbolic::Vector& x,
                                        bool is_direction) const;

 private:
  [[nodiscard]] symbolic::Vector moved(std::size_t joint, const symbolic::Vector& x, bool back,
                                       bool is_direction) const;
};

}  // namespace qvgen::derive::loops
