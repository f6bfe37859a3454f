// SPDX-License-Identifier: MIT
#include "pass.h"

namespace qvgen::inverse::elimination {

static constexpr Pass two_lanes = {&eliminate_once<2>, &lead_in_lanes<2>, &put_out_in_lanes<2>};
const Pass* const pass_for_all = &two_lanes;

}  // namespace qvgen::inverse::elimination
