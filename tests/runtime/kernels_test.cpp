// SPDX-License-Identifier: MIT

// Kernels of machines without AVX2, tested on machines that have it, too.
#include "kernels.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

TEST(PortableKernels, AreTheLibrarys) {
  const double a[8] = {0.1, -0.2, 3.0, 1e300, -1e10, 1e-310, 2.0, 7.0};
  double sines[8] = {};
  double cosines[8] = {};
  qvgen::detail::portable_of_8(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], sines, cosines);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(sines[i], std::sin(a[i]));
    EXPECT_EQ(cosines[i], std::cos(a[i]));
  }
  qvgen::detail::portable_of_4(a[4], a[5], a[6], a[7], sines, cosines);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(sines[i], std::sin(a[4 + i]));
    EXPECT_EQ(cosines[i], std::cos(a[4 + i]));
  }
}

}  // namespace
