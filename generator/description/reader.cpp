// SPDX-License-Identifier: MIT
#include "description/reader.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "description/names.h"
#include "description/physics.h"
#include "description/plain_text.h"
#include "description/robot_file.h"
#include "description/robot_table.h"
#include "description/size_limits.h"
#include "description/tree/tree.h"
#include "description/xml/file_text.h"
#include "description/xml/mjcf_fragment.h"
#include "description/xml/reader.h"
#include "description/xml/text.h"

namespace qvgen::description {
namespace {

bool is_blank(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; });
}

ReadResult failed(const Context& context, Place place, const std::string& message, const std::string& hint) {
  ReadResult result;
  result.diagnostics.push_back(context.diagnostic(place, message, hint));
  return result;
}

/// Mistakes of the file itself first, then those of each file that it names. A place that is read several
/// times (a class, a copied part) is reported once.
void sort_by_place(Context& context) {
  const auto place = [&](const Diagnostic& d) {
    const auto file = std::find(context.files.begin(), context.files.end(), d.file);
    const bool is_main = d.file == context.source.file();
    return Place{d.line, d.column, is_main ? 0 : 1 + static_cast<int>(file - context.files.begin())};
  };
  auto& all = context.diagnostics;
  std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  const auto same = [](const Diagnostic& a, const Diagnostic& b) { return to_string(a) == to_string(b); };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
}

/// Limbs are robots of their own, named after the robot and their tip.
void check_names_of_limbs(Context& context, Place place, const model::Mechanism& mechanism) {
  for (const model::Frame& tip : mechanism.tips) {
    const std::string name = mechanism.robot.name + "_" + tip.name;
    const NameProblem problem = check_robot_name(name);
    if (!problem.message.empty())
      context.error(place, "the limb '" + name + "': " + problem.message, problem.hint);
  }
}

ReadResult finished(Context& context, Place name_place, model::Mechanism mechanism) {
  model::take_chain(mechanism);
  check_names_of_limbs(context, name_place, mechanism);
  sort_by_place(context);
  ReadResult result;
  result.name_place = context.diagnostic(name_place, "", "");
  result.files = context.files;
  std::sort(result.files.begin(), result.files.end());
  result.files.erase(std::unique(result.files.begin(), result.files.end()), result.files.end());
  result.diagnostics = std::move(context.diagnostics);
  const auto is_error = [](const Diagnostic& d) { return d.severity == Diagnostic::error; };
  if (std::none_of(result.diagnostics.begin(), result.diagnostics.end(), is_error)) {
    result.robot = std::move(mechanism.robot);
    result.tips = std::move(mechanism.tips);
    result.loops = std::move(mechanism.loops);
  }
  return result;
}

void rename(Context& context, model::Robot& robot) {
  const std::string& name = context.options.name;
  if (name.empty()) return;
  const NameProblem problem = check_robot_name(name);
  if (!problem.message.empty()) context.error({}, "--name " + name + ": " + problem.message, problem.hint);
  robot.name = name;
}

/// Leaves the chain to the tip that the options name.
void take_limb(Context& context, model::Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const model::Frame& tip : mechanism.tips) {
    names.push_back(tip.name);
    if (tip.name != context.options.tip) continue;
    mechanism = {model::limb(mechanism.robot, tip), {}};
    return;
  }
  const std::string near = nearest(context.options.tip, names);
  context.error({}, "--tip " + context.options.tip + ": there is no [[tip]] of that name",
                near.empty() ? "name a tip of the file" : "did you mean '" + near + "'?");
}

/// Reads a file that lists the loops of a URDF.
ReadResult read_beside_urdf(Context& context, const Table& root) {
  model::Mechanism mechanism = read_robot_file(root);
  rename(context, mechanism.robot);
  return finished(context, root.place_of(root.has("name") ? "name" : "robot"), std::move(mechanism));
}

ReadResult read_toml(Context& context, std::string_view text) {
  if (text.size() > max_bytes) {
    return failed(context, {}, "the file has " + std::to_string(text.size()) + " bytes",
                  "a description has at most " + std::to_string(max_bytes));
  }
  if (const auto place = too_many_dots(text)) {
    return failed(context, *place, "the file has more than " + std::to_string(max_dots) + " dots in keys",
                  "write tables as [table]");
  }
  try {
    const toml::table document = toml::parse(text);
    const Table root(context, document, "the file");
    if (root.has("robot")) return read_beside_urdf(context, root);
    model::Mechanism mechanism = read_robot(root);
    const ReadOptions& options = context.options;
    if (mechanism.tips.empty() ? !options.base.empty() || !options.tip.empty() : !options.base.empty())
      context.error({}, "--base and --tip: this description has no links to choose from",
                    "they are for URDF and MJCF; here [base] and [tool] give the frames");
    else if (!options.tip.empty())
      take_limb(context, mechanism);
    if (!options.tips.empty() || !options.fixed.empty() || options.floating)
      context.error(
          {}, "--tips, --fixed and --floating: this description says itself what it has",
          "they are for URDF and MJCF; here [[tip]] gives the tips, [floating_base] a base that floats");
    rename(context, mechanism.robot);
    return finished(context, root.place_of("name"), std::move(mechanism));
  } catch (const toml::parse_error& error) {
    return failed(context, begin_of(error.source()), "TOML syntax: " + std::string(error.description()),
                  "texts and expressions stand in quotes, arrays in [ ], one key = value per line");
  }
}

