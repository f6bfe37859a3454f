// SPDX-License-Identifier: MIT
#include "table.h"

#include <algorithm>
#include <cstdio>

namespace comparison {
namespace {

/// The element of that name, appended if there is none.
template <class Element>
Element& named(std::vector<Element>& elements, const std::string& name) {
  const auto found =
      std::find_if(elements.begin(), elements.end(), [&](const Element& e) { return e.name == name; });
  if (found != elements.end()) return *found;
  elements.emplace_back();
  elements.back().name = name;
  return elements.back();
}

}  // namespace

void Table::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const std::string& name = run.run_name.function_name;
    const std::size_t first = name.find('/');
    const std::size_t second = name.find('/', first + 1);
    if (second == std::string::npos) continue;
    Quantity& quantity = named(quantities_, name.substr(0, first));
    const std::string variant = name.substr(second + 1);
    if (std::find(quantity.variants.begin(), quantity.variants.end(), variant) == quantity.variants.end()) {
      quantity.variants.push_back(variant);
    }
    Row& row = named(quantity.rows, name.substr(first + 1, second - first - 1));
    const double time = run.cpu_accumulated_time / static_cast<double>(run.iterations) * 1e9;
    const auto [best, is_new] = row.nanoseconds.emplace(variant, time);
    if (!is_new) best->second = std::min(best->second, time);
  }
}

void Table::print(const Quantity& quantity) {
  std::printf("\n%s: nanoseconds a call (times as fast as %s)\n", quantity.name.c_str(),
              quantity.variants.front().c_str());
  std::printf("%-14s", "");
  for (const std::string& variant : quantity.variants) std::printf("%20s", variant.c_str());
  std::printf("\n");
  for (const Row& row : quantity.rows) {
    std::printf("%-14s", row.name.c_str());
    const auto base = row.nanoseconds.find(quantity.variants.front());
    for (const std::string& variant : quantity.variants) {
      const auto time = row.nanoseconds.find(variant);
      if (time == row.nanoseconds.end()) {
        std::printf("%20s", "-");
      } else if (time == base || base == row.nanoseconds.end()) {
        std::printf("%20.1f", time->second);
      } else {
        std::printf("%10.1f %8.1fx", time->second, base->second / time->second);
      }
    }
    std::printf("\n");
  }
}

void Table::Finalize() {
  for (const Quantity& quantity : quantities_) print(quantity);
}

}  // namespace comparison
