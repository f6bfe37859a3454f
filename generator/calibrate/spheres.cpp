// SPDX-License-Identifier: MIT
#include "calibrate/spheres.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "calibrate/geometry.h"
#include "calibrate/urdf.h"
#include "description/xml/urdf_spheres.h"
#include "measured/table.h"

namespace qvgen::calibrate {
namespace {

using description::Diagnostic;
using measured::Quantity;

constexpr std::size_t most_spheres = 200;
constexpr std::array lengths{"x", "y", "z", "radius"};

std::vector<measured::Wanted> wanted() {
  std::vector<measured::Wanted> all{{"link", Quantity::number, true, false, {}}};
  for (const char* name : lengths) all.push_back({name, Quantity::length, true, false, {}});
  return all;
}

/// Returns what is wrong with a row, and what would be right; nothing if all is well.
std::pair<std::string, std::string> mistake_of(double link, double radius, std::size_t links) {
  if (link != std::floor(link) || link < 0 || link > static_cast<double>(links))
    return {fmt::format("there is no link {:.6g}", link),
            fmt::format("links are numbered 1 to {}, and 0 is the base", links)};
  if (!(radius > 0) || radius > 10)
    return {fmt::format("a sphere with a radius of {:.6g} m", radius),
            "radii are above 0; write radius [mm] in the header for millimetres"};
  return {};
}

}  // namespace

SpheresResult read_spheres(const std::filesystem::path& path, const model::Robot& robot, double length_unit) {
  measured::TableOptions options;
  options.length_unit = length_unit;
  measured::TableResult read = measured::read_table(path, wanted(), options);
  SpheresResult result{{}, std::move(read.diagnostics), false};
  result.good = std::none_of(result.diagnostics.begin(), result.diagnostics.end(),
                             [](const auto& each) { return each.severity == Diagnostic::error; });
  if (result.good && read.table.rows() > most_spheres) {
    result.good = false;
    result.diagnostics.push_back(
        {path.string(), read.table.lines[most_spheres], 1, Diagnostic::error,
         fmt::format("{} spheres", read.table.rows()),
         fmt::format("at most {} are taken: make some of them larger", most_spheres)});
  }
  if (!result.good) return result;
  const auto value = [&](const char* name, std::size_t row) { return (*read.table.find(name))[row]; };
  for (std::size_t row = 0; row < read.table.rows(); ++row) {
    const double link = value("link", row), radius = value("radius", row);
    if (auto [message, hint] = mistake_of(link, radius, robot.joints.size()); !message.empty()) {
      result.good = false;
      result.diagnostics.push_back(
          {path.string(), read.table.lines[row], 1, Diagnostic::error, message, hint});
      continue;
    }
    const auto index = static_cast<std::size_t>(link);
    const Vec<double> centre{value("x", row), value("y", row), value("z", row)};
    result.spheres.push_back({index, link_frame(robot, index) * centre, radius});
  }
  return result;
}

std::vector<Sphere> spheres_of_urdf(const std::string& text, const description::ReadOptions& options,
                                    const model::Robot& robot) {
  std::vector<Sphere> result;
  for (const auto& each : description::xml::urdf_spheres(text, options)) {
    if (each.joints > robot.joints.size() || !(each.radius > 0)) continue;
    Rigid<double> way = link_frame(robot, each.joints);
    for (const auto& origin : each.ways) way = way * rigid_of(origin);
    result.push_back({each.joints, way.position, each.radius});
  }
  return result;
}

}  // namespace qvgen::calibrate
