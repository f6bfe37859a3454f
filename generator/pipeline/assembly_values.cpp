// SPDX-License-Identifier: MIT
#include "pipeline/assembly_values.h"

#include <algorithm>

#include "derive/inverse/lower.h"
#include "derive/inverse/names.h"
#include "derive/loops/constraints.h"
#include "emit/ast/literal.h"
#include "emit/ast/printer.h"
#include "emit/c/printer.h"
#include "emit/cpp/printer.h"
#include "emit/inverse/every_assembly.h"
#include "emit/inverse/steps.h"
#include "emit/inverse/target.h"
#include "emit/leaves.h"
#include "emit/math/describe.h"
#include "emit/template_values.h"
#include "exact/named_constant.h"
#include "model/private_names.h"
#include "passes/pass.h"
#include "pipeline/assembly.h"
#include "verify/loops/certify_loops.h"

namespace qvgen::pipeline {
namespace {

using derive::loops::AssemblyPlan;
using nlohmann::json;
namespace names = derive::inverse::names;

constexpr int certificate_inputs = 12;

std::vector<std::string> flags(std::size_t count, const std::vector<std::size_t>& joints) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(std::find(joints.begin(), joints.end(), i) == joints.end() ? "false" : "true");
  return list;
}

/// A language, and what stands in front of its functions of mathematics.
struct Dialect {
  const emit::ast::Printer& printer;
  std::string math;
};

Dialect in_cpp() { return {emit::cpp(), "std::"}; }
Dialect in_c() { return {emit::c::printer(), ""}; }

/// The symbols that stand for a joint, with their values in code. With the rate there is a turn's angle, too.
json values_of_joint(const model::Robot& robot, std::size_t joint, bool with_rate, const Dialect& dialect) {
  const std::string& variable = robot.joints[joint].variable;
  const std::string q = fmt::format("q[{}]", joint);
  json list = json::array();
  const bool slides = robot.joints[joint].type == model::JointType::prismatic;
  if (slides || with_rate) list.push_back({{"name", variable}, {"value", q}});
  if (!slides) {
    list.push_back(
        {{"name", names::cosine(variable)}, {"value", dialect.math + "cos(" + q + ")"}, {"cosine_of", q}});
    list.push_back(
        {{"name", names::sine(variable)}, {"value", dialect.math + "sin(" + q + ")"}, {"sine_of", q}});
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
                    const std::vector<std::string>& places, const Dialect& dialect) {
  std::vector<std::string> all;
  for (const auto& output : program.outputs()) all.push_back(output.name);
  dag::Function function = passes::share_reciprocals(derive::inverse::lowered(program, all));
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
  result.code = emit::values_of(straight, dialect.printer);
  for (std::size_t i = 0; i < kept.size(); ++i) result.code["outputs"][i]["place"] = kept[i];
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint)
    for (const json& value : values_of_joint(robot, joint, true, dialect))
      if (emit::ast::mentions(straight, value["name"])) result.values.push_back(value);
  return result;
}

/// The angles of cosines and sines among values, which are taken from one call for all of them.
json in_one_call(json& values) {
  std::vector<std::string> angles;
  const auto place_of = [&](const std::string& angle) {
    const auto place = std::find(angles.begin(), angles.end(), angle);
    if (place != angles.end()) return place - angles.begin();
    angles.push_back(angle);
    return static_cast<std::ptrdiff_t>(angles.size()) - 1;
  };
  for (json& each : values)
    for (const char* part : {"cosine", "sine"})
      if (const auto angle = each.find(std::string(part) + "_of"); angle != each.end())
        each["value"] = fmt::format("angles.{}[{}]", part, place_of(*angle));
  return angles.empty() ? json(false) : json{{"list", fmt::format("{}", fmt::join(angles, ", "))}};
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

/// An entry of a matrix, "0, 1", as one of an array of arrays.
std::string place_in_c(const std::string& place) {
  const std::size_t comma = place.find(", ");
  return comma == std::string::npos ? place : place.substr(0, comma) + "][" + place.substr(comma + 2);
}

/// Code for the values of joints that gears lead, one after the other.
json values_of_gears(const AssemblyPlan& assembly, const Dialect& dialect) {
  json list = json::array();
  std::vector<derive::loops::Geared> gears = assembly.geared;
  gears.insert(gears.end(), assembly.led.begin(), assembly.led.end());
  for (const derive::loops::Geared& each : gears) {
    const ProgramCode code = code_of(derive::loops::program_of(each, assembly.robot, assembly.cycles),
                                     assembly.robot, numbers(1), dialect);
    list.push_back({{"joint", each.joint}, {"values", code.values}, {"code", code.code}});
  }
  return list;
}

json values_of_known(const AssemblyPlan& assembly, const Dialect& dialect) {
  json list = json::array();
  for (const std::size_t joint : assembly.known())
    for (const json& value : values_of_joint(assembly.robot, joint, false, dialect)) list.push_back(value);
  return list;
}

/// The loops that are solved as chains. Each calls what comes behind it by its number.
json chains_of(const AssemblyPlan& assembly) {
  json list = json::array();
  for (std::size_t i = assembly.chains.size(); i-- > 0;) {
    const derive::loops::LoopChain& each = assembly.chains[i];
    json joints = json::array(), fields = json::array();
    for (std::size_t place = 0; place < each.joints.size(); ++place)
      if (each.joints[place]) joints.push_back({{"place", place}, {"joint", *each.joints[place]}});
    for (const model::Parameter& parameter : each.chain.geometry)
      fields.push_back({{"field", parameter.name}});
    list.push_back({{"number", i},
                    {"next", i + 1},
                    {"loop", each.cycle + 1},
                    {"chain", each.chain.name},
                    {"rest", each.rest.name},
                    {"rest_joints", commas(each.rest_joints)},
                    {"joints", joints},
                    {"fields", fields},
                    {"is_short", each.held().size() < derive::loops::rows_of(assembly.cycles[each.cycle])}});
  }
  return list;
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

/// Says which numbers of equations are gears'.
std::string text_of_gears(const AssemblyPlan& assembly) {
  const auto is_gear = [](const derive::loops::Cycle& cycle) { return cycle.type == model::LoopType::gear; };
  const auto first = std::find_if(assembly.cycles.begin(), assembly.cycles.end(), is_gear);
  if (first == assembly.cycles.end()) return "";
  return fmt::format(" From {} on they are joints that follow others, rad or m, and their forces N m or N.",
                     first->number);
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

/// Lengths of the slides that are driven, where these are what is given, as a list in code; false without
/// any. `magnitude`: the function of absolute values.
json slides_in(const LoopVariant& variant, const AssemblyPlan& assembly, const std::string& magnitude) {
  std::vector<std::string> lengths;
  for (const std::size_t joint : assembly.given)
    if (assembly.robot.joints[joint].type == model::JointType::prismatic)
      lengths.push_back(fmt::format("{}(q[{}])", magnitude, joint));
  if (variant.function != "assemble" || lengths.empty()) return false;
  return {{"list", fmt::format("{{{}}}", fmt::join(lengths, ", "))}};
}

/// Each unknown with its equation.
std::vector<std::string> summary_of(const model::Robot& described, const AssemblyPlan& assembly) {
  std::vector<std::string> lines;
  for (const derive::loops::LoopChain& chain : assembly.chains)
    lines.push_back(fmt::format("{}: the inverse kinematics of {}", described_names(described, chain.held()),
                                chain.chain.name));
  for (const std::string& line : step_lines(described, assembly.plan)) lines.push_back(line);
  return lines;
}

/// Says what is proven of the steps. Loops that are chains are certified as inverse kinematics.
std::string certificate_of(const model::Mechanism& mechanism, const AssemblyPlan& assembly,
                           const derive::inverse::LoweredPlan& plan) {
  if (!assembly.chains.empty() && assembly.plan.steps.empty())
    return "Newton's steps close each row to rounding.";
  return verify::certify_loops(mechanism, assembly, plan, certificate_inputs).text();
}

}  // namespace

std::string described_names(const model::Robot& robot, const std::vector<std::size_t>& joints) {
  std::vector<std::string> list;
  for (const std::size_t joint : joints) list.push_back(robot.joints[joint].variable);
  return commas(list);
}

std::string capacity_of(const AssemblyPlan& assembly, const std::string& before, const std::string& behind) {
  std::string text;
  for (const derive::loops::LoopChain& chain : assembly.chains)
    text += before + chain.chain.name + behind + " * ";
  if (!text.empty() && assembly.plan.capacity == 1) return text.substr(0, text.size() - 3);
  return text + std::to_string(assembly.plan.capacity);
}

void add_constraints(const AssemblyPlan& assembly, json& values) {
  const derive::loops::Constraints constraints = derive::loops::constraints_of(assembly);
  const model::Robot& robot = assembly.robot;
  const std::size_t gaps = constraints.rows + constraints.redundant_rows;
  const auto add = [&](const std::string& name, ProgramCode code) {
    values[name + "_angles"] = in_one_call(code.values);
    values[name + "_values"] = code.values;
    values[name + "_code"] = code.code;
  };
  add("gap", code_of(constraints.gap, robot, numbers(gaps), in_cpp()));
  add("jacobian",
      code_of(constraints.jacobian, robot, entries(constraints.rows, robot.joints.size()), in_cpp()));
  // Newton's steps take both at the same joints.
  const bool share = values["gap_angles"] == values["jacobian_angles"];
  values["shared_angles"] = share ? values["gap_angles"] : json(false);
  add("bias", code_of(constraints.bias, robot, numbers(constraints.rows), in_cpp()));
  values["gap_count"] = gaps;
  std::string doc = "In the order";
  for (const std::size_t i : assembly.used) doc += " " + std::to_string(i + 1);
  for (const std::size_t i : assembly.redundant) doc += " " + std::to_string(i + 1) + " (redundant)";
  values["gap_doc"] = doc + " of the description's loops." + text_of_gears(assembly);
}

json variant_of(const model::Mechanism& mechanism, const LoopVariant& variant, const AssemblyPlan& assembly) {
  const derive::inverse::LoweredPlan plan = derive::inverse::lower(assembly.plan);
  const bool has_chains = !assembly.chains.empty();
  const model::Robot& robot = assembly.robot;
  const bool forward = variant.function == "assemble";
  json geometry = json::array();
  for (const auto& [name, field] : emit::geometry_fields(robot)) geometry.push_back({{"field", field}});
  json given_values = values_of_known(assembly, in_cpp());
  const json given_angles = in_one_call(given_values);
  const emit::CppPrinter in_signs("inverse::BothSigns");
  const std::vector<std::string> arguments = {"t", "q", "found"};
  const bool as_found = !has_chains && !assembly.has_gears() && assembly.redundant.empty();
  return {{"function", variant.function},
          {"type", variant.type},
          {"space", variant.space},
          {"doc", "All assemblies for values of " + described_names(mechanism.robot, variant.given) +
                      (has_chains ? "." : "; at most " + capacity_of(assembly, "", "") + ".") +
                      text_of_order(mechanism.robot, assembly)},
          {"summary", emit::lines_of(summary_of(mechanism.robot, assembly))},
          {"certificate", certificate_of(mechanism, assembly, plan)},
          {"capacity", capacity_of(assembly, "robots::", "::Solutions::max_size")},
          {"chains", chains_of(assembly)},
          {"has_chains", has_chains},
          {"count_of_chains", assembly.chains.size()},
          {"each_chain", assembly.plan.capacity},
          {"argument", variant.argument},
          {"argument_type", forward ? std::string("Driven")
                                    : fmt::format("Eigen::Matrix<double, {}, 1>", variant.given.size())},
          {"given", commas(assembly.given)},
          {"given_count", assembly.given.size()},
          {"given_flags", commas(flags(robot.joints.size(), assembly.told()))},
          {"rods", false},
          {"has_gears", assembly.has_gears()},
          {"gears", values_of_gears(assembly, in_cpp())},
          {"given_angles", given_angles},
          {"given_values", given_values},
          {"closing", closing_of(variant, assembly)},
          {"lengths", lengths_in(mechanism, assembly.given)},
          {"slides", slides_in(variant, assembly, "std::abs")},
          {"checks_all", !assembly.redundant.empty()},
          {"has_all_inline", !assembly.plan.quartic()},
          {"geometry", geometry},
          {"has_geometry", !geometry.empty()},
          {"target_fields", fields_of(assembly.plan.target_kept)},
          {"work_fields", fields_of(emit::work_fields(plan))},
          {"target", emit::target_values(robot, plan, emit::cpp())},
          {"steps", emit::step_values(robot, plan, emit::cpp())},
          {"lines", emit::lines_of(in_signs.body(
                        arguments, emit::every_assembly(plan, emit::Signs::side_by_side, as_found)))}};
}

void add_constraints_in_c(const AssemblyPlan& assembly, json& values) {
  const derive::loops::Constraints constraints = derive::loops::constraints_of(assembly);
  const model::Robot& robot = assembly.robot;
  const auto add = [&](const std::string& name, const symbolic::Program& program,
                       const std::vector<std::string>& places) {
    ProgramCode code = code_of(program, robot, places, in_c());
    for (json& output : code.code["outputs"]) output["place"] = place_in_c(output["place"]);
    values[name + "_values"] = code.values;
    values[name + "_code"] = code.code;
  };
  add("gap", constraints.gap, numbers(constraints.rows + constraints.redundant_rows));
  add("jacobian", constraints.jacobian, entries(constraints.rows, robot.joints.size()));
  add("bias", constraints.bias, numbers(constraints.rows));
}

json variant_in_c(const LoopVariant& variant, const AssemblyPlan& assembly, json values) {
  const derive::inverse::LoweredPlan plan = derive::inverse::lower(assembly.plan);
  const std::string prefix = variant.function + "_";
  const emit::c::Printer printer(prefix);
  values["p"] = prefix;
  values["capacity"] = capacity_of(assembly, "", "_solutions_capacity");
  values["gears"] = values_of_gears(assembly, in_c());
  values["given_values"] = values_of_known(assembly, in_c());
  values["slides"] = slides_in(variant, assembly, "fabs");
  if (values["closing"] != "t.tolerance")
    values["closing"] = "larger(t->tolerance, 1e-11)";
  else
    values["closing"] = "t->tolerance";
  values["target"] = emit::target_values(assembly.robot, plan, printer);
  values["steps"] = emit::step_values(assembly.robot, plan, printer);
  values["lines"] =
      emit::lines_of(printer.body({"t", "q", "found"}, emit::every_assembly(plan, emit::Signs::in_turn)));
  return values;
}

}  // namespace qvgen::pipeline
