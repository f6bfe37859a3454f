// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "exact/constant_angle.h"
#include "exact/named_constant.h"
#include "reference/load.h"

namespace qvgen::test {

/// Values of the symbols of random descriptions (random_description.h).
inline reference::Values symbols() {
  reference::Values values{{"h1", 0.7}};
  for (int i = 1; i <= 9; ++i) values["l" + std::to_string(i)] = 0.2 + 0.11 * i;
  return values;
}

/// Values of a function's leaves in double.
struct Leaves {
  std::map<std::string, double> values;
  [[nodiscard]] double constant(const exact::Number& number) const { return number.to_double(); }
  [[nodiscard]] double symbol(const std::string& name) const {
    if (const auto known = exact::named_value(name)) return cln::double_approx(*known);
    const auto place = values.find(name);
    if (place == values.end()) throw std::out_of_range("no value of " + name);
    return place->second;
  }
  [[nodiscard]] double of(const exact::Angle& angle) const {
    double sum = cln::double_approx(angle.pi) * M_PI;
    for (const auto& [name, coefficient] : angle.terms) {
      const auto constant = exact::constant_angle(name);
      sum += cln::double_approx(coefficient) *
             (constant ? cln::double_approx(exact::radians(*constant)) : symbol(name));
    }
    return sum;
  }
  [[nodiscard]] double sine(const exact::Angle& a) const { return std::sin(of(a)); }
  [[nodiscard]] double cosine(const exact::Angle& a) const { return std::cos(of(a)); }
  [[nodiscard]] double root(double x) const { return std::sqrt(x); }
  [[nodiscard]] double arctangent(double y, double x) const { return std::atan2(y, x); }
};

}  // namespace qvgen::test
