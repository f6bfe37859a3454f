// SPDX-License-Identifier: MIT
#pragma once

// For a source that gives the same bits one by one and in vector lanes: a*b + c is rounded twice, whoever
// compiles it and for whatever machine. To be included before anything else. A build that gives
// -ffp-contract=off itself defines QVGEN_NO_CONTRACTION.
#if !defined(QVGEN_NO_CONTRACTION)
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif
#endif
