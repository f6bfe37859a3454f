// SPDX-License-Identifier: MIT
#include "map/quantities.h"

#include <limits>

namespace qvgen::map {

std::vector<Quantity> quantities_of(const About& about) {
  std::vector<Quantity> all{
      {"share",
       about.task == "position" ? "reached or not"
                                : "share of the " + target_name(about) + " that are reached",
       [](const Cell& cell, double targets) { return static_cast<float>(cell.reached / targets); }},
      {"mean_solutions", "solutions, on average of those that are reached",
       [](const Cell& cell, double) {
         return cell.reached == 0 ? 0.0F
                                  : static_cast<float>(static_cast<double>(cell.solutions) / cell.reached);
       }},
      {"most_solutions", "solutions at most",
       [](const Cell& cell, double) { return static_cast<float>(cell.most); }},
      {"manipulability", "best manipulability: product of the Jacobian's singular values",
       [](const Cell& cell, double) { return static_cast<float>(cell.manipulability); }}};
  if (about.limits_known)
    all.push_back({"limit_distance", "best distance from joint limits: 0 at a limit, 1 in the middle of all",
                   [](const Cell& cell, double) { return static_cast<float>(cell.limit_distance); }});
  return all;
}

Cube::Cube(const Part& part) : part_(part), grid_(part.about.plan.sphere) {
  cells_.assign(edge() * edge() * edge(), nullptr);
  std::uint64_t index = 0;
  for (const auto& [block, cells] : part.blocks)
    for (index = grid_.first_of(block); const Cell& cell : cells) {
      const auto [i, j, k] = grid_.cell(index++);
      cells_[(static_cast<std::size_t>(i + half()) * edge() + static_cast<std::size_t>(j + half())) * edge() +
             static_cast<std::size_t>(k + half())] = &cell;
    }
}

const Cell* Cube::at(std::int64_t i, std::int64_t j, std::int64_t k) const {
  return cells_[(static_cast<std::size_t>(i + half()) * edge() + static_cast<std::size_t>(j + half())) *
                    edge() +
                static_cast<std::size_t>(k + half())];
}

float Cube::value(const Quantity& quantity, std::int64_t i, std::int64_t j, std::int64_t k) const {
  const Cell* cell = at(i, j, k);
  if (cell == nullptr && !part_.about.own_reach) return std::numeric_limits<float>::quiet_NaN();
  return quantity.of(cell == nullptr ? Cell() : *cell, static_cast<double>(part_.about.plan.targets));
}

double Cube::place(std::size_t axis, std::int64_t index) const {
  const Sphere& sphere = part_.about.plan.sphere;
  return sphere.centre.at(axis) + sphere.resolution * static_cast<double>(index);
}

}  // namespace qvgen::map
