// SPDX-License-Identifier: MIT
// A picture of all motions along a path: a panel for each joint, the path to the right, a colour for each
// motion. Limits are shaded; circles mark meetings, crosses wrist flips, bars limits.
#include "path/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "path/result.h"
#include "report/html.h"

namespace qvgen::path {
namespace {

constexpr double width = map_width, height = 130, gap = 34, left = map_left, top = map_top;
constexpr double degrees = 180 / std::numbers::pi;
/// Colours that stay apart in print and for most eyes (after Okabe and Ito).
constexpr std::array<const char*, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#444444", "#8c6d31"};

/// One joint's panel: what its values and the path become on the page.
struct Panel {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double end = 1, y = 0;

  [[nodiscard]] double across(double s) const { return left + width * s / end; }
  [[nodiscard]] double up(double value) const { return y + height * (high - value) / (high - low); }
};

Panel panel_of(const Result& result, std::size_t joint, const MovingJoint& moving, double y) {
  Panel panel;
  for (const Motion& motion : result.motions)
    for (const auto& [s, q] : motion.curve) {
      panel.low = std::min(panel.low, q.at(joint));
      panel.high = std::max(panel.high, q.at(joint));
    }
  if (std::isfinite(moving.limits.first)) panel.low = moving.limits.first;
  if (std::isfinite(moving.limits.second)) panel.high = moving.limits.second;
  if (!(panel.low <= panel.high)) panel.low = panel.high = 0;
  const double room = std::max(0.05 * (panel.high - panel.low), 0.05);
  panel.low -= room;
  panel.high += room;
  panel.end = std::max(1.0, result.end());
  panel.y = y;
  return panel;
}

std::string shade(const Panel& panel, double from, double to) {
  return fmt::format("<rect x=\"{}\" y=\"{:.2f}\" width=\"{}\" height=\"{:.2f}\" fill=\"#e8e8e8\"/>", left,
                     panel.up(to), width, panel.up(from) - panel.up(to));
}

std::string frame(const Panel& panel, const MovingJoint& joint) {
  std::string text;
  if (std::isfinite(joint.limits.first)) text += shade(panel, panel.low, joint.limits.first);
  if (std::isfinite(joint.limits.second)) text += shade(panel, joint.limits.second, panel.high);
  text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#999\"/>",
                      left, panel.y, width, height);
  text += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", left, panel.y - 6, report::escaped(joint.name));
  for (const double value : {panel.low, panel.high})
    text += fmt::format(
        "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left - 6, panel.up(value) + 4,
        joint.revolute ? fmt::format("{:.0f}°", value * degrees) : fmt::format("{:.3g} m", value));
  return text + "\n";
}

std::string mark(const MotionEnd& end, const Panel& panel, std::size_t joint, const char* colour) {
  const double x = panel.across(end.s), y = panel.up(end.q.at(joint));
  if (end.cause == "meeting" || end.cause == "boundary")
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"none\" stroke=\"{}\"/>", x, y,
                       colour);
  if (end.cause == "flip")
    return fmt::format("<path d=\"M{:.2f} {:.2f}l6 6m0 -6l-6 6\" stroke=\"{}\"/>", x - 3, y - 3, colour);
  if (end.cause == "limit" && end.partner == static_cast<int>(joint))
    return fmt::format("<path d=\"M{:.2f} {:.2f}h8\" stroke=\"{}\" stroke-width=\"2\"/>", x - 4, y, colour);
  return "";
}

std::string curve(const Motion& motion, const Panel& panel, std::size_t joint, std::size_t number) {
  const char* colour = colours.at(number % colours.size());
  std::string points;
  for (const auto& [s, q] : motion.curve)
    points += fmt::format("{:.2f},{:.2f} ", panel.across(s), panel.up(q.at(joint)));
  return fmt::format("<g data-motion=\"{}\"><polyline points=\"{}\" fill=\"none\" stroke=\"{}\"/>", number,
                     points, colour) +
         mark(motion.begin, panel, joint, colour) + mark(motion.end, panel, joint, colour) + "</g>\n";
}

}  // namespace

std::string picture_of(const Result& result, const Task& task, const std::string& title) {
  const double total = top + static_cast<double>(task.joints.size()) * (height + gap) + 20;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" style=\"font:12px sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"{}\" y=\"20\" "
      "font-size=\"15\">{}</text>\n",
      left + width + 30, total, left, report::escaped(title));
  for (std::size_t joint = 0; joint < task.joints.size(); ++joint) {
    const Panel panel =
        panel_of(result, joint, task.joints[joint], top + static_cast<double>(joint) * (height + gap));
    text += frame(panel, task.joints[joint]);
    for (std::size_t i = 0; i < result.motions.size(); ++i) text += curve(result.motions[i], panel, joint, i);
  }
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{:.4g}</text>", left + width * share,
                        total - 20 - gap + 16, share * std::max(1.0, result.end()));
  return text + "\n</svg>\n";
}

}  // namespace qvgen::path
