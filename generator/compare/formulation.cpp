// SPDX-License-Identifier: MIT
#include "compare/formulation.h"

namespace qvgen::compare {

const std::vector<Formulation>& formulations(What what) {
  static const std::vector<Formulation> forward = forward_formulations();
  static const std::vector<Formulation> none;
  return what == What::forward ? forward : none;
}

}  // namespace qvgen::compare
