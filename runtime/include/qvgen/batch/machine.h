// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>

namespace qvgen {

/// Instruction sets of batches, ordered by the width of their registers. On x86-64 all of them give the same
/// bits in double.
enum class InstructionSet { baseline, neon, avx2, avx512 };

namespace batch {

// Each is a type of its own, so that code for one is never taken for code for another.
struct Baseline {
  static constexpr int bytes = 16;
};
struct Neon {
  static constexpr int bytes = 16;
};
struct Avx2 {
  static constexpr int bytes = 32;
};
struct Avx512 {
  static constexpr int bytes = 64;
};

// The batch sources of a robot are compiled once for each set, which the command of the build names; for all
// but the baseline with lanes.
#if defined(QVGEN_BATCH_AVX512) || defined(QVGEN_BATCH_AVX2) || defined(QVGEN_BATCH_NEON)
#define QVGEN_BATCH_LANES
#endif
#if defined(QVGEN_BATCH_AVX512)
using Compiled = Avx512;
#elif defined(QVGEN_BATCH_AVX2)
using Compiled = Avx2;
#elif defined(QVGEN_BATCH_NEON)
using Compiled = Neon;
#else
using Compiled = Baseline;
#endif

/// True if this machine runs code for the set.
inline bool machine_has([[maybe_unused]] InstructionSet set) {
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (set == InstructionSet::avx2) return avx2;
  if (set == InstructionSet::avx512)
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
#elif defined(__GNUC__) && defined(__aarch64__)
  if (set == InstructionSet::neon) return true;
#endif
  return set == InstructionSet::baseline;
}

}  // namespace batch

/// The widest set that this machine has.
inline InstructionSet widest_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::neon})
    if (batch::machine_has(set)) return set;
  return InstructionSet::baseline;
}

}  // namespace qvgen
