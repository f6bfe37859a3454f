// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dag/counts.h"
#include "derive/dynamics/formulation.h"
#include "optimise/quantity.h"
#include "passes/search/search.h"

namespace qvgen::optimise {

/// A quantity after passes and choice, certified.
struct Optimised {
  std::string name;
  dag::Function function;   ///< the cheapest by the cost model: what is emitted
  dag::Function constants;  ///< its symbols "$0", ... in the description's, if they are split off
  /// As it was found, before constants were split off and it was put in terms of the description (see
  /// Quantity): what further functions are derived from.
  derive::dynamics::Formulation of_arm = {};
  dag::OperationCounts counts;                          ///< of `function`
  std::optional<dag::OperationCounts> constant_counts;  ///< of `constants`, if they are split off
  dag::OperationCounts fewest;  ///< fewest multiplications and additions, sines and cosines given
  struct FormCounts {
    std::string name;
    dag::OperationCounts counts;
  };
  std::vector<FormCounts> forms;  ///< each competing form by itself, after the passes
  int certified_points = 0;       ///< exact points at which `function` equals the definition
  double largest_error = 0;       ///< see accuracy.h
  /// Choices for functions of dynamics that have any.
  std::optional<derive::dynamics::FormulationOptions> choices;
};

/// Annealing steps for functions of some dozen operations. Ten times as many gain less than one percent.
inline passes::SearchOptions small_function_search() {
  passes::SearchOptions options;
  options.iterations = 50'000;
  return options;
}

struct OptimiseOptions {
  passes::CostModel cost;
  passes::SearchOptions search = small_function_search();
  int certificate_points = 4;
  /// Look also for the fewest multiplications and additions with sines and cosines for nothing (a second
  /// search).
  bool also_fewest = true;
  /// Run the passes on each form by itself before the search: counts of the forms mean something, and forms
  /// that share little gain by it. For large functions whose forms share much the search does as well
  /// without.
  bool simplify_forms = true;
  /// Annealing steps of a search about the cheapest function found alone, repeated as long as it finds
  /// cheaper ones; 0: none. Where many forms fill the search with values, new ones are tried only then.
  long more_steps = 0;
};

/// Runs the passes, lets the forms compete, splits constants off and certifies the winner.
/// Throws CertificateError if a result differs from the definition: a pass has broken an identity.
Optimised optimise(const Quantity& quantity, const OptimiseOptions& options = {});
Optimised optimise(const derive::Quantity& quantity, const OptimiseOptions& options = {});

}  // namespace qvgen::optimise
