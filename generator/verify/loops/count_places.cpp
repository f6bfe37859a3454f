// SPDX-License-Identifier: MIT
// Counts the places of a platform on six rods: see six_rods.h. Random numbers are whole ones divided by
// 10,000, so that they are the same on every machine and exact in text.
#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>

#include <qvgen/inverse/six_rods/path.h>

#include "verify/loops/six_rods.h"

namespace qvgen::verify {
namespace {

using namespace inverse::six_rods;
using Design = Ends<Complex>;

constexpr std::size_t most_places = 40;
constexpr int most_loops = 60;
constexpr int most_runs = 5;  ///< that lose a path, before counting is given up

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number() { return static_cast<double>(engine_() % 20001) / 10000 - 1; }
  Complex complex() {
    const double re = number();
    return {re, number()};
  }
  template <std::size_t n>
  std::array<Complex, n> complexes() {
    std::array<Complex, n> values;
    for (Complex& each : values) each = complex();
    return values;
  }
  /// Squares of lengths, as far apart as those of platforms of size 1 and farther.
  PerRod<Complex> squares() {
    PerRod<Complex> values = complexes<rod_count>();
    for (Complex& each : values) each = Complex{1, 0} + 3 * each;
    return values;
  }

 private:
  std::mt19937 engine_;
};

Design random_design(Random& random) {
  Design design;
  for (std::size_t i = 0; i < rod_count; ++i) {
    design.base[i] = random.complexes<3>();
    design.platform[i] = random.complexes<3>();
  }
  return design;
}

Complex dot4(const Point& z, const Complex* other) {
  return z[0] * other[0] + z[1] * other[1] + z[2] * other[2] + z[3] * other[3];
}

/// A random place with x . y = 0, in the patch.
Point random_place(const Patch& patch, Random& random) {
  Point z = random.complexes<8>();
  const Complex off = dot4(z, &z[4]) * reciprocal(dot4(z, z.data()));
  for (std::size_t i = 0; i < 4; ++i) z[4 + i] -= off * z[i];
  const Complex scale = reciprocal(dot4(z, patch.data()));
  for (Complex& each : z) each = each * scale;
  return z;
}

PerRod<Complex> squares_at(const Equations<Complex>& equations, const Point& z) {
  Products products{};
  add_products(z, z, products);
  const Values values = equations.values(products, {});
  PerRod<Complex> squares;
  for (std::size_t i = 0; i < rod_count; ++i) squares[i] = values[i + 1] * reciprocal(products.turn);
  return squares;
}

bool are_one(const Point& a, const Point& b) {
  double most = 0;
  for (std::size_t i = 0; i < 8; ++i) most = std::max(most, size(a[i] - b[i]));
  return most < 1e-7 * std::max(largest(a), largest(b));
}

bool add_new(const Point& z, std::vector<Point>& to) {
  for (const Point& each : to)
    if (are_one(each, z)) return false;
  to.push_back(z);
  return true;
}

/// A platform of no special shape with its 40 places.
struct General {
  Design design;
  PerRod<Complex> squares{};
  Patch patch{};
  std::vector<Point> places;
};

/// Goes once around a triangle of lengths with every known place; what comes back may be a new one.
void go_around(General& general, Random& random) {
  const Equations<Complex> equations(general.design);
  PerRod<Complex> first = random.complexes<rod_count>(), second = random.complexes<rod_count>();
  for (std::size_t i = 0; i < rod_count; ++i) {
    first[i] = 3 * first[i];
    second[i] = 3 * second[i];
  }
  const Path<Complex> away(equations, general.patch, general.squares, first),
      across(equations, general.patch, first, second),
      back(equations, general.patch, second, general.squares);
  const Pace pace{1e-5, 1000};
  const std::vector<Point> known = general.places;
  for (Point z : known)
    if (away.follow(z, pace) && across.follow(z, pace) && back.follow(z, pace)) add_new(z, general.places);
}

General general_platform(unsigned seed) {
  Random random(seed);
  General general;
  general.design = random_design(random);
  general.patch = random.complexes<4>();
  general.places = {random_place(general.patch, random)};
  general.squares = squares_at(Equations<Complex>(general.design), general.places.front());
  for (int k = 0; k < most_loops && general.places.size() < most_places; ++k) go_around(general, random);
  if (general.places.size() != most_places)
    throw std::domain_error("a general platform's places were not found; this is a mistake of the tool");
  return general;
}

/// Follows places while ends and lengths move along a line. Equations are quadratic in its parameter.
class Move {
 public:
  Move(const General& from, const Design& to, const PerRod<Complex>& squares)
      : from_(from), to_(to), squares_(squares) {}

