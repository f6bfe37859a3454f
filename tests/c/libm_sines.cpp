// SPDX-License-Identifier: MIT
// In place of the runtime's kernels: the sines that C has.
#include <cmath>

#include <qvgen/sine_cosine.h>

namespace qvgen {

void sines_and_cosines(const double* angles, double* sines, double* cosines, int count) noexcept {
  for (int i = 0; i < count; ++i) {
    const double angle = angles[i];
    sines[i] = std::sin(angle);
    cosines[i] = std::cos(angle);
  }
}

void sines_and_cosines(const float* angles, float* sines, float* cosines, int count) noexcept {
  for (int i = 0; i < count; ++i) {
    const float angle = angles[i];
    sines[i] = std::sin(angle);
    cosines[i] = std::cos(angle);
  }
}

namespace detail {

void sine_cosine_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept {
  const double angles[4] = {a0, a1, a2, a3};
  for (int i = 0; i < 4; ++i) {
    sines[i] = std::sin(angles[i]);
    cosines[i] = std::cos(angles[i]);
  }
}

void sine_cosine_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
                      double* sines, double* cosines) noexcept {
  sine_cosine_of_4(a0, a1, a2, a3, sines, cosines);
  sine_cosine_of_4(a4, a5, a6, a7, sines + 4, cosines + 4);
}

}  // namespace detail
}  // namespace qvgen
