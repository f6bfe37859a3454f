// SPDX-License-Identifier: MIT
#include "report/arm_section.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "emit/math/mathml.h"
#include "emit/math/notation.h"
#include "emit/render.h"
#include "model/evaluate.h"
#include "model/tasks.h"
#include "report/class_lines.h"
#include "report/dh.h"
#include "report/drawing.h"

namespace qvgen::report {
namespace {

using model::Displacement;

constexpr double degree = std::numbers::pi / 180;

Cell variable_cell(const std::string& variable) {
  return {emit::inline_mathml(emit::formula(variable, emit::Notation::latex)), false};
}

/// Numbers as decimals, whatever has symbols as the description writes it.
std::string text_of(const model::Expression& entry, double unit = 1) {
  if (!model::symbols(entry).empty()) return to_string(entry);
  return number_cell(model::to_double(model::evaluate(entry)) / unit).html + (unit == 1 ? "" : "°");
}

std::string axis_name(const model::Vector3& axis) {
  const std::string text = model::axis_text(axis);
  if (text.size() <= 2) return text;
  return "(" + text_of(axis[0]) + ", " + text_of(axis[1]) + ", " + text_of(axis[2]) + ")";
}

std::string displacement_text(const Displacement& displacement) {
  std::string text;
  for (const model::Turn& turn : displacement.turns)
    text += (text.empty() ? "" : ", ") + (axis_name(turn.axis) + " by " + text_of(turn.angle, degree));
  bool moves = false;
  for (const auto& part : displacement.translation) moves = moves || !part.is_literal_zero();
  const auto& way = displacement.translation;
  if (moves)
    text += (text.empty() ? "(" : ", (") + text_of(way[0]) + ", " + text_of(way[1]) + ", " + text_of(way[2]) +
            ")";
  return text.empty() ? "–" : text;
}

/// Returns a joint's limits as text; for a follower the joint that it follows, since that has the limits.
std::string limits_text(const Chain& chain, const ChainJoint& joint) {
  if (joint.follows)
    return fmt::format("{:.4g} {}", joint.follows->second,
                       variable_cell(chain.joints[joint.follows->first].variable).html);
  if (!joint.limits) return "none";
  const double unit = joint.revolute ? degree : 1;
  const auto number = [&](double value) { return number_cell(value / unit, 5).html; };
  return number(joint.limits->first) + " to " + number(joint.limits->second) + (joint.revolute ? "°" : " m");
}

HtmlTable joint_table(const model::Robot& robot, const Chain& chain) {
  HtmlTable table{
      "Joints as the description has them. Lengths in metres, before: from the frame of "
      "the link before, after: carried along by the joint; turns, and in brackets the way.",
      {text_cell("joint"), text_cell("type"), text_cell("axis"), text_cell("before"), text_cell("after"),
       text_cell("limits")},
      {}};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const model::Joint& joint = robot.joints[i];
    table.rows.push_back({variable_cell(joint.variable),
                          text_cell(chain.joints[i].revolute ? "revolute" : "prismatic"),
                          text_cell(axis_name(joint.axis)),
                          text_cell(displacement_text(joint.before)),
                          text_cell(displacement_text(joint.after)),
                          {limits_text(chain, chain.joints[i]), false}});
  }
  return table;
}

HtmlTable parameter_table(const model::Robot& robot, const Chain& chain) {
  HtmlTable table{"Symbols of the geometry, fields of Geometry in the code, metres or radians.",
                  {text_cell("symbol"), {"value", true}},
                  {}};
  for (std::size_t i = 0; i < robot.geometry.size(); ++i) {
    const bool known = robot.geometry[i].default_value.has_value();
    table.rows.push_back({variable_cell(robot.geometry[i].name),
                          known ? number_cell(chain.geometry[i]) : Cell{"the caller’s", true}});
  }
  return table;
}

HtmlTable parameters_of_axes(const Chain& chain) {
  HtmlTable table{
      "Denavit–Hartenberg parameters of the axes, whatever frames the description uses: turn about z by θ, "
      "slide along z by d, slide along x by a, turn about x by α. The joint’s variable is added where it "
      "stands. Degrees and metres.",
      {text_cell("joint"), {"θ", true}, {"d", true}, {"a", true}, {"α", true}},
      {}};
  const DhTable dh = dh_table(chain);
  for (std::size_t i = 0; i < dh.rows.size(); ++i) {
    const DhRow& row = dh.rows[i];
    const ChainJoint& joint = chain.joints[i];
    const auto with_variable = [&](Cell cell, bool moves) {
      if (!moves) return cell;
      const std::string variable = variable_cell(joint.variable).html;
      cell.html =
          cell.html == "0" ? variable : variable + (cell.html.substr(0, 3) == "−" ? " " : " + ") + cell.html;
      return cell;
    };
    table.rows.push_back({variable_cell(joint.variable),
                          with_variable(number_cell(row.theta / degree), joint.revolute),
                          with_variable(number_cell(row.d), !joint.revolute), number_cell(row.a),
                          number_cell(row.alpha / degree)});
  }
  return table;
}

std::string pose_text(const Chain& chain, const std::vector<double>& q) {
  std::string text;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const bool revolute = chain.joints[i].revolute;
    text += fmt::format("{}{} = {}{}", i == 0 ? "" : ", ", typeset(chain.joints[i].variable),
                        number_cell(revolute ? q[i] / degree : q[i], 4).html, revolute ? "°" : " m");
  }
  return text;
}

