// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include "canonical/structure.h"
#include "compare/comparison_json.h"
#include "model/followers.h"
#include "optimise/dynamics.h"
#include "pipeline/files.h"
#include "pipeline/output_folder.h"
#include "pipeline/parallel.h"
#include "report/arm_section.h"
#include "report/count_section.h"
#include "report/drawing.h"
#include "report/formula_sections.h"
#include "report/function_section.h"
#include "report/live_section.h"
#include "report/page.h"
#include "report/pages.h"
#include "report/reach_section.h"
#include "report/webassembly.h"

namespace qvgen::report {
namespace {

using compare::What;
using nlohmann::ordered_json;
using toolchain::Runtime;

/// Budget of one part of a page; the largest takes a twentieth of it.
constexpr pipeline::Budget budget{60, 4096};

ordered_json to_json(const Section& section) {
  return {{"id", section.id}, {"title", section.title}, {"html", section.html}};
}
Section section_from_json(const ordered_json& json) {
  return {json.at("id"), json.at("title"), json.at("html")};
}

std::string compared(const model::Robot& robot, What what) {
  ordered_json rows = ordered_json::array();
  for (const compare::Row& row : compare::compare(robot, {what, {}, {}}))
    rows.push_back(compare::to_json(row));
  return rows.dump();
}

/// The parts of a page by the processes that make them.
struct Part {
  const char* id;
  const char* title;
  std::string (*make)(const model::Robot& robot, const Runtime* runtime);
};

template <Section (*make)(const model::Robot&)>
std::string section_text(const model::Robot& robot, const Runtime*) {
  return to_json(make(robot)).dump();
}
std::string arm_text(const model::Robot& robot, const Runtime*) {
  return to_json(arm_section(robot, chain_of(robot))).dump();
}
std::string live_text(const model::Robot& robot, const Runtime* runtime) {
  return to_json(live_section(robot, runtime)).dump();
}
template <What what>
std::string rows_text(const model::Robot& robot, const Runtime*) {
  const bool has_none = what == What::dynamics && !optimise::has_inertia(robot);
  return has_none || model::has_followers(robot) ? "[]" : compared(robot, what);
}

/// Those that take longest first.
const std::vector<Part>& parts() {
  static const std::vector<Part> all{
      {"interactive", "Interactive view", live_text},
      {"rows of dynamics", "", rows_text<What::dynamics>},
      {"rows of forward", "", rows_text<What::forward>},
      {"rows of jacobian", "", rows_text<What::jacobian>},
      {"jacobian", "Jacobian and singularities", section_text<jacobian_section>},
      {"inverse", "Inverse kinematics", section_text<inverse_section>},
      {"arm", "The arm", arm_text},
      {"forward", "Forward kinematics", section_text<forward_section>},
      {"dynamics", "Dynamics", section_text<dynamics_section>},
      {"reach", "Reach", section_text<reach_section>}};
  return all;
}

/// A part that could not be made says so.
Section section_of(const Part& part, const pipeline::Outcome& outcome) {
  if (outcome.done) return section_from_json(ordered_json::parse(outcome.text));
  return {part.id, part.title, "<p>Not made: " + escaped(outcome.text) + ".</p>\n"};
}

std::vector<compare::Row> rows_of(const pipeline::Outcome& outcome) {
  std::vector<compare::Row> rows;
  if (!outcome.done) return rows;
  for (const auto& json : ordered_json::parse(outcome.text)) rows.push_back(compare::row_from_json(json));
  return rows;
}

std::string letters_of(const model::Robot& robot) {
  std::string letters;
  for (const model::Joint& joint : robot.joints)
    letters += joint.type == model::JointType::revolute ? 'R' : 'P';
  return letters;
}

ordered_json numbers_of(const compare::Row& row) {
  return {row.counts.multiplications, row.counts.additions, row.counts.sine_cosines, row.cost};
}

/// Returns the entry of a robot on the common pages.
ordered_json entry_of(const model::Robot& robot, const std::vector<Compared>& compared, const Times& times) {
  ordered_json entry{{"title", robot.title.empty() ? robot.name : robot.title},
                     {"joints", letters_of(robot)}};
  const auto structure = robot.joints.size() >= 3 ? canonical::structure_of(robot) : std::nullopt;
  entry["workspace"] = structure ? to_string(canonical::workspace_of(*structure)) : "";
  const std::string text = fmt::format("{} joints, {}.", robot.joints.size(), letters_of(robot));
  entry["thumbnail"] = thumbnail({chain_of(robot)}, {robot.name + "-small", robot.name, text});
  ordered_json& whats = entry["compared"] = ordered_json::object();
  for (const Compared& each : compared)
    for (const compare::Row& row : each.rows)
      whats[compare::what_names()[static_cast<std::size_t>(each.what)]]
           [compare::level_names()[static_cast<std::size_t>(row.level)]][row.formulation] = numbers_of(row);
  if (auto measured = times_json(times, robot.name); !measured.is_null()) entry["times"] = measured;
  return entry;
}

std::vector<std::string> subtitle_of(const model::Robot& robot) {
  std::vector<std::string> lines;
  if (!robot.title.empty()) lines.push_back(robot.title);
  if (!robot.source.empty()) lines.push_back("Source: " + robot.source);
  return lines;
}

pipeline::RobotOutput page_of(const model::Robot& robot, const std::vector<pipeline::Outcome>& outcomes,
                              const Ingredients& ingredients, const ordered_json& counts) {
  const auto place_of = [](const std::string& id) {
    const auto part =
        std::find_if(parts().begin(), parts().end(), [&](const Part& each) { return each.id == id; });
    return static_cast<std::size_t>(part - parts().begin());
  };
  const auto made = [&](const std::string& id) {
    return section_of(parts()[place_of(id)], outcomes[place_of(id)]);
  };
  std::vector<Compared> compared;
  for (const What what : {What::forward, What::jacobian, What::dynamics})
    compared.push_back(
        {what,
         rows_of(outcomes[place_of("rows of " + compare::what_names()[static_cast<std::size_t>(what)])])});
  const auto entry = counts.contains(robot.name) ? counts.at(robot.name) : ordered_json();
  Page page{robot.name, subtitle_of(robot), true, {}, live_script() + asset("sort.js")};
  for (const char* id : {"arm", "interactive", "forward", "inverse", "jacobian", "dynamics"})
    page.sections.push_back(made(id));
  page.sections.push_back(comparison_section(robot.name, compared, ingredients.times));
  page.sections.push_back(count_section(entry));
  page.sections.push_back(function_section(robot.name, ingredients.generated, entry));
  page.sections.push_back(made("reach"));
  return {page_name(robot.name),
          {{robot.name + ".html", html(page)}},
          entry_of(robot, compared, ingredients.times),
          {}};
}

}  // namespace

std::string page_name(const std::string& robot) { return "report/" + robot; }

std::string made_of(const std::string& robot, const Ingredients& ingredients) {
  const std::filesystem::path& generated = ingredients.generated;
  const ordered_json counts = pipeline::counts_in(generated);
  std::string text = counts.contains(robot) ? counts.at(robot).dump() : "";
  for (const std::string& path : pipeline::files_of_robots(generated, {robot}))
    if (path.ends_with(".h")) text += pipeline::content_of(generated / path).value_or("");
  text += times_json(ingredients.times, robot).dump();
  return text + missing_compiler() + (missing_compiler().empty() ? missing_cpp_library() : "");
}

std::vector<pipeline::RobotOutput> robot_pages(const std::vector<model::Robot>& robots,
                                               const Ingredients& ingredients,
                                               const std::function<void(const std::string&)>& progress) {
  const std::size_t count = parts().size();
  const ordered_json counts = pipeline::counts_in(ingredients.generated);
  std::vector<std::size_t> open(robots.size(), count);
  const auto done = [&](std::size_t i) {
    if (--open[i / count] == 0 && progress) progress(robots[i / count].name);
  };
  const auto outcomes = pipeline::in_processes(
      robots.size() * count,
      [&](std::size_t i) { return parts()[i % count].make(robots[i / count], ingredients.runtime); }, budget,
      done);
  std::vector<pipeline::RobotOutput> pages;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const auto begin = outcomes.begin() + static_cast<std::ptrdiff_t>(i * count);
    pages.push_back(
        page_of(robots[i], {begin, begin + static_cast<std::ptrdiff_t>(count)}, ingredients, counts));
  }
  return pages;
}

}  // namespace qvgen::report
