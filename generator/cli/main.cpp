// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/documents.h"
#include "cli/installation.h"
#include "cli/language_table.h"
#include "cli/suggestion.h"
#include "cli/verdict.h"
#include "pipeline/pipeline.h"
#include "pipeline/robot_output.h"
#include "toolchain/packages.h"
#include "verify/certificate.h"

namespace {

namespace fs = std::filesystem;
using namespace qvgen::cli;
using namespace qvgen::pipeline;
namespace compare = qvgen::compare;
using qvgen::description::ReadOptions;

std::vector<std::string> names_in(const fs::path& robots) {
  std::vector<std::string> names;
  for (const fs::path& path : descriptions_in(robots)) names.push_back(path.stem().string());
  return names;
}

/// A folder may have the name of a robot.
bool is_file(const fs::path& path) { return fs::exists(path) && !fs::is_directory(path); }

/// The file that package://NAME/FILE means.
fs::path file_in_package(const std::string& robot, const ReadOptions& options) {
  std::vector<std::string> folders = options.package_folders;
  if (const char* path = std::getenv("ROS_PACKAGE_PATH")) folders.emplace_back(path);
  const fs::path file = qvgen::toolchain::without_package(
      robot, qvgen::toolchain::packages_in(folders, fs::current_path() / "file"));
  if (file.empty())
    throw UsageError(robot + ": there is no such package; say where with --package-path FOLDER");
  return file;
}

/// A robot by name or by file. What looks like a file is one, and whoever reads it says if it is not there.
fs::path description_of(const std::string& robot, const fs::path& robots, const ReadOptions& options) {
  if (robot.rfind("package://", 0) == 0) return file_in_package(robot, options);
  const fs::path named = robots / (robot + ".toml");
  const bool is_path = robot.find('/') != std::string::npos || fs::path(robot).has_extension();
  if (is_file(robot) || is_path) return robot;
  if (!fs::exists(named)) {
    if (fs::is_directory(robot)) throw UsageError("'" + robot + "' is a folder; name the files in it");
    const std::string problem = "there is no file and no known robot '" + robot + "'";
    throw UsageError(with_suggestion(problem, robot, names_in(robots)));
  }
  return named;
}

std::vector<fs::path> descriptions_of(const std::vector<std::string>& names, const fs::path& robots,
                                      const ReadOptions& options) {
  std::vector<fs::path> paths;
  for (const std::string& name : names) paths.push_back(description_of(name, robots, options));
  return paths;
}

bool has(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

void check_parts(const std::string& option, const std::vector<std::string>& parts,
                 const std::vector<std::string>& known) {
  check_names(option + ": there is no part", parts, known);
}

CompareArguments compare_arguments(CommandLine& line, const Installation& here) {
  CompareArguments arguments = line.compare;
  const auto& whats = compare::what_names();
  arguments.request.what =
      static_cast<compare::What>(std::find(whats.begin(), whats.end(), line.what) - whats.begin());
  const auto& levels = compare::level_names();
  for (const std::string& name : line.levels)
    arguments.request.levels.push_back(
        static_cast<compare::Level>(std::find(levels.begin(), levels.end(), name) - levels.begin()));
  check_names("--formulations: there is no", arguments.request.formulations,
              compare::formulation_names(arguments.request.what));
  arguments.all_known = line.compared.empty();
  arguments.descriptions = line.compared.empty()
                               ? descriptions_in(here.robots)
                               : descriptions_of(line.compared, here.robots, arguments.read);
  return arguments;
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path from = fs::weakly_canonical(path).lexically_relative(fs::weakly_canonical(folder));
  return !from.empty() && *from.begin() != "..";
}

/// ./generated; for the robots of the source tree, called from inside it, the tree's own.
fs::path default_output(const Installation& here, const std::vector<std::string>& files) {
  const fs::path current = fs::current_path();
  if (!here.source_tree || !is_inside(current, *here.source_tree)) return "generated";
  const bool own = std::none_of(files.begin(), files.end(), [](const auto& file) { return is_file(file); });
  if (own) return *here.source_tree / "generated";
  if (fs::weakly_canonical(current / "generated") != fs::weakly_canonical(*here.source_tree / "generated"))
    return "generated";
  throw UsageError("./generated is that of qvgen's own robots here; say where to with --output");
}

int print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print("{}\n", line);
  return success;
}

fs::path folder_of(const CommandLine& line, const Installation& here, const std::vector<std::string>& files) {
  return line.output.empty() ? default_output(here, files) : fs::path(line.output);
}

/// Named ones, or all that are known.
std::vector<fs::path> wanted_descriptions(const std::vector<std::string>& named, const Installation& here,
                                          const ReadOptions& options) {
  return named.empty() ? descriptions_in(here.robots) : descriptions_of(named, here.robots, options);
}

void check_parts_of(const GenerateArguments& generate) {
  check_parts("--only", generate.parts, product_names());
  check_parts("--require", generate.required, part_names());
  for (const std::string& part : generate.required)
    if (!generate.parts.empty())
      check_parts("--only without what is required", {product_of(part)}, generate.parts);
  for (const std::string& part : extra_names())
    if (generate.parts.empty() && has(generate.required, part))
      throw UsageError("--require " + part + ": it is made only if --only names it too");
}

Language language_of(const std::string& name, const std::string& scalar) {
  Language found = Language::cxx;
  for (const LanguageRow& row : languages())
    if (row.name == name) found = row.language;
  if (scalar != "float") return found;
  if (!is_in_float(in_float(found)))
    throw UsageError(
        "--scalar float: it is for --language c, opencl and cuda; functions of C++ take float as they are, "
        "crates of Rust "
        "have the feature f32, other languages compute in double");
  return in_float(found);
}

/// Generates in one language after the other. Descriptions that cannot be read end the run.
int generate_in(const std::vector<Language>& wanted, GenerateArguments& generate) {
  const BuildFiles& build = generate.build;
  if (wanted.size() > 1 && !(build.outputs.empty() && build.depfile.empty() && build.sources.empty()))
    throw UsageError("--list-outputs, --depfile and --sources are for one language");
  KeptProducts kept;
  ExitCode verdict = success;
  for (const Language language : wanted) {
    generate.language = language;
    const auto result = static_cast<ExitCode>(run_generate(generate, kept));
    if (result == bad_description) return result;
    verdict = worse(verdict, result);
  }
  return verdict;
}

int generate(CommandLine& line, const Installation& here) {
  GenerateArguments& generate = line.generate;
  check_parts_of(generate);
  std::vector<Language> wanted;
  for (const std::string& name : line.languages) wanted.push_back(language_of(name, line.scalar));
  generate.known_robots = here.robots;
  generate.output = folder_of(line, here, line.generate_files);
  generate.tool = here.tool;
  generate.all_known = line.generate_files.empty();
  generate.descriptions = wanted_descriptions(line.generate_files, here, generate.read);
  return generate_in(wanted, generate);
}

int show(CommandLine& line, const Installation& here) {
  if (line.functions)
    return run_show_functions(fs::path(line.shown).stem().string(), folder_of(line, here, {}));
  line.show.description = description_of(line.shown, here.robots, line.show.read);
  return run_show(line.show);
}

int counts(CommandLine& line, const Installation& here) {
  line.counts.folder = folder_of(line, here, {});
  return run_counts(line.counts);
}

int report(CommandLine& line, const Installation& here) {
  ReportArguments& report = line.report;
  report.known_robots = here.robots;
  report.source_tree = here.source_tree;
  report.tool = here.tool;
  report.all_known = line.reported.empty();
  report.descriptions = wanted_descriptions(line.reported, here, report.read);
  if (report.generated.empty()) report.generated = default_output(here, {});
  return run_report(report);
}

int map(CommandLine& line, const Installation& here) {
  MapArguments& map = line.map;
  if (line.mapped.empty() == map.merged.empty())
    throw UsageError("map takes either a robot or --merge with parts");
  if (!line.mapped.empty()) map.description = description_of(line.mapped, here.robots, map.read);
  map.known_robots = here.robots;
  map.source_tree = here.source_tree;
  map.tool = here.tool;
  return run_map(map);
}

int calibrate(CommandLine& line, const Installation& here) {
  CalibrateArguments& calibrate = line.calibrate;
  calibrate.description = description_of(calibrate.robot, here.robots, calibrate.read);
  return run_calibrate(calibrate);
}

int identify(CommandLine& line, const Installation& here) {
  line.identify.description = description_of(line.identified, here.robots, line.identify.read);
  return run_identify(line.identify);
}

int path(CommandLine& line, const Installation& here) {
  PathArguments& path = line.path;
  path.description = description_of(path.robot, here.robots, path.read);
  path.known_robots = here.robots;
  path.source_tree = here.source_tree;
  path.tool = here.tool;
  return run_path(path);
}

int run(CommandLine& line, const Installation& here) {
  if (*line.generate_command) return generate(line, here);
  if (*line.remove_command) return run_remove(line.removed, folder_of(line, here, {}));
  if (*line.show_command) return show(line, here);
  if (*line.counts_command) return counts(line, here);
  if (*line.compare_command) return run_compare(compare_arguments(line, here));
  if (*line.report_command) return report(line, here);
  if (*line.map_command) return map(line, here);
  if (*line.calibrate_command) return calibrate(line, here);
  if (*line.identify_command) return identify(line, here);
  if (*line.path_command) return path(line, here);
  if (*line.import_command)
    return run_import(description_of(line.imported, here.robots, line.import), line.import);
  if (*line.new_command) return run_new(line.letters, line.name, line.wrist == "euler", here.robots);
  if (*line.list_command) return print(names_in(here.robots));
  if (*line.languages_command) return print({language_table()});
  if (*line.manual_command) return print({man_page(line.app)});
  if (*line.completion_command) return print({completion(line.app, line.shell)});
  return run_check(descriptions_of(line.checked, here.robots, line.check), line.check, line.thorough);
}

/// A slip of the keyboard in the command itself.
void check_command(const CommandLine& line, const std::string& word) {
  std::vector<std::string> commands;
  for (const CLI::App* command : line.app.get_subcommands({})) commands.push_back(command->get_name());
  if (word.empty() || word.front() != '-') check_names("there is no command", {word}, commands);
}

/// Likewise in an option, which CLI11 tells only where nothing else is wrong.
void check_options(const CommandLine& line, const std::vector<std::string>& words) {
  std::vector<std::string> known;
  for (const CLI::App* command : line.app.get_subcommands({})) {
    if (command->get_name() != words.front()) continue;
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  if (known.empty()) return;
  std::vector<std::string> given;
  for (const std::string& word : words)
    if (word.starts_with("--") && word != "--") given.push_back(word.substr(0, word.find('=')));
  check_names("'" + words.front() + "' has no option", given, known);
}

int run(int argc, char** argv) {
  CommandLine line;
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (argc > 1) {
      check_command(line, argv[1]);
      check_options(line, {argv + 1, argv + argc});
    }
    const int code = line.app.exit(error);
    return code == 0 ? success : usage_error;
  }
  return run(line, find_installation());
}

}  // namespace

int main(int argc, char** argv) {
  int code = failure;
  try {
    code = run(argc, argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "qvgen: {}\n", error.what());
    return usage_error;
  } catch (const qvgen::verify::CertificateError& error) {
    fmt::print(stderr, "qvgen: {}\n", qvgen::pipeline::defect_text(error.what()));
    return internal_error;
  } catch (const std::exception& error) {
    fmt::print(stderr, "qvgen: {}\n", error.what());
    return failure;
  }
  // A full disk or a closed pipe may tell only here.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "qvgen: cannot write the output\n");
    return failure;
  }
  return code;
}
