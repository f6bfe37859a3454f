// SPDX-License-Identifier: MIT
#pragma once

namespace qvgen {

void sines_and_cosines(const double* angles, double* sines, double* cosines, int count) noexcept;

}  // namespace qvgen
