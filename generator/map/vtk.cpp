// SPDX-License-Identifier: MIT
// The legacy format of VTK: structured points, which ParaView and VisIt read; binary, the highest byte first.
#include <bit>

#include <fmt/format.h>

#include "map/quantities.h"

namespace qvgen::map {
namespace {

void append_values(const Cube& cube, const Quantity& quantity, std::string& text) {
  text += fmt::format("SCALARS {} float 1\nLOOKUP_TABLE default\n", quantity.name);
  const std::int64_t half = cube.half();
  for (std::int64_t k = -half; k <= half; ++k)
    for (std::int64_t j = -half; j <= half; ++j)
      for (std::int64_t i = -half; i <= half; ++i) {
        const auto bits = std::bit_cast<std::uint32_t>(cube.value(quantity, i, j, k));
        for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(bits >> shift & 0xFFU);
      }
  text += '\n';
}

}  // namespace

std::string vtk_text(const Part& part) {
  const Cube cube(part);
  const About& about = part.about;
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\nreachability of {}, asked for {} at each place\nBINARY\nDATASET "
      "STRUCTURED_POINTS\n"
      "DIMENSIONS {} {} {}\nORIGIN {} {} {}\nSPACING {} {} {}\nPOINT_DATA {}\n",
      about.robot, targets_text(about), cube.edge(), cube.edge(), cube.edge(), cube.place(0, -cube.half()),
      cube.place(1, -cube.half()), cube.place(2, -cube.half()), about.plan.sphere.resolution,
      about.plan.sphere.resolution, about.plan.sphere.resolution, cube.edge() * cube.edge() * cube.edge());
  for (const Quantity& quantity : quantities_of(about)) append_values(cube, quantity, text);
  return text;
}

}  // namespace qvgen::map
