// SPDX-License-Identifier: MIT
#include "pipeline/assembly.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "derive/inverse/lower.h"
#include "derive/inverse/names.h"
#include "derive/loops/constraints.h"
#include "emit/ast/literal.h"
#include "emit/ast/printer.h"
#include "emit/cpp/printer.h"
#include "emit/inverse/every_assembly.h"
#include "emit/inverse/steps.h"
#include "emit/inverse/target.h"
#include "emit/leaves.h"
#include "emit/math/describe.h"
#include "emit/render.h"
#include "emit/template_values.h"
#include "exact/named_constant.h"
#include "model/private_names.h"
#include "pipeline/limbs.h"
#include "pipeline/loop_variants.h"
#include "verify/loops/certify_loops.h"
#include "verify/loops/mobility.h"

namespace qvgen::pipeline {
namespace {

using derive::loops::AssemblyPlan;
using nlohmann::json;
namespace names = derive::inverse::names;

constexpr int certificate_inputs = 12;

template <class List>
std::string commas(const List& list) {
  return fmt::format("{}", fmt::join(list, ", "));
}

std::string described_names(const model::Robot& robot, const std::vector<std::size_t>& joints) {
  std::vector<std::string> list;
  for (const std::size_t joint : joints) list.push_back(robot.joints[joint].variable);
  return commas(list);
}

std::vector<std::string> flags(std::size_t count, const std::vector<std::size_t>& joints) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(std::find(joints.begin(), joints.end(), i) == joints.end() ? "false" : "true");
  return list;
}

/// The symbols that stand for a joint, with their values in code.
json values_of_joint(const model::Robot& robot, std::size_t joint, bool with_rate) {
  const std::string& variable = robot.joints[joint].variable;
  const std::string q = fmt::format("q[{}]", joint);
  json list = json::array();
  if (robot.joints[joint].type == model::JointType::prismatic) {
    list.push_back({{"name", variable}, {"value", q}});
  } else {
    list.push_back({{"name", names::cosine(variable)}, {"value", "std::cos(" + q + ")"}});
    list.push_back({{"name", names::sine(variable)}, {"value", "std::sin(" + q + ")"}});
  }
  if (with_rate) list.push_back({{"name", "rate_" + variable}, {"value", fmt::format("qd[{}]", joint)}});
  return list;
}

emit::ast::Leaves leaves_of(const model::Robot& robot) {
  using emit::ast::Expression;
  const auto symbol = [fields = emit::geometry_fields(robot)](const std::string& name) -> Expression {
    if (const auto constant = exact::named_value(name))
      return emit::ast::real(emit::literal(exact::Number(*constant)));
    const auto field = fields.find(name);
    return emit::ast::name(field == fields.end() ? name : "g." + field->second);
  };
  const auto constant = [](std::string (*literal_of)(const exact::Angle&)) {
    return [literal_of](const dag::Angle& angle) -> Expression {
      const std::string text = literal_of(angle);
      if (text.empty())
        throw std::domain_error("closed loops whose frames are turned by an angle that is a symbol");
      return emit::ast::real(text);
    };
  };
  return {symbol, constant(emit::sine_literal), constant(emit::cosine_literal)};
}

/// Code of a program: the joints' values that it reads, temporaries, and outputs with their places.
struct ProgramCode {
  json values = json::array();
  json code;
};

ProgramCode code_of(const symbolic::Program& program, const model::Robot& robot,
                    const std::vector<std::string>& places) {
  std::vector<std::string> all;
  for (const auto& output : program.outputs()) all.push_back(output.name);
  dag::Function function = derive::inverse::lowered(program, all);
  std::vector<std::string> kept;
  // Zeros stay as they were set.
  std::vector<dag::Output> outputs;
  for (std::size_t i = 0; i < function.outputs.size(); ++i) {
    const bool is_entry = places[i].find(',') != std::string::npos;
    if (is_entry && function.graph.is_zero(function.outputs[i].value)) continue;
    outputs.push_back(function.outputs[i]);
    kept.push_back(places[i]);
  }
  function.outputs = outputs;
  const emit::ast::Straight straight = emit::ast::straight(function, leaves_of(robot));
  ProgramCode result;
  result.code = emit::values_of(straight, emit::cpp());
  for (std::size_t i = 0; i < kept.size(); ++i) result.code["outputs"][i]["place"] = kept[i];
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint)
    for (const json& value : values_of_joint(robot, joint, true))
      if (emit::ast::mentions(straight, value["name"])) result.values.push_back(value);
  return result;
}

std::vector<std::string> numbers(std::size_t count) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(std::to_string(i));
  return list;
}

