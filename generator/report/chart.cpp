// SPDX-License-Identifier: MIT
#include "report/chart.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/html.h"

namespace qvgen::report {

std::string bar_chart(const std::vector<Bar>& bars, const Caption& caption) {
  constexpr double width = 640;
  constexpr double left = 190;
  constexpr double right = 150;
  constexpr double pitch = 24;
  constexpr double thick = 13;
  int most = 1;
  for (const Bar& bar : bars) most = std::max(most, bar.multiplications + bar.additions);
  const double scale = (width - left - right) / most;
  std::string body;
  double y = 4;
  for (const Bar& bar : bars) {
    const double first = bar.multiplications * scale;
    const double second = bar.additions * scale;
    const std::string own = bar.marked ? " own" : "";
    const double base = y + thick - 2;
    body += fmt::format("<text class=\"bar-name{}\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n", own,
                        left - 8, coordinate(base), escaped(bar.name));
    body += fmt::format("<rect class=\"mul{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", own, left,
                        coordinate(y), coordinate(first), thick);
    body += fmt::format("<rect class=\"add{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", own,
                        coordinate(left + first), coordinate(y), coordinate(second), thick);
    body += fmt::format("<text class=\"bar-value\" x=\"{}\" y=\"{}\">{} + {}{}</text>\n",
                        coordinate(left + first + second + 7), coordinate(base), bar.multiplications,
                        bar.additions, bar.note.empty() ? "" : "  " + escaped(bar.note));
    y += pitch;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-labelledby=\"{}-title {}-text\">\n"
      "<title id=\"{}-title\">{}</title>\n<desc id=\"{}-text\">{}</desc>\n{}</svg>\n",
      width, coordinate(y), caption.id, caption.id, caption.id, escaped(caption.title), caption.id,
      escaped(caption.description), body);
}

}  // namespace qvgen::report
