// SPDX-License-Identifier: MIT
#include "identify/page.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "identify/derivatives.h"
#include "identify/spectrum.h"
#include "identify/summary.h"
#include "model/followers.h"
#include "report/page.h"
#include "report/pieces.h"
#include "report/plot.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
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

constexpr double interval_of_95 = 1.959964;

bool turns(const model::Robot& robot, std::size_t joint) {
  return model::driven_joints(robot)[joint].type == model::JointType::revolute;
}

std::string doubts(const Identification& found) {
  std::string text;
  for (const std::string& doubt : found.doubts) text += paragraph("Warning: " + doubt + ".");
  return text;
}

Section summary_section(const model::Robot& robot, const Identification& found) {
  const auto variables = model::variables(robot);
  HtmlTable table{"Torques by joint (forces of slides), root mean squares",
                  {text_cell("joint"),
                   {"rows", true},
                   {"torque", true},
                   {"residual", true},
                   {"share, %", true},
                   {"lag 1", true},
                   {"hold-out", true}},
                  {}};
  for (std::size_t i = 0; i < found.joints.size(); ++i) {
    const JointResidual& joint = found.joints[i];
    table.rows.push_back({text_cell(variables[i]), report::count_cell(static_cast<int>(joint.rows)),
                          number_cell(joint.torque, 4), number_cell(joint.residual, 4),
                          number_cell(joint.torque > 0 ? 100 * joint.residual / joint.torque : 0, 3),
                          number_cell(joint.correlation, 2),
                          joint.hold_out ? number_cell(*joint.hold_out, 4) : Cell{"–", true}});
  }
  std::string logs;
  for (const MotionLog& log : found.logs) logs += (logs.empty() ? "" : ", ") + log.name;
  return {"summary", "Summary",
          paragraph("Fitted: " + logs + ".") + doubts(found) + scrolled(table) +
              paragraph(
                  "Lag 1 is the correlation of a residual with the next one: near 0 it is noise, near 1 the "
                  "model lacks something.") +
              paragraph(fmt::format("The condition number of these data is {:.3g}; below 100 is good.",
                                    found.estimate.condition))};
}

/// Times of a log's samples; their numbers if it has none.
std::vector<double> times_of(const MotionLog& log) {
  if (!log.time.empty()) return log.time;
  std::vector<double> times;
  for (Index k = 0; k < log.samples(); ++k) times.push_back(static_cast<double>(k));
  return times;
}

Series series_of(const std::string& name, int colour, const std::vector<double>& times,
                 const Eigen::VectorXd& values) {
  Series series{name, Series::Mark::line, colour, {}};
  for (Index k = 0; k < values.size(); ++k)
    series.points.emplace_back(times[static_cast<std::size_t>(k)], values[k]);
  series.points = report::thinned(series.points);
  return series;
}

/// Returns what the spectrum says in words.
std::string words_on(const std::vector<std::pair<double, double>>& spectrum) {
  if (spectrum.empty()) return "";
  const double band = band_of_power(spectrum), highest = spectrum.back().first;
  const std::string where =
      fmt::format("Nine tenths of the residual's power lie below {:.3g} Hz of {:.3g} Hz: ", band, highest);
  return where + (band > 0.7 * highest ? "it is noise of all frequencies."
                  : band < 0.1 * highest
                      ? "it is slow; friction or a load that is not modelled, or the temperature."
                      : "it has frequencies of its own: filtered data, gears, or an elastic arm.");
}

std::string joint_html(const model::Robot& robot, const MotionLog& log, const Eigen::VectorXd& predicted,
                       std::size_t joint) {
  const auto column = static_cast<Index>(joint);
  const std::string name = model::variables(robot)[joint], unit = turns(robot, joint) ? "Nm" : "N";
  const std::string id = std::to_string(joint + 1), time = log.time.empty() ? "sample" : "s";
  const std::vector<double> times = times_of(log);
  const Eigen::VectorXd measured = log.torque.col(column), rest = measured - predicted;
  std::string body = "<h3>" + report::escaped(name) + "</h3>\n";
  body += figure(report::plot({{"torque-" + id, "Torque of " + name, "Measured and predicted over time."},
                               time,
                               unit,
                               false,
                               {series_of("measured", 0, times, measured),
                                series_of("predicted", 1, times, predicted)}}),
                 "Measured and predicted, " + log.name + ".");
  body += figure(report::plot({{"rest-" + id, "Residual of " + name, "Measured minus predicted over time."},
                               time,
                               unit,
                               false,
                               {series_of("measured minus predicted", 0, times, rest)},
                               120}),
                 "What is left.");
  const auto found = spectrum(rest, log.time.empty() ? 1 : usual_step(log.time));
  if (found.empty()) return body;
  const std::string hertz = log.time.empty() ? "per sample" : "Hz";
  return body +
         figure(
             report::plot({{"spectrum-" + id, "Spectrum of " + name, "Density of the residual by frequency."},
                           hertz,
                           unit + "/√Hz",
                           true,
                           {{"residual", Series::Mark::line, 0, found}},
                           160}),
             words_on(found));
}