  enum class Outcome { arrived, left, lost };

  /// Follows a place by steps of Runge and Kutta, and Newton's. Places that leave for infinity have x . x = 0
  /// there, or coordinates that grow without bound.
  Outcome follow(Point& z) const {
    double at = 0, step = 0.02;
    for (int k = 0; k < 2000 && at < 1 && step > 1e-13 && !has_left(z, at); ++k) {
      const double next = at + step < 1 ? at + step : 1;
      Point moved = z;
      double error = 0;
      if (!predict(moved, at, next - at) || !correct(moved, next, error)) {
        step = 0.5 * (next - at);
        continue;
      }
      z = moved;
      step = error < 1e-8 ? 3 * (next - at) : error < 1e-6 ? 1.6 * (next - at) : next - at;
      at = next;
    }
    if (at == 1) return Outcome::arrived;
    return has_left(z, at) ? Outcome::left : Outcome::lost;
  }

 private:
  /// True if a place is near infinity at the end.
  static bool has_left(const Point& z, double at) {
    const double left = 1 - at, turn = square(z[0]) + square(z[1]) + square(z[2]) + square(z[3]);
    return (left < 1e-2 && size(dot4(z, z.data())) < 1e-6 * turn) || (left < 1e-3 && largest(z) > 1e4);
  }

  struct At {
    Equations<Complex> equations;
    PerRod<Complex> squares;
  };

