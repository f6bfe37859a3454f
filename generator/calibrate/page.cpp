// SPDX-License-Identifier: MIT
#include "calibrate/page.h"

#include <fmt/format.h>

#include "calibrate/dh.h"
#include "calibrate/interval.h"
#include "report/page.h"
#include "report/pieces.h"
#include "report/plot.h"

namespace qvgen::calibrate {
namespace {

using report::bullets;
using report::Cell;
using report::figure;
using report::HtmlTable;
using report::number_cell;
using report::paragraph;
using report::scrolled;
using report::Section;
using report::Series;
using report::text_cell;

constexpr double milli = 1e3;

/// Returns a verdict on the hold-out residual in words.
std::string verdict(const Calibration& found) {
  if (!found.hold_out || !found.expected)
    return "There are too few rows to leave some out: how well other postures are predicted was not tried.";
  const double measured = found.hold_out->position, promised = found.expected->position;
  const std::string numbers =
      fmt::format("Rows that were not fitted are predicted to {:.4f} mm; {:.4f} mm is expected. ",
                  milli * measured, milli * promised);
  return numbers +
         (measured > 1.5 * promised
              ? "That is more by half: the arm has errors that are not geometric, or the rows are too few."
              : "The arm is known as well as these data can tell.");
}

Section summary(const DataSet& set, const Calibration& found) {
  const bool turns = found.identifiable.setup.has_orientation();
  HtmlTable table{"Residuals, root mean squares",
                  {text_cell(""), {"before", true}, {"after", true}, {"hold-out", true}, {"expected", true}},
                  {}};
  const auto row = [&](const std::string& name, double Size::*member) {
    std::vector<Cell> cells{text_cell(name), number_cell(milli * found.before.*member, 4),
                            number_cell(milli * found.after.*member, 4)};
    for (const auto& size : {found.hold_out, found.expected})
      cells.push_back(size ? number_cell(milli * (*size).*member, 4) : Cell{"–", true});
    table.rows.push_back(cells);
  };
  row("position, mm", &Size::position);
  if (turns) row("orientation, mrad", &Size::angle);
  std::string deviations = fmt::format("A measurement deviates by {:.4g} mm", milli * found.sigma);
  if (turns) deviations += fmt::format(" and {:.4g} mrad", milli * found.sigma_angle);
  deviations += set.sigma_known ? fmt::format(", as was said; residuals are {:.2f} of that.", found.misfit)
                                : ", by the residuals themselves.";
  return {"summary", "Summary",
          paragraph(fmt::format("{} rows of {}, of which {} were left out.", set.rows.size(), set.file,
                                found.outliers.size())) +
              html(table) + paragraph(verdict(found)) + paragraph(deviations)};
}

/// Returns the residual of each row by its line: the position's length in mm, or the turn's in mrad.
Series residuals_of(const DataSet& set, const Calibration& found, const State& state, bool turn) {
  Series series;
  for (const Measurement& row : set.rows) {
    const Eigen::VectorXd value = residual_of(found.identifiable.model, set.data, state, row, false).value;
    const Eigen::Index heads = std::min<Eigen::Index>(3, value.size());
    series.points.emplace_back(row.line, milli * (turn ? value.tail(3) : value.head(heads)).norm());
  }
  return series;
}

std::string residual_plot(const DataSet& set, const Calibration& found, bool turn) {
  Series before = residuals_of(set, found, found.nominal, turn),
         after = residuals_of(set, found, found.state, turn);
  before.name = "arm as described";
  after.name = "calibrated";
  after.colour = 1;
  const std::string what = turn ? "orientation" : "position";
  return figure(
      report::plot({{"residual-" + what, "Residuals of the " + what,
                     "Each row's residual before and after calibration."},
                    "line of the table",
                    turn ? "mrad" : "mm",
                    true,
                    {before, after}}),
      "Residual of the " + what +
          " of each row, with the frames of the instrument fitted in both cases; the scale is logarithmic.");
}

Section residuals(const DataSet& set, const Calibration& found) {
  std::string body = residual_plot(set, found, false);
  if (found.identifiable.setup.has_orientation()) body += residual_plot(set, found, true);
  if (found.outliers.empty()) return {"residuals", "Residuals", body + paragraph("No row stands out.")};
  std::vector<std::string> lines;
  for (const Outlier& each : found.outliers)
    lines.push_back(fmt::format("line {}: {:.0f} standard deviations", each.line, each.size));
  return {"residuals", "Residuals",
          body + paragraph("Left out, since they stand out from the others:") + bullets(lines)};
}

std::string chart_of(const std::vector<ErrorEstimate>& all, const std::string& unit, const std::string& id) {
  std::vector<report::Interval> intervals;
  for (const ErrorEstimate& each : all)
    if (each.unit == unit) intervals.push_back({each.name, each.value, each.low, each.high});
  if (intervals.empty()) return "";
  return figure(
      interval_chart(intervals, unit, {id, "Errors in " + unit, "Each error with its interval of 95 %."}),
      "Errors with their intervals of 95 %, in " + unit + ".");
}

Section errors(const Calibration& found) {
  const std::vector<ErrorEstimate> all = error_estimates(found);
  HtmlTable table{"Errors of the arm",
                  {text_cell("error"),
                   {"value", true},
                   text_cell(""),
                   {"deviation", true},
                   {"95 % from", true},
                   {"to", true},
                   text_cell("")},
                  {}};
  for (const ErrorEstimate& each : all)
    table.rows.push_back({text_cell(each.name), number_cell(each.value, 5), text_cell(each.unit),
                          number_cell(each.deviation, 3), number_cell(each.low, 5), number_cell(each.high, 5),
                          text_cell(each.is_significant() ? "" : "may be zero")});
  std::string body = paragraph(
                         "The true value lies within an interval with a probability of 95 %. "
                         "Where the interval has zero in it, the data do not show that there is an error.") +
                     chart_of(all, "mm", "errors-mm") + chart_of(all, "mrad", "errors-mrad") + html(table);
  const std::vector<std::string> together = correlated(found);
  if (!together.empty())
    body += paragraph(
                "These pairs hang together: the data know their combination better than either alone. "
                "Predictions do not "
                "suffer from it.") +
            bullets(together);
  return {"errors", "Errors", body};
}

Section untold(const Calibration& found) {
  const auto part = [](const std::string& title, const std::vector<std::string>& sentences) {
    return "<h3>" + title + "</h3>\n" + (sentences.empty() ? paragraph("None.") : bullets(sentences));
  };
  return {"untold", "Not told",
          part("No data of this kind can tell", found.identifiable.never) +
              paragraph("These stay zero by choice. What the arm does, seen by this instrument, does not "
                        "depend on them.") +
              part("These data do not tell", found.untold) +
              paragraph("Other postures would: move the joints named through more of their range.")};
}

Section table_section(const Calibration& found) {
  const DhChange change = dh_change(found, DhForm::hayati);
  HtmlTable table{
      "Rows of Denavit and Hartenberg after calibration, and the changes", {text_cell("joint")}, {}};
  for (const char* name : {"θ / rad", "d / m", "a / m", "α / rad", "β / rad", "Δθ / mrad", "Δd / mm",
                           "Δa / mm", "Δα / mrad", "Δβ / mrad"})
    table.head.push_back({name, true});
  for (std::size_t i = 0; i < change.after.rows.size(); ++i) {
    const DhRow &from = change.before.rows[i], &to = change.after.rows[i];
    std::vector<Cell> cells{text_cell(std::to_string(i + 1))};
    for (const double each : {to.theta, to.d, to.a, to.alpha, to.beta}) cells.push_back(number_cell(each, 7));
    const double theta = std::remainder(to.theta - from.theta, 2 * 3.14159265358979323846);
    for (const double each :
         {theta, to.d - from.d, to.a - from.a, to.alpha - from.alpha, to.beta - from.beta})
      cells.push_back(number_cell(milli * each, 4));
    table.rows.push_back(cells);
  }
  return {"dh", "Table for a controller",
          paragraph(
              "A row is turn(z, θ) shift(z, d) shift(x, a) turn(x, α) turn(y, β). Axes that are parallel by "
              "description have β. --format dh writes the table with four numbers a row.") +
              scrolled(table)};
}

}  // namespace

std::string page(const model::Robot& robot, const DataSet& set, const Calibration& found) {
  return html(report::Page{
      "Calibration of " + robot.name,
      {robot.title},
      false,
      {summary(set, found), residuals(set, found), errors(found), untold(found), table_section(found)},
      ""});
}

}  // namespace qvgen::calibrate
