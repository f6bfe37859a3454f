// SPDX-License-Identifier: MIT
#include "description/write.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <cln/integer.h>
#include <fmt/format.h>

#include "model/arithmetic.h"
#include "model/followers.h"
#include "model/tasks.h"

namespace qvgen::description {
namespace {

using model::Expression;

/// In quotes, as TOML wants them.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code == 0x7f ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return result + "\"";
}

std::string integer_text(const cln::cl_I& value) { return to_string(Expression(cln::cl_RA(value))); }

/// The decimal digits of a number that has finitely many of them.
std::optional<std::string> decimal_text(const cln::cl_RA& value) {
  int places = 0;
  cln::cl_RA scaled = cln::abs(value);
  for (; places <= 60 && cln::denominator(scaled) != 1; ++places) scaled = scaled * 10;
  if (cln::denominator(scaled) != 1) return std::nullopt;
  std::string digits = integer_text(cln::numerator(scaled));
  const auto behind = static_cast<std::size_t>(places);
  if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
  if (behind > 0) digits.insert(digits.size() - behind, ".");
  return (cln::minusp(value) ? "-" : "") + digits;
}

std::string text(const Expression& e) {
  if (e.kind() != Expression::Kind::number) return quoted(to_string(e));
  const auto decimal = decimal_text(e.number());
  // Longer ones than a double has would make a reader of TOML wonder.
  return decimal && decimal->size() <= 18 ? *decimal : quoted(decimal.value_or(to_string(e)));
}

/// In degrees where it is a part of a turn.
std::string angle_text(const Expression& angle) {
  const auto form = model::angle_form(angle);
  if (!form) return text(angle);
  if (cln::zerop(form->half_turns))
    return cln::abs(form->radians) > 6
               ? quoted(decimal_text(form->radians).value_or(to_string(angle)) + " rad")
               : text(angle);
  if (!cln::zerop(form->radians)) return text(angle);
  const cln::cl_RA degrees = form->half_turns * 180;
  return quoted(decimal_text(degrees).value_or(to_string(Expression(degrees))) + " deg");
}

std::string list(const model::Vector3& v) {
  return "[" + text(v[0]) + ", " + text(v[1]) + ", " + text(v[2]) + "]";
}

std::string quoted_axis(const model::Vector3& axis) {
  for (std::size_t i = 0; i < 3; ++i)
    for (const long sign : {1L, -1L})
      if (const auto unit = model::unit_vector(i, sign);
          std::equal(axis.begin(), axis.end(), unit.begin(), model::same))
        return std::string("\"") + (sign > 0 ? '+' : '-') + "xyz"[i] + '"';
  return list(axis);
}

std::string turns_text(const std::vector<model::Turn>& turns) {
  std::string result;
  for (const model::Turn& turn : turns)
    result += (result.empty() ? "" : ", ") +
              fmt::format("{{ axis = {}, angle = {} }}", quoted_axis(turn.axis), angle_text(turn.angle));
  return "[" + result + "]";
}

std::string frame_text(const model::Displacement& frame, const std::string& translation) {
  std::string result;
  if (!model::is_literal_zero(frame.translation))
    result += translation + " = " + list(frame.translation) + "\n";
  if (!frame.turns.empty()) result += "turns = " + turns_text(frame.turns) + "\n";
  return result;
}

std::string table(const std::string& title, const model::Displacement& frame) {
  const std::string content = frame_text(frame, "translation");
  return content.empty() ? "" : "\n[" + title + "]\n" + content;
}

std::string entry(const std::string& key, const Expression& value) {
  return value.is_literal_zero() ? "" : key + " = " + text(value) + "\n";
}

std::string inertia_text(const model::Inertia& inertia) {
  std::string result = entry("mass", inertia.mass);
  if (!model::is_literal_zero(inertia.centre_of_mass))
    result += "centre_of_mass = " + list(inertia.centre_of_mass) + "\n";
  const auto& i = inertia.inertia;
  if (std::all_of(i.begin(), i.end(), [](const Expression& e) { return e.is_literal_zero(); })) return result;
  result += "inertia = [" + text(i[0]) + ", " + text(i[1]) + ", " + text(i[2]);
  if (std::any_of(i.begin() + 3, i.end(), [](const Expression& e) { return !e.is_literal_zero(); }))
    result += ", " + text(i[3]) + ", " + text(i[4]) + ", " + text(i[5]);
  return result + "]\n";
}

std::string floating_base_text(const model::Robot& robot) {
  return robot.floating_base ? "\n[floating_base]\n" + inertia_text(*robot.floating_base) : "";
}

/// Limits of a joint or of a motor, as lines.
template <class Moving>
std::string limits_text(const Moving& joint) {
  std::string result;
  const auto bound = joint.type == model::JointType::revolute ? angle_text : text;
  if (joint.limits)
    result = "limits = [" + bound(joint.limits->lower) + ", " + bound(joint.limits->upper) + "]\n";
  if (joint.greatest_velocity) result += entry("velocity_limit", *joint.greatest_velocity);
  if (joint.greatest_effort) result += entry("effort_limit", *joint.greatest_effort);
  return result;
}

/// `gear`: a constant that does not stand in the joint's frame, and powers.
std::string follows_text(const model::Joint& joint, const model::Gear& gear = {}) {
  if (joint.follows.empty()) return "";
  const Expression& offset = gear.offset;
  const bool is_zero = offset.is_literal_zero();
  if (joint.follows.size() > 1 || !gear.powers.empty())
    return "follows = " +
           quoted(model::relation_text(joint.follows, gear.powers) +
                  (is_zero ? "" : " + (" + to_string(offset) + ")")) +
           "\n";
  const auto& [leader, ratio] = joint.follows.front();
  const bool turns = joint.type == model::JointType::revolute;
  return "follows = " + quoted(leader) + "\n" + (ratio == 1 ? "" : "ratio = " + text(ratio) + "\n") +
         (is_zero ? "" : "offset = " + (turns ? angle_text : text)(offset) + "\n");
}

std::string parent_text(const model::Robot& robot, const model::Joint& joint) {
  if (!joint.parent) return "";
  const bool on_base = *joint.parent == model::base_link;
  return "parent = " + quoted(on_base ? "base" : robot.joints[*joint.parent].variable) + "\n";
}

std::string named_frame_text(const model::Robot& robot, const model::Frame& frame, const std::string& key) {
  return "\n[[" + key + "]]\nname = " + quoted(frame.name) +
         "\njoint = " + quoted(robot.joints[frame.joint].variable) + "\n" +
         frame_text(frame.placement, "translation");
}

std::string drive_text(const model::Drive& drive) {
  return entry("rotor_inertia", drive.rotor_inertia) + entry("viscous_friction", drive.viscous_friction) +
         entry("coulomb_friction", drive.coulomb_friction);
}

std::string joint_text(const model::Robot& robot, const model::Joint& joint, const model::Gear& gear) {
  if (!joint.after.turns.empty()) throw std::invalid_argument("a link frame is turned behind its joint");
  std::string result = "\n[[joint]]\ntype = ";
  result += joint.type == model::JointType::revolute ? "\"revolute\"\n" : "\"prismatic\"\n";
  result += "axis = " + quoted_axis(joint.axis) + "\nvariable = " + quoted(joint.variable) + "\n" +
            parent_text(robot, joint) + follows_text(joint, gear);
  result += frame_text(joint.before, "origin");
  if (!model::is_literal_zero(joint.after.translation))
    result += "link = " + list(joint.after.translation) + "\n";
  return result + limits_text(joint) + inertia_text(joint.inertia) + drive_text(joint.drive);
}

std::string motor_text(const model::Motor& motor) {
  return "\n[[motor]]\ntype = " +
         std::string(motor.type == model::JointType::revolute ? "\"revolute\"\n" : "\"prismatic\"\n") +
         "variable = " + quoted(motor.variable) + "\n" + limits_text(motor) + drive_text(motor.drive);
}

/// Names of constants with their default values, and without; nothing if none has one.
std::string parameters_text(const model::Robot& robot) {
  std::string values, names;
  for (const auto* parameters : {&robot.geometry, &robot.inertia_parameters})
    for (const model::Parameter& each : *parameters)
      if (each.default_value)
        values += (values.empty() ? "" : ", ") + each.name + " = " + text(*each.default_value);
      else
        names += (names.empty() ? "" : ", ") + quoted(each.name);
  if (values.empty()) return "";
  return "defaults = { " + values + " }\n" + (names.empty() ? "" : "symbols = [" + names + "]\n");
}

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
  return result;
}