  [[nodiscard]] At at(double t) const {
    const auto between = [&](Complex a, Complex b) { return (1 - t) * a + t * b; };
    Design design;
    PerRod<Complex> squares;
    for (std::size_t i = 0; i < rod_count; ++i) {
      squares[i] = between(from_.squares[i], squares_[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        design.base[i][k] = between(from_.design.base[i][k], to_.base[i][k]);
        design.platform[i][k] = between(from_.design.platform[i][k], to_.platform[i][k]);
      }
    }
    return {Equations<Complex>(design), squares};
  }
  [[nodiscard]] Values gaps(const Point& z, double t) const {
    Products products{};
    add_products(z, z, products);
    const At here = at(t);
    return here.equations.values(products, here.squares);
  }
  /// Step of z, within the patch, that changes the values so.
  bool solve(const Point& z, double t, const Values& change, Point& step) const {
    const At here = at(t);
    const Factors factors(within(from_.patch, here.equations.gradients(z, here.squares)));
    if (!factors.are_regular()) return false;
    step = full(from_.patch, factors.solve(change));
    return is_finite(step);
  }
  bool correct(Point& z, double t, double& error) const {
    for (const double most : {1e-5, 1e-9}) {
      Point step;
      if (!solve(z, t, gaps(z, t), step)) return false;
      for (std::size_t i = 0; i < 8; ++i) z[i] -= step[i];
      const double share = largest(step) / largest(z);
      if (!(share < most)) return false;
      error = std::max(error, share);
    }
    return true;
  }
  /// Direction of the path. A difference over a whole unit is exact for what is quadratic.
  bool direction(const Point& z, double t, Point& result) const {
    const Values after = gaps(z, t + 0.5);
    Values change = gaps(z, t - 0.5);
    for (std::size_t i = 0; i < equation_count; ++i) change[i] -= after[i];
    return solve(z, t, change, result);
  }
  bool predict(Point& z, double t, double h) const {
    const auto ahead = [&](const Point& by, double step) {
      Point moved = z;
      for (std::size_t i = 0; i < 8; ++i) moved[i] += step * by[i];
      return moved;
    };
    Point a, b, c, d;
    if (!direction(z, t, a) || !direction(ahead(a, h / 2), t + h / 2, b) ||
        !direction(ahead(b, h / 2), t + h / 2, c) || !direction(ahead(c, h), t + h, d))
      return false;
    for (std::size_t i = 0; i < 8; ++i) z[i] += (h / 6) * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    return true;
  }

  const General& from_;
  const Design& to_;
  PerRod<Complex> squares_;
};

/// A design with lengths, and its places: those of a general one, followed there. None if a path was lost.
std::optional<General> followed(const General& general, const Design& design,
                                const PerRod<Complex>& squares) {
  const Move move(general, design, squares);
  General result{design, squares, general.patch, {}};
  for (Point z : general.places) {
    const Move::Outcome outcome = move.follow(z);
    const bool is_one_more = outcome == Move::Outcome::arrived && add_new(z, result.places);
    if (!is_one_more && outcome != Move::Outcome::left) return std::nullopt;
  }
  return result;
}

/// The places of a design by way of another general one, so that no two runs have anything in common.
General one_run(const General& general, const Design& design, Random& random) {
  for (int k = 0; k < most_runs; ++k) {
    const Design between = random_design(random);
    const auto half = followed(general, between, random.squares());
    if (!half || half->places.size() != most_places) continue;
    if (const auto whole = followed(*half, design, random.squares())) return *whole;
  }
  throw std::domain_error("its complex places were not counted: paths to them are lost");
}

std::array<double, 3> centre_of(const PerRod<Vector<double>>& points) {
  std::array<double, 3> sum{};
  for (const auto& each : points)
    for (std::size_t k = 0; k < 3; ++k) sum[k] += each[k] / rod_count;
  return sum;
}

/// The power of two next above a platform's size, m.
double unit_of(const Ends<double>& ends) {
  double most = 0;
  for (const auto* points : {&ends.base, &ends.platform})
    for (const auto& each : *points)
      for (const double value : each) most = std::max(most, std::abs(value));
  return most > 0 ? std::exp2(std::ilogb(most) + 1) : 1;
}

void move_and_scale(PerRod<Vector<double>>& points, const std::array<double, 3>& centre, double unit) {
  for (auto& each : points)
    for (std::size_t k = 0; k < 3; ++k) each[k] = (each[k] - centre[k]) / unit;
}

Design complex(const Ends<double>& ends) {
  Design design;
  for (std::size_t i = 0; i < rod_count; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      design.base[i][k] = {ends.base[i][k], 0};
      design.platform[i][k] = {ends.platform[i][k], 0};
    }
  return design;
}

}  // namespace

CountedPlaces count_places(const Ends<double>& ends) {
  constexpr unsigned seed_of_general = 1, seed = 7;  // the first with which few loops find all
  const General general = general_platform(seed_of_general);
  CountedPlaces result;
  result.base_centre = centre_of(ends.base);
  result.platform_centre = centre_of(ends.platform);
  result.ends = ends;
  move_and_scale(result.ends.base, result.base_centre, 1);
  move_and_scale(result.ends.platform, result.platform_centre, 1);
  result.unit = unit_of(result.ends);
  move_and_scale(result.ends.base, {}, result.unit);
  move_and_scale(result.ends.platform, {}, result.unit);
  Random random(seed);
  const Design design = complex(result.ends);
  const General first = one_run(general, design, random), second = one_run(general, design, random);
  if (first.places.size() != second.places.size())
    throw std::domain_error("its complex places were not counted: two runs disagree");
  if (first.places.empty())
    throw std::domain_error("its platform moves though all rods are held: the ends' places are special");
  result.squares = first.squares;
  result.patch = first.patch;
  result.points = first.places;
  return result;
}

}  // namespace qvgen::verify
