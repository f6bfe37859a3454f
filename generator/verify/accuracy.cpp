// SPDX-License-Identifier: MIT
#include "verify/accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dag/evaluate.h"
#include "exact/point.h"
#include "verify/inverse/real.h"

namespace qvgen::verify {
namespace {

using exact::Number;

/// A point whose symbols are doubles, so that both evaluations start from the same values.
class DoublePoint {
 public:
  explicit DoublePoint(std::uint64_t seed) : point_(seed) {}
  double symbol(const std::string& name) const { return point_.symbol(name).to_double(); }
  Number sine(const exact::Angle& angle) const { return point_.sine(angle); }
  Number cosine(const exact::Angle& angle) const { return point_.cosine(angle); }

 private:
  exact::ExactPoint point_;
};

struct PreciseLeaves {
  const DoublePoint& point;
  Real symbol(const std::string& name) const { return Real(point.symbol(name)); }
  Real constant(const Number& value) const { return Real(value); }
  Real sine(const exact::Angle& angle) const { return Real(point.sine(angle)); }
  Real cosine(const exact::Angle& angle) const { return Real(point.cosine(angle)); }
  Real root(const Real& value) const { return sqrt(value); }
  Real arctangent(const Real& y, const Real& x) const { return atan2(y, x); }
};

struct RoundedLeaves {
  const DoublePoint& point;
  double symbol(const std::string& name) const { return point.symbol(name); }
  double constant(const Number& value) const { return value.to_double(); }
  double sine(const exact::Angle& angle) const { return point.sine(angle).to_double(); }
  double cosine(const exact::Angle& angle) const { return point.cosine(angle).to_double(); }
  double root(double value) const { return std::sqrt(value); }
  double arctangent(double y, double x) const { return std::atan2(y, x); }
};

double ulp(double value) {
  return std::nextafter(std::abs(value), std::numeric_limits<double>::infinity()) - std::abs(value);
}

}  // namespace

double largest_error_in_ulps(const dag::Function& function, const std::vector<OutputGroup>& groups,
                             int points) {
  double largest = 0;
  for (int k = 0; k < points; ++k) {
    const DoublePoint point(1000 + static_cast<std::uint64_t>(k));
    const auto precise = dag::evaluate<Real>(function, PreciseLeaves{point});
    const auto rounded = dag::evaluate<double>(function, RoundedLeaves{point});
    for (const OutputGroup& group : groups) {
      double size = std::numeric_limits<double>::min();
      double error = 0;
      for (std::size_t i = 0; i < precise.size(); ++i) {
        if (std::find(group.begin(), group.end(), function.outputs[i].name) == group.end()) continue;
        size = std::max(size, std::abs(precise[i].to_double()));
        error = std::max(error, std::abs((precise[i] - Real(rounded[i])).to_double()));
      }
      largest = std::max(largest, error / ulp(size));
    }
  }
  return largest;
}

}  // namespace qvgen::verify
