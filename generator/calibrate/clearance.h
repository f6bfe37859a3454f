// SPDX-License-Identifier: MIT
// Distances between the spheres of an arm, at postures and on straight motions of all joints between them.
// Spheres of one link and of neighbours, which touch at their joint, are not compared.
//
// A motion is followed in steps that prove themselves: no two spheres can come together faster than the
// joints between them move them, so a gap lasts for a while (conservative advancement, Mirtich 1996). Nothing
// is missed between two steps.
#pragma once

#include <string>
#include <vector>

#include "calibrate/chain.h"
#include "calibrate/spheres.h"

namespace qvgen::calibrate {

class Clearance {
 public:
  /// `least` is the distance to keep, m.
  Clearance(const Geometry<double>& geometry, const std::vector<Sphere>& spheres, double least);

  [[nodiscard]] bool empty() const { return pairs_.empty(); }
  /// True if all pairs keep the distance at these joint values (rad, m), one for each joint that follows
  /// none.
  [[nodiscard]] bool kept_at(const std::vector<double>& q) const;
  /// True if they keep it all the way while the joint values change in proportion. Gaps that shrink to next
  /// to nothing count as closed.
  [[nodiscard]] bool kept_between(const std::vector<double>& from, const std::vector<double>& to) const;

  /// Stops comparing pairs that are too near at all of these postures, for the arm is built so. Returns their
  /// links in words: "link 4 and link 6".
  std::vector<std::string> leave_out_constant(const std::vector<std::vector<double>>& postures);
  /// Returns the links of the pair that is too near at most of these postures, in words.
  [[nodiscard]] std::string nearest_links(const std::vector<std::vector<double>>& postures) const;

 private:
  struct Pair {
    std::size_t a, b;  ///< spheres; the link of b is further from the base
    double distance;   ///< of the centres, to keep
  };

  /// Returns how much more than the distance to keep a pair has, m.
  static double gap(const Pair& pair, const std::vector<Vec<double>>& centres);
  [[nodiscard]] std::vector<Vec<double>> centres_at(const std::vector<double>& q) const;
  [[nodiscard]] std::vector<double> speeds(const std::vector<double>& from,
                                           const std::vector<double>& to) const;
  [[nodiscard]] double speed(const Pair& pair, const std::vector<double>& by,
                             const std::vector<double>& slides) const;
  [[nodiscard]] std::string words(const Pair& pair) const;

  const Geometry<double>& geometry_;
  std::vector<Sphere> spheres_;
  std::vector<Pair> pairs_;
};

}  // namespace qvgen::calibrate
