// SPDX-License-Identifier: MIT
#pragma once

#include "derive/jacobian/definition.h"
#include "derive/jacobian/frames.h"

namespace qvgen::derive {

/// The joints' axes and the vectors between them, all written out in one frame of the linkage, and their
/// derivatives by time as seen from the base: those of a vector fixed to a link are omega x v, and omega x
/// (omega x v) + alpha x v, with the link's angular velocity omega and, at constant joint rates, acceleration
/// alpha.
///
/// Splits the offset between two axes into a part along the one, a part along the other and a rest, so that
/// the axes' derivatives serve for the vectors too: omega x z is there already.
class AxesInMotion {
 public:
  enum class Order { first, second };
  AxesInMotion(symbolic::Program& program, const Linkage& linkage, std::size_t frame,
               const Frames::RateOf& rate_of, Order order);

  /// The columns of the Jacobian, differentiated, in the base frame: for a revolute joint with the vector r
  /// from its axis to the tool point (z' x r + z x r', z').
  std::vector<Twist> column_rates();
  /// The tool's acceleration at constant joint rates in the base frame.
  Twist acceleration();

 private:
  /// Link behind the first k pivots.
  struct Link {
    symbolic::Vector velocity;      ///< angular
    symbolic::Vector acceleration;  ///< angular, if it is wanted
  };
  /// The vector from behind the first k pivots to the next one or to the tool: along the axis before, and all
  /// else.
  struct Step {
    Moving along;
    Moving across;
  };
  void turn_all();
  void step_all();
  Moving fixed(std::size_t pivots, const symbolic::Vector& v);
  Moving let(const Moving& v);
  [[nodiscard]] Moving scaled(const GiNaC::ex& s, const GiNaC::ex& rate, const Moving& v) const;
  [[nodiscard]] const Linkage::Way& way(std::size_t pivots) const;
  Twist to_base(const Twist& twist);

  symbolic::Program& program_;
  const Linkage& linkage_;
  Frames frames_;
  std::size_t frame_;
  Frames::RateOf rate_of_;
  Order order_;
  std::vector<Moving> axes_;  ///< of each pivot
  std::vector<Link> links_;   ///< one more than pivots
  std::vector<Step> steps_;   ///< likewise
};

}  // namespace qvgen::derive
