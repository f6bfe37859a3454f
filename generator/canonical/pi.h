// SPDX-License-Identifier: MIT
#pragma once

#include <cln/float.h>
#include <cln/real.h>

#include "model/evaluate.h"

namespace qvgen::canonical {

/// Returns pi with as many digits as models are evaluated with.
inline cln::cl_R pi() { return cln::pi(cln::float_format(model::evaluation_digits)); }

}  // namespace qvgen::canonical
