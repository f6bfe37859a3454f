// SPDX-License-Identifier: MIT
#pragma once

#include "document.h"

namespace qvgen::test::sources {

/// All sources judged, once for all tests: it takes most of their time.
inline const std::vector<Part>& judged_parts() {
  static const std::vector<Part> all = parts();
  return all;
}

}  // namespace qvgen::test::sources
