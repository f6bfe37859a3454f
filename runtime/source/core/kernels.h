// SPDX-License-Identifier: MIT
#pragma once

// Kernels from which sine_cosine.cpp chooses. Nothing here may be inline: it is included by files that are
// compiled for different machines.

namespace qvgen::detail {

using KernelOf4 = void (*)(double, double, double, double, double* sines, double* cosines) noexcept;
using KernelOf8 = void (*)(double, double, double, double, double, double, double, double, double* sines,
                           double* cosines) noexcept;

// Only where QVGEN_HAS_AVX2_KERNEL is defined; to be called on machines with AVX2 and FMA only.
void avx2_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept;
void avx2_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
               double* sines, double* cosines) noexcept;

// On every machine.
void portable_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept;
void portable_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
                   double* sines, double* cosines) noexcept;

}  // namespace qvgen::detail