std::vector<std::string> entries(std::size_t rows, std::size_t columns) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) list.push_back(fmt::format("{}, {}", i, j));
  return list;
}

void add_constraints(const AssemblyPlan& assembly, json& values) {
  const derive::loops::Constraints constraints = derive::loops::constraints_of(assembly);
  const model::Robot& robot = assembly.robot;
  const std::size_t gaps = constraints.rows + constraints.redundant_rows;
  const auto add = [&](const std::string& name, const ProgramCode& code) {
    values[name + "_values"] = code.values;
    values[name + "_code"] = code.code;
  };
  add("gap", code_of(constraints.gap, robot, numbers(gaps)));
  add("jacobian", code_of(constraints.jacobian, robot, entries(constraints.rows, robot.joints.size())));
  add("bias", code_of(constraints.bias, robot, numbers(constraints.rows)));
  values["gap_count"] = gaps;
  std::string doc = "In the order";
  for (const std::size_t i : assembly.used) doc += " " + std::to_string(i + 1);
  for (const std::size_t i : assembly.redundant) doc += " " + std::to_string(i + 1) + " (redundant)";
  values["gap_doc"] = doc + " of the description's loops.";
}

json fields_of(const std::vector<std::string>& list) {
  json result = json::array();
  for (const std::string& name : list) result.push_back({{"field", name}});
  return result;
}

/// How assemblies are numbered where a step gives all of its solutions at once.
std::string text_of_order(const model::Robot& described, const AssemblyPlan& assembly) {
  for (const derive::inverse::Step& step : assembly.plan.steps)
    if (step.is_quartic())
      return " They are numbered in the order of " +
             described.joints[static_cast<std::size_t>(step.joint)].variable +
             ": the number of one changes where others appear or vanish, its place next to a seed does not.";
  return "";
}

/// The gap, a share of the size, of closed rows; wider where more joints than freedoms are given, rounded.
std::string closing_of(const LoopVariant& variant, const AssemblyPlan& assembly) {
  const bool too_many = variant.of_limb && !assembly.redundant.empty();
  return too_many ? "std::max(t.tolerance, 1e-11)" : "t.tolerance";
}

/// Given slides whose values are lengths of rods, so not below zero.
json lengths_in(const model::Mechanism& mechanism, const std::vector<std::size_t>& given) {
  json list = json::array();
  for (const std::size_t joint : given) {
    const auto& closures = mechanism.loops.closures;
    if (std::any_of(closures.begin(), closures.end(),
                    [&](const model::Loop& loop) { return loop.length_joint == joint; }))
      list.push_back({{"joint", joint}});
  }
  return list;
}

json variant_of(const model::Mechanism& mechanism, const LoopVariant& variant, const AssemblyPlan& assembly) {
  const derive::inverse::LoweredPlan plan = derive::inverse::lower(assembly.plan);
  const verify::LoopCertificate certificate =
      verify::certify_loops(mechanism, assembly, plan, certificate_inputs);
  const model::Robot& robot = assembly.robot;
  const bool forward = variant.function == "assemble";
  json geometry = json::array();
  for (const auto& [name, field] : emit::geometry_fields(robot)) geometry.push_back({{"field", field}});
  json given_values = json::array();
  for (const std::size_t joint : assembly.given)
    for (const json& value : values_of_joint(robot, joint, false)) given_values.push_back(value);
  return {{"function", variant.function},
          {"type", variant.type},
          {"space", variant.space},
          {"doc", "All assemblies for values of " + described_names(mechanism.robot, variant.given) +
                      "; at most " + std::to_string(assembly.plan.capacity) + "." +
                      text_of_order(mechanism.robot, assembly)},
          {"summary", emit::lines_of(step_lines(mechanism.robot, assembly.plan))},
          {"certificate", certificate.text()},
          {"capacity", assembly.plan.capacity},
          {"argument", variant.argument},
          {"argument_type", forward ? std::string("Driven")
                                    : fmt::format("Eigen::Matrix<double, {}, 1>", variant.given.size())},
          {"given", commas(assembly.given)},
          {"given_count", assembly.given.size()},
          {"given_flags", commas(flags(robot.joints.size(), assembly.given))},
          {"given_values", given_values},
          {"closing", closing_of(variant, assembly)},
          {"lengths", lengths_in(mechanism, assembly.given)},
          {"checks_all", assembly.redundant.empty() ? "false" : "true"},
          {"geometry", geometry},
          {"has_geometry", !geometry.empty()},
          {"target_fields", fields_of(assembly.plan.target_kept)},
          {"work_fields", fields_of(emit::work_fields(plan))},
          {"target", emit::target_values(robot, plan, emit::cpp())},
          {"steps", emit::step_values(robot, plan, emit::cpp())},
          {"lines", emit::lines_of(emit::cpp().body({"t", "q", "found"}, emit::every_assembly(plan)))}};
}

