// SPDX-License-Identifier: MIT
#include "report/reach_section.h"

#include <fmt/format.h>

#include "emit/math/notation.h"
#include "emit/render.h"
#include "model/followers.h"
#include "report/chain.h"
#include "report/reach.h"
#include "report/workspace.h"

namespace qvgen::report {
namespace {

/// Longer formulas say nothing to a reader.
constexpr std::size_t longest_readable = 400;

/// Those that are not too long, and how many are.
std::string readable_html(const std::vector<std::string>& formulas) {
  std::vector<std::string> short_ones;
  for (const std::string& formula : formulas)
    if (formula.size() <= longest_readable) short_ones.push_back(formula);
  std::string html;
  if (!short_ones.empty()) html = formulas_html(short_ones);
  if (const std::size_t left_out = formulas.size() - short_ones.size(); left_out > 0)
    html += fmt::format("<p>{} too long to be read.</p>\n",
                        left_out == 1 ? "One is" : fmt::format("{} are", left_out));
  return html;
}

std::string boundary_html(const model::Robot& robot) {
  if (model::has_followers(robot)) return "";
  std::string html;
  for (const WorkspacePassage& passage : workspace_passages(robot, emit::Notation::latex)) {
    std::string words;
    for (const std::string& line : passage.words)
      words += (words.empty() ? "" : words.back() == ',' ? " " : "<br/>\n") + with_formulas(line);
    html += "<p>" + words + "</p>\n" + readable_html(passage.formulas);
  }
  return html.empty() ? "" : "<h3 id=\"boundary\">Boundary in closed form</h3>\n" + html;
}

}  // namespace

Section reach_section(const model::Robot& robot) {
  const Reach reach = reach_of(chain_of(robot));
  const std::string text = fmt::format(
      "The farthest of {} points lies {:.4g} m from the first axis’s origin, the nearest {:.4g} m; up to "
      "{:.4g} m beside "
      "the axis, from {:.4g} m to {:.4g} m along it.",
      Reach::samples, reach.farthest, reach.nearest, reach.widest, reach.lowest, reach.highest);
  return {"reach", "Reach",
          emit::render("report/reach.html",
                       {{"svg", cross_section(reach, {"reach-figure", "Cross-section of the workspace",
                                                      "Half plane through the first axis. " + text})},
                        {"text", text},
                        {"boundary", boundary_html(robot)}})};
}

}  // namespace qvgen::report
