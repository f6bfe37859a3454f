// SPDX-License-Identifier: MIT
// Compiled with -mavx512f -mavx512dq -mavx512vl -mfma; called only where the machine has all of them.
#include "gathered.h"

#if defined(__AVX512DQ__)
#include "pass.h"

namespace qvgen::inverse::elimination {
static constexpr Pass pass = {&eliminate_once<8>, &lead_in_lanes<8>, &put_out_in_lanes<8>};
const Pass* const pass_for_avx512 = &pass;
}  // namespace qvgen::inverse::elimination
#else
namespace qvgen::inverse::elimination {
const Pass* const pass_for_avx512 = nullptr;
}
#endif