std::string joined(const std::vector<std::string>& reasons) {
  return fmt::format("{}", fmt::join(reasons, "; "));
}

void check_number_of_motors(const model::Mechanism& mechanism) {
  const verify::Mobility mobility = verify::mobility_of(mechanism);
  if (!mobility.assembled) throw std::domain_error(joined(verify::text_of(mobility, mechanism)));
  const std::string problem = problem_of_motors(mechanism, mobility.free);
  if (!problem.empty()) throw std::domain_error(problem);
}

bool has_file(const RobotOutput& output, const std::string& path) {
  return std::any_of(output.files.begin(), output.files.end(),
                     [&](const OutputFile& file) { return file.path == path; });
}

/// The tips with the constants of their limbs, and how each is solved for its pose.
json tips_of(const model::Mechanism& mechanism, const std::vector<LimbInverse>& inverses) {
  json tips = json::array();
  const std::vector<model::Robot> limbs = limbs_of(mechanism);
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    json fields = json::array();
    for (const model::Parameter& parameter : limbs[i].geometry) fields.push_back({{"field", parameter.name}});
    tips.push_back({{"tip", mechanism.tips[i].name}, {"fields", fields}, {"inverse", false}});
    if (i >= inverses.size() || inverses[i].function.empty()) continue;
    tips.back()["inverse"] = {{"function", inverses[i].function}, {"type", inverses[i].type}};
  }
  return tips;
}

/// How each tip is solved for its pose; what is missing is noted.
std::vector<LimbInverse> inverses_of(const model::Mechanism& mechanism, const std::vector<RobotOutput>& limbs,
                                     const std::vector<PlannedVariant>& plans, RobotOutput& output) {
  std::vector<LimbInverse> list;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    list.push_back(limb_inverse(mechanism, i, limbs[i], plans));
    if (!list.back().lack.empty())
      output.missing.push_back(
          {"inverse_kinematics_of_" + mechanism.tips[i].name, Missing::Kind::not_derived, list.back().lack});
  }
  return list;
}

void add_platform(const model::Loops& loops, std::size_t joints, json& values) {
  values["has_outputs"] = !loops.outputs.empty();
  values["outputs"] = commas(loops.outputs);
  values["output_count"] = loops.outputs.size();
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < joints; ++i)
    if (std::find(loops.outputs.begin(), loops.outputs.end(), i) == loops.outputs.end()) others.push_back(i);
  values["others"] = commas(others);
}

/// Plans of all ways; those of limbs are there if they are found.
std::vector<PlannedVariant> plans_of(const model::Mechanism& mechanism, bool has_limbs) {
  std::vector<PlannedVariant> plans;
  for (const LoopVariant& variant : loop_variants(mechanism.loops))
    plans.push_back({variant, derive::loops::assembly_plan(mechanism, variant.given)});
  if (!has_limbs) return plans;
  for (const LoopVariant& variant : limb_variants(mechanism))
    plans.push_back({variant, derive::loops::assembly_plan(mechanism, variant.given)});
  return plans;
}

/// The first plan that there is. Its equations, as many as there are passive joints, serve rates and
/// dynamics.
const AssemblyPlan& first_found(const std::vector<PlannedVariant>& plans) {
  for (const PlannedVariant& each : plans)
    if (each.assembly.found) return each.assembly;
  throw std::domain_error(joined(plans.front().assembly.reasons));
}

std::vector<std::size_t> passive_joints(const model::Mechanism& mechanism) {
  std::vector<std::size_t> result;
  const auto& driven = mechanism.loops.actuated;
  for (std::size_t i = 0; i < mechanism.robot.joints.size(); ++i)
    if (std::find(driven.begin(), driven.end(), i) == driven.end()) result.push_back(i);
  return result;
}

/// A gap, m, that rounding leaves of loops of this size.
std::string closed_gap(const model::Mechanism& mechanism) {
  const verify::LoopNumbers numbers(mechanism);
  return fmt::format("{:.1e}", 1e-13 * std::max(numbers.size(), 1e-3));
}

