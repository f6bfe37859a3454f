// SPDX-License-Identifier: MIT
// Compiled with -mavx2 -mfma; called only where the machine has both.
#include "gathered.h"

#if defined(__AVX2__)
#include "pass.h"

namespace qvgen::inverse::elimination {
static constexpr Pass pass = {&eliminate_once<4>, &lead_in_lanes<4>, &put_out_in_lanes<4>};
const Pass* const pass_for_avx2 = &pass;
}  // namespace qvgen::inverse::elimination
#else
namespace qvgen::inverse::elimination {
const Pass* const pass_for_avx2 = nullptr;
}
#endif
