// SPDX-License-Identifier: MIT
#include "calibrate/report.h"

#include <fmt/format.h>

#include "calibrate/interval.h"

namespace qvgen::calibrate {
namespace {

constexpr double milli = 1e3;

std::string name_of(Data data) {
  static constexpr std::array names{"poses",     "positions",        "poses of a board",
                                    "distances", "points of planes", "points of spheres"};
  return names.at(static_cast<std::size_t>(data));
}

std::string list_of(const std::string& title, const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& each : sentences) text += "  " + each + "\n";
  return text.empty() ? "" : title + "\n" + text;
}

std::string column(const std::optional<Size>& size, double Size::*member) {
  return size ? fmt::format("{:>12.4f}", milli * (*size).*member) : fmt::format("{:>12}", "-");
}

std::string sizes_row(const std::string& name, const Calibration& found, double Size::*member) {
  return fmt::format("{:<26}{}{}{}{}\n", name, column(found.before, member), column(found.after, member),
                     column(found.hold_out, member), column(found.expected, member));
}

std::string sizes(const Calibration& found) {
  std::string text = fmt::format("{:<26}{:>12}{:>12}{:>12}{:>12}\n", "residuals (rms)", "before", "after",
                                 "hold-out", "expected");
  text += sizes_row("position [mm]", found, &Size::position);
  if (found.identifiable.setup.has_orientation())
    text += sizes_row("orientation [mrad]", found, &Size::angle);
  return text;
}

/// Returns the errors of the arm with the deviations of their estimates and the intervals of 95 %.
std::string errors(const Calibration& found) {
  std::string text =
      fmt::format("{:<44}{:>12}  {:<5}{:>11}{:>26}\n", "error", "value", "", "deviation", "95 % interval");
  for (const ErrorEstimate& each : error_estimates(found))
    text += fmt::format("{:<44}{:>+12.5f}  {:<5}{:>11.5f}{:>+13.5f}{:>+13.5f}{}\n", each.name, each.value,
                        each.unit, each.deviation, each.low, each.high,
                        each.is_significant() ? "" : "  may be zero");
  return text;
}

std::string outliers(const DataSet& set, const Calibration& found) {
  std::string text;
  for (const Outlier& each : found.outliers)
    text += fmt::format("{}:{}: left out: {:.0f} standard deviations from the others\n", set.file, each.line,
                        each.size);
  return text;
}

std::string deviations(const DataSet& set, const Calibration& found) {
  const std::string angle = found.identifiable.setup.has_orientation()
                                ? fmt::format(", {:.4g} mrad", milli * found.sigma_angle)
                                : "";
  if (!set.sigma_known)
    return fmt::format("standard deviation of the data, from the residuals: {:.4g} mm{}\n",
                       milli * found.sigma, angle);
  const std::string verdict = found.misfit > 1.5
                                  ? ": the data are worse than said, or the arm has other errors"
                              : found.misfit < 0.5 ? ": the data are better than said"
                                                   : "";
  return fmt::format("residuals are {:.2f} of the deviations that were said{}\n", found.misfit, verdict);
}

}  // namespace

std::string report_text(const model::Robot& robot, const DataSet& set, const Calibration& found) {
  std::string text = fmt::format("{}: {} {}\n\n", robot.name, set.rows.size(), name_of(set.data));
  text += sizes(found) + deviations(set, found) + "\n" + errors(found);
  text += outliers(set, found).empty() ? "" : "\n" + outliers(set, found);
  const std::string never = list_of("\nno data of this kind can tell", found.identifiable.never);
  const std::string here = list_of("\nthese data do not tell", found.untold);
  return text + list_of("\nnearly told together only", correlated(found)) + never + here;
}

}  // namespace qvgen::calibrate
