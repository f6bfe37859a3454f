// SPDX-License-Identifier: MIT
#include <cmath>

#include <qvgen/sine_cosine.h>

#include "parts.h"

bool vector_file_works() {
  const auto t = qvgen::sines_and_cosines<double>(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
  return std::abs(t.cosine[5] - std::cos(6.0)) < 1e-15;
}
