// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <qvgen/batch/machine.h>

#include "throughput.h"

/// Most that one core of the machine does, measured.
namespace throughput {

/// Bytes a second that a copy reads and writes.
inline double bandwidth() {
  const std::vector<double> from(1 << 24, 1.0);
  std::vector<double> to(from.size());
  return 2 * 8 * static_cast<double>(from.size()) /
         shortest([&] { std::copy(from.begin(), from.end(), to.begin()); });
}

// Products and sums are rounded one by one in batches, so they are apart here too: six chains of either, more
// than two units with a latency of four cycles need.
#define QVGEN_ARITHMETIC                                                          \
  using Lanes __attribute__((vector_size(Bytes))) = T;                            \
  const Lanes factor = Lanes{} + T(0.999999), more = Lanes{} + T(1e-6);           \
  Lanes a = factor, b = a, c = a, d = a, e = a, f = a;                            \
  Lanes u = more, v = u, w = u, x = u, y = u, z = u;                              \
  for (int round = 0; round < rounds; ++round) {                                  \
    a *= factor, b *= factor, c *= factor, d *= factor, e *= factor, f *= factor; \
    u += more, v += more, w += more, x += more, y += more, z += more;             \
    asm volatile("" : "+v"(a), "+v"(b), "+v"(c), "+v"(d), "+v"(e), "+v"(f));      \
    asm volatile("" : "+v"(u), "+v"(v), "+v"(w), "+v"(x), "+v"(y), "+v"(z));      \
  }                                                                               \
  return 12.0 * Bytes / sizeof(T) * rounds;

#if defined(__x86_64__) && defined(__GNUC__)
template <class T, int Bytes>
[[gnu::target("avx512f"), gnu::noinline]] double work_avx512(int rounds) {
  QVGEN_ARITHMETIC
}
template <class T, int Bytes>
[[gnu::target("avx2"), gnu::noinline]] double work_avx2(int rounds) {
  QVGEN_ARITHMETIC
}
#endif
#undef QVGEN_ARITHMETIC

/// Products and sums a second in registers of the set; 0 where there are none.
template <class T>
double arithmetic([[maybe_unused]] qvgen::InstructionSet set) {
  double done = 0;
#if defined(__x86_64__) && defined(__GNUC__)
  constexpr int rounds = 100000;
  if (!qvgen::batch::machine_has(set) || set == qvgen::InstructionSet::baseline) return 0;
  const double time = shortest([&] {
    done = set == qvgen::InstructionSet::avx512 ? work_avx512<T, 64>(rounds) : work_avx2<T, 32>(rounds);
  });
  done /= time;
#endif
  return done;
}

}  // namespace throughput
