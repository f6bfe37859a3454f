// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_derivation.h"

#include "model/private_names.h"

namespace qvgen::pipeline {
namespace {

void add_closed_forms(const model::Robot& described, InverseDerivation& result) {
  const model::Robot robot = model::with_private_names(described);
  std::vector<derive::inverse::Derivation> all{derive::inverse::derive(robot)};
  for (auto& derivation : derive::inverse::derive_given(robot)) all.push_back(std::move(derivation));
  for (const auto& derivation : all) {
    if (derivation.found) result.closed_forms.push_back(derivation);
    result.reasons.insert(result.reasons.end(), derivation.reasons.begin(), derivation.reasons.end());
  }
}

void add_elimination(const model::Robot& described, InverseDerivation& result) {
  result.general = derive::inverse::derive_general(described);
  if (!result.general.reason.empty()) result.reasons.push_back(result.general.reason);
}

}  // namespace

InverseDerivation derive_inverse(const model::Robot& described) {
  InverseDerivation result;
  const bool may_eliminate = described.inverse.task.value_or(model::Task::pose) == model::Task::pose &&
                             described.inverse.given.empty();
  const bool is_general = may_eliminate && derive::inverse::lacks_structure(described);
  if (is_general) add_elimination(described, result);
  if (!result.found()) add_closed_forms(described, result);
  if (!result.found() && may_eliminate && !is_general) add_elimination(described, result);
  return result;
}

}  // namespace qvgen::pipeline
