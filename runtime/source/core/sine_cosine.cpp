// SPDX-License-Identifier: MIT
#include <atomic>
#include <cmath>

#include <qvgen/sine_cosine.h>

#include "kernels.h"

namespace qvgen {
namespace detail {

void repair(const double* angles, double* sines, double* cosines, int count) noexcept {
  for (int i = 0; i < count; ++i) {
    if (!(std::abs(angles[i]) <= reduction_bound)) {
      sines[i] = std::sin(angles[i]);
      cosines[i] = std::cos(angles[i]);
    }
  }
}

void portable_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept {
  const double angles[4] = {a0, a1, a2, a3};
  for (int i = 0; i < 4; ++i) {
    sines[i] = std::sin(angles[i]);
    cosines[i] = std::cos(angles[i]);
  }
}

void portable_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
                   double* sines, double* cosines) noexcept {
  portable_of_4(a0, a1, a2, a3, sines, cosines);
  portable_of_4(a4, a5, a6, a7, sines + 4, cosines + 4);
}

namespace {

struct Kernels {
  KernelOf4 of_4;
  KernelOf8 of_8;
};

Kernels best_kernels() noexcept {
#ifdef QVGEN_HAS_AVX2_KERNEL
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    return {&avx2_of_4, &avx2_of_8};
  }
#endif
  return {&portable_of_4, &portable_of_8};
}

void choose_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept;
void choose_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
                 double* sines, double* cosines) noexcept;

// Both start as functions that choose, store their choice and do the call. They are constants at load time,
// so that a call from the constructor of another file's global object works too; two threads that choose at
// once store the same thing.
std::atomic<KernelOf4> kernel_of_4{&choose_of_4};
std::atomic<KernelOf8> kernel_of_8{&choose_of_8};

void choose_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept {
  const KernelOf4 choice = best_kernels().of_4;
  kernel_of_4.store(choice, std::memory_order_relaxed);
  choice(a0, a1, a2, a3, sines, cosines);
}

void choose_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
                 double* sines, double* cosines) noexcept {
  const KernelOf8 choice = best_kernels().of_8;
  kernel_of_8.store(choice, std::memory_order_relaxed);
  choice(a0, a1, a2, a3, a4, a5, a6, a7, sines, cosines);
}

/// 0 < count <= 8 angles through arrays of full size.
template <class Scalar>
void part(const Scalar* angles, Scalar* sines, Scalar* cosines, int count) noexcept {
  double a[8] = {};
  double s[8];
  double c[8];
  for (int i = 0; i < count; ++i) {
    a[i] = static_cast<double>(angles[i]);
  }
  if (count <= 4) {
    sine_cosine_of_4(a[0], a[1], a[2], a[3], s, c);
  } else {
    sine_cosine_of_8(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], s, c);
  }
  for (int i = 0; i < count; ++i) {
    sines[i] = static_cast<Scalar>(s[i]);
    cosines[i] = static_cast<Scalar>(c[i]);
  }
}

template <class Scalar>
void all_parts(const Scalar* angles, Scalar* sines, Scalar* cosines, int count) noexcept {
  for (int done = 0; done < count; done += 8) {
    part(angles + done, sines + done, cosines + done, count - done < 8 ? count - done : 8);
  }
}

}  // namespace

void sine_cosine_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept {
  kernel_of_4.load(std::memory_order_relaxed)(a0, a1, a2, a3, sines, cosines);
}

void sine_cosine_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
                      double* sines, double* cosines) noexcept {
  kernel_of_8.load(std::memory_order_relaxed)(a0, a1, a2, a3, a4, a5, a6, a7, sines, cosines);
}

}  // namespace detail

void sines_and_cosines(const double* angles, double* sines, double* cosines, int count) noexcept {
  detail::all_parts(angles, sines, cosines, count);
}

void sines_and_cosines(const float* angles, float* sines, float* cosines, int count) noexcept {
  detail::all_parts(angles, sines, cosines, count);
}

}  // namespace qvgen
