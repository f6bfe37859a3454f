// SPDX-License-Identifier: MIT
#include "verify/accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <cln/float.h>

#include "dag/evaluate.h"
#include "exact/point.h"

namespace qvgen::verify {
namespace {

using exact::Number;

/// A point whose symbols are doubles, so that both evaluations start from the same values.
class DoublePoint {
 public:
  explicit DoublePoint(std::uint64_t seed) : point_(seed) {}
  Number symbol(const std::string& name) const {
    return Number(cln::rational(cln::cl_float(point_.symbol(name).to_double())));
  }
  Number constant(const Number& value) const { return value; }
  Number sine(const exact::Angle& angle) const { return point_.sine(angle); }
  Number cosine(const exact::Angle& angle) const { return point_.cosine(angle); }
  Number root(const Number& value) const { return point_.root(value); }
  Number arctangent(const Number& y, const Number& x) const { return point_.arctangent(y, x); }

 private:
  exact::ExactPoint point_;
};

struct RoundedLeaves {
  const DoublePoint& exact;
  double symbol(const std::string& name) const { return exact.symbol(name).to_double(); }
  double constant(const Number& value) const { return value.to_double(); }
  double sine(const exact::Angle& angle) const { return exact.sine(angle).to_double(); }
  double cosine(const exact::Angle& angle) const { return exact.cosine(angle).to_double(); }
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
    const auto exact = dag::evaluate<Number>(function, point);
    const auto rounded = dag::evaluate<double>(function, RoundedLeaves{point});
    for (const OutputGroup& group : groups) {
      double size = std::numeric_limits<double>::min();
      double error = 0;
      for (std::size_t i = 0; i < exact.size(); ++i) {
        if (std::find(group.begin(), group.end(), function.outputs[i].name) == group.end()) continue;
        size = std::max(size, std::abs(exact[i].to_double()));
        const Number difference = exact[i] - Number(cln::rational(cln::cl_float(rounded[i])));
        error = std::max(error, std::abs(difference.to_double()));
      }
      largest = std::max(largest, error / ulp(size));
    }
  }
  return largest;
}

}  // namespace qvgen::verify
