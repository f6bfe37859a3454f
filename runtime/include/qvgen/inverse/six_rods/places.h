// SPDX-License-Identifier: MIT
// Every place of a platform on six rods for given lengths: from each of the places for random complex
// lengths, which the generator has found for this platform, a path leads to one for the lengths that are
// asked for. All are there if as many different ones are proven as paths began. Fixed sizes, no heap, no
// exceptions.
#pragma once

#include <array>
#include <cmath>

#include <qvgen/inverse/six_rods/path.h>
#include <qvgen/inverse/six_rods/proof.h>

namespace qvgen::inverse::six_rods {

/// A platform with all its places for some complex lengths. Ends are in units of `unit` metres, from the
/// centres.
template <int count>
struct Start {
  double unit;
  std::array<double, 3> base_centre, platform_centre;  ///< m, in the frames of the base and of the platform
  Ends<double> ends;
  PerRod<Complex> squares;  ///< of the lengths at the start
  Patch patch;
  std::array<Point, static_cast<std::size_t>(count)> points;
};

/// A place: the platform's frame as seen from the base.
struct Place {
  std::array<double, 4> turn{};      ///< w x y z, of length one
  std::array<double, 3> position{};  ///< m
  int path = 0;                      ///< index of the point at the start that led here
  bool meets = false;  ///< not proven: two places, or a real and a complex one, nearly meet here
};

template <int count>
struct Places {
  std::array<Place, static_cast<std::size_t>(count)> rows{};
  int size = 0;
  int proven = 0;  ///< different complex places that are proven, real ones among them
  /// As many as there can be are proven, each real or certainly not; or rods cannot meet, by their lengths
  /// alone.
  bool complete = false;
};

namespace detail {

/// Turns a vector by a quaternion of length one.
inline std::array<double, 3> turned(const std::array<double, 4>& x, const std::array<double, 3>& v) {
  const auto cross = [&](const std::array<double, 3>& w, std::size_t i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    return x[1 + j] * w[k] - x[1 + k] * w[j];
  };
  std::array<double, 3> half{}, result{};
  for (std::size_t i = 0; i < 3; ++i) half[i] = cross(v, i) + x[0] * v[i];
  for (std::size_t i = 0; i < 3; ++i) result[i] = v[i] + 2 * cross(half, i);
  return result;
}

/// Place of a point that is real but for rounding.
template <int count>
Place place_of(const Start<count>& start, const Point& z, std::size_t path) {
  Place place;
  place.path = static_cast<int>(path);
  double norm = 0;
  for (std::size_t i = 0; i < 4; ++i) norm += z[i].re * z[i].re;
  const double scale = 1 / std::sqrt(norm);
  std::array<double, 4> x{}, y{};
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = place.turn[i] = z[i].re * scale;
    y[i] = z[4 + i].re * scale;
  }
  const std::array<double, 3> centre = turned(place.turn, start.platform_centre);
  for (std::size_t i = 0; i < 3; ++i) {  // the vector of y times x conjugate
    const std::size_t j = 1 + (i + 1) % 3, k = 1 + (i + 2) % 3;
    const double between = x[0] * y[1 + i] - y[0] * x[1 + i] - (y[j] * x[k] - y[k] * x[j]);
    place.position[i] = start.base_centre[i] + start.unit * between - centre[i];
  }
  return place;
}

/// Imaginary parts, and distances, of unproven places that may be real ones which meet: the root of rounding.
inline constexpr double nearly = 1e-6;

/// Follows all paths and keeps what is proven of their ends.
template <int count>
class Search {
 public:
  Search(const Start<count>& start, const std::array<double, rod_count>& lengths)
      : start_(start),
        equations_(start.ends),
        squares_(squares_of(start.unit, lengths)),
        curvatures_(equations_.curvatures(squares_)),
        path_(equations_, start.patch, start.squares, squares_) {}

  Places<count> run() {
    if (cannot_meet()) return none();
    again_.fill(true);
    follow({});
    for (const Pace& pace : {Pace{1e-8, 600}, Pace{1e-11, 1200}}) {
      note_doubtful();
      follow(pace);
    }
    return result();
  }

 private:
  static constexpr auto paths = static_cast<std::size_t>(count);

