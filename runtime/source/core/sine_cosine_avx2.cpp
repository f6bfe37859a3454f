// SPDX-License-Identifier: MIT

// Compiled for AVX2 and FMA whatever the rest is compiled for, and called only where the machine has them. It
// includes nothing but the kernel: an inline function of another header, compiled here for AVX2, could be the
// copy that the linker keeps for everybody.
#include <qvgen/detail/sine_cosine_avx2.h>

#include "kernels.h"

namespace qvgen::detail {

void avx2_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept {
  avx2::sine_cosine_of_4(a0, a1, a2, a3, sines, cosines);
}

void avx2_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
               double* sines, double* cosines) noexcept {
  avx2::sine_cosine_of_8(a0, a1, a2, a3, a4, a5, a6, a7, sines, cosines);
}

}  // namespace qvgen::detail
