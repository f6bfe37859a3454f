// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include <qvgen/batch/machine.h>

/// Choice of the instruction set of a batch at run time: the wanted one, or the next narrower one that this
/// machine has and the build has compiled.
namespace qvgen::batch {

/// The set for so many configurations: fewer than four in double are computed as single calls do, where those
/// have the same bits. In float and beside NEON they have not, and what a configuration yields should not
/// depend on how many there are.
template <class T>
InstructionSet set_for(InstructionSet wanted, std::size_t count) {
  return std::is_same_v<T, double> && count < 4 && !machine_has(InstructionSet::neon)
             ? InstructionSet::baseline
             : wanted;
}

/// Calls `function` with the type of the wanted set, or of the next narrower one that this machine has and
/// the build has compiled.
template <class Function>
void with_set([[maybe_unused]] InstructionSet wanted, const Function& function) {
#if defined(QVGEN_BATCH_HAS_AVX512)
  if (wanted == InstructionSet::avx512 && machine_has(InstructionSet::avx512)) return function(Avx512{});
#endif
#if defined(QVGEN_BATCH_HAS_AVX2)
  if (wanted >= InstructionSet::avx2 && machine_has(InstructionSet::avx2)) return function(Avx2{});
#endif
#if defined(QVGEN_BATCH_HAS_NEON)
  if (wanted != InstructionSet::baseline && machine_has(InstructionSet::neon)) return function(Neon{});
#endif
  function(Baseline{});
}

}  // namespace qvgen::batch
