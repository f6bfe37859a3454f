// SPDX-License-Identifier: MIT
// Descriptions for the commands. Each is read in a process of its own first, which ends with its budget, so
// that no file can hold a command up; there macros are expanded, too. What was read in time is read again
// here: a model does not travel between processes.
#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/driven_joints.h"
#include "pipeline/files.h"
#include "pipeline/parallel.h"
#include "toolchain/xacro.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;
using description::Diagnostic;
using description::ReadOptions;
using description::ReadResult;

// The first letter of what a trial says: what comes behind it.
constexpr char as_it_is = 'a';  ///< nothing
constexpr char expanded = 'x';  ///< the files that xacro has included, and what it makes of the file
constexpr char refused = 'r';   ///< what xacro says against it
constexpr char piped = 'p';     ///< the text of what can be read once, such as /dev/stdin

bool has_error(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& diagnostic) { return diagnostic.severity == Diagnostic::error; });
}

/// True if the file has macros, and the machine a xacro that expands them.
bool is_for_xacro(const fs::path& path) {
  std::error_code error;
  if (path.extension() == ".toml" || !fs::is_regular_file(path, error)) return false;
  if (fs::file_size(path, error) > description::max_file_size) return false;
  return toolchain::uses_xacro(pipeline::content_of(path).value_or("")) && toolchain::is_program("xacro");
}

std::string trial(const fs::path& path, const ReadOptions& options) {
  if (!is_for_xacro(path)) {
    const ReadResult result = description::read_file(path, options);
    std::error_code error;
    const bool lasts = result.text.empty() || fs::is_regular_file(path, error);
    return lasts ? std::string(1, as_it_is) : piped + result.text;
  }
  std::vector<std::string> files;
  const toolchain::Outcome outcome = toolchain::run_xacro(
      path, options.xacro_arguments, options.package_folders, options.lists_files ? &files : nullptr);
  if (!outcome.done) return refused + outcome.said;
  description::read_text(outcome.said, path.string(), options);
  std::string list;
  for (const std::string& file : files) list += (list.empty() ? "" : "\t") + file;
  return expanded + list + "\n" + outcome.said;
}

/// Reads what a trial has expanded: a line of the files that it includes, then a URDF.
ReadResult result_of_expanded(const fs::path& path, const ReadOptions& options, const std::string& text) {
  const std::size_t end = text.find('\n');
  ReadResult result = description::read_text(text.substr(end + 1), path.string(), options);
  std::istringstream list(text.substr(0, end));
  for (std::string file; std::getline(list, file, '\t');) result.files.push_back(file);
  const bool has_links = text.find("<link", end) != std::string::npos;
  for (Diagnostic& diagnostic : result.diagnostics) {
    diagnostic.file += " (expanded)";  // the lines are xacro's
    if (diagnostic.severity == Diagnostic::error && !has_links)
      diagnostic.hint = "if it defines macros alone, give the file that includes it and calls them";
  }
  return result;
}

ReadResult failed(const fs::path& path, const std::string& message, const std::string& hint) {
  ReadResult result;
  result.diagnostics.push_back({path.string(), 1, 1, Diagnostic::error, message, hint});
  return result;
}

/// The lines of a program's message as one.
std::string one_line(std::string text) {
  constexpr std::size_t longest = 1000;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (text.size() > longest) text = "... " + text.substr(text.size() - longest);
  std::string line;
  for (const char c : text) line += c == '\n' ? std::string("; ") : std::string(1, c);
  return line;
}

/// Returns what may help xacro. It loads YAML by a module of Python that its package does not bring along.
std::string advice(const std::string& said) {
  if (said.find("No module named 'yaml'") != std::string::npos)
    return "it needs a module of Python beside xacro: pip install pyyaml";
  return "give its arguments with --xacro-arg NAME:=VALUE, folders of packages with --package-path";
}

