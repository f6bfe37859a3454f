// SPDX-License-Identifier: MIT
#pragma once

// Instruction sets of batches. The batch sources of a robot are compiled once for each set, which the command
// of the build names; for all but the baseline with lanes.

#include <qvgen/simd/instruction_sets.h>

#if defined(QVGEN_BATCH_AVX512) || defined(QVGEN_BATCH_AVX2) || defined(QVGEN_BATCH_NEON)
#define QVGEN_BATCH_LANES
#endif

namespace qvgen::batch {

using simd::Avx2;
using simd::Avx512;
using simd::Baseline;
using simd::machine_has;
using simd::Neon;

#if defined(QVGEN_BATCH_AVX512)
using Compiled = Avx512;
#elif defined(QVGEN_BATCH_AVX2)
using Compiled = Avx2;
#elif defined(QVGEN_BATCH_NEON)
using Compiled = Neon;
#else
using Compiled = Baseline;
#endif

}  // namespace qvgen::batch
