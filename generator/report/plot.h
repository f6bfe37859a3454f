// SPDX-License-Identifier: MIT
// Charts of measured numbers as SVG: dots, lines and intervals over a common axis, which pages of
// calibrations and identifications show.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/drawing.h"

namespace qvgen::report {

/// Points (x, y) that belong together; those that are not finite break a line and are no dots.
struct Series {
  enum class Mark { dots, line };
  std::string name;
  Mark mark = Mark::dots;
  int colour = 0;  ///< 0 to 3: classes "series-0" and so on of the style sheet
  std::vector<std::pair<double, double>> points;
};

struct Plot {
  Caption caption;
  std::string x, y;          ///< labels, with units
  bool logarithmic = false;  ///< the y axis; what is not above zero is left out
  std::vector<Series> series;
  double height = 240;
};
std::string plot(const Plot& plot);

/// A value with an interval, drawn on a line of its own.
struct Interval {
  std::string name;
  double value = 0, low = 0, high = 0;
};
/// Intervals below each other on one scale, zero marked.
std::string interval_chart(const std::vector<Interval>& intervals, const std::string& x,
                           const Caption& caption);

/// At most so many points of a line: of each stretch the least and the greatest are kept.
std::vector<std::pair<double, double>> thinned(const std::vector<std::pair<double, double>>& points,
                                               std::size_t most = 1200);

}  // namespace qvgen::report