void add_variants(const model::Mechanism& mechanism, const std::vector<PlannedVariant>& plans,
                  RobotOutput& output, json& values) {
  values["variants"] = json::array();
  for (const PlannedVariant& each : plans) {
    if (each.assembly.found) {
      values["variants"].push_back(variant_of(mechanism, each.variant, each.assembly));
      continue;
    }
    if (each.variant.of_limb) continue;  // missed by the limb's inverse kinematics alone
    const std::string reason = joined(each.assembly.reasons);
    output.missing.push_back({each.variant.function, Missing::Kind::not_derived, reason});
    if (each.variant.function == "assemble") values["missing"] = {{"reason", reason}};
  }
}

/// Other output of the robot, and whether a header for C is wanted.
struct Surroundings {
  bool has_dynamics, has_limbs, with_c;
  const std::vector<RobotOutput>& limbs;
};

void generate_assembly(const model::Mechanism& mechanism, const Surroundings& has, RobotOutput& output) {
  const std::string& name = mechanism.robot.name;
  const model::Loops& loops = mechanism.loops;
  check_number_of_motors(mechanism);
  const std::vector<PlannedVariant> plans = plans_of(mechanism, has.has_limbs);
  const std::vector<std::size_t> passive = passive_joints(mechanism);
  json values{{"name", name},
              {"dof", mechanism.robot.joints.size()},
              {"driven_count", loops.actuated.size()},
              {"passive_count", passive.size()},
              {"driven_names", described_names(mechanism.robot, loops.actuated)},
              {"driven", commas(loops.actuated)},
              {"passive", commas(passive)},
              {"has_dynamics", has.has_dynamics},
              {"has_limbs", has.has_limbs},
              {"tips", tips_of(mechanism, inverses_of(mechanism, has.limbs, plans, output))},
              {"enough", closed_gap(mechanism)},
              {"missing", false}};
  add_constraints(first_found(plans), values);
  add_platform(loops, mechanism.robot.joints.size(), values);
  add_variants(mechanism, plans, output, values);
  output.files.push_back(
      {"include/qvgen/robots/" + name + "/assembly.h", emit::render("cpp/assembly.h", values)});
  output.files.push_back({"source/" + name + "/assembly.cpp", emit::render("cpp/assembly.cpp", values)});
  if (!has.with_c) return;
  output.files.push_back({"c/qvgen_" + name + "_assembly.h", emit::render("c/assembly.h", values)});
  output.files.push_back({"source/" + name + "/c_assembly.cpp", emit::render("c/assembly.cpp", values)});
}

}  // namespace

std::vector<std::string> step_lines(const model::Robot& described, const derive::inverse::Plan& plan) {
  std::vector<std::string> lines;
  for (const derive::inverse::Step& step : plan.steps) {
    const std::string unknown =
        step.joint < 0 ? step.unknown : described.joints[static_cast<std::size_t>(step.joint)].variable;
    const std::string title = std::visit([](const auto& kind) { return std::string(kind.title); }, step.kind);
    lines.push_back(fmt::format("{}: {}; {}, {}", unknown, step.equation, title,
                                step.branches == 1 ? "1 value" : fmt::format("{} values", step.branches)));
  }
  return lines;
}

std::string problem_of_motors(const model::Mechanism& mechanism, int freedoms) {
  const auto count = [](int number, const std::string& of) {
    return fmt::format("{} {}{}", number, of, number == 1 ? "" : "s");
  };
  const auto driven = static_cast<int>(mechanism.loops.actuated.size());
  const auto outputs = static_cast<int>(mechanism.loops.outputs.size());
  if (driven != freedoms)
    return fmt::format("the mechanism has {} and {}; name {} in `actuated`", count(freedoms, "freedom"),
                       count(driven, "driven joint"), freedoms);
  if (outputs != 0 && outputs != freedoms)
    return fmt::format("the mechanism has {} and `outputs` names {}; name as many",
                       count(freedoms, "freedom"), count(outputs, "joint"));
  return "";
}

void add_assembly(const model::Mechanism& mechanism, const std::vector<RobotOutput>& limbs, Language language,
                  bool with_c, RobotOutput& output) {
  const std::string headers = "include/qvgen/robots/" + mechanism.robot.name + "/";
  const Surroundings has{has_file(output, headers + "dynamics.h"), has_file(output, headers + "limbs.h"),
                         with_c, limbs};
  const auto generate = [&](RobotOutput& made) { generate_assembly(mechanism, has, made); };
  if (const std::string lack = lack_of(row_of(language), "assembly"); !lack.empty())
    output.missing.push_back({"assembly", Missing::Kind::not_in_language, lack});
  else
    attempt_all({{"assembly", generate}}, output);
  if (!output.missing.empty()) output.counts["missing"] = missing_to_json(output.missing);
}

}  // namespace qvgen::pipeline
