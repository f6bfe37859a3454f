// SPDX-License-Identifier: MIT
#include "pass.h"

namespace qvgen::inverse::general {

const Pass pass_for_all = &eliminate_once<2>;

}  // namespace qvgen::inverse::general