std::string chain_text(const Chain& chain) {
  std::vector<std::string> parts;
  for (const ChainJoint& joint : chain.joints)
    parts.push_back(typeset(joint.variable) + (joint.revolute ? " turns" : " slides"));
  return fmt::format("From the base to the tool: {}.", fmt::join(parts, ", "));
}

nlohmann::json captioned(const std::string& svg, const std::string& caption) {
  return {{"svg", svg}, {"caption", caption}};
}

nlohmann::json figures(const model::Robot& robot, const Chain& chain) {
  const std::vector<double> bent = bent_pose(chain);
  const std::string parts = chain_text(chain), pose = pose_text(chain, bent);
  const Caption zero_caption{"arm-zero", robot.title + " at its zero pose", parts + " All joints at zero."};
  const Caption bent_caption{"arm-bent", robot.title + " away from zero", parts + " " + pose + "."};
  const Caption frames{"arm-frames", robot.title + ": frames",
                       fmt::format("The frames of {} links and the tool, at {}.", chain.joints.size(), pose),
                       true, true};
  return {
      captioned(drawing(chain, zero_pose(chain), zero_caption),
                "Zero pose, with the offsets’ names and lengths (m). Cylinders turn about the dashed axes, "
                "boxes slide along them."),
      captioned(drawing(chain, bent, bent_caption), escaped(pose)),
      captioned(drawing(chain, bent, frames),
                "The same pose: the frames in which the links are described, by the number of their joint, "
                "x dotted, y dashed, z drawn through; the tool’s last.")};
}

}  // namespace

Section arm_section(const model::Robot& robot, const Chain& chain) {
  nlohmann::json values;
  values["figures"] = figures(robot, chain);
  values["assumed"] =
      chain.assumed.empty()
          ? ""
          : fmt::format("{} without a value in the description: drawn, and used on this page, with {}.",
                        fmt::join(chain.assumed, ", "), assumed_value);
  values["has_assumed"] = !chain.assumed.empty();
  values["class"] = nlohmann::json::array();
  for (const std::string& line : class_lines(robot)) values["class"].push_back({{"line", escaped(line)}});
  values["has_class"] = !values["class"].empty();
  values["joints"] = html(joint_table(robot, chain));
  values["dh"] = html(parameters_of_axes(chain));
  values["parameters"] = robot.geometry.empty() ? "" : html(parameter_table(robot, chain));
  return {"arm", "The arm", emit::render("report/arm.html", values)};
}

}  // namespace qvgen::report