Section torque_section(const model::Robot& robot, const Identification& found) {
  const MotionLog& log = found.logs.front();
  const Eigen::MatrixXd torque = predicted(found.arm, log, found.estimate.value);
  std::string body;
  for (std::size_t i = 0; i < found.joints.size(); ++i)
    body += joint_html(robot, log, torque.col(static_cast<Index>(i)), i);
  return {"torques", "Torques", body};
}

Section parameter_section(const Identification& found) {
  const Estimate& estimate = found.estimate;
  HtmlTable table{"Parameters that motions can tell",
                  {text_cell("parameter"),
                   {"value", true},
                   {"deviation", true},
                   {"95 % from", true},
                   {"to", true},
                   text_cell(""),
                   text_cell("made of")},
                  {}};
  for (Index k = 0; k < estimate.value.size(); ++k) {
    if (!estimate.told[static_cast<std::size_t>(k)]) continue;
    const double value = estimate.value[k], reach = interval_of_95 * estimate.deviation[k];
    table.rows.push_back(
        {text_cell(found.arm.names[static_cast<std::size_t>(k)]), number_cell(value, 5),
         number_cell(estimate.deviation[k], 2), number_cell(value - reach, 5), number_cell(value + reach, 5),
         text_cell(std::abs(value) < reach ? "may be zero" : ""), text_cell(definition(found.arm, k))});
  }
  return {"parameters", "Parameters",
          paragraph("The true value lies within an interval with a probability of 95 %, if the residual is "
                    "noise: see lag 1.") +
              scrolled(table)};
}

Section untold_section(const Identification& found) {
  const std::vector<std::string> sentences = untold(found);
  return {"untold", "Not told",
          sentences.empty() ? paragraph("These data tell every parameter that motions can tell.")
                            : bullets(sentences)};
}

Section full_section(const Identification& found) {
  HtmlTable table{"Bodies nearest to the prior that give these torques",
                  {text_cell(found.arm.motors.empty() ? "link" : "link or motor"),
                   {"mass, kg", true},
                   {"centre x, m", true},
                   {"y", true},
                   {"z", true},
                   {"rotor inertia", true},
                   {"viscous", true},
                   {"Coulomb", true},
                   {"offset", true}},
                  {}};
  for (std::size_t i = 0; i < found.arm.drive_units(); ++i) {
    std::vector<Cell> cells{i < found.arm.links ? report::count_cell(static_cast<int>(i) + 1)
                                                : text_cell(found.arm.drive_name(i))};
    if (i < found.arm.links) {
      const auto p = found.full.values.segment<10>(10 * static_cast<Index>(i));
      for (const double each : {p[0], p[1] / p[0], p[2] / p[0], p[3] / p[0]})
        cells.push_back(number_cell(each, 4));
    } else {
      cells.resize(cells.size() + 4, text_cell(""));
    }
    for (const double each : found.full.values.segment<4>(found.arm.standard() + 4 * static_cast<Index>(i)))
      cells.push_back(number_cell(each, 4));
    table.rows.push_back(cells);
  }
  return {"full", "Full set",
          paragraph(found.full.exact ? "Bodies with exactly these parameters exist."
                                     : "No bodies have exactly these parameters; these are the nearest.") +
              scrolled(table)};
}

}  // namespace

std::string page(const model::Robot& robot, const Identification& found) {
  return html(report::Page{"Identification of " + robot.name,
                           {robot.title},
                           false,
                           {summary_section(robot, found), torque_section(robot, found),
                            parameter_section(found), untold_section(found), full_section(found)},
                           ""});
}

}  // namespace qvgen::identify
