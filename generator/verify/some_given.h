// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "exact/point.h"

namespace qvgen::verify {

/// Leaves of a function at an exact point (dag/evaluate.h), some of whose symbols have given values.
struct SomeGiven {
  const exact::ExactPoint& point;
  std::map<std::string, exact::Number> given;

  [[nodiscard]] exact::Number constant(const exact::Number& value) const { return value; }
  [[nodiscard]] exact::Number symbol(const std::string& name) const {
    const auto place = given.find(name);
    return place != given.end() ? place->second : point.symbol(name);
  }
  [[nodiscard]] exact::Number sine(const dag::Angle& angle) const { return point.sine(angle); }
  [[nodiscard]] exact::Number cosine(const dag::Angle& angle) const { return point.cosine(angle); }
  [[nodiscard]] exact::Number root(const exact::Number& value) const { return point.root(value); }
  [[nodiscard]] exact::Number arctangent(const exact::Number& y, const exact::Number& x) const {
    return point.arctangent(y, x);
  }
};

}  // namespace qvgen::verify
