// SPDX-License-Identifier: MIT
#include "application/optimise.h"

#include "application/certificate.h"
#include "dag/import.h"
#include "passes/pass.h"

namespace qvgen::application {
namespace {

/// Sines and cosines for nothing: what is left are multiplications and additions. The trifle keeps the search from
/// taking angles that it does not need.
passes::CostModel operations_only(passes::CostModel cost) {
  cost.sine_cosine = 1e-3;
  return cost;
}

}  // namespace

Optimised optimise(const derive::Quantity& quantity, const OptimiseOptions& options) {
  Optimised result;
  result.name = quantity.name;
  std::vector<dag::Function> forms;
  for (const derive::Form& form : quantity.forms) {
    forms.push_back(passes::simplify(dag::import(form.program)));
    result.forms.push_back({form.name, dag::count(forms.back(), options.search.is_free_symbol)});
  }
  result.function = passes::search(forms, options.cost, options.search);
  result.counts = dag::count(result.function, options.search.is_free_symbol);
  const dag::Function fewest = passes::search(forms, operations_only(options.cost), options.search);
  result.fewest = dag::count(fewest, options.search.is_free_symbol);
  certify(fewest, quantity.definition, options.certificate_points, quantity.name);
  certify(result.function, quantity.definition, options.certificate_points, quantity.name);
  result.certified_points = options.certificate_points;
  return result;
}

}  // namespace qvgen::application
