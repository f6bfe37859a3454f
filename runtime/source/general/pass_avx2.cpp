// SPDX-License-Identifier: MIT
// Compiled with -mavx2 -mfma; called only where the machine has both.
#include "gathered.h"

#if defined(__AVX2__)
#include "pass.h"

namespace qvgen::inverse::general {
const Pass pass_for_avx2 = &eliminate_once<4>;
}
#else
namespace qvgen::inverse::general {
const Pass pass_for_avx2 = nullptr;
}
#endif
