// SPDX-License-Identifier: MIT
#include "report/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "report/html.h"

namespace qvgen::report {
namespace {

/// Fractions that fill a cube evenly, the i-th point's k-th coordinate (Roberts 2018, generalised golden
/// ratio).
class EvenPoints {
 public:
  explicit EvenPoints(std::size_t dimensions) {
    double ratio = 2;
    for (int i = 0; i < 60; ++i) ratio = std::pow(1 + ratio, 1 / (static_cast<double>(dimensions) + 1));
    double step = 1;
    for (std::size_t k = 0; k < dimensions; ++k) steps_.push_back(std::fmod(step /= ratio, 1.0));
  }
  [[nodiscard]] double at(int i, std::size_t k) const { return std::fmod(0.5 + i * steps_[k], 1.0); }

 private:
  std::vector<double> steps_;
};

Vector tool_point(const Chain& chain, const std::vector<double>& q) {
  Vector point = chain.tool.motion.translation();
  for (std::size_t i = chain.joints.size(); i-- > 0;) {
    const ChainJoint& joint = chain.joints[i];
    point = joint.after.motion * point;
    point =
        joint.revolute ? Vector(turn(joint.axis, q[i]).linear() * point) : Vector(point + q[i] * joint.axis);
    point = joint.before.motion * point;
  }
  return chain.base.motion * point;
}

/// A round number of metres, about a fifth of the picture.
double tick_of(double extent) {
  const double rough = extent / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

}  // namespace

Reach reach_of(const Chain& chain) {
  const std::size_t count = chain.joints.size();
  const Posture zero = posture_of(chain, std::vector<double>(count));
  const Vector origin = zero.joints.front().point;
  const Vector axis = zero.joints.front().axis;
  const EvenPoints even(count);
  Reach reach;
  reach.nearest = std::numeric_limits<double>::max();
  reach.lowest = std::numeric_limits<double>::max();
  reach.highest = -reach.lowest;
  std::vector<double> q(count);
  for (int i = 0; i < Reach::samples; ++i) {
    for (std::size_t k = 0; k < count; ++k) {
      const auto [lower, upper] = range_of(chain, k);
      q[k] = lower + even.at(i, k) * (upper - lower);
    }
    const Vector from = tool_point(chain, following(chain, q)) - origin;
    const double height = from.dot(axis);
    const double radius = (from - height * axis).norm();
    reach.points.push_back({radius, height});
    reach.farthest = std::max(reach.farthest, from.norm());
    reach.nearest = std::min(reach.nearest, from.norm());
    reach.widest = std::max(reach.widest, radius);
    reach.lowest = std::min(reach.lowest, height);
    reach.highest = std::max(reach.highest, height);
  }
  return reach;
}

std::string cross_section(const Reach& reach, const Caption& caption) {
  constexpr int cells = 72;  // along the longer side
  constexpr double margin = 34;
  constexpr double longest = 360;
  const double tall = std::max(reach.highest - reach.lowest, 1e-6);
  const double extent = std::max({reach.widest, tall, 1e-6});
  const double scale = longest / extent;
  const double size = extent / cells;
  std::set<std::array<int, 2>> filled;
  for (const auto& [radius, height] : reach.points)
    filled.insert({static_cast<int>(std::floor(radius / size)),
                   static_cast<int>(std::floor((reach.highest - height) / size))});
  std::string path;
  for (auto cell = filled.begin(); cell != filled.end();) {  // columns, top to bottom
    const auto [column, top] = *cell;
    int bottom = top;
    while (++cell != filled.end() && (*cell)[0] == column && (*cell)[1] == bottom + 1) ++bottom;
    path += fmt::format("M{} {}h{}v{}h-{}z", coordinate(margin + column * size * scale),
                        coordinate(12 + top * size * scale), coordinate(size * scale),
                        coordinate((bottom - top + 1) * size * scale), coordinate(size * scale));
  }
  const double width = std::max(reach.widest, 1e-6) * scale;
  const double height = tall * scale;
  const double tick = tick_of(extent);
  std::string axes = fmt::format("<path class=\"scale\" d=\"M{} 12v{}h{}\"/>\n", margin, coordinate(height),
                                 coordinate(width + 8));
  for (int i = 0; i * tick <= reach.widest + 1e-9; ++i)
    axes += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>\n",
                        coordinate(margin + i * tick * scale), coordinate(height + 28), i * tick);
  for (double at = std::ceil(reach.lowest / tick) * tick; at <= reach.highest + 1e-9; at += tick)
    axes +=
        fmt::format("<text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{:.3g}</text>\n", margin - 5,
                    coordinate(16 + (reach.highest - at) * scale), std::abs(at) < tick / 100 ? 0.0 : at);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"reach\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-labelledby=\"{}-title {}-text\">\n"
      "<title id=\"{}-title\">{}</title>\n<desc id=\"{}-text\">{}</desc>\n<path class=\"filled\" "
      "d=\"{}\"/>\n{}</svg>\n",
      coordinate(margin + width + 20), coordinate(height + 36), caption.id, caption.id, caption.id,
      escaped(caption.title), caption.id, escaped(caption.description), path, axes);
}

}  // namespace qvgen::report
