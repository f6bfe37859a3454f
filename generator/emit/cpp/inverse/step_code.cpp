// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/step_code.h"

#include <algorithm>
#include <map>

#include "derive/inverse/divisors.h"
#include "derive/inverse/schedule.h"
#include "emit/cpp/code.h"
#include "emit/cpp/literal.h"
#include "emit/cpp/symbol_table.h"
#include "emit/cpp/template_values.h"
#include "emit/math/describe.h"
#include "exact/named_constant.h"
#include "model/private_names.h"

namespace qvgen::emit {

using derive::inverse::Kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using nlohmann::json;

namespace {

/// Whether the step is the wrist that ends the plan: it gives angles, not cosines and sines.
bool ends(const LoweredPlan& plan, const Step& step) {
  return step.is_wrist() && plan.plan.wrist.ends_the_plan;
}

std::string length_place(const std::string& unknown) { return "w.length_" + unknown; }

/// Symbols of a step: geometry and the target's values from t, what earlier steps left from w, the block's
/// results.
SymbolTable names_of(const model::Robot& robot, const LoweredPlan& plan, const Step& step) {
  const std::map<std::string, std::string> fields = geometry_fields(robot);
  const std::vector<std::string> target = plan.plan.target_kept;
  const std::string result = step.unit ? "result" : "(sign * " + length_place(step.unknown) + ")";
  const bool slides = step.kind == Kind::slide_turn;
  const auto symbol = [fields, target, result, slides](const std::string& name) -> std::string {
    if (const auto constant = exact::named_value(name))
      return "Scalar(" + literal(exact::Number(*constant)) + ")";
    if (const auto field = fields.find(name); field != fields.end())
      return "Scalar(t.geometry." + field->second + ")";
    if (slides && name == "result") return "result.slide";
    if (slides && name == "cos_result") return "result.turn.cosine";
    if (slides && name == "sin_result") return "result.turn.sine";
    if (name == "cos_result" || name == "result_1") return "result.cosine";
    if (name == "sin_result" || name == "result_2") return "result.sine";
    if (name == "result") return result;
    if (std::find(target.begin(), target.end(), name) != target.end()) return "Scalar(t." + name + ")";
    return "w." + name;
  };
  const auto refuse = [](const dag::Angle& angle) -> std::string {
    throw std::logic_error("inverse kinematics: angle " + to_string(angle));
  };
  return {symbol, refuse, refuse};
}

json to_json(const Code& code) {
  return {{"temporaries", values_of(code.temporaries)}, {"outputs", values_of(code.outputs)}};
}

std::string rotor(const std::string& x, const std::string& y) {
  return "inverse::Rotor<Scalar>{" + x + ", " + y + "}";
}

std::string preferred_angle(int joint) {
  return "Scalar(t.preference->angle[" + std::to_string(joint) + "])";
}

std::string preferred_slide(int joint) {
  return "Scalar(t.preference->slide[" + std::to_string(joint) + "])";
}

/// A joint's seed; what a sum of angles shall be is worked out before.
std::string choice(int joint, const std::string& kind = "turn") {
  const std::string turn = "t.preference->" + kind + "[" + std::to_string(joint) + "]";
  return rotor("Scalar(" + turn + ".cosine)", "Scalar(" + turn + ".sine)");
}
/// The row's place of the joint that a step determines.
int place(const LoweredPlan& plan, int joint) { return plan.plan.places[static_cast<std::size_t>(joint)]; }

std::string spread() {
  return rotor("Scalar(t.preference->spread.cosine)", "Scalar(t.preference->spread.sine)");
}

/// A slide's seed, or what is nearest to it with the joint after it in reach.
std::string slide_choice(const LoweredPlan& plan, const Step& step) {
  const std::string value = preferred_slide(place(plan, step.joint));
  if (!step.has_input("inner")) return value;
  const bool between = step.has_input("outer");
  return std::string("inverse::") + (between ? "slide_between" : "slide_beyond") + "<Scalar>(" +
         rotor("point_x", "point_y") + ", " + rotor("along_x", "along_y") + ", inner, " +
         (between ? "outer" : "Scalar(t.size_square)") + ", " + value + ", " + spread() + ")";
}

/// The turn that the seed's angles add up to.
std::string seeds(const LoweredPlan& plan, const Step& step) {
  std::string product;
  for (const Step::Seed& seed : step.seeds) {
    const std::string turn = choice(place(plan, seed.joint));
    product += (product.empty() ? "" : " * ") + (seed.sense > 0 ? turn : "inverse::inverse(" + turn + ")");
  }
  return product;
}

std::string tiny(const Step& step) { return "Scalar(t.tiny" + std::to_string(step.degree) + ")"; }

std::string direction(const LoweredPlan& plan, const Step& step) {
  // What a sum of angles shall be is worked out before.
  if (step.joint < 0)
    return "inverse::chosen_direction<Scalar>(" + rotor("x", "y") + ", " + rotor("choice_x", "choice_y") +
           ", t.boundary, w.branch)";
  const std::string block = step.unit ? "direction" : step.length_known ? "span_of_length" : "span";
  const std::string types = step.kind == Kind::opposite ? "<Scalar, true>(" : "<Scalar>(";
  return "inverse::" + block + types + rotor("x", "y") + (step.length_known ? ", length, " : ", ") +
         tiny(step) + ", " + choice(place(plan, step.joint), step.unit ? "turn" : "brief") + ", " +
         (step.unit ? "" : length_place(step.unknown) + ", ") + "w.branch)";
}

std::string half(const LoweredPlan& plan, const Step& step) {
  if (!plan.plan.wrist.right) return "inverse::half<Scalar>(" + rotor("cosine", "sine") + ")";
  std::string length;
  for (const std::string& unknown : step.lengths)
    length += (length.empty() ? "" : " * ") + length_place(unknown);
  return "inverse::half_direction<Scalar>(" + rotor("cosine", "sine") + ", " +
         (length.empty() ? "Scalar(1)" : length) + ")";
}

/// The declaration of `result` and the block's call.
std::pair<std::string, std::string> block(const LoweredPlan& plan, const Step& step) {
  const std::string turn = "inverse::Rotor<Scalar>";
  const std::string tolerance = "Scalar(t.tolerance)";
  switch (step.kind) {
    case Kind::circle:
      return {turn, "inverse::circle_angle<Scalar>(low, high, scale, sign, t.boundary, w.branch)"};
    case Kind::free_circle:
      return {turn, "inverse::free_circle_angle<Scalar>(low, high, " + rotor("x", "y") + ", " + tiny(step) +
                        ", " + choice(place(plan, step.joint)) + ", sign, t.boundary, w.branch)"};
    case Kind::factored:
      return {turn, "inverse::factored_line_angle<Scalar>(" + rotor("x", "y") + ", rhs, low, high, " +
                        tiny(step) + ", " + choice(place(plan, step.joint)) +
                        ", sign, t.boundary, w.branch)"};
    case Kind::reach:
      return {turn, "inverse::reachable_direction<Scalar>(" + rotor("point_x", "point_y") + ", " +
                        rotor("offset_x", "offset_y") + ", inner, outer, " + seeds(plan, step) + ")"};
    case Kind::opposite:
      return {turn, "sign * " + direction(plan, step)};
    case Kind::pair:
      return {turn, direction(plan, step)};
    case Kind::half:
      return {turn, half(plan, step)};
    case Kind::root:
      return {"Scalar",
              "inverse::signed_root<Scalar>(square, scale, Scalar(t.tiny1), sign, t.boundary, w.branch)"};
    case Kind::line:
      return {"Scalar", "inverse::slide_on_line<Scalar>(" +
                            (step.has_input("divisor")
                                 ? rotor("divisor", "Scalar(0)") + ", " + rotor("rhs", "Scalar(0)")
                                 : rotor("x", "y") + ", " + rotor("rhs_x", "rhs_y")) +
                            ", Scalar(t.tiny1), " + slide_choice(plan, step) + ", t.boundary, w.branch)"};
    case Kind::slides:
      return {turn, "inverse::two_slides<Scalar>(" + rotor("a", "b") + ", k, " + rotor("g", "f") +
                        ", gap, Scalar(t.tiny1), Scalar(t.size_square), " +
                        preferred_slide(place(plan, step.joint)) + ", " + spread() + ", " +
                        (step.branches == 1 ? "Scalar(0)" : "sign") + ", t.boundary, w.branch)"};
    case Kind::require:
      return {"", "inverse::require_zero<Scalar>(residual, scale, " + tolerance + ", w.branch)"};
    case Kind::conic:
      return {"inverse::CircleRoots<Scalar>",
              "inverse::conic_circle<Scalar>({xx, xy, yy, x, y, one}, t.boundary, inverse::pi<Scalar>())"};
    case Kind::slide_turn:
      return {"inverse::SlideTurns<Scalar>",
              "inverse::slide_and_turn<Scalar>({divisor, h, level, {l_x, l_y}, mean, {m_x, m_y}}, "
              "Scalar(t.tiny1), Scalar(t.size_square), " +
                  preferred_slide(place(plan, step.slide)) + ", " + spread() +
                  ", t.boundary, inverse::pi<Scalar>())"};
    case Kind::right_wrist: {
      const std::string swapped = plan.plan.wrist.middle_swapped ? "true" : "false";
      const std::string uv = rotor("u_x", "u_y") + ", " + rotor("v_x", "v_y") + ", " + swapped + ", ";
      if (ends(plan, step))
        return {"inverse::WristBranches<Scalar>",
                "inverse::right_wrist<Scalar>(" + uv +
                    preferred_angle(place(plan, plan.plan.wrist.joints[0])) +
                    ", inverse::pi<Scalar>(), w.branch)"};
      return {"inverse::WristTurns<Scalar>", "inverse::right_wrist_turns<Scalar>(" + uv +
                                                 rotor("choice_x", "choice_y") +
                                                 ", sign, t.boundary, w.branch)"};
    }
    case Kind::oblique_wrist: {
      const std::string uv = rotor("u_x", "u_y") + ", " + rotor("v_x", "v_y") +
                             ", {cosine_sum, sine_sum, cosine_difference, sine_difference, product}, ";
      if (!ends(plan, step))
        return {"inverse::WristTurns<Scalar>",
                "inverse::oblique_wrist_turns<Scalar>(" + uv + rotor("cosine_delta", "sine_delta") + ", " +
                    rotor("choice_x", "choice_y") + ", sign, t.boundary, w.branch)"};
      return {"inverse::WristAngles<Scalar>", "inverse::oblique_wrist<Scalar>(" + uv + "sign, " +
                                                  preferred_angle(place(plan, plan.plan.wrist.joints[0])) +
                                                  ", t.boundary, inverse::pi<Scalar>(), w.branch)"};
    }
    case Kind::polish:
    case Kind::linear:
      return {"", ""};
  }
  return {};
}

int joint_of(const model::Robot& robot, const std::string& variable) {
  int joint = 0;
  while (robot.joints[static_cast<std::size_t>(joint)].variable != variable) ++joint;
  return joint;
}

std::string triple(const std::string& name, std::size_t i) {
  const std::string full = name + std::to_string(i + 1);
  return "{" + full + "_x, " + full + "_y, " + full + "_z}";
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return "{{" + text + "}}";
}

/// A polish step's task, and the values it changes in place.
std::vector<std::string> polish_lines(const model::Robot& robot, const LoweredPlan& plan, const Step& step) {
  std::vector<std::string> arm, from, seed, start, goal, back;
  for (std::size_t i = 0; i < step.turns.size(); ++i) {
    const int index = joint_of(robot, step.turns[i]);
    const auto& joint = plan.plan.joints[static_cast<std::size_t>(index)];
    arm.push_back(std::string("inverse::Screw<Scalar>{") + (joint.revolute ? "true" : "false") + ", " +
                  triple("axis", i) + ", " + triple("point", i) + "}");
    from.push_back(rotor("w." + joint.cosine, joint.revolute ? "w." + joint.sine : "Scalar(0)"));
    seed.push_back(joint.revolute ? choice(place(plan, index))
                                  : rotor(preferred_slide(place(plan, index)), "Scalar(0)"));
    const std::string value = "values[" + std::to_string(i) + "].";
    back.push_back("w." + joint.cosine + " = " + value + "cosine;");
    if (joint.revolute) back.push_back("w." + joint.sine + " = " + value + "sine;");
    for (const Step& other : plan.plan.steps)
      if (!other.unit && other.unknown == step.turns[i])
        back.push_back(length_place(other.unknown) + " = Scalar(1);");
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(step.points); ++i) {
    start.push_back("inverse::Triple<Scalar>" + triple("start", i));
    goal.push_back("inverse::Triple<Scalar>" + triple("goal", i));
  }
  const std::string type = "inverse::JointValues<Scalar, " + std::to_string(arm.size()) + ">";
  std::vector<std::string> lines = {type + " values" + joined(from) + ";",
                                    "const " + type + " seed" + joined(seed) + ";",
                                    "const inverse::PointMatching<Scalar, " + std::to_string(arm.size()) +
                                        ", " + std::to_string(start.size()) + "> task{",
                                    "    " + joined(arm) + ",",
                                    "    " + joined(start) + ",",
                                    "    " + joined(goal) + ", Scalar(t.size_square)};",
                                    "if (!tracker.settle(label, task, t.boundary, t.preference->seeded ? "
                                    "&seed : nullptr, values, w.branch)) return false;"};
  lines.insert(lines.end(), back.begin(), back.end());
  lines.emplace_back("return true;");
  return lines;
}

std::vector<std::string> wrist_turn_lines(const Step& step) {
  std::vector<std::string> lines;
  const std::array<const char*, 3> parts = {"first", "middle", "last"};
  for (std::size_t i = 0; i < 3; ++i) {
    lines.push_back("w.cos_" + step.turns[i] + " = result." + parts[i] + ".cosine;");
    lines.push_back("w.sin_" + step.turns[i] + " = result." + parts[i] + ".sine;");
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
    if (ends(plan, step)) continue;
    for (const std::string& turn : step.turns)
      for (const char* part : {"cos_", "sin_"})
        if (step.kind != Kind::polish) fields.push_back(part + turn);
    fields.insert(fields.end(), step.kept.begin(), step.kept.end());
    if (!step.unit) fields.push_back("length_" + step.unknown);
  }
  return fields;
}

namespace {

bool mentions(const json& code, const std::string& name) {
  return code.dump().find(name) != std::string::npos;
}

}  // namespace

json target_values(const model::Robot& robot, const LoweredPlan& plan) {
  const std::map<std::string, std::string> fields = geometry_fields(robot);
  const auto symbol = [&](const std::string& name) {
    if (const auto constant = exact::named_value(name)) return literal(exact::Number(*constant));
    const auto field = fields.find(name);
    return field != fields.end() ? "t.geometry." + field->second : name;
  };
  // Sines of twists that are symbols, and of a joint that is held.
  const SymbolTable plain{symbol, {}, {}};
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
  json code = to_json(straight_code(plan.target, {symbol, named("sin"), named("cos")}));
  json sines = json::array();
  for (const dag::Angle& angle : angles)
    for (const char* function : {"sin", "cos"})
      if (mentions(code, name(function, angle)))
        sines.push_back(
            {{"name", name(function, angle)},
             {"expression", std::string("std::") + function + "(" + angle_code(angle, plain) + ")"}});
  sines.insert(sines.end(), code["temporaries"].begin(), code["temporaries"].end());
  code["temporaries"] = sines;
  return code;
}

json range_test_values(const model::Robot& robot, const LoweredPlan& plan) {
  const derive::inverse::RangeTest& test = plan.plan.range_test;
  if (!test.exists()) return false;
  return {{"unknown", test.unknown},
          {"equation", test.equation},
          {"values", to_json(straight_code(plan.range_test, names_of(robot, plan, {})))}};
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

json step_values(const model::Robot& robot, const LoweredPlan& plan) {
  json steps = json::array();
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const Step& step = plan.plan.steps[i];
    const SymbolTable names = names_of(robot, plan, step);
    const Code before = straight_code(plan.steps[i].before, names);
    const Code after = straight_code(plan.steps[i].after, names);
    const auto [type, call] = block(plan, step);
    std::vector<std::string> extra;
    const bool polish = step.kind == Kind::polish;
    if (polish) extra = polish_lines(robot, plan, step);
    if (step.is_wrist() && !ends(plan, step)) extra = wrist_turn_lines(step);
    const bool split = step.is_quartic();
    const bool slides = step.kind == Kind::slide_turn;
    if (plan.plan.chooses_for_others(step)) extra = {"w.branch.doubt(w.branch.continuum);"};
    if (slides) extra = {"if (result.chosen) w.branch.continuum = w.branch.doubtful = true;"};
    const bool returns = split || ends(plan, step);
    const bool oblique = step.kind == Kind::oblique_wrist;
    steps.push_back({{"name", step_name(plan, i)},
                     {"comment", lines_of(step_comment(plan, i))},
                     {"sign", step.branches == 2 && !(ends(plan, step) && !oblique)},
                     {"returns", returns},
                     {"split", split},
                     {"root", std::string("inverse::") + (slides ? "SlideTurn" : "Rotor") + "<Scalar>"},
                     {"polish", polish ? json{{"joints", step.turns.size()}} : json(false)},
                     {"regular", !split && !polish},
                     {"type", type},
                     {"call", call},
                     {"has_result", !type.empty() && !returns},
                     {"has_call", !call.empty() && type.empty()},
                     {"delta", oblique && ends(plan, step)},
                     {"before", to_json(before)},
                     {"after", to_json(after)},
                     {"lines", lines_of(extra)}});
  }
  return steps;
}

}  // namespace qvgen::emit
