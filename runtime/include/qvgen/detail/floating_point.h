// SPDX-License-Identifier: MIT
#pragma once

// What tells solved from unreachable and valid from invalid sees NaN and infinity, and sums in the order in
// which they are written.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "qvgen: -ffast-math and -ffinite-math-only would change verdicts; compile this file without them"
#endif
