// SPDX-License-Identifier: MIT
#include <qvgen/sine_cosine.h>

#include <cmath>

namespace qvgen {

void sines_and_cosines(const double* angles, double* sines, double* cosines, int count) noexcept {
  for (int i = 0; i < count; ++i) {
    sines[i] = std::sin(angles[i]);
    cosines[i] = std::cos(angles[i]);
  }
}

}  // namespace qvgen
