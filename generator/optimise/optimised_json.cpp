// SPDX-License-Identifier: MIT
#include "optimise/optimised_json.h"

#include <cmath>

#include "verify/counts_json.h"

namespace qvgen::optimise {

using nlohmann::ordered_json;

ordered_json to_json(const Optimised& optimised) {
  using verify::to_json;
  ordered_json forms = ordered_json::object();
  for (const auto& form : optimised.forms) forms[form.name] = to_json(form.counts);
  return {{"emitted", to_json(optimised.counts)},
          {"fewest_operations", to_json(optimised.fewest)},
          {"certified_points", optimised.certified_points},
          {"largest_error_ulp", std::round(optimised.largest_error * 100) / 100},
          {"forms", forms}};
}

}  // namespace qvgen::optimise