ReadResult result_of(const fs::path& path, const ReadOptions& options, const pipeline::Outcome& outcome) {
  if (!outcome.done) return failed(path, "reading it does not end: " + outcome.text, "make it simpler");
  const std::string behind = outcome.text.substr(1);
  if (outcome.text.front() == refused) return failed(path, "xacro: " + one_line(behind), advice(behind));
  if (outcome.text.front() == as_it_is) return description::read_file(path, options);
  if (outcome.text.front() == expanded) return result_of_expanded(path, options, behind);
  return description::read_text(behind, path.string(), options);
}

Diagnostic tree_refused(const ReadResult& result) {
  std::string tips;
  for (const model::Frame& tip : result.tips) tips += (tips.empty() ? "" : ", ") + tip.name;
  Diagnostic diagnostic = result.name_place;
  diagnostic.message = "this command takes one chain, and the robot has the tips " + tips;
  diagnostic.hint = "say which: --tip " + result.tips.front().name;
  return diagnostic;
}

/// Leaves the chain as one on a base that stands still.
void stand_still(ReadResult& result) {
  if (!result.robot->floating_base) return;
  Diagnostic diagnostic = result.name_place;
  diagnostic.severity = Diagnostic::note;
  diagnostic.message = "the base floats: this command takes the chain on a base that stands still";
  diagnostic.hint = "generate makes the functions of the base that floats";
  print_diagnostics({diagnostic});
  result.robot->floating_base.reset();
}

}  // namespace

void print_diagnostics(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics)
    fmt::print(stderr, "{}\n", description::to_string(diagnostic));
}

std::optional<std::vector<ReadResult>> read_descriptions(const std::vector<fs::path>& paths,
                                                         const ReadOptions& options) {
  const auto outcomes = pipeline::in_processes(
      paths.size(), [&](std::size_t i) { return trial(paths[i], options); }, pipeline::Budget{});
  std::vector<ReadResult> results;
  for (std::size_t i = 0; i < paths.size(); ++i) results.push_back(result_of(paths[i], options, outcomes[i]));
  bool good = true;
  for (ReadResult& result : results) {
    const std::string choices = find_driven_joints(result);
    print_diagnostics(result.diagnostics);
    if (!choices.empty()) fmt::print(stderr, "{}\n", choices);
    good = good && !has_error(result.diagnostics) && result.robot.has_value();
  }
  const auto clashes = description::check_together(results);
  print_diagnostics(clashes);
  if (!good || has_error(clashes)) return std::nullopt;
  return results;
}

model::Mechanism mechanism_of(const ReadResult& result) {
  return {result.robot.value(), result.tips, result.loops};
}

namespace {

bool are_chains(const std::vector<ReadResult>& results) {
  bool good = true;
  for (const ReadResult& result : results) {
    if (result.tips.empty()) continue;
    print_diagnostics({tree_refused(result)});
    good = false;
  }
  return good;
}

}  // namespace

std::optional<std::vector<ReadResult>> read_chains(const std::vector<fs::path>& paths,
                                                   const ReadOptions& options) {
  auto results = read_descriptions(paths, options);
  if (!results || !are_chains(*results)) return std::nullopt;
  for (ReadResult& result : *results) stand_still(result);
  return results;
}

std::optional<std::vector<model::Robot>> robots_of(const std::vector<ReadResult>& results) {
  if (!are_chains(results)) return std::nullopt;
  std::vector<model::Robot> robots;
  for (ReadResult result : results) {
    stand_still(result);
    robots.push_back(result.robot.value());
  }
  return robots;
}

std::optional<std::vector<ReadResult>> read_open(const std::vector<fs::path>& paths,
                                                 const ReadOptions& options) {
  auto results = read_descriptions(paths, options);
  if (!results) return std::nullopt;
  bool good = true;
  for (const ReadResult& result : *results) {
    if (result.loops.empty()) continue;
    Diagnostic diagnostic = result.name_place;
    diagnostic.message = "this command takes joints that all are free, and the robot has closed loops";
    diagnostic.hint = "qvgen show prints how they are assembled";
    print_diagnostics({diagnostic});
    good = false;
  }
  if (!good) return std::nullopt;
  return results;
}

}  // namespace qvgen::cli
