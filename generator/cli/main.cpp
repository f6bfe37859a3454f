// SPDX-License-Identifier: MIT
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.h"

namespace {

namespace fs = std::filesystem;
using namespace qvgen::cli;

constexpr const char* examples = R"(
examples:
  qvgen generate                              all robots of the source tree, into its generated/
  qvgen generate my_arm.toml --output out     one robot, into out/
  qvgen generate arm.urdf --tip tool0         an arm of a URDF (or MJCF), from its root to the link tool0
  qvgen import arm.urdf > arm.toml            the same as a description to read and edit
  qvgen new RRP --wrist euler > my_arm.toml   a description to begin with
  qvgen check my_arm.toml                     every mistake of a description, nothing written
  qvgen show ns                               the closed form of the forward kinematics
  qvgen show my_arm.toml --latex              the same typeset
  qvgen show puma560 --singularities          where the arm is singular, factor by factor
  qvgen counts --format markdown              operation counts of everything generated

exit codes: 0 success, 1 failure, 2 wrong arguments, 3 mistakes in a description
)";

/// A robot by name or by file.
fs::path description_of(const std::string& robot, const fs::path& robots) {
  const fs::path named = robots / (robot + ".toml");
  return fs::exists(robot) || !fs::exists(named) ? fs::path(robot) : named;
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

}  // namespace

int main(int argc, char** argv) {
  const fs::path source = QVGEN_SOURCE_DIR;
  CLI::App app{"qvgen: symbolic code generator for robot manipulators", "qvgen"};
  app.footer(examples);
  app.set_version_flag("--version", "qvgen " QVGEN_VERSION);
  app.require_subcommand(1);

  GenerateArguments generate;
  std::vector<std::string> generate_files;
  std::string output = (source / "generated").string();
  auto* generate_command = app.add_subcommand("generate", "derive, certify and emit C++ for robots");
  generate_command->add_option("FILES", generate_files,
                               "robot descriptions or names of known robots; all known ones without");
  generate_command->add_option("-o,--output", output, "folder to write to")->capture_default_str();
  generate_command
      ->add_option("--only", generate.parts, "parts to generate: kinematics, jacobian, ...; all without")
      ->allow_extra_args(false)
      ->delimiter(',');
  generate_command->add_option("--require", generate.required,
                               "a product (inverse) that every robot must get, else an error");
  generate_command->add_flag("--strict", generate.read.strict, "warnings about a description are errors");
  add_reading(*generate_command, generate.read);

  std::string shown;
  ShowArguments show;
  auto* show_command = app.add_subcommand("show", "print the derived closed form of a robot");
  show_command->add_option("ROBOT", shown, "name of a known robot, or a description")->required();
  show_command->add_flag("--dynamics", show.dynamics, "the joint forces of up to three joints, written out");
  show_command->add_flag("--latex", show.latex, "as LaTeX");
  show_command->add_flag("--singularities", show.singularities,
                         "the factored determinant of the Jacobian instead");
  show_command->add_flag("--inverse", show.inverse, "the derivation of inverse kinematics");
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
  counts_command->add_option("-o,--output", output, "folder that was generated")->capture_default_str();

  std::vector<std::string> checked;
  qvgen::description::ReadOptions check;
  auto* check_command = app.add_subcommand("check", "report the mistakes of descriptions, write nothing");
  check_command->add_option("FILES", checked, "robot descriptions")->required();
  check_command->add_flag("--strict", check.strict, "warnings are errors");
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

  const fs::path robots = source / "generator" / "robots";
  try {
    if (*generate_command) {
      generate.output = output;
      for (const std::string& file : generate_files)
        generate.descriptions.push_back(description_of(file, robots));
      if (generate_files.empty()) generate.descriptions = descriptions_in(robots);
      return run_generate(generate);
    }
    if (*show_command) {
      show.description = description_of(shown, robots);
      return run_show(show);
    }
    if (*counts_command) return run_counts(fs::path(output) / "operation_counts.json", format, forms);
    if (*import_command) return run_import(imported, import);
    if (*new_command) return run_new(letters, name, wrist == "euler", robots);
    return run_check({checked.begin(), checked.end()}, check);
  } catch (const std::exception& error) {
    fmt::print(stderr, "qvgen: {}\n", error.what());
    return failure;
  }
}
