// SPDX-License-Identifier: MIT
#include <cstdio>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/installation.h"
#include "description/names.h"
#include "pipeline/pipeline.h"

namespace {

namespace fs = std::filesystem;
using namespace qvgen::cli;
using namespace qvgen::pipeline;

constexpr const char* examples = R"(
examples:
  qvgen generate my_arm.toml --output out     one robot, into out/; without --output into ./generated
  qvgen generate                              all robots that qvgen knows
  qvgen generate arm.urdf --tip tool0         an arm of a URDF (or MJCF), from its root to the link tool0
  qvgen generate ur5 --language c -o out      out/c/qvgen_ur5.h and .c: C99 that needs nothing but libm
  qvgen import arm.urdf > arm.toml            the same as a description to read and edit
  qvgen new RRP --wrist euler > my_arm.toml   a description to begin with
  qvgen check my_arm.toml                     every mistake of a description, nothing written
  qvgen show ns                               the closed form of the forward kinematics
  qvgen show my_arm.toml --latex              the same typeset
  qvgen show puma560 --singularities          where the arm is singular, factor by factor
  qvgen counts --format markdown              operation counts of everything generated

exit codes: 0 success, 1 failure, 2 wrong arguments, 3 mistakes in a description
)";

/// Wrong arguments that CLI11 cannot see.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string with_suggestion(const std::string& message, const std::string& name,
                            const std::vector<std::string>& known) {
  const std::string near = qvgen::description::nearest(name, known);
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  return message + (near.empty() ? "; there are " + list : "; did you mean '" + near + "'?");
}

std::vector<std::string> names_in(const fs::path& robots) {
  std::vector<std::string> names;
  for (const fs::path& path : descriptions_in(robots)) names.push_back(path.stem().string());
  return names;
}

/// A robot by name or by file. What looks like a file is one, and whoever reads it says if it is not there.
fs::path description_of(const std::string& robot, const fs::path& robots) {
  const fs::path named = robots / (robot + ".toml");
  const bool is_path = robot.find('/') != std::string::npos || fs::path(robot).has_extension();
  if (fs::exists(robot) || is_path) return robot;
  if (!fs::exists(named))
    throw UsageError(
        with_suggestion("there is no file and no known robot '" + robot + "'", robot, names_in(robots)));
  return named;
}

std::vector<fs::path> descriptions_of(const std::vector<std::string>& names, const fs::path& robots) {
  std::vector<fs::path> paths;
  for (const std::string& name : names) paths.push_back(description_of(name, robots));
  return paths;
}

void check_parts(const std::string& option, const std::vector<std::string>& parts,
                 const std::vector<std::string>& known) {
  for (const std::string& part : parts)
    if (std::find(known.begin(), known.end(), part) == known.end())
      throw UsageError(with_suggestion(option + ": there is no part '" + part + "'", part, known));
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path from = fs::weakly_canonical(path).lexically_relative(fs::weakly_canonical(folder));
  return !from.empty() && *from.begin() != "..";
}

/// ./generated; for the robots of the source tree, called from inside it, the tree's own.
fs::path default_output(const Installation& here, const std::vector<std::string>& files) {
  const fs::path current = fs::current_path();
  if (!here.source_tree || !is_inside(current, *here.source_tree)) return "generated";
  const bool own =
      std::none_of(files.begin(), files.end(), [](const auto& file) { return fs::exists(file); });
  if (own) return *here.source_tree / "generated";
  if (fs::weakly_canonical(current / "generated") != fs::weakly_canonical(*here.source_tree / "generated"))
    return "generated";
  throw UsageError("./generated is that of qvgen's own robots here; say where to with --output");
}

/// Options of every command that reads a description.
void add_reading(CLI::App& command, qvgen::description::ReadOptions& options) {
  command.add_option("--base", options.base, "URDF, MJCF: link where the chain begins; the root without");
  command.add_option("--tip", options.tip,
                     "URDF, MJCF: link where it ends; the only one that can be meant without");
  command.add_option("--name", options.name, "the robot's name instead of the file's");
  command.add_option_function<std::string>(
      "--snap",
      [&options](const std::string& text) {
        const auto snap = qvgen::description::parse_snap(text);
        if (snap)
          options.snap = *snap;
        else
          throw CLI::ValidationError("--snap",
                                     "'" + text + "' is neither a tolerance such as 1e-4, nor off, nor auto");
      },
      "URDF, MJCF: read numbers that near to an exact one as that one; off: none; auto: those rounded to it");
}

