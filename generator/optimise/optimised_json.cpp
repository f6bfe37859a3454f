// SPDX-License-Identifier: MIT
#include "optimise/optimised_json.h"

#include <cmath>

#include "verify/counts_json.h"

namespace qvgen::optimise {

using nlohmann::ordered_json;

ordered_json to_json(const Optimised& optimised, const std::string& choices) {
  using verify::to_json;
  const bool is_split = optimised.constant_counts.has_value();
  ordered_json entry{{"emitted", to_json(optimised.counts)}};
  if (is_split)
    entry["set_up"] = to_json(*optimised.constant_counts);
  else
    entry["fewest_operations"] = to_json(optimised.fewest);
  entry["certified_points"] = optimised.certified_points;
  if (is_split) entry["choices"] = choices;
  if (!is_split || optimised.largest_error > 0)
    entry["largest_error_ulp"] = std::round(optimised.largest_error * 100) / 100;
  if (is_split) return entry;
  ordered_json forms = ordered_json::object();
  for (const auto& form : optimised.forms) forms[form.name] = to_json(form.counts);
  entry["forms"] = forms;
  return entry;
}

}  // namespace qvgen::optimise
