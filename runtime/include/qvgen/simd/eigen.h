// SPDX-License-Identifier: MIT
#pragma once

// Lanes as entries of Eigen's matrices.

#include <Eigen/Core>
#include <qvgen/simd/lanes.h>

template <class T, class Set>
struct Eigen::NumTraits<qvgen::simd::Lanes<T, Set>> : Eigen::GenericNumTraits<qvgen::simd::Lanes<T, Set>> {
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};
