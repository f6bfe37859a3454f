// SPDX-License-Identifier: MIT
#include "cli/commands.h"

#include <algorithm>

#include <fmt/format.h>

#include "canonical/dh_table.h"
#include "cli/limbs.h"
#include "cli/suggestion.h"
#include "description/reader.h"
#include "description/write.h"
#include "emit/math/ability.h"
#include "emit/math/closed_form.h"
#include "emit/math/describe.h"
#include "emit/math/dynamics_closed_form.h"
#include "emit/math/jacobian_lines.h"
#include "emit/math/legend.h"
#include "emit/math/lines.h"
#include "emit/math/singularities.h"
#include "emit/math/transforms.h"
#include "model/followers.h"
#include "model/links.h"
#include "optimise/dynamics.h"
#include "pipeline/files.h"
#include "pipeline/loop_lines.h"
#include "pipeline/output_folder.h"
#include "pipeline/products/inverse_derivation.h"
#include "report/class_lines.h"
#include "report/workspace.h"

namespace qvgen::cli {
namespace fs = std::filesystem;

std::vector<fs::path> descriptions_in(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw UsageError("the descriptions of the known robots are not in " +
                     fs::weakly_canonical(folder).string() +
                     ", where this tool looks for them; install it with `cmake --install`, or name files");
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

int run_import(const fs::path& description, const description::ReadOptions& options) {
  const auto results = read_descriptions({description}, options);
  if (!results) return bad_description;
  return pipeline::bounded(description.string(), {}, [&] {
    fmt::print("{}", description::write_text(mechanism_of(results->front())));
    return int{success};
  });
}

int run_new(const std::string& code, const std::string& name, bool euler_wrist, const fs::path& robots) {
  const fs::path known = robots / (code + ".toml");
  const auto text =
      fs::exists(known) ? pipeline::content_of(known) : description::write_template(name, code, euler_wrist);
  if (!text) {
    fmt::print(stderr, "qvgen: '{}' is neither a known robot nor letters R and P, at most {}\n", code,
               description::max_joints);
    return usage_error;
  }
  fmt::print("{}", *text);
  return success;
}

namespace {

model::Robot part_to_show(model::Robot robot, const ShowArguments& arguments) {
  if (arguments.joints > 0) robot = model::first_joints(robot, arguments.joints);
  if (!arguments.masses.empty())
    robot = model::with_masses(robot,
                               arguments.masses == "end" ? model::MassPlace::end : model::MassPlace::middle);
  return robot;
}

/// Returns a sentence on what with_masses has put in place of the description's inertia.
std::string masses_sentence(const std::string& place) {
  if (place.empty()) return "";
  if (place == "end") return "m1, m2, ...: the mass of each link, all of it at the link's end.\n";
  return "m1, m2, ...: the mass of each link, in the middle of it;\n"
         "Ixx1, Iyy1, Izz1, ...: moments about that in the link's frame;\n"
         "length1, ...: of a link that slides, a rod along its axis.\n";
}

int show_dynamics(const model::Robot& robot, const std::string& masses, emit::Notation notation) {
  std::string missing;
  if (robot.joints.size() > 3)
    missing = "more than three joints: its closed form is too long to read; --joints 3 has its first three";
  else if (!optimise::has_inertia(robot))
    missing = "no inertia; --masses gives its links a mass each";
  if (!missing.empty()) {
    fmt::print(stderr, "qvgen: {} has {}\n", robot.name, missing);
    return failure;
  }
  fmt::print("{}", masses_sentence(masses));
  for (const std::string& line : emit::dynamics_closed_form_lines(robot, notation)) fmt::print("{}\n", line);
  return success;
}

int show_class(const model::Robot& robot) {
  const auto lines = report::class_lines(robot);
  for (const std::string& line : lines) fmt::print("{}\n", line);
  if (!lines.empty()) return success;
  fmt::print(stderr, "qvgen: {} has no class: {}\n", robot.name,
             model::has_followers(robot) ? "a joint follows another"
             : robot.joints.size() < 3   ? "fewer than three joints"
                                         : "a twist of its axes is a symbol");
  return failure;
}

int show_dh(const model::Robot& robot, const std::string& convention) {
  const auto table = canonical::dh_table(
      robot, convention == "modified" ? model::DhConvention::modified : model::DhConvention::standard);
  if (table) {
    fmt::print("{}", description::write_dh_text(robot, *table));
    return success;
  }
  fmt::print(stderr, "qvgen: {} has no table of Denavit and Hartenberg: {}\n", robot.name,
             robot.joints.empty() ? "no joints" : "the angle of a constant rotation is a symbol");
  return failure;
}

int show_workspace(const model::Robot& robot, emit::Notation notation) {
  const auto lines = report::workspace_lines(robot, notation);
  for (const std::string& line : lines) fmt::print("{}\n", line);
  if (!lines.empty()) return success;
  fmt::print(stderr, "qvgen: {} has no workspace in closed form: {}\n", robot.name,
             report::workspace_section(robot).missing);
  return failure;
}

void show_closed_form(const model::Robot& described, const derive::inverse::Derivation& derivation,
                      const std::string& more, emit::Notation notation) {
  const derive::inverse::Problem& problem = derivation.problem;
  const auto print = [&](const std::string& sentence, const char* end) {
    fmt::print("{}{}", notation.typeset ? emit::latex_words(sentence) : sentence, end);
  };
  print(emit::ability(described, derivation), "\n\n");
  if (!more.empty()) print(more, "\n\n");
  for (const std::string& line : emit::legend(described, {problem.moving, problem.phases})) print(line, "\n");
  for (const std::string& line : describe(derivation, notation)) fmt::print("{}\n", line);
}

/// Says what stands between the robot and the arm that the inverse kinematics is derived for.
void show_derived_arm(const pipeline::InverseDerivation& derivation) {
  for (const model::Joint& joint : derivation.coupled.joints)
    if (!joint.follows.empty())
      fmt::print("In joints, with {} = {}.\n", joint.variable, model::relation_text(joint.follows));
  if (derivation.outer)
    fmt::print("Given joints move the pose or are constants of the arm; what follows is of the {} others.\n",
               derivation.arm.joints.size());
}

int show_inverse(const model::Robot& robot, emit::Notation notation) {
  const pipeline::InverseDerivation derivation = pipeline::derive_inverse(robot);
  const model::Robot& described = derivation.found() ? derivation.arm : robot;
  if (derivation.found()) show_derived_arm(derivation);
  for (const auto& elimination : derivation.eliminations) {
    fmt::print("{}\n\n", emit::ability(described, elimination));
    for (const std::string& line : describe_elimination(elimination)) fmt::print("{}\n", line);
  }
  const std::string by_arm_angle = emit::arm_angle_ability(described);
  for (const auto& form : derivation.closed_forms)
    show_closed_form(described, form, &form == &derivation.closed_forms.front() ? by_arm_angle : "",
                     notation);
  if (derivation.found()) return success;
  for (const std::string& reason : derivation.reasons)
    fmt::print(stderr, "{}: no inverse kinematics: {}\n", described.name, reason);
  return failure;
}

}  // namespace

namespace {

int show(const model::Robot& whole, const ShowArguments& arguments) {
  const model::Robot robot = part_to_show(whole, arguments);
  const emit::Notation notation{arguments.latex,
                                arguments.exact ? emit::Numbers::exact : emit::Numbers::decimal};
  if (arguments.dynamics) return show_dynamics(robot, arguments.masses, notation);
  if (arguments.structure) return show_class(robot);
  if (!arguments.dh.empty()) return show_dh(robot, arguments.dh);
  if (arguments.singularities) {
    for (const std::string& line : emit::singularity_lines(robot, notation)) fmt::print("{}\n", line);
    return success;
  }
  if (arguments.transform) {
    for (const std::string& line : emit::transform_lines(robot, notation)) fmt::print("{}\n", line);
    return success;
  }
  if (arguments.jacobian) {
    for (const std::string& line : emit::jacobian_lines(robot, notation)) fmt::print("{}\n", line);
    return success;
  }
  if (arguments.workspace) return show_workspace(robot, notation);
  if (arguments.inverse) return show_inverse(robot, notation);
  const auto lines = emit::pose_lines(robot, notation);
  for (const std::string& line : lines) fmt::print("{}\n", line);
  if (!lines.empty()) return success;
  fmt::print(stderr,
             "qvgen: {} has a constant rotation by a symbolic angle: no closed form in half-angle sums\n",
             robot.name);
  return failure;
}

/// The option that asks for a formula of arms; empty if there is none.
std::string option_of_arms(const ShowArguments& arguments) {
  const std::pair<bool, const char*> options[] = {
      {arguments.inverse, "--inverse"},     {arguments.singularities, "--singularities"},
      {arguments.jacobian, "--jacobian"},   {arguments.transform, "--transform"},
      {arguments.workspace, "--workspace"}, {arguments.dynamics, "--dynamics"},
      {arguments.structure, "--class"},     {!arguments.dh.empty(), "--dh"}};
  for (const auto& [is_given, option] : options)
    if (is_given) return option;
  return "";
}

/// The derivation of closed loops, step by step, in a process of its own.
int show_loops(const model::Mechanism& mechanism, const ShowArguments& arguments) {
  if (const std::string option = option_of_arms(arguments); !option.empty()) {
    fmt::print(stderr,
               "qvgen: {} has closed loops, and {} is of arms: without it, show says how the loops are "
               "assembled\n",
               mechanism.robot.name, option);
    return failure;
  }
  return pipeline::bounded("show " + mechanism.robot.name, {}, [&] {
    const emit::Notation notation = arguments.latex ? emit::Notation::latex : emit::Notation::text;
    const pipeline::LoopLines loops = pipeline::loop_lines(mechanism, true, notation);
    for (const std::string& line : loops.lines) fmt::print("{}\n", line);
    for (const std::string& problem : loops.problems) fmt::print(stderr, "qvgen: {}\n", problem);
    return static_cast<int>(loops.problems.empty() ? success : failure);
  });
}

/// Shows a whole robot: which joint carries which, then each limb as a chain.
int show_limbs(const description::ReadResult& result, const ShowArguments& arguments) {
  if (arguments.dynamics) {
    fmt::print(
        stderr,
        "qvgen: {} branches, and joint forces of a limb alone are not the robot's: name a chain, --tip {}\n",
        result.robot->name, result.tips.front().name);
    return failure;
  }
  const std::vector<description::ReadResult> limbs = limbs_of(result);
  pipeline::Budget budget;
  budget.seconds *= limbs.size();
  return pipeline::bounded("show " + result.robot->name, budget, [&] {
    for (const std::string& line : tree_lines(result)) fmt::print("{}\n", line);
    int code = success;
    for (const description::ReadResult& limb : limbs) {
      fmt::print("\n{}:\n", limb.robot->name);
      std::fflush(stdout);
      code = std::max(code, show(*limb.robot, arguments));
    }
    return code;
  });
}

}  // namespace

int run_show(const ShowArguments& arguments) {
  const auto results = read_descriptions({arguments.description}, arguments.read);
  if (!results) return bad_description;
  if (!results->front().loops.empty()) return show_loops(mechanism_of(results->front()), arguments);
  if (!results->front().tips.empty()) return show_limbs(results->front(), arguments);
  const auto robots = robots_of(*results);
  if (!robots) return bad_description;
  return pipeline::bounded("show " + robots->front().name, {},
                           [&] { return show(robots->front(), arguments); });
}

int run_show_functions(const std::string& robot, const fs::path& folder) {
  const auto counts = pipeline::counts_in(folder);
  if (!counts.contains(robot)) {
    fmt::print(stderr, "qvgen: {} has no robot {}: run `qvgen generate` first, or say where with --output\n",
               folder.string(), robot);
    return failure;
  }
  const auto& entry = counts.at(robot);
  for (const std::string& name : pipeline::functions_in(entry)) fmt::print("{}\n", name);
  if (!entry.contains("missing")) return success;
  for (const pipeline::Missing& missing : pipeline::missing_from_json(entry.at("missing")))
    fmt::print("no {}: {}\n", missing.part, missing.reason);
  return success;
}

int run_counts(const CountsArguments& arguments) {
  const auto counts = pipeline::counts_in(arguments.folder);
  if (counts.empty()) {
    fmt::print(stderr, "qvgen: no operation counts in {}: run `qvgen generate` first\n",
               arguments.folder.string());
    return failure;
  }
  const CountsFilter& filter = arguments.filter;
  if (arguments.against.empty()) {
    check(filter, counts);
    fmt::print("{}", report(filtered(counts, filter), arguments.format, arguments.forms, filter.columns));
    return success;
  }
  const auto before = pipeline::counts_of(arguments.against);
  nlohmann::ordered_json both = before;  // what is named may be in one of the two alone
  for (const auto& [robot, functions] : counts.items()) both[robot].update(functions);
  check(filter, both);
  fmt::print("{}",
             changes(filtered(before, filter), filtered(counts, filter), arguments.format, filter.columns));
  return success;
}

}  // namespace qvgen::cli
