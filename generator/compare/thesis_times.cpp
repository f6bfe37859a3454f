// SPDX-License-Identifier: MIT
#include "compare/thesis_times.h"

namespace qvgen::compare {

const std::vector<ThesisTimes>& thesis_times() {
  static const std::vector<ThesisTimes> table{
      {"ns", 39.922, 26.172, "spherical"},   {"rn", 41.032, 31.938, "spherical"},
      {"nn", 40.953, 31.922, "spherical"},   {"nr", 40.953, 31.984, "spherical"},
      {"cr", 40.062, 31.453, "spherical"},   {"rr", 40, 31.454, "spherical"},
      {"cc", 39.953, 31.484, "cylindrical"}, {"sr", 39.922, 31.453, "cylindrical"},
      {"sn", 39.89, 31.53, "spherical"},     {"rc", 39.906, 31.547, "cylindrical"},
      {"cn", 39.891, 31.594, "spherical"},   {"sc", 39.109, 30.953, "cylindrical"},
      {"cs", 38.953, 31.031, "cylindrical"}, {"nc", 36, 28.453, "spherical"},
      {"rs", 35.953, 28.469, "cylindrical"}, {"ss", 37.953, 30.875, "prismatic"},
  };
  return table;
}

}  // namespace qvgen::compare