/// Demands on the inverse kinematics, and the robot that this one would be ideally.
std::string request_text(const model::Robot& robot) {
  const model::InverseRequest& request = robot.inverse;
  const std::string given = request.every_given ? "all" : joined(request.given);
  const std::string later = joined(robot.on_request);
  return (robot.ideal.empty() ? "" : "ideal = " + quoted(robot.ideal) + "\n") +
         (request.task ? "task = " + quoted(model::task_name(*request.task)) + "\n" : "") +
         (request.tool_axis ? "tool_axis = " + quoted_axis(*request.tool_axis) + "\n" : "") +
         (given.empty() ? "" : "given = " + quoted(given) + "\n") +
         (later.empty() ? "" : "on_request = " + quoted(later) + "\n");
}

}  // namespace

namespace {

/// The gear of a joint that follows others; an empty one if there is none.
model::Gear gear_of(std::size_t joint, const std::vector<model::Gear>& gears) {
  const auto of_joint = [&](const model::Gear& gear) { return gear.joint == joint; };
  const auto found = std::find_if(gears.begin(), gears.end(), of_joint);
  return found == gears.end() ? model::Gear() : *found;
}

/// The description of a robot; `keys` stand in front of all tables. The offsets of `gears` stand in no
/// frames.
std::string text_of(const model::Robot& robot, const std::string& keys,
                    const std::vector<model::Gear>& gears = {}) {
  std::string result =
      "# Lengths in metres, angles in radians unless they say deg, masses in kilograms; every number is "
      "exact.\n";
  result += "name = " + quoted(robot.name) + "\ntitle = " + quoted(robot.title) + "\n";
  if (!robot.source.empty()) result += "source = " + quoted(robot.source) + "\n";
  result += keys + request_text(robot) + parameters_text(robot);
  result += table("base", robot.base) + table("tool", robot.tool) + floating_base_text(robot);
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    result += joint_text(robot, robot.joints[i], gear_of(i, gears));
  for (const model::Motor& motor : robot.motors) result += motor_text(motor);
  for (const model::Frame& frame : robot.frames) result += named_frame_text(robot, frame, "frame");
  return result;
}

std::string link_text(const model::Robot& robot, std::size_t link) {
  return quoted(link == model::base_link ? "base" : robot.joints[link].variable);
}

std::string length_text(const model::Robot& robot, const model::Loop& loop) {
  if (loop.type != model::LoopType::rod) return "";
  return "length = " +
         (loop.length_joint ? quoted(robot.joints[*loop.length_joint].variable) : text(loop.length)) + "\n";
}

std::string loop_text(const model::Robot& robot, const model::Loop& loop) {
  static constexpr const char* types[]{"pin", "ball", "rod", "weld", "slide"};
  const bool is_turned = loop.type == model::LoopType::weld || loop.type == model::LoopType::slide;
  return "\n[[loop]]\ntype = " + quoted(types[static_cast<int>(loop.type)]) + "\nbetween = [" +
         link_text(robot, loop.links[0]) + ", " + link_text(robot, loop.links[1]) + "]\nat = [" +
         list(loop.points[0]) + ", " + list(loop.points[1]) + "]\n" + length_text(robot, loop) +
         (loop.axis ? "axis = " + quoted_axis(*loop.axis) + "\n" : "") +
         (is_turned && !loop.turns.empty() ? "turns = " + turns_text(loop.turns) + "\n" : "");
}

/// A list of joints by their variables; nothing if it is empty.
std::string joints_text(const model::Robot& robot, const std::string& key,
                        const std::vector<std::size_t>& joints) {
  std::string names;
  for (const std::size_t joint : joints)
    names += (names.empty() ? "" : ", ") + quoted(robot.joints[joint].variable);
  return names.empty() ? "" : key + " = [" + names + "]\n";
}

}  // namespace

