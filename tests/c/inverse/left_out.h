// SPDX-License-Identifier: MIT
// Number of robots with a closed form whose C a usual run does not compile.
#pragma once

namespace qvgen::test {

inline int& left_out_of_c() {
  static int number = 0;
  return number;
}

}  // namespace qvgen::test
