// SPDX-License-Identifier: MIT
#include "compare/formulation.h"

#include "optimise/dynamics.h"

namespace qvgen::compare {

const std::vector<Formulation>& formulations(What what) {
  static const std::vector<Formulation> forward = forward_formulations(), jacobian = jacobian_formulations(),
                                        dynamics = dynamics_formulations();
  return what == What::forward ? forward : what == What::jacobian ? jacobian : dynamics;
}

dag::IsFree free_symbols(const model::Robot& robot) { return optimise::free_symbols(robot); }

const std::vector<std::string>& what_names() {
  static const std::vector<std::string> names{"forward", "jacobian", "dynamics"};
  return names;
}

}  // namespace qvgen::compare
