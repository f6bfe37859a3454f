// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "pipeline/products/product.h"

namespace qvgen::pipeline {

/// The C functions that a report's page calls, the same as in the whole products: `forward_kinematics`,
/// `jacobian`, `singularity_measures` and the closed forms of inverse kinematics. The counts have the names
/// of the measures alone, under "measures".
const std::vector<Product>& page_products();

}  // namespace qvgen::pipeline
