// SPDX-License-Identifier: MIT
#include "compare/published_counts.h"

namespace qvgen::compare {

const std::vector<PublishedCounts>& published_counts() {
  static const std::vector<PublishedCounts> counts{{"general_6r", "symbols, base parameters", 425, 369},
                                                   {"puma560", "numbers", 347, 260},
                                                   {"rx90", "symbols, base parameters", 253, 238},
                                                   {"stanford", "numbers", 339, 250}};
  return counts;
}

}  // namespace qvgen::compare
