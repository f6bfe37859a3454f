// SPDX-License-Identifier: MIT
#include "pipeline/assembly.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "emit/math/describe.h"
#include "emit/render.h"
#include "model/coordinates.h"
#include "pipeline/assembly_in_c.h"
#include "pipeline/assembly_values.h"
#include "pipeline/limbs.h"
#include "pipeline/loop_variants.h"
#include "pipeline/pipeline.h"
#include "pipeline/six_rods.h"
#include "verify/loops/driven.h"
#include "verify/loops/mobility.h"

namespace qvgen::pipeline {
namespace {

using derive::loops::AssemblyPlan;
using nlohmann::json;

std::string joined(const std::vector<std::string>& reasons) {
  return fmt::format("{}", fmt::join(reasons, "; "));
}

void check_number_of_motors(const model::Mechanism& mechanism) {
  const verify::Mobility mobility = verify::mobility_of(mechanism);
  if (!mobility.assembled) throw std::domain_error(joined(verify::text_of(mobility, mechanism)));
  const std::string problem = problem_of_motors(mechanism, mobility);
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
    tips.back()["inverse"] = {{"function", inverses[i].function},
                              {"type", inverses[i].type},
                              {"space", inverses[i].space},
                              {"has_gears", inverses[i].has_gears}};
  }
  return tips;
}

/// Other output of the robot, its language, and whether a C header for C++ is wanted.
struct Surroundings {
  bool has_dynamics, has_limbs, with_c;
  Language language;
  const PartsOfLoops& parts;
};

/// True if a header in C of a robot declares a function.
bool declares(const RobotOutput& output, const std::string& robot, const std::string& part,
              const std::string& function) {
  return std::any_of(output.files.begin(), output.files.end(), [&](const OutputFile& file) {
    return file.path == "c/qvgen_" + robot + part + ".h" &&
           file.content.find(" " + robot + "_" + function + "(") != std::string::npos;
  });
}

/// How each tip is solved for its pose; what is missing is noted.
std::vector<LimbInverse> inverses_of(const model::Mechanism& mechanism, const Surroundings& has,
                                     const std::vector<PlannedVariant>& plans, RobotOutput& output) {
  std::vector<LimbInverse> list;
  for (std::size_t i = 0; i < has.parts.limbs.size(); ++i) {
    const std::string& tip = mechanism.tips[i].name;
    const std::string function = "inverse_kinematics_of_" + tip;
    list.push_back(limb_inverse(mechanism, i, has.parts.limbs[i], plans));
    if (!list.back().lack.empty())
      output.missing.push_back({function, Missing::Kind::not_derived, list.back().lack});
    const std::string limb = mechanism.robot.name + "_" + tip;
    if (list.back().function.empty() || has.language == Language::cxx ||
        declares(has.parts.limbs[i], limb, "_inverse", "inverse_kinematics"))
      continue;
    list.back() = {};
    output.missing.push_back({function, Missing::Kind::not_in_language, "the limb's is written in C++"});
  }
  return list;
}

/// Robots whose headers the loops' chains need.
json headers_of_chains(const std::vector<PlannedVariant>& plans) {
  json list = json::array();
  for (const PlannedVariant& each : plans)
    for (const derive::loops::LoopChain& chain : each.assembly.chains)
      if (each.assembly.found) list.push_back({{"chain", chain.chain.name}, {"rest", chain.rest.name}});
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

/// Says why the chain of a loop is not solved; empty if it is.
std::string lack_of_chain(const derive::loops::LoopChain& chain, const Surroundings& has) {
  const std::string& name = chain.chain.name;
  const auto& chains = has.parts.chains;
  const auto output = std::find_if(chains.begin(), chains.end(), [&](const RobotOutput& each) {
    return each.robot == folder_name(name, has.language);
  });
  if (output == chains.end()) return fmt::format("{} is not made", name);
  if (has.language != Language::cxx && !declares(*output, name, "_inverse", "inverse_kinematics"))
    return fmt::format("the inverse kinematics of {} is written in C++", name);
  if (solves_poses(*output)) return "";
  const auto missing = std::find_if(output->missing.begin(), output->missing.end(),
                                    [](const Missing& each) { return each.part == "inverse"; });
  return fmt::format("loop {} is the inverse kinematics of {}, and that is not derived: {}", chain.cycle + 1,
                     name, missing == output->missing.end() ? "it takes no pose" : missing->reason);
}

/// Plans some of whose chains are not solved are none.
void drop_unsolved(const Surroundings& has, std::vector<PlannedVariant>& plans) {
  for (PlannedVariant& each : plans)
    for (const derive::loops::LoopChain& chain : each.assembly.chains)
      if (const std::string lack = lack_of_chain(chain, has); each.assembly.found && !lack.empty()) {
        each.assembly.found = false;
        each.assembly.reasons = {lack};
      }
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

/// Adds `assemble` of a platform on six rods; false for other mechanisms, and with the reason if that fails.
bool add_six_rods(const model::Mechanism& mechanism, const LoopVariant& variant, json& values,
                  std::string& reason) {
  if (variant.function != "assemble" || !is_on_six_rods(mechanism)) return false;
  try {
    values["variants"].push_back(six_rods_variant(mechanism, variant, values["tips"]));
  } catch (const std::domain_error& error) {
    reason += "; " + std::string(error.what());
    return false;
  }
  return values["has_rods"] = true;
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
    std::string reason = joined(each.assembly.reasons);
    if (add_six_rods(mechanism, each.variant, values, reason)) continue;
    output.missing.push_back({each.variant.function, Missing::Kind::not_derived, reason});
    if (each.variant.function == "assemble") values["missing"] = {{"reason", reason}};
  }
}

/// Adds which driven joint each equation has to itself, by its place among them, if each has one and there
/// are as many: a rod on a motor's crank, or one that is a cylinder. The rates' right side is diagonal then.
void add_own_joints(const std::vector<std::size_t>& driven, std::size_t equations, json& values) {
  std::vector<std::size_t> own(equations, driven.size());
  std::size_t entries = 0;
  for (const json& output : values["jacobian_code"]["outputs"]) {
    std::size_t row = 0, column = 0;
    std::istringstream place(output["place"].get<std::string>());
    place >> row;
    place.ignore(1);
    place >> column;
    const auto found = std::find(driven.begin(), driven.end(), column);
    if (found == driven.end()) continue;
    ++entries;
    own.at(row) = static_cast<std::size_t>(found - driven.begin());
  }
  std::vector<std::size_t> sorted = own;
  std::sort(sorted.begin(), sorted.end());
  bool each = equations == driven.size() && entries == equations;
  for (std::size_t i = 0; each && i < equations; ++i) each = sorted[i] == i;
  values["has_own_equations"] = each;
  values["own_joints"] = commas(own);
}

/// Adds how dynamics are told where the robot is and how it moves: with a base that floats, or by joints
/// alone.
void add_configuration(const model::Robot& robot, json& values) {
  const bool floats = robot.floating_base.has_value();
  values["base_floats"] = floats;
  const std::size_t base = model::base_motions(robot);
  values["base_motions"] = base;
  const std::size_t moved = base + values["driven_count"].get<std::size_t>();
  values["whole_size"] = base + robot.joints.size();
  values["moved_size"] = moved;
  values["tips_in_world"] = floats && values["has_dynamics"] && values["has_limbs"];
  values["configuration"] = floats ? "Configuration<double>" : "JointVector<double>";
  values["at"] = floats ? "at" : "q";
  values["joint_values"] = floats ? "at.q" : "q";
  values["all_vector"] = floats ? "Velocity<double>" : "JointVector<double>";
  values["driven_vector"] = floats ? "DrivenVelocity" : "Driven";
  values["driven_matrix"] = floats ? "DrivenVelocityMatrix" : "DrivenMatrix";
  values["gravity"] = floats ? "const FreeFall<double>&" : "double";
}

/// Values of all templates. Adds what is missing to the output.
json values_of(const model::Mechanism& mechanism, const Surroundings& has,
               const std::vector<PlannedVariant>& plans, const AssemblyPlan& first, RobotOutput& output) {
  const model::Loops& loops = mechanism.loops;
  const std::vector<std::size_t> passive = passive_joints(mechanism);
  json values{{"name", mechanism.robot.name},
              {"dof", mechanism.robot.joints.size()},
              {"driven_count", loops.actuated.size()},
              {"passive_count", passive.size()},
              {"driven_names", described_names(mechanism.robot, loops.actuated)},
              {"driven", commas(loops.actuated)},
              {"passive", commas(passive)},
              {"has_dynamics", has.has_dynamics},
              {"has_limbs", has.has_limbs},
              {"tips", tips_of(mechanism, inverses_of(mechanism, has, plans, output))},
              {"enough", closed_gap(mechanism)},
              {"in_c", false},
              {"has_rods", false},
              {"chain_headers", headers_of_chains(plans)},
              {"missing", false}};
  add_constraints(first, values);
  add_own_joints(loops.actuated, passive.size(), values);
  add_platform(loops, mechanism.robot.joints.size(), values);
  add_configuration(mechanism.robot, values);
  add_variants(mechanism, plans, output, values);
  return values;
}

void add_cxx(const std::string& name, bool with_c, const json& values, RobotOutput& output) {
  const std::string headers = "include/qvgen/robots/" + name;
  output.files.push_back({headers + "/assembly.h", emit::render("cpp/assembly.h", values)});
  output.files.push_back({headers + "/assembly_batch.h", emit::render("cpp/assembly_batch.h", values)});
  output.files.push_back({"source/" + name + "/assembly.cpp", emit::render("cpp/assembly.cpp", values)});
  if (!with_c) return;
  output.files.push_back({"c/qvgen_" + name + "_assembly.h", emit::render("c/assembly.h", values)});
  output.files.push_back({"source/" + name + "/c_assembly.cpp", emit::render("c/assembly.cpp", values)});
}

void generate_assembly(const model::Mechanism& mechanism, const Surroundings& has, RobotOutput& output) {
  check_number_of_motors(mechanism);
  const std::string& name = mechanism.robot.name;
  std::vector<PlannedVariant> plans = plans_of(mechanism, has.has_limbs);
  const AssemblyPlan first = first_found(plans);
  drop_unsolved(has, plans);
  const json values = values_of(mechanism, has, plans, first, output);
  if (has.language == Language::cxx) return add_cxx(name, has.with_c, values, output);
  const emit::c::Part part = loops_in_c(mechanism, plans, first, values);
  output.files.push_back({"c/qvgen_" + name + "_loops.h", part.header});
  output.files.push_back({"c/qvgen_" + name + "_loops.c", part.source});
}

Surroundings surroundings_of(const model::Mechanism& mechanism, const PartsOfLoops& parts, Language language,
                             bool with_c, const RobotOutput& output) {
  const std::vector<RobotOutput>& limbs = parts.limbs;
  const std::string& name = mechanism.robot.name;
  if (language == Language::cxx) {
    const std::string headers = "include/qvgen/robots/" + name + "/";
    return {has_file(output, headers + "dynamics.h"), has_file(output, headers + "limbs.h"), with_c, language,
            parts};
  }
  bool has_limbs = !limbs.empty();
  for (std::size_t i = 0; i < limbs.size(); ++i)
    for (const char* function : {"forward_kinematics", "jacobian"})
      has_limbs = has_limbs && declares(limbs[i], name + "_" + mechanism.tips[i].name, "", function);
  const bool has_dynamics =
      declares(output, name, "", "inverse_dynamics") && declares(output, name, "", "mass_matrix");
  return {has_dynamics, has_limbs, with_c, language, parts};
}

/// Says why a language has no code of loops, or nothing.
std::string lack_of_loops(Language language) {
  if (language == Language::c_in_float) return "it is made in double";
  return lack_of(row_of(language), "assembly");
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

std::vector<ChainRobot> chain_robots(const model::Mechanism& mechanism) {
  std::vector<ChainRobot> robots;
  for (const derive::loops::LoopChain& each : derive::loops::chains_of(mechanism)) {
    robots.push_back({each.chain, "inverse"});
    robots.push_back({each.rest, "kinematics"});
  }
  return robots;
}

namespace {

/// Names of driven joints that determine the mechanism, the present ones among them, with a closed form if
/// there is one; empty if none are found.
std::string example_of_motors(const model::Mechanism& mechanism) {
  const auto choices = verify::driven_choices(mechanism, mechanism.loops.actuated).choices;
  if (choices.empty()) return "";
  const auto closed = std::find_if(choices.begin(), choices.end(), [&](const auto& joints) {
    return derive::loops::assembly_plan(mechanism, joints).found;
  });
  std::vector<std::string> names;
  for (const std::size_t joint : closed == choices.end() ? choices.front() : *closed)
    names.push_back(mechanism.robot.joints[joint].variable);
  return fmt::format(", for example {}", fmt::join(names, ","));
}

}  // namespace

std::string problem_of_motors(const model::Mechanism& mechanism, const verify::Mobility& mobility) {
  const int freedoms = mobility.free;
  const auto count = [](int number, const std::string& of) {
    return fmt::format("{} {}{}", number, of, number == 1 ? "" : "s");
  };
  const auto driven = static_cast<int>(mechanism.loops.actuated.size());
  const auto outputs = static_cast<int>(mechanism.loops.outputs.size());
  if (driven != freedoms)
    return fmt::format("the mechanism has {} and {}; name {} in `actuated`{}", count(freedoms, "freedom"),
                       count(driven, "driven joint"), freedoms, example_of_motors(mechanism));
  if (outputs != 0 && outputs != freedoms)
    return fmt::format("the mechanism has {} and `outputs` names {}; name as many",
                       count(freedoms, "freedom"), count(outputs, "joint"));
  if (!mobility.loose.empty())
    return fmt::format(
        "{} move although the driven joints stand still; name one of them in `actuated`, in place of another "
        "joint",
        described_names(mechanism.robot, mobility.loose));
  return "";
}

void add_assembly(const model::Mechanism& mechanism, const PartsOfLoops& parts, Language language,
                  bool with_c, RobotOutput& output) {
  const Surroundings has = surroundings_of(mechanism, parts, language, with_c, output);
  const auto generate = [&](RobotOutput& made) { generate_assembly(mechanism, has, made); };
  if (const std::string lack = lack_of_loops(language); !lack.empty())
    output.missing.push_back({"assembly", Missing::Kind::not_in_language, lack});
  else
    attempt_all({{"assembly", generate}}, output);
  if (!output.missing.empty()) output.counts["missing"] = missing_to_json(output.missing);
}

}  // namespace qvgen::pipeline
