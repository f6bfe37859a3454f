// SPDX-License-Identifier: MIT
#include <cmath>

#include <qvgen/angle.h>
#include <qvgen/pose.h>
#include <qvgen/sine_cosine.h>

#include "parts.h"

bool runtime_works() {
  const qvgen::Pose<double> pose{Eigen::Quaterniond(0.6, 0.8, 0, 0), {1, 2, 3}};
  const auto t = qvgen::sines_and_cosines<double>(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
  return linear_distance(pose * pose.inverse(), {}) < 1e-14 && std::abs(t.sine[5] - std::sin(6.0)) < 1e-15 &&
         qvgen::wrap(7.0) < 1;
}
