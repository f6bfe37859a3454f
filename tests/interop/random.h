// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <sstream>
#include <string>

/// Numbers, attributes and ways of writing a frame, drawn for files that nobody would write.
namespace arms {

class Random {
 public:
  explicit Random(unsigned seed) : engine(seed) {}
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine); }
  double real(double size = 1) { return std::uniform_real_distribution<double>(-size, size)(engine); }
  /// So many numbers in a text.
  std::string reals(int count, double size = 1) {
    std::ostringstream text;
    text.precision(17);
    for (int i = 0; i < count; ++i) text << (i == 0 ? "" : " ") << real(size);
    return text.str();
  }
  std::mt19937 engine;
};

inline std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}

/// One of the ways in which an MJCF gives an orientation, or none; angles up to `angle`.
inline std::string orientation(Random& random, double angle) {
  switch (random.below(6)) {
    case 0:
      return attribute("quat", random.reals(4));
    case 1:
      return attribute("euler", random.reals(3, angle));
    case 2:
      return attribute("axisangle", random.reals(3) + " " + random.reals(1, angle));
    case 3:
      return attribute("xyaxes", random.reals(6));
    case 4:
      return attribute("zaxis", random.reals(3));
    default:
      return "";
  }
}

}  // namespace arms
