// SPDX-License-Identifier: MIT
// In place of the runtime's kernels: the sines that C has.
#include <cmath>

#include <qvgen/sine_cosine.h>

namespace qvgen {
namespace {

/// Scalar of the C that is compared: its sines are rounded to that.
#ifdef QVGEN_C_SCALAR
using InC = QVGEN_C_SCALAR;
#else
using InC = double;
#endif

template <class Scalar>
void by_libm(const Scalar* angles, Scalar* sines, Scalar* cosines, int count) {
  for (int i = 0; i < count; ++i) {
    const InC angle = static_cast<InC>(angles[i]);
    sines[i] = static_cast<Scalar>(std::sin(angle));
    cosines[i] = static_cast<Scalar>(std::cos(angle));
  }
}

}  // namespace

void sines_and_cosines(const double* angles, double* sines, double* cosines, int count) noexcept {
  by_libm(angles, sines, cosines, count);
}

void sines_and_cosines(const float* angles, float* sines, float* cosines, int count) noexcept {
  by_libm(angles, sines, cosines, count);
}

namespace detail {

void sine_cosine_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept {
  const double angles[4] = {a0, a1, a2, a3};
  by_libm(angles, sines, cosines, 4);
}

void sine_cosine_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
                      double* sines, double* cosines) noexcept {
  sine_cosine_of_4(a0, a1, a2, a3, sines, cosines);
  sine_cosine_of_4(a4, a5, a6, a7, sines + 4, cosines + 4);
}

}  // namespace detail
}  // namespace qvgen
