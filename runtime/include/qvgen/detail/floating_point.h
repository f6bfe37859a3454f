// SPDX-License-Identifier: MIT
#pragma once

// Tests for unreachable and invalid poses compare with NaN and infinity, and sums must keep the order in
// which they are written.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "qvgen: -ffast-math and -ffinite-math-only would change verdicts; compile this file without them"
#endif
