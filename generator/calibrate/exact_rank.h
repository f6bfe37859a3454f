// SPDX-License-Identifier: MIT
// Combinations that no data of a kind can ever tell, whatever postures were measured: the rank of the
// derivatives at random exact postures, in a prime field. A rank that the field shows is one over the
// rationals; that it shows less than there is has a probability of about 1e-15.
#pragma once

#include "calibrate/setup.h"

namespace qvgen::calibrate {

/// Returns which of the parameters the kind of data can tell, keeping them in the order of priority.
Rank exact_rank(const Model<Field>& model, const Setup& setup, const std::vector<std::size_t>& priority);

}  // namespace qvgen::calibrate
