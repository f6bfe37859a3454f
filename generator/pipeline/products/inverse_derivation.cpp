// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_derivation.h"

#include <algorithm>

#include "model/followers.h"
#include "model/private_names.h"
#include "pipeline/products/brief_reasons.h"

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

void add_eliminations(const model::Robot& described, InverseDerivation& result) {
  derive::inverse::EliminationDerivations derivations = derive::inverse::derive_eliminations(described);
  result.eliminations = std::move(derivations.found);
  result.reasons.insert(result.reasons.end(), derivations.reasons.begin(), derivations.reasons.end());
}

/// True if a closed form is a quartic of an arm with axes that nearly meet. Its equations are nearly those of
/// a simpler arm, and its roots carry so few digits that solutions take twenty times as long as by
/// elimination; the smallest offsets lose some.
bool has_faint_quartic(const model::Robot& described, const InverseDerivation& derivation) {
  const auto is_quartic = [](const derive::inverse::Derivation& form) { return form.plan.quartic(); };
  return std::any_of(derivation.closed_forms.begin(), derivation.closed_forms.end(), is_quartic) &&
         derive::inverse::nearly_has_structure(described);
}

/// Puts eliminations in place of closed forms, if there are any.
void replace_by_eliminations(const model::Robot& described, InverseDerivation& derivation) {
  derive::inverse::EliminationDerivations derivations = derive::inverse::derive_eliminations(described);
  if (derivations.found.empty()) return;
  derivation = {{}, std::move(derivations.found), {}};
}

}  // namespace

InverseDerivation derive_inverse(const model::Robot& described) {
  InverseDerivation result;
  if (model::has_followers(described)) {
    result.reasons = {"a joint follows another, and none is derived for such arms"};
    return result;
  }
  const bool has_no_structure = derive::inverse::lacks_structure(described);
  if (has_no_structure) add_eliminations(described, result);
  if (!result.found()) add_closed_forms(described, result);
  if (!result.found() && !has_no_structure) add_eliminations(described, result);
  if (has_faint_quartic(described, result)) replace_by_eliminations(described, result);
  result.reasons = brief_reasons(result.reasons, described.joints.size());
  return result;
}

}  // namespace qvgen::pipeline
