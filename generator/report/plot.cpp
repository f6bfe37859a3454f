// SPDX-License-Identifier: MIT
#include "report/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "report/html.h"

namespace qvgen::report {
namespace {

constexpr double plot_width = 720, plot_left = 70, plot_right = 12, plot_top = 24, plot_bottom = 40;

/// A range of numbers with round marks.
struct Scale {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Makes an empty range one, and adds a margin.
  void widen() {
    if (!(low <= high)) low = 0, high = 1;
    const double margin = high > low ? 0.04 * (high - low) : std::max(1e-12, 0.1 * std::abs(high));
    low -= margin;
    high += margin;
  }
  [[nodiscard]] double share(double value) const { return (value - low) / (high - low); }
  [[nodiscard]] std::vector<double> marks() const {
    const double rough = (high - low) / 6, power = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = power * (rough / power < 1.5   ? 1
                                 : rough / power < 3.5 ? 2
                                 : rough / power < 7.5 ? 5
                                                       : 10);
    std::vector<double> result;
    for (double at = std::ceil(low / step) * step; at <= high; at += step)
      result.push_back(std::abs(at) < 1e-9 * step ? 0 : at);
    return result;
  }
};

std::string begin_of(const Caption& caption, double height) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-labelledby=\"{}-title {}-text\">\n<title id=\"{}-title\">{}</title>\n<desc "
      "id=\"{}-text\">{}</desc>\n",
      plot_width, coordinate(height), caption.id, caption.id, caption.id, escaped(caption.title), caption.id,
      escaped(caption.description));
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", coordinate(x), coordinate(y),
                     anchor, escaped(text));
}

std::string line_at(const char* kind, double x1, double y1, double x2, double y2) {
  return fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", kind, coordinate(x1),
                     coordinate(y1), coordinate(x2), coordinate(y2));
}

/// One plot: its scales, and where they are on the page.
class Plotter {
 public:
  explicit Plotter(const Plot& what) : plot_(what), bottom_(plot_top + what.height) {
    for (const Series& series : what.series)
      for (const auto& [x, y] : series.points)
        if (is_shown(x, y)) {
          x_.take(x);
          y_.take(height_of(y));
        }
    x_.widen();
    y_.widen();
  }

  [[nodiscard]] std::string text() const {
    std::string body = begin_of(plot_.caption, bottom_ + plot_bottom) + grid();
    double at = plot_left;
    for (const Series& series : plot_.series) {
      body += fmt::format("<g class=\"series-{}\">\n{}", series.colour,
                          series.mark == Series::Mark::dots ? dots(series) : lines(series));
      body += fmt::format("<rect x=\"{0}\" y=\"6\" width=\"10\" height=\"10\"/></g>\n", coordinate(at)) +
              text_at(at + 15, 15, "start", series.name);
      at += 40 + 7 * static_cast<double>(letters_in(series.name));
    }
    return body + "</svg>\n";
  }

 private:
  [[nodiscard]] bool is_shown(double x, double y) const {
    return std::isfinite(x) && std::isfinite(y) && (!plot_.logarithmic || y > 0);
  }
  [[nodiscard]] double height_of(double y) const { return plot_.logarithmic ? std::log10(y) : y; }
  [[nodiscard]] double across(double x) const {
    return plot_left + (plot_width - plot_left - plot_right) * x_.share(x);
  }
  [[nodiscard]] double up(double height) const { return bottom_ - plot_.height * y_.share(height); }

  [[nodiscard]] std::string grid() const {
    std::string body;
    for (const double mark : y_.marks()) {
      body += line_at("grid", plot_left, up(mark), plot_width - plot_right, up(mark));
      body += text_at(plot_left - 6, up(mark) + 4, "end",
                      fmt::format("{:.3g}", plot_.logarithmic ? std::pow(10, mark) : mark));
    }
    for (const double mark : x_.marks()) {
      body += line_at("grid", across(mark), bottom_, across(mark), bottom_ + 4);
      body += text_at(across(mark), bottom_ + 17, "middle", fmt::format("{:.4g}", mark));
    }
    body += text_at(plot_width - plot_right, bottom_ + 33, "end", plot_.x);
    return body + text_at(plot_width - plot_right, 15, "end", plot_.y);
  }

  [[nodiscard]] std::string dots(const Series& series) const {
    std::string body;
    for (const auto& [x, y] : series.points)
      if (is_shown(x, y))
        body += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"2.4\"/>\n", coordinate(across(x)),
                            coordinate(up(height_of(y))));
    return body;
  }

  [[nodiscard]] std::string lines(const Series& series) const {
    std::string path;
    bool goes_on = false;
    for (const auto& [x, y] : series.points) {
      const bool shown = is_shown(x, y);
      if (shown)
        path +=
            fmt::format("{}{} {}", goes_on ? "L" : "M", coordinate(across(x)), coordinate(up(height_of(y))));
      goes_on = shown;
    }
    return "<path d=\"" + path + "\"/>\n";
  }

  const Plot& plot_;
  double bottom_;
  Scale x_, y_;
};

}  // namespace

std::string plot(const Plot& plot) { return Plotter(plot).text(); }

std::string interval_chart(const std::vector<Interval>& intervals, const std::string& x,
                           const Caption& caption) {
  constexpr double names = 300, pitch = 20;
  Scale scale;
  scale.take(0);
  for (const Interval& each : intervals) scale.take(each.low), scale.take(each.high);
  scale.widen();
  const double bottom = plot_top + pitch * static_cast<double>(intervals.size());
  const auto across = [&](double value) {
    return names + (plot_width - names - plot_right) * scale.share(value);
  };
  std::string body = begin_of(caption, bottom + plot_bottom);
  for (const double mark : scale.marks()) {
    body += line_at(mark == 0 ? "zero" : "grid", across(mark), plot_top - 8, across(mark), bottom);
    body += text_at(across(mark), bottom + 15, "middle", fmt::format("{:.3g}", mark));
  }
  double y = plot_top + 4;
  for (const Interval& each : intervals) {
    body += text_at(names - 10, y + 4, "end", each.name);
    body += "<g class=\"series-0\">\n" + line_at("interval", across(each.low), y, across(each.high), y);
    body += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3\"/></g>\n", coordinate(across(each.value)),
                        coordinate(y));
    y += pitch;
  }
  return body + text_at(plot_width - plot_right, bottom + 33, "end", x) + "</svg>\n";
}

std::vector<std::pair<double, double>> thinned(const std::vector<std::pair<double, double>>& points,
                                               std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<std::pair<double, double>> result;
  const std::size_t stretches = most / 2;
  for (std::size_t i = 0; i < stretches; ++i) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(i * points.size() / stretches);
    const auto end = points.begin() + static_cast<std::ptrdiff_t>((i + 1) * points.size() / stretches);
    const auto by_y = [](const auto& a, const auto& b) { return a.second < b.second; };
    auto [least, greatest] = std::minmax_element(begin, end, by_y);
    if (greatest < least) std::swap(least, greatest);
    result.push_back(*least);
    if (greatest != least) result.push_back(*greatest);
  }
  return result;
}

}  // namespace qvgen::report