int run(int argc, char** argv) {
  CLI::App app{"qvgen: symbolic code generator for robot manipulators", "qvgen"};
  app.footer(examples);
  app.set_version_flag("--version", "qvgen " QVGEN_VERSION);
  app.require_subcommand(1);

  GenerateArguments generate;
  std::vector<std::string> generate_files;
  std::string output;
  const auto is_named = [](const std::string& folder) {
    return folder.empty() ? std::string("the folder has no name") : std::string();
  };
  const auto add_output = [&](CLI::App* command, const std::string& text) {
    command->add_option("-o,--output", output, text + "; ./generated without")->check(is_named);
  };
  auto* generate_command = app.add_subcommand("generate", "derive, certify and emit C++ for robots");
  generate_command->add_option("FILES", generate_files,
                               "robot descriptions or names of known robots; all known ones without");
  add_output(generate_command,
             "folder to write to: files of it that qvgen has not written are never touched");
  generate_command
      ->add_option("--only", generate.parts, "parts to generate: kinematics,jacobian,...; all without")
      ->allow_extra_args(false)
      ->delimiter(',');
  generate_command
      ->add_option("--require", generate.required,
                   "parts (inverse,dynamics,...) that every robot must get, else an error")
      ->allow_extra_args(false)
      ->delimiter(',');
  std::string language = "cxx";
  generate_command
      ->add_option("--language", language,
                   "cxx, or c: C99 into the output's folder c, without inverse kinematics")
      ->check(CLI::IsMember({"cxx", "c"}));
  generate_command->add_flag("--strict", generate.read.strict, "warnings about a description are errors");
  add_reading(*generate_command, generate.read);
  generate_command->add_flag("--force", generate.force, "also robots that have not changed");
  generate_command->add_option("--seconds", generate.budget.seconds, "processor time that a part may take")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  generate_command->add_option("--megabytes", generate.budget.megabytes, "memory that a part may take")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();

  generate_command->add_option("--list-outputs", generate.build.outputs,
                               "write the paths of all files there");
  generate_command->add_option("--depfile", generate.build.depfile,
                               "write there, for make and ninja, what TARGET of TARGET.d is made from");
  generate_command->add_option(
      "--sources", generate.build.sources,
      "folder for sources of a single robot that are always the same: robot.c, or one of each part");
  generate_command->add_flag("--quiet", generate.build.quiet, "no table of operation counts");

  std::vector<std::string> removed;
  auto* remove_command =
      app.add_subcommand("remove", "remove robots from a generated folder, and no other file");
  remove_command->add_option("ROBOTS", removed, "names of robots")->required();
  add_output(remove_command, "folder that was generated");

  std::string shown;
  ShowArguments show;
  auto* show_command = app.add_subcommand("show", "print the derived closed form of a robot");
  show_command->add_option("ROBOT", shown, "name of a known robot, or a description")->required();
  show_command->add_flag("--dynamics", show.dynamics, "the joint forces of up to three joints, written out");
  show_command->add_flag("--latex", show.latex, "as LaTeX");
  show_command->add_flag("--singularities", show.singularities,
                         "the factored determinant of the Jacobian instead");
  show_command->add_flag("--inverse", show.inverse, "the derivation of inverse kinematics");
  bool functions = false;
  show_command->add_flag("--functions", functions,
                         "the functions that were generated, and why any is missing");
  add_output(show_command, "for --functions: folder that was generated");
  add_reading(*show_command, show.read);

  ReportFormat format = ReportFormat::table;
  const std::map<std::string, ReportFormat> formats{{"table", ReportFormat::table},
                                                    {"csv", ReportFormat::csv},
                                                    {"json", ReportFormat::json},
                                                    {"markdown", ReportFormat::markdown}};
  auto* counts_command =
      app.add_subcommand("counts", "print the operation counts of the generated functions");
  counts_command->add_option("--format", format, "table, csv, json or markdown")
      ->transform(CLI::CheckedTransformer(formats).description(""));
  bool forms = false;
  counts_command->add_flag("--forms", forms, "also the forms that competed for each function");
  add_output(counts_command, "folder that was generated");

  std::vector<std::string> checked;
  qvgen::description::ReadOptions check;
  auto* check_command = app.add_subcommand("check", "report the mistakes of descriptions, write nothing");
  check_command->add_option("FILES", checked, "robot descriptions or names of known robots")->required();
  check_command->add_flag("--strict", check.strict, "warnings are errors");
  bool thorough = false;
  check_command->add_flag("--thorough", thorough, "derive and certify everything as generate does");
  add_reading(*check_command, check);

  std::string imported;
  qvgen::description::ReadOptions import;
  auto* import_command = app.add_subcommand("import", "print the description that a URDF or MJCF is read as");
  import_command->add_option("FILE", imported, "URDF or MJCF")->required();
  add_reading(*import_command, import);

  std::string letters, wrist = "none", name = "my_arm";
  auto* new_command = app.add_subcommand("new", "print a commented description to edit");
  new_command->add_option("CODE", letters, "a known robot, or its joints by their letters: RRP")->required();
  new_command->add_option("--wrist", wrist, "euler: three more revolute joints whose axes meet")
      ->check(CLI::IsMember({"euler", "none"}))
      ->capture_default_str();
  new_command->add_option("--name", name, "the robot's name")->capture_default_str();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? success : usage_error;
  }

  const Installation here = find_installation();
  const auto folder = [&](const std::vector<std::string>& files) {
    return output.empty() ? default_output(here, files) : fs::path(output);
  };
  if (*generate_command) {
    check_parts("--only", generate.parts, product_names());
    check_parts("--require", generate.required, part_names());
    for (const std::string& part : generate.required)
      if (!generate.parts.empty())
        check_parts("--only without what is required", {product_of(part)}, generate.parts);
    if (language == "c") generate.language = Language::c;
    generate.known_robots = here.robots;
    generate.output = folder(generate_files);
    generate.tool = here.tool;
    generate.all_known = generate_files.empty();
    generate.descriptions =
        generate_files.empty() ? descriptions_in(here.robots) : descriptions_of(generate_files, here.robots);
    return run_generate(generate);
  }
  if (*remove_command) return run_remove(removed, folder({}));
  if (*show_command && functions) return run_show_functions(fs::path(shown).stem().string(), folder({}));
  if (*show_command) {
    show.description = description_of(shown, here.robots);
    return run_show(show);
  }
  if (*counts_command) return run_counts(folder({}), format, forms);
  if (*import_command) return run_import(imported, import);
  if (*new_command) return run_new(letters, name, wrist == "euler", here.robots);
  return run_check(descriptions_of(checked, here.robots), check, thorough);
}

}  // namespace

int main(int argc, char** argv) {
  int code = failure;
  try {
    code = run(argc, argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "qvgen: {}\n", error.what());
    return usage_error;
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
