// SPDX-License-Identifier: MIT
#pragma once

// Instruction sets as types. A set is part of the type of each vector (lanes.h), so that the linker never
// takes code for one set for code for another; what a set's registers can do is in a header of its own
// (operations.h).

#include <initializer_list>

namespace qvgen {

/// Instruction sets of batches, ordered by the width of their registers. On x86-64 all of them give the same
/// bits in double.
enum class InstructionSet { baseline, neon, avx2, avx512 };

namespace simd {

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

#if defined(__AVX512DQ__)
inline constexpr int widest_register = 64;
#elif defined(__AVX__)
inline constexpr int widest_register = 32;
#else
inline constexpr int widest_register = 16;
#endif

/// So many doubles in whatever registers the including file is compiled for, one or several. Their width is
/// part of the type: files with different options have different types.
template <int count, int register_bytes = widest_register>
struct Doubles {
  static constexpr int bytes = 8 * count;
};

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

}  // namespace simd

/// The widest set that this machine has.
inline InstructionSet widest_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::neon})
    if (simd::machine_has(set)) return set;
  return InstructionSet::baseline;
}

}  // namespace qvgen