bool is_named_as_xml(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  return extension == ".urdf" || extension == ".xml" || extension == ".mjcf" || extension == ".xacro";
}

bool is_xml(std::string_view text, const std::string& file) {
  if (std::filesystem::path(file).extension() == ".toml") return false;
  if (is_named_as_xml(file)) return true;
  if (xml::is_utf16_xml(text)) return true;
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string_view::npos && text[first] == '<';
}

/// Names the robot by --name, else by what its file calls it, else by the file's own name, made a valid name;
/// a change is noted.
void name_robot(Context& context, const xml::Element& root, model::Robot& robot) {
  if (!context.options.name.empty()) return rename(context, robot);
  const xml::Attribute* name = root.attribute(root.name == "mujoco" ? "model" : "name");
  const bool is_named = name != nullptr && !name->value.empty();
  const std::string stem = std::filesystem::path(context.source.file()).stem().string();
  robot.name = tree::robot_identifier(is_named ? name->value : stem.empty() ? "robot" : stem);
  if (!is_named) robot.title = robot.name;
  if (is_named && robot.name != name->value)
    context.note(name->place, "the robot '" + name->value + "' is '" + robot.name + "' in the code",
                 "names of robots have small letters, digits and '_' there; --name gives another");
}

ReadResult read_xml(Context& context, std::string_view text) {
  model::Mechanism mechanism;
  model::Robot& robot = mechanism.robot;
  const auto root = xml::parse(context, text);
  const Place place = root ? root->place : Place{};
  if (root && root->name == "robot") {
    mechanism = xml::read_urdf(context, *root);
  } else if (root && root->name == "mujoco") {
    if (!xml::is_part_of_model(context, *root)) mechanism = xml::read_mjcf(context, *root);
  } else if (root && root->name == "mujocoinclude") {
    if (const auto model = xml::model_of_fragment(context, *root))
      mechanism = xml::read_mjcf(context, *model);
  } else if (root) {
    context.error(place, "<" + root->name + "> is no robot description",
                  "a URDF begins with <robot>, an MJCF with <mujoco>");
  }
  if (root) name_robot(context, *root, robot);
  robot.source = std::filesystem::path(context.source.file()).filename().string();
  for (const std::string* text_of_robot : {&robot.title, &robot.source})
    if (const std::string problem = problem_of_text(*text_of_robot); !problem.empty())
      context.error(place, "the robot's title or source " + problem, "use plain text");
  if (!context.has_error) check_inertia(context, robot);
  if (!context.has_error) check_size(context, robot);
  return finished(context, place, std::move(mechanism));
}

}  // namespace

ReadResult::ReadResult() = default;
ReadResult::ReadResult(const ReadResult&) = default;
ReadResult::ReadResult(ReadResult&&) noexcept = default;
ReadResult& ReadResult::operator=(const ReadResult&) = default;
ReadResult& ReadResult::operator=(ReadResult&&) noexcept = default;
ReadResult::~ReadResult() = default;

namespace {

const char* severity_text(Diagnostic::Severity severity) {
  switch (severity) {
    case Diagnostic::error:
      return ": error: ";
    case Diagnostic::warning:
      return ": warning: ";
    case Diagnostic::note:
      return ": note: ";
  }
  return ": ";
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  std::ostringstream text;
  text << diagnostic.file << ':' << diagnostic.line << ':' << diagnostic.column
       << severity_text(diagnostic.severity) << diagnostic.message;
  if (!diagnostic.hint.empty()) text << "; " << diagnostic.hint;
  return printable(text.str());
}

ReadResult read_text(std::string_view text, const std::string& file, const ReadOptions& options) {
  Context context(text, file, options);
  if (is_blank(text)) {
    return failed(context, {}, "the file is empty",
                  is_named_as_xml(file) ? "a URDF begins with <robot>, an MJCF with <mujoco>"
                                        : "begin with name = \"...\" and add [[joint]] tables");
  }
  ReadResult result = is_xml(text, file) ? read_xml(context, text) : read_toml(context, text);
  result.text = text;
  return result;
}

ReadResult read_file(const std::filesystem::path& path, const ReadOptions& options) {
  const xml::FileText file = xml::read_text_of(path, max_file_size);
  const Context context("", path.string(), options);
  if (file.is_too_large) {
    return failed(context, {}, "the file has more than " + std::to_string(max_file_size / 1'000'000) + " MB",
                  "a robot description is text, and far shorter");
  }
  if (!file.problem.empty())
    return failed(context, {}, "cannot read the file: " + file.problem,
                  "give the path of a robot description");
  return read_text(file.text, path.string(), options);
}

std::vector<Diagnostic> check_together(const std::vector<ReadResult>& robots) {
  std::vector<Diagnostic> diagnostics;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (std::size_t j = 0; robots[i].robot && j < i; ++j) {
      if (!robots[j].robot || robots[j].robot->name != robots[i].robot->name) continue;
      Diagnostic clash = robots[i].name_place;
      clash.message =
          "the robot name '" + robots[i].robot->name + "' is taken by " + robots[j].name_place.file;
      clash.hint = "give each robot of a run a name of its own";
      diagnostics.push_back(clash);
      break;
    }
  }
  return diagnostics;
}

}  // namespace qvgen::description
