// SPDX-License-Identifier: MIT
#pragma once

// Operations on vectors in the instruction sets that the including file is compiled for: the one place that
// chooses.

#include <qvgen/simd/parts.h>

#if defined(__GNUC__)
#if defined(__SSE2__)
#include <qvgen/simd/sse2.h>
#elif defined(__aarch64__)
#include <qvgen/simd/neon.h>
#endif
#if defined(__AVX__)
#include <qvgen/simd/avx2.h>
#endif
#if defined(__AVX512DQ__)
#include <qvgen/simd/avx512.h>
#endif
#endif

#undef QVGEN_OPERATION