std::string write_text(const model::Robot& robot) { return text_of(robot, ""); }

std::string write_text(const model::Mechanism& mechanism) {
  const auto& [described, tips, loops] = mechanism;
  model::Robot robot = described;
  for (const model::Gear& gear : loops.gears)
    for (const auto& [leader, ratio] : gear.leaders)
      robot.joints[gear.joint].follows.push_back({robot.joints[leader].variable, ratio});
  std::string result = text_of(
      robot, joints_text(robot, "actuated", loops.actuated) + joints_text(robot, "outputs", loops.outputs),
      loops.gears);
  for (const model::Frame& tip : tips) result += named_frame_text(robot, tip, "tip");
  for (const model::Loop& loop : loops.closures) result += loop_text(robot, loop);
  return result;
}

namespace {

std::set<std::string> symbols_of(const model::DhTable& dh) {
  std::set<std::string> names;
  const auto add = [&](const Expression& e) {
    for (const std::string& name : model::symbols(e)) names.insert(name);
  };
  for (const model::Displacement* frame : {&dh.base, &dh.tool})
    for (const Expression& e : frame->translation) add(e);
  for (const model::DhRow& row : dh.rows)
    for (const Expression* e : {&row.theta, &row.d, &row.a, &row.alpha}) add(*e);
  return names;
}

/// The constants of a table, those that have a default value with it.
std::string constants_text(const model::Robot& robot, const model::DhTable& dh) {
  const std::set<std::string> used = symbols_of(dh);
  std::string values, names;
  for (const model::Parameter& parameter : robot.geometry) {
    if (used.count(parameter.name) == 0) continue;
    if (parameter.default_value)
      values += (values.empty() ? "" : ", ") + parameter.name + " = " + text(*parameter.default_value);
    else
      names += (names.empty() ? "" : ", ") + quoted(parameter.name);
  }
  return (values.empty() ? "" : "defaults = { " + values + " }\n") +
         (names.empty() ? "" : "symbols = [" + names + "]\n");
}

/// An entry of a row that may move: the variable, then a constant.
std::string moving_text(const std::string& key, const std::string& variable, const Expression& offset) {
  const Expression sum = model::add(Expression::symbol(variable), offset);
  return key + " = " + quoted(to_string(sum)) + "\n";
}

std::string angle_entry(const std::string& key, const Expression& angle) {
  return angle.is_literal_zero() ? "" : key + " = " + angle_text(angle) + "\n";
}

std::string row_text(const model::Robot& robot, const model::DhRow& row) {
  std::string result = "\n[[dh]]\n";
  const model::Joint* joint = row.joint ? &robot.joints[*row.joint] : nullptr;
  const bool turns = joint != nullptr && joint->type == model::JointType::revolute;
  const bool slides = joint != nullptr && !turns;
  if (joint != nullptr) result += "variable = " + quoted(joint->variable) + "\n";
  result += turns ? moving_text("theta", joint->variable, row.theta) : angle_entry("theta", row.theta);
  result += slides ? moving_text("d", joint->variable, row.d) : entry("d", row.d);
  result += entry("a", row.a) + angle_entry("alpha", row.alpha);
  return joint == nullptr ? result : result + follows_text(*joint) + limits_text(*joint);
}

}  // namespace

std::string write_dh_text(const model::Robot& robot, const model::DhTable& dh) {
  const bool standard = dh.convention == model::DhConvention::standard;
  std::string result =
      standard ? "# A row is Rz(theta) Tz(d) Tx(a) Rx(alpha)" : "# A row is Rx(alpha) Tx(a) Rz(theta) Tz(d)";
  result +=
      "; tool pose = base * rows * tool. Lengths in metres, angles in radians\n# unless they say deg. "
      "Inertias are left out: they belong to other link frames.\n";
  result += "name = " + quoted(robot.name) + "\ntitle = " + quoted(robot.title) + "\n";
  if (!robot.source.empty()) result += "source = " + quoted(robot.source) + "\n";
  result += constants_text(robot, dh) + "convention = " + (standard ? "\"standard\"\n" : "\"modified\"\n");
  result += table("base", dh.base) + table("tool", dh.tool);
  for (const model::DhRow& row : dh.rows) result += row_text(robot, row);
  for (const model::Motor& motor : robot.motors) result += motor_text(motor);
  return result;
}

}  // namespace qvgen::description
