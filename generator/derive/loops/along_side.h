// SPDX-License-Identifier: MIT
// A side of a loop, followed joint by joint from the common link: every joint turns what comes before it,
// under names of a program. Written out as one expression a chain would grow with a power of its length; here
// a derivative is a cross product with an axis, and second derivatives are those of velocities.
#pragma once

#include "derive/loops/cycle.h"

namespace qvgen::derive::loops {

/// A joint on the way along a side, in the common link's frame.
struct PassedJoint {
  std::size_t joint;
  bool turns;
  symbolic::Vector axis, point;
  symbolic::Vector to_next;  ///< from this point to that of the next joint, or to the side's end
};

/// A frame on the way along a side: where it is, and how it moves at the rates of the joints.
struct MovingFrame {
  symbolic::Matrix3 turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  symbolic::Vector point;
  symbolic::Vector spin, spin_rate;  ///< angular velocity, and its derivative without joint accelerations
  symbolic::Vector velocity, acceleration;  ///< of the point, likewise
};

/// Follows a side to its end; `moves`: with rates. Names are added to `program`.
class AlongSide {
 public:
  AlongSide(const model::Robot& robot, const Side& side, bool moves, symbolic::Program& program);

  [[nodiscard]] const std::vector<PassedJoint>& joints() const { return joints_; }
  [[nodiscard]] const MovingFrame& end() const { return at_; }
  /// A direction of the last link in the common link's frame.
  [[nodiscard]] symbolic::Vector seen(const symbolic::Vector& direction) const;

 private:
  void pass(std::size_t index);
  void turn(const std::string& variable, const symbolic::Vector& own, const symbolic::Vector& axis,
            const GiNaC::ex& rate);
  void slide(const std::string& variable, const symbolic::Vector& axis, const GiNaC::ex& rate);
  void displace(const model::Displacement& displacement);
  /// Goes on by a vector of the link.
  void go(const symbolic::Vector& by);
  /// Likewise by one in the common link's frame that turns with the link.
  void go_by(const symbolic::Vector& by);

  const model::Robot& robot_;
  bool moves_;
  symbolic::Program& program_;
  MovingFrame at_;
  std::vector<PassedJoint> joints_;
};

}  // namespace qvgen::derive::loops
