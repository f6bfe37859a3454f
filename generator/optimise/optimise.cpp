// SPDX-License-Identifier: MIT
#include "optimise/optimise.h"

#include "dag/import.h"
#include "passes/pass.h"
#include "verify/certificate.h"

namespace qvgen::optimise {
namespace {

/// Sines and cosines for nothing: what is left are multiplications and additions. The trifle keeps the search
/// from taking angles that it does not need.
passes::CostModel operations_only(passes::CostModel cost) {
  cost.sine_cosine = 1e-3;
  return cost;
}

/// Without the outputs that are only suggestions to the search.
dag::Function results_only(dag::Function function) {
  std::erase_if(function.outputs,
                [](const dag::Output& output) { return output.name.front() == passes::suggestion; });
  return function;
}

}  // namespace

Optimised optimise(const derive::Quantity& quantity, const OptimiseOptions& options) {
  Optimised result;
  result.name = quantity.name;
  std::vector<dag::Function> forms;
  for (const derive::Form& form : quantity.forms) {
    forms.push_back(dag::import(form.program));
    if (options.simplify_forms) forms.back() = passes::simplify(forms.back());
    result.forms.push_back(
        {form.name, dag::count(results_only(forms.back()), options.search.is_free_symbol)});
  }
  result.function = passes::search(forms, options.cost, options.search);
  result.counts = dag::count(result.function, options.search.is_free_symbol);
  result.fewest = result.counts;
  verify::certify(result.function, quantity.definition, options.certificate_points, quantity.name);
  result.certified_points = options.certificate_points;
  if (!options.also_fewest) return result;
  const dag::Function fewest = passes::search(forms, operations_only(options.cost), options.search);
  result.fewest = dag::count(fewest, options.search.is_free_symbol);
  verify::certify(fewest, quantity.definition, options.certificate_points, quantity.name);
  return result;
}

}  // namespace qvgen::optimise
