// SPDX-License-Identifier: MIT
#pragma once

#include "reduced.h"

namespace qvgen::inverse::certified {

/// Values of the angles that a reduced loop has left, those of its first side first.
struct Box {
  Interval angle[most_unknown];
};

/// Region with at most one solution of the reduced equations: all angles within `radius` of a row.
struct Region {
  double centre[most_unknown];
  double radius = 0;  ///< 0: none is known
};

/// Equations g(a) - h(b) = 0 of a reduced loop: as many unknown angles, and as many equations or more.
class Equations {
 public:
  explicit Equations(const Reduced& reduced);

  [[nodiscard]] int unknowns() const { return unknowns_; }
  /// The joint whose angle the unknown is.
  [[nodiscard]] int joint(int unknown) const { return joint_[unknown]; }

  /// True if some equation has certainly no zero in a box.
  [[nodiscard]] bool exclude(const Box& box) const;
  /// Leaves of a box what may hold a zero by Krawczyk's operator; false if nothing does.
  [[nodiscard]] bool narrow(Box& box) const;
  /// The largest that is found, around the angles of a row.
  [[nodiscard]] Region region_around(const double (&row)[joints]) const;

 private:
  struct Values {
    Interval value[most_functions];
    Interval slope[most_functions][most_unknown];
  };
  struct Centred;

  [[nodiscard]] Values values(const Box& box, bool with_slopes) const;
  void add_side(const Side& side, int first, const SineCosine* at, double sign, bool with_slopes,
                Values& result) const;

  Reduced reduced_;
  int unknowns_ = 0;
  int joint_[most_unknown] = {};
};

}  // namespace qvgen::inverse::certified