  static Places<count> none() {
    Places<count> found;
    found.complete = true;
    return found;
  }
  /// True if two lengths differ by more than the distances of their rods' ends, so that no real place has
  /// them.
  [[nodiscard]] bool cannot_meet() const {
    constexpr double rounded = 1 + 1e-12;
    const Ends<double>& ends = start_.ends;
    for (std::size_t i = 0; i < rod_count; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const double most =
            distance(ends.base[i], ends.base[k]) + distance(ends.platform[i], ends.platform[k]);
        const double a = std::sqrt(squares_[i].re), b = std::sqrt(squares_[k].re);
        if (std::abs(a - b) > rounded * most + (rounded - 1) * (a + b)) return true;
      }
    return false;
  }
  static double distance(const Vector<double>& a, const Vector<double>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  static PerRod<Complex> squares_of(double unit, const std::array<double, rod_count>& lengths) {
    PerRod<Complex> squares;
    for (std::size_t i = 0; i < rod_count; ++i) squares[i].re = lengths[i] / unit * (lengths[i] / unit);
    return squares;
  }

  void follow(const Pace& pace) {
    for (std::size_t i = 0; i < paths; ++i) {
      if (!again_[i]) continue;
      ends_[i] = start_.points[i];
      proofs_[i] =
          path_.follow(ends_[i], pace) ? prove(equations_, curvatures_, squares_, ends_[i]) : Proof{};
    }
  }
  /// Notes the paths without proof, and those that have led to one place together.
  void note_doubtful() {
    for (std::size_t i = 0; i < paths; ++i) again_[i] = !proofs_[i].proven;
    for (std::size_t i = 0; i < paths; ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (are_one(i, k)) again_[i] = again_[k] = true;
  }
  [[nodiscard]] bool are_one(std::size_t i, std::size_t k) const {
    return proofs_[i].proven && proofs_[k].proven && !are_different(proofs_[i], proofs_[k]);
  }
  [[nodiscard]] bool is_known(std::size_t i) const {
    for (std::size_t k = 0; k < i; ++k)
      if (are_one(i, k)) return true;
    return false;
  }

  Places<count> result() {
    Places<count> found;
    bool are_decided = true;
    for (std::size_t i = 0; i < paths; ++i) {
      if (!proofs_[i].proven || is_known(i)) continue;
      ++found.proven;
      are_decided = are_decided && (proofs_[i].is_real() || proofs_[i].is_not_real());
      if (proofs_[i].is_real()) append(proofs_[i].z, i, false, found);
    }
    found.complete = found.proven == count && are_decided;
    if (!found.complete)
      for (std::size_t i = 0; i < paths; ++i) add_meeting(i, found);
    return found;
  }

  void append(const Point& z, std::size_t path, bool meets, Places<count>& found) const {
    Place place = place_of(start_, z, path);
    place.meets = meets;
    found.rows[static_cast<std::size_t>(found.size++)] = place;
  }
  /// Adds the end of a path without proof where it is real to half of the digits and solves the equations.
  void add_meeting(std::size_t i, Places<count>& found) {
    if (proofs_[i].proven && !is_undecided(i)) return;
    path_.approach_end(ends_[i]);
    if (!is_finite(ends_[i])) return;
    Point z = scaled(ends_[i], largest_of_turn(ends_[i]));
    double imaginary = 0;
    for (Complex& each : z) {
      imaginary = std::max(imaginary, std::abs(each.im));
      each.im = 0;
    }
    Products products{};
    add_products(z, z, products);
    if (!(imaginary < nearly) || !(largest(equations_.values(products, squares_)) < nearly * nearly)) return;
    const Place place = place_of(start_, z, i);
    for (int k = 0; k < found.size; ++k)
      if (are_near(place, found.rows[static_cast<std::size_t>(k)])) return;
    append(z, i, true, found);
  }
  [[nodiscard]] bool is_undecided(std::size_t i) const {
    return !proofs_[i].is_real() && !proofs_[i].is_not_real();
  }
  [[nodiscard]] bool are_near(const Place& a, const Place& b) const {
    double cosine = 0, distance = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += a.turn[i] * b.turn[i];
    for (std::size_t i = 0; i < 3; ++i)
      distance = std::max(distance, std::abs(a.position[i] - b.position[i]));
    return 1 - std::abs(cosine) < nearly * nearly && distance < nearly * start_.unit;
  }

  const Start<count>& start_;
  Equations<double> equations_;
  PerRod<Complex> squares_;
  Curvatures curvatures_;
  Path<double> path_;
  std::array<Point, paths> ends_{};
  std::array<Proof, paths> proofs_{};
  std::array<bool, paths> again_{};
};

}  // namespace detail

/// Finds the places for real lengths, m. Paths that lead to one place together, or whose ends are not proven,
/// are followed again in shorter steps. At most 2,100 steps a path.
template <int count>
Places<count> find_places(const Start<count>& start, const std::array<double, rod_count>& lengths) {
  return detail::Search<count>(start, lengths).run();
}

}  // namespace qvgen::inverse::six_rods
