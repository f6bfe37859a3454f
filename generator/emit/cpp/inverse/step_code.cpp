// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/step_code.h"

#include <algorithm>
#include <map>

#include "derive/inverse/divisors.h"
#include "derive/inverse/names.h"
#include "derive/inverse/schedule.h"
#include "emit/cpp/code.h"
#include "emit/cpp/inverse/text_backend.h"
#include "emit/cpp/literal.h"
#include "emit/cpp/symbol_table.h"
#include "emit/cpp/template_values.h"
#include "emit/math/describe.h"
#include "exact/named_constant.h"
#include "model/private_names.h"

namespace qvgen::emit {

namespace names = derive::inverse::names;

namespace kind = derive::inverse::kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using nlohmann::json;

namespace {

/// Symbols of a step: geometry and the target's values from t, what earlier steps left from w, the block's
/// results.
SymbolTable names_of(const model::Robot& robot, const LoweredPlan& plan, const Step& step, const Dialect& d) {
  const std::map<std::string, std::string> fields = geometry_fields(robot);
  const std::vector<std::string> target = plan.plan.target_kept;
  const std::string result =
      step.keeps_length() ? "(sign * " + length_place(d, step.unknown) + ")" : "result";
  const bool slides = step.is<kind::SlideTurn>();
  const auto symbol = [fields, target, result, slides, &d](const std::string& name) -> std::string {
    if (const auto constant = exact::named_value(name))
      return d.spelling().number(literal(exact::Number(*constant)));
    if (const auto field = fields.find(name); field != fields.end())
      return d.scalar(d.member("t", "geometry." + field->second));
    if (slides && name == "result") return "result.slide";
    if (slides && name == names::cosine_result) return "result.turn.cosine";
    if (slides && name == names::sine_result) return "result.turn.sine";
    if (name == names::cosine_result || name == names::result_1) return "result.cosine";
    if (name == names::sine_result || name == names::result_2) return "result.sine";
    if (name == "result") return result;
    if (std::find(target.begin(), target.end(), name) != target.end()) return d.scalar(d.member("t", name));
    return d.member("w", name);
  };
  const auto refuse = [](const dag::Angle& angle) -> std::string {
    throw std::logic_error("inverse kinematics: angle " + to_string(angle));
  };
  return {symbol, refuse, refuse, d.spelling()};
}

int joint_of(const model::Robot& robot, const std::string& variable) {
  int joint = 0;
  while (robot.joints[static_cast<std::size_t>(joint)].variable != variable) ++joint;
  return joint;
}

std::vector<std::string> triples(const std::string& name, std::size_t count) {
  std::vector<std::string> list;
  for (std::size_t i = 1; i <= count; ++i) list.push_back(name + std::to_string(i));
  return list;
}

/// A polish step's task, and the values it changes in place.
PolishTask polish_task(const model::Robot& robot, const LoweredPlan& plan, const kind::Newton& newton,
                       const Dialect& d) {
  PolishTask task;
  for (std::size_t i = 0; i < newton.variables.size(); ++i) {
    const std::string& variable = newton.variables[i];
    const int index = joint_of(robot, variable);
    const auto& joint = plan.plan.joints[static_cast<std::size_t>(index)];
    const std::string zero = d.spelling().number("0");
    const std::string cosine = d.member("w", joint.cosine);
    task.revolute.push_back(joint.revolute);
    task.from.push_back(d.rotor(cosine, joint.revolute ? d.member("w", joint.sine) : zero));
    task.seed.push_back(joint.revolute ? preferred_turn(plan, index, d)
                                       : d.rotor(preferred_slide(plan, index, d), zero));
    const std::string value = d.joint_value(i);
    task.back.push_back(cosine + " = " + value + ".cosine;");
    if (joint.revolute) task.back.push_back(d.member("w", joint.sine) + " = " + value + ".sine;");
    for (const Step& other : plan.plan.steps)
      if (other.keeps_length() && other.unknown == variable)
        task.back.push_back(length_place(d, other.unknown) + " = " + d.spelling().number("1") + ";");
  }
  task.axes = triples("axis", newton.variables.size());
  task.points = triples("point", newton.variables.size());
  task.start = triples("start", static_cast<std::size_t>(newton.points));
  task.goal = triples("goal", static_cast<std::size_t>(newton.points));
  task.size_square = d.scalar(d.member("t", "size_square"));
  return task;
}

std::vector<std::string> wrist_turn_lines(const kind::Wrist& wrist, const Dialect& d) {
  std::vector<std::string> lines;
  const std::array<const char*, 3> parts = {"first", "middle", "last"};
  for (std::size_t i = 0; i < 3; ++i) {
    lines.push_back(d.member("w", names::cosine(wrist.variables[i])) + " = result." + parts[i] + ".cosine;");
    lines.push_back(d.member("w", names::sine(wrist.variables[i])) + " = result." + parts[i] + ".sine;");
  }
  return lines;
}

}  // namespace

std::map<std::string, std::string> geometry_fields(const model::Robot& robot) {
  std::map<std::string, std::string> fields;
  for (const auto& parameter : robot.geometry) fields[parameter.name] = model::described_name(parameter.name);
  // The only symbol without a mark is a held joint's.
  for (auto& [name, field] : fields)
    if (!model::is_marked(name)) field = "given_";
  std::size_t index = 0;
  for (const auto& definition : robot.definitions)
    fields[definition.first] = "defined_" + std::to_string(++index) + "_";
  return fields;
}

std::vector<std::string> work_fields(const LoweredPlan& plan) {
  std::vector<std::string> fields;
  for (const Step& step : plan.plan.steps) {
    if (step.ends_plan()) continue;
    if (const auto* wrist = step.wrist())
      for (const std::string& variable : wrist->variables)
        for (const char* part : {"cos_", "sin_"}) fields.push_back(part + variable);
    fields.insert(fields.end(), step.kept.begin(), step.kept.end());
    if (step.keeps_length()) fields.push_back(names::length(step.unknown));
  }
  return fields;
}

namespace {

bool mentions(const json& code, const std::string& name) {
  return code.dump().find(name) != std::string::npos;
}

}  // namespace

namespace {

/// Lines of a polish step's function; where a language has two of them, they stand one behind the other with
/// an empty line between.
json polish_values(const std::vector<std::string>& lines) {
  const auto gap = std::find(lines.begin(), lines.end(), "");
  const std::vector<std::string> task(lines.begin(), gap);
  const std::vector<std::string> back(gap == lines.end() ? gap : gap + 1, lines.end());
  return {{"task_lines", lines_of(task)}, {"back_lines", lines_of(back)}};
}

}  // namespace

json target_values(const model::Robot& robot, const LoweredPlan& plan, const Dialect& d) {
  const std::map<std::string, std::string> fields = geometry_fields(robot);
  const auto symbol = [&](const std::string& name) {
    if (const auto constant = exact::named_value(name)) return literal(exact::Number(*constant));
    const auto field = fields.find(name);
    return field != fields.end() ? d.member("t", "geometry." + field->second) : name;
  };
  // Sines of twists that are symbols, and of a joint that is held.
  const SymbolTable plain{symbol, {}, {}, d.spelling()};
  const std::vector<dag::Angle> angles = angles_of(plan.target);
  const auto name = [&](const std::string& letter, const dag::Angle& angle) {
    const auto place =
        static_cast<std::size_t>(std::find(angles.begin(), angles.end(), angle) - angles.begin());
    std::string of = angle_name(robot, angle, place);
    if (const auto mark = of.find("g."); mark != std::string::npos) of.erase(mark, 2);
    return letter + (of.front() == '_' ? "" : "_") + of;
  };
  const auto named = [&](const std::string& letter) {
    return [&, letter](const dag::Angle& angle) { return name(letter, angle); };
  };
  json code = values_of(straight_code(plan.target, {symbol, named("sin"), named("cos"), d.spelling()}));
  json sines = json::array();
  for (const dag::Angle& angle : angles)
    for (const char* function : {"sin", "cos"})
      if (mentions(code, name(function, angle)))
        sines.push_back({{"name", name(function, angle)},
                         {"expression", d.mathematical(function) + "(" + angle_code(angle, plain) + ")"}});
  sines.insert(sines.end(), code["temporaries"].begin(), code["temporaries"].end());
  code["temporaries"] = sines;
  return code;
}

json range_test_values(const model::Robot& robot, const LoweredPlan& plan, const Dialect& d) {
  const derive::inverse::RangeTest& test = plan.plan.range_test;
  if (!test.exists()) return false;
  return {{"unknown", test.unknown},
          {"equation", test.equation},
          {"values", values_of(straight_code(plan.range_test, names_of(robot, plan, {}, d)))}};
}

json divisor_values(const model::Robot& robot, const LoweredPlan& plan) {
  json divisors = json::array();
  for (const auto& [name, field] : geometry_fields(robot)) {
    if (!derive::inverse::divides_by(plan.plan, name)) continue;
    const auto definition = robot.definitions.find(name);
    const std::string text = definition == robot.definitions.end()
                                 ? field
                                 : model::without_marks(model::to_string(definition->second));
    divisors.push_back({{"field", field}, {"text", text}, {"last", false}});
  }
  if (!divisors.empty()) divisors.back()["last"] = true;
  return divisors;
}

namespace {

/// Statements behind what a step leaves.
std::vector<std::string> further_lines(const model::Robot& robot, const LoweredPlan& plan, const Step& step,
                                       const Dialect& d) {
  if (const auto* newton = step.as<kind::Newton>())
    return d.polish_lines(polish_task(robot, plan, *newton, d));
  if (step.wrist() != nullptr && !step.ends_plan()) return wrist_turn_lines(*step.wrist(), d);
  if (step.is<kind::SlideTurn>())
    return {"if (result.chosen) " + d.member("w", "branch.continuum") + " = " +
            d.member("w", "branch.doubtful") + " = true;"};
  return {};
}

/// Returns the values from which a template writes a step's function.
json step_value(const model::Robot& robot, const LoweredPlan& plan, std::size_t i, const Dialect& d) {
  const Step& step = plan.plan.steps[i];
  const SymbolTable names = names_of(robot, plan, step, d);
  const TextBackend backend(plan, d);
  const auto [type, call] =
      std::visit([&](const auto& kind) { return kind.apply(step, backend); }, step.kind);
  const std::vector<std::string> lines = further_lines(robot, plan, step, d);
  const bool newton = step.is<kind::Newton>();
  const bool split = step.is_quartic();
  const bool returns = split || step.ends_plan();
  const bool angles_by_sign = step.ends_plan() && step.is<kind::ObliqueWrist>();
  return {{"name", step_name(plan, i)},
          {"comment", lines_of(step_comment(plan, i))},
          {"sign", step.branches == 2 && (!step.ends_plan() || angles_by_sign)},
          {"returns", returns},
          {"split", split},
          {"root", d.type(step.is<kind::SlideTurn>() ? "SlideTurn" : "Rotor")},
          {"polish", newton ? polish_values(lines) : json(false)},
          {"regular", !split && !newton},
          {"type", type},
          {"call", call},
          {"has_result", !type.empty() && !returns},
          {"has_call", !call.empty() && type.empty()},
          {"delta", angles_by_sign},
          {"before", values_of(straight_code(plan.steps[i].before, names))},
          {"after", values_of(straight_code(plan.steps[i].after, names))},
          {"lines", lines_of(lines)}};
}

}  // namespace

json step_values(const model::Robot& robot, const LoweredPlan& plan, const Dialect& d) {
  json steps = json::array();
  for (std::size_t i = 0; i < plan.steps.size(); ++i) steps.push_back(step_value(robot, plan, i, d));
  return steps;
}

}  // namespace qvgen::emit
