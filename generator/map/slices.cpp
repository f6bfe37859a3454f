// SPDX-License-Identifier: MIT
// Pictures of a map: planes through its centre, cells of one shade and one row drawn as one piece.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "map/quantities.h"
#include "report/html.h"

namespace qvgen::map {
namespace {

constexpr double panel = 220, gap = 60, left = 60, top = 60, row_height = 300;
/// Light to dark, so that a print without colours says the same; of nothing, and of what is reached.
constexpr std::array<const char*, 10> shades{"#e3eef7", "#cbdff0", "#aacfe5", "#82bada", "#5aa1cf",
                                             "#3c87c0", "#2470b1", "#12589f", "#084387", "#062f63"};

/// A plane: what runs to the right, what runs up, and what is the same everywhere.
struct Plane {
  std::size_t right, up, fixed;
};
constexpr std::array<Plane, 3> planes{{{0, 2, 1}, {1, 2, 0}, {0, 1, 2}}};

/// The shade of a value, 1 ... 10; 0 where nothing is reached, and -1 where nothing was looked for.
int shade_of(const Cube& cube, const Quantity& quantity, double largest, const Plane& plane,
             std::int64_t right, std::int64_t up) {
  std::array<std::int64_t, 3> at{};
  at.at(plane.right) = right;
  at.at(plane.up) = up;
  const Cell* cell = cube.at(at[0], at[1], at[2]);
  if (cell == nullptr) return -1;
  if (cell->reached == 0) return 0;
  const double share = largest > 0 ? cube.value(quantity, at[0], at[1], at[2]) / largest : 0;
  return 1 + static_cast<int>(std::clamp(share * 10, 0.0, 9.0));
}

/// The pieces of each shade as a path's commands, cells being one unit wide.
std::array<std::string, 11> pieces_of(const Cube& cube, const Quantity& quantity, double largest,
                                      const Plane& plane) {
  std::array<std::string, 11> paths;
  const std::int64_t half = cube.half();
  for (std::int64_t up = half; up >= -half; --up)
    for (std::int64_t right = -half; right <= half; ++right) {
      const int shade = shade_of(cube, quantity, largest, plane, right, up);
      if (shade < 0) continue;
      const std::int64_t first = right;
      while (right < half && shade_of(cube, quantity, largest, plane, right + 1, up) == shade) ++right;
      const std::int64_t width = right - first + 1;
      paths.at(static_cast<std::size_t>(shade)) +=
          fmt::format("M{} {}h{}v1h-{}z", first + half, half - up, width, width);
    }
  return paths;
}

/// Ends and middle of an axis, in metres.
std::string scale_of(const Cube& cube, const Plane& plane) {
  std::string text;
  for (const std::int64_t index : {-cube.half(), std::int64_t{0}, cube.half()}) {
    const double place =
        panel * (static_cast<double>(index + cube.half()) + 0.5) / static_cast<double>(cube.edge());
    text += fmt::format("<text x=\"{:.1f}\" y=\"{}\" class=\"m\">{}</text>", place, panel + 14,
                        report::coordinate(cube.place(plane.right, index)));
    text += fmt::format("<text x=\"-5\" y=\"{:.1f}\" class=\"e\">{}</text>", panel - place + 4,
                        report::coordinate(cube.place(plane.up, index)));
  }
  return text;
}

std::string panel_of(const Cube& cube, const Quantity& quantity, double largest, const Plane& plane) {
  constexpr const char* names = "xyz";
  std::string text = fmt::format("<g transform=\"scale({:.6g})\" shape-rendering=\"crispEdges\">",
                                 panel / static_cast<double>(cube.edge()));
  const auto paths = pieces_of(cube, quantity, largest, plane);
  for (std::size_t shade = 0; shade < paths.size(); ++shade)
    if (!paths.at(shade).empty())
      text += fmt::format("<path fill=\"{}\" d=\"{}\"/>", shade == 0 ? "#f2f2f2" : shades.at(shade - 1),
                          paths.at(shade));
  return text + "</g>" + scale_of(cube, plane) +
         fmt::format("<text x=\"{}\" y=\"{}\" class=\"m\">{} to the right, {} up, {} = {} m</text>\n",
                     panel / 2, panel + 30, names[plane.right], names[plane.up], names[plane.fixed],
                     report::coordinate(cube.place(plane.fixed, 0)));
}

/// From nothing to the largest value.
std::string legend(double largest, const std::string& label) {
  std::string text;
  for (std::size_t i = 0; i < shades.size(); ++i)
    text += fmt::format("<rect x=\"{}\" y=\"-22\" width=\"14\" height=\"10\" fill=\"{}\"/>", 14 * i,
                        shades.at(i));
  return text + fmt::format(
                    "<text x=\"-5\" y=\"-13\" class=\"e\">0</text>"
                    "<text x=\"145\" y=\"-13\">{:.3g}: {}</text>\n",
                    largest, report::escaped(label));
}

/// Returns the largest value that the three planes show.
double largest_of(const Cube& cube, const Quantity& quantity) {
  if (quantity.name == "share" || quantity.name == "limit_distance") return 1;
  double largest = 0;
  for (const Plane& plane : planes)
    for (std::int64_t right = -cube.half(); right <= cube.half(); ++right)
      for (std::int64_t up = -cube.half(); up <= cube.half(); ++up) {
        std::array<std::int64_t, 3> at{};
        at.at(plane.right) = right;
        at.at(plane.up) = up;
        if (cube.at(at[0], at[1], at[2]) == nullptr) continue;
        largest = std::max(largest, static_cast<double>(cube.value(quantity, at[0], at[1], at[2])));
      }
  return largest;
}

}  // namespace

std::string svg_text(const Part& part) {
  const Cube cube(part);
  const About& about = part.about;
  const auto quantities = quantities_of(about);
  const double width = left + 3 * (panel + gap);
  const double height = top + row_height * static_cast<double>(quantities.size());
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" "
      "font-family=\"sans-serif\" font-size=\"11\">\n<style>.m{{text-anchor:middle}}.e{{text-anchor:end}}"
      "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      "<text x=\"{}\" y=\"22\" font-size=\"14\">{}, asked for {} at places {:.4g} m apart{}</text>\n",
      width, height, width, left, report::escaped(about.robot), targets_text(about),
      about.plan.sphere.resolution, about.plan.limits ? ", within joint limits" : "");
  for (std::size_t row = 0; row < quantities.size(); ++row) {
    const double largest = largest_of(cube, quantities[row]);
    const double y = top + row_height * static_cast<double>(row);
    text += fmt::format("<g transform=\"translate({} {})\">", left, y) +
            legend(largest, quantities[row].label) + "</g>\n";
    for (std::size_t column = 0; column < planes.size(); ++column)
      text += fmt::format("<g transform=\"translate({} {})\">",
                          left + (panel + gap) * static_cast<double>(column), y) +
              panel_of(cube, quantities[row], largest, planes.at(column)) + "</g>\n";
  }
  return text + "</svg>\n";
}

}  // namespace qvgen::map
