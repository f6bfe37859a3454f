// SPDX-License-Identifier: MIT
#include "optimise/optimise.h"

#include "dag/import.h"
#include "passes/constant_split.h"
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

int operations(const dag::OperationCounts& counts) {
  constexpr int division = 4;
  return counts.multiplications + counts.additions + division * counts.divisions;
}

dag::Function cheapest(const std::vector<dag::Function>& forms, const OptimiseOptions& options,
                       passes::SearchOptions search) {
  dag::Function found = passes::search(forms, options.cost, search);
  search.iterations = options.more_steps;
  search.restarts = 1;
  while (options.more_steps > 0) {
    ++search.seed;
    dag::Function next = passes::search({found}, options.cost, search);
    const bool cheaper = operations(dag::count(next, search.is_free_symbol)) <
                         operations(dag::count(found, search.is_free_symbol));
    if (!cheaper) break;
    found = std::move(next);
  }
  return found;
}

/// The passes' result as it is emitted.
Optimised split(const Quantity& quantity, const dag::Function& found) {
  Optimised result;
  result.name = quantity.name;
  result.counts = dag::count(found, quantity.is_free);
  result.function = found;
  if (!quantity.constants) return result;
  passes::ConstantSplit parts = passes::split_constants(found, *quantity.constants, quantity.is_free);
  result.function = std::move(parts.function);
  result.constants = std::move(parts.constants);
  result.constant_counts = dag::count(result.constants);
  result.of_arm = {found, *quantity.constants};
  if (quantity.in_terms_of_description) result.function = quantity.in_terms_of_description(result.function);
  return result;
}

void certify(const Quantity& quantity, Optimised& found, int points) {
  for (std::size_t i = 0; i < quantity.outputs.size(); ++i)
    if (found.function.outputs.at(i).name != quantity.outputs[i])
      throw verify::CertificateError(quantity.name + ": outputs are not those of the definition");
  verify::certify(found.function, found.constants, quantity.residuals, quantity.whole, points, quantity.name);
  found.certified_points = points;
}

}  // namespace

Quantity lowered(const derive::Quantity& quantity) {
  Quantity result{quantity.name, {}, verify::residuals_of(quantity.definition)};
  for (const derive::Form& form : quantity.forms)
    result.forms.push_back({form.name, dag::import(form.program)});
  for (const auto& output : quantity.definition.outputs()) result.outputs.push_back(output.name);
  return result;
}

Optimised optimise(const Quantity& quantity, const OptimiseOptions& options) {
  passes::SearchOptions search = options.search;
  search.is_free_symbol = quantity.is_free;
  std::vector<dag::Function> forms;
  std::vector<Optimised::FormCounts> form_counts;
  for (const Quantity::Form& form : quantity.forms) {
    forms.push_back(options.simplify_forms ? passes::simplify(form.function) : form.function);
    form_counts.push_back({form.name, dag::count(results_only(forms.back()), quantity.is_free)});
  }
  Optimised result = split(quantity, cheapest(forms, options, search));
  result.forms = std::move(form_counts);
  result.fewest = result.counts;
  certify(quantity, result, options.certificate_points);
  if (!options.also_fewest) return result;
  Optimised fewest = split(quantity, passes::search(forms, operations_only(options.cost), search));
  certify(quantity, fewest, options.certificate_points);
  result.fewest = fewest.counts;
  return result;
}

Optimised optimise(const derive::Quantity& quantity, const OptimiseOptions& options) {
  return optimise(lowered(quantity), options);
}

}  // namespace qvgen::optimise
