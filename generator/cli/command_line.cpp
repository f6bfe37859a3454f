// SPDX-License-Identifier: MIT
#include "cli/command_line.h"

#include <cmath>
#include <cstdlib>
#include <map>

#include "cli/examples.h"
#include "cli/identify_options.h"
#include "cli/reading_options.h"

namespace qvgen::cli {

namespace {

void add_output(CommandLine& line, CLI::App& command, const std::string& text) {
  const auto is_named = [](const std::string& folder) {
    return folder.empty() ? std::string("the folder has no name") : std::string();
  };
  command.add_option("-o,--output", line.output, text + "; ./generated without")
      ->type_name("FOLDER")
      ->check(CLI::Validator(is_named, "", "named"));
}

/// Adds which parts are generated, and in which language.
void add_parts(CommandLine& line, CLI::App& command) {
  command
      .add_option(
          "--only", line.generate.parts,
          "parts to generate: model, kinematics, inverse, arm_angle, jacobian, from_ideal, dynamics; "
          "all of these without, and assembly of mechanisms with loops. Headers of dynamics that a "
          "description leaves out have names too: "
          "dynamics_derivatives, dynamics_loads, regressor. Others are made if they are named: batch, forms "
          "of the other parts "
          "named for many at once; frames, poses and Jacobians of links and named frames; mass, the "
          "centre of mass; regressor_with_drives, for identification; geometry_jacobian, for calibration; "
          "nearest_pose, the nearest pose in "
          "reach; given_joint, seven joints within limits; certified, solutions with a proof; c_inverse, a "
          "C header for inverse kinematics by elimination; c_assembly, one for closed loops; moveit_plugin, "
          "a ROS 2 package; linuxcnc, a kinematics component")
      ->type_name("PARTS")
      ->allow_extra_args(false)
      ->delimiter(',');
  command
      .add_option("--require", line.generate.required,
                  "parts (inverse,dynamics,...) that every robot must get, else an error")
      ->type_name("PARTS")
      ->allow_extra_args(false)
      ->delimiter(',');
  command
      .add_option(
          "--language", line.languages,
          "cxx; c, rust, javascript, octave, opencl or cuda: files in a folder of that name in the output; "
          "several, separated by commas, are derived once")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->check(CLI::IsMember({"cxx", "c", "rust", "javascript", "octave", "opencl", "cuda"}));
  command.add_option("--scalar", line.scalar, "what C and kernels of devices compute in: double or float")
      ->check(CLI::IsMember({"double", "float"}));
}

/// Adds what builds ask for that run the tool.
void add_build(BuildFiles& build, CLI::App& command) {
  command.add_option("--list-outputs", build.outputs, "write the paths of all files there")
      ->type_name("FILE");
  command
      .add_option("--depfile", build.depfile,
                  "write there, for make and ninja, what TARGET of TARGET.d is made from")
      ->type_name("FILE");
  command
      .add_option(
          "--sources", build.sources,
          "folder for sources of a single robot that are always the same: robot.c, or one of each part")
      ->type_name("FOLDER");
  command.add_flag("--quiet", build.quiet, "no table of operation counts");
}

void add_generate(CommandLine& line) {
  GenerateArguments& generate = line.generate;
  CLI::App& command = *line.app.add_subcommand("generate", "derive, certify and emit C++ for robots");
  line.generate_command = &command;
  command
      .add_option("FILES", line.generate_files,
                  "robot descriptions or names of known robots; all known ones without")
      ->type_name("ROBOT");
  add_output(line, command, "folder to write to: files of it that qvgen has not written are never touched");
  add_parts(line, command);
  command.add_flag("--strict", generate.read.strict, "warnings about a description are errors");
  add_reading(command, generate.read);
  add_tips(command, generate.read);
  command.add_flag("--force", generate.force, "also robots that have not changed");
  command.add_option("--seconds", generate.budget.seconds, "processor time that a part may take")
      ->type_name("SECONDS")
      ->check(CLI::Range(1, 1000000).description(""))
      ->capture_default_str();
  command.add_option("--megabytes", generate.budget.megabytes, "memory that a part may take")
      ->type_name("MEGABYTES")
      ->check(CLI::Range(1, 100000000).description(""))
      ->capture_default_str();
  add_build(generate.build, command);
}

void add_remove(CommandLine& line) {
  line.remove_command =
      line.app.add_subcommand("remove", "remove robots from a generated folder, and no other file");
  line.remove_command->add_option("ROBOTS", line.removed, "names of robots")->type_name("ROBOT")->required();
  add_output(line, *line.remove_command, "folder that was generated");
}

void add_show(CommandLine& line) {
  CLI::App& command = *line.app.add_subcommand("show", "print the derived closed form of a robot");
  line.show_command = &command;
  command.add_option("ROBOT", line.shown, "name of a known robot, or a description")
      ->type_name("ROBOT")
      ->required();
  command.add_flag("--dynamics", line.show.dynamics, "the joint forces of up to three joints, written out");
  command.add_flag("--transform", line.show.transform,
                   "the homogeneous matrices, link by link, and the entries of their product");
  command.add_flag("--jacobian", line.show.jacobian,
                   "the Jacobian by three methods, velocities of the links, determinant, inverse");
  command.add_option("--joints", line.show.joints, "the first ones alone, without what they carry")
      ->type_name("COUNT")
      ->check(CLI::Range(1, 16).description(""));
  command
      .add_option(
          "--masses", line.show.masses,
          "for --dynamics: a mass in the middle or at the end of each link, in place of the described ones")
      ->check(CLI::IsMember({"middle", "end"}));
  command.add_flag("--latex", line.show.latex, "as LaTeX");
  command.add_flag("--exact", line.show.exact, "exact fractions in place of decimals");
  command.add_flag("--singularities", line.show.singularities,
                   "the factored determinant of the Jacobian instead");
  command.add_flag("--inverse", line.show.inverse, "the derivation of inverse kinematics");
  command.add_flag("--class", line.show.structure,
                   "the class of the arm by its first three joints: two letters, workspace");
  command
      .add_option("--dh", line.show.dh,
                  "a description with the table of Denavit and Hartenberg, standard or modified (Craig)")
      ->expected(0, 1)
      ->default_str("standard")
      ->type_name("CONVENTION")
      ->check(CLI::IsMember({"standard", "modified"}));
  command.add_flag("--workspace", line.show.workspace,
                   "the workspace of three joints or of a wrist centre: boundary curves, reach, volume");
  command.add_flag("--functions", line.functions,
                   "the functions that were generated, and why any is missing");
  add_output(line, command, "for --functions: folder that was generated");
  add_reading(command, line.show.read);
  add_tips(command, line.show.read);
}

void add_format(CLI::App& command, ReportFormat& format) {
  const std::map<std::string, ReportFormat> formats{{"table", ReportFormat::table},
                                                    {"csv", ReportFormat::csv},
                                                    {"json", ReportFormat::json},
                                                    {"markdown", ReportFormat::markdown}};
  command.add_option("--format", format, "table, csv, json or markdown")
      ->transform(CLI::CheckedTransformer(formats).description("{csv,json,markdown,table}"));
}

void add_counts(CommandLine& line) {
  CLI::App& command =
      *line.app.add_subcommand("counts", "print the operation counts of the generated functions");
  line.counts_command = &command;
  command.add_option("ROBOTS", line.counts.filter.robots, "names of robots; all without")->type_name("ROBOT");
  command.add_option("--functions", line.counts.filter.functions, "some of them by name; all without")
      ->type_name("NAMES")
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_option("--columns", line.counts.filter.columns, "some of them; all without")
      ->check(CLI::IsMember(counts_columns()))
      ->allow_extra_args(false)
      ->delimiter(',');
  command
      .add_option("--against", line.counts.against,
                  "an earlier operation_counts.json: print what has changed since, and nothing else")
      ->type_name("FILE");
  add_format(command, line.counts.format);
  command.add_flag("--forms", line.counts.forms, "also the forms that competed for each function");
  add_output(line, command, "folder that was generated");
}

void add_compare(CommandLine& line) {
  CLI::App& command = *line.app.add_subcommand("compare",
                                               "compare formulations of a quantity by their operations, each "
                                               "certified: as a textbook has them, with the "
                                               "robot's zeros and ones gone, and after all passes");
  line.compare_command = &command;
  command
      .add_option("ROBOTS", line.compared,
                  "robot descriptions or names of known robots; all known ones without")
      ->type_name("ROBOT");
  command.add_option("--what", line.what, "forward kinematics, the jacobian, or inverse dynamics")
      ->check(CLI::IsMember(compare::what_names()))
      ->capture_default_str();
  command
      .add_option("--formulations", line.compare.request.formulations,
                  "some of them by name: pairs,dh,...; all without")
      ->type_name("NAMES")
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_option("--level", line.levels, "textbook, specialised or optimised; all without")
      ->check(CLI::IsMember(compare::level_names()))
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_flag("--time", line.compare.time, "nanoseconds too: compiles and runs a benchmark");
  command.add_option("--rounds", line.compare.rounds, "for --time: how often each is timed, in turn")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  add_format(command, line.compare.format);
  add_reading(command, line.compare.read);
  add_tips(command, line.compare.read);
  command.footer(std::string("\nexamples:") + compare_examples);
}

void add_report(CommandLine& line) {
  CLI::App& command = *line.app.add_subcommand(
      "report", "write pages for people, HTML that needs no network: one for each robot, and an index");
  line.report_command = &command;
  command
      .add_option("ROBOTS", line.reported,
                  "robot descriptions or names of known robots; all known ones without")
      ->type_name("ROBOT");
  command
      .add_option("-o,--output", line.report.output,
                  "folder to write to: files of it that qvgen has not written are never touched")
      ->type_name("FOLDER")
      ->default_val("report");
  command
      .add_option("--generated", line.report.generated,
                  "folder of the generated code, whose counts and signatures are shown; ./generated without")
      ->type_name("FOLDER");
  command
      .add_option("--times", line.report.times,
                  "nanoseconds to show, with the name of the machine: what compare --time --format json has "
                  "written, one file for each quantity")
      ->type_name("FILE");
  command.add_flag("--force", line.report.force, "also robots that have not changed");
  add_reading(command, line.report.read);
  add_tips(command, line.report.read);
  command.footer(std::string("\nexamples:") + report_examples);
}

/// Numbers of metres.
const CLI::Validator& length() {
  static const CLI::Validator check(
      [](const std::string& text) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        return *end == '\0' && std::isfinite(value) && value > 0
                   ? std::string()
                   : "'" + text + "' is no length: a number of metres above 0";
      },
      "", "length");
  return check;
}

void add_map_work(CommandLine& line, CLI::App& command) {
  MapArguments& map = line.map;
  command.add_option("--resolution", map.resolution, "edge of a cell; a twentieth of the reach without")
      ->type_name("METRES")
      ->check(length());
  command
      .add_option(
          "--orientations", map.orientations,
          "how many at each position, spread evenly; directions or angles if the arm is asked for those")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, 10000000).description(""))
      ->capture_default_str();
  command.add_flag("--limits", map.limits, "count only solutions within the description's joint limits");
  command
      .add_option("--reach", map.reach,
                  "radius of the sphere that is looked at, about a point of the first axis; the arm's reach "
                  "without")
      ->type_name("METRES")
      ->check(length());
  command.add_option("--threads", map.threads, "how many; those of the machine without")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, 1024).description(""));
  command
      .add_option("--blocks", map.blocks,
                  "only these of the 1000 blocks, 0 to 999, that each map is divided into, as a .part")
      ->type_name("FIRST:LAST");
}

void add_map(CommandLine& line) {
  CLI::App& command = *line.app.add_subcommand(
      "map",
      "what an arm reaches: at each position of a grid the share of orientations, the number of "
      "solutions, the best manipulability and distance from joint limits; a run that was stopped goes on "
      "where it was");
  line.map_command = &command;
  command.add_option("ROBOT", line.mapped, "name of a known robot, or a description")->type_name("ROBOT");
  command
      .add_option("-o,--output", line.map.outputs,
                  "file to write, .npz (NumPy), .vtk (ParaView), .svg (slices) or .part; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->required();
  add_map_work(line, command);
  CLI::Option* merge =
      command.add_option("--merge", line.map.merged, "parts of a map, .part, in place of a robot")
          ->type_name("FILE");
  for (const char* other : {"--resolution", "--orientations", "--limits", "--reach", "--threads", "--blocks"})
    merge->excludes(other);
  add_reading(command, line.map.read);
  command.footer(std::string("\nexamples:") + map_examples);
}

void add_check(CommandLine& line) {
  CLI::App& command = *line.app.add_subcommand("check", "report the mistakes of descriptions, write nothing");
  line.check_command = &command;
  command.add_option("FILES", line.checked, "robot descriptions or names of known robots")
      ->type_name("ROBOT")
      ->required();
  command.add_flag("--strict", line.check.strict, "warnings are errors");
  command.add_flag("--thorough", line.thorough, "derive and certify everything as generate does");
  add_reading(command, line.check);
  add_tips(command, line.check);
}

void add_import(CommandLine& line) {
  line.import_command =
      line.app.add_subcommand("import", "print the description that a URDF or MJCF is read as");
  line.import_command->add_option("FILE", line.imported, "URDF or MJCF")->type_name("FILE")->required();
  add_reading(*line.import_command, line.import);
  add_tips(*line.import_command, line.import);
}

void add_new(CommandLine& line) {
  CLI::App& command = *line.app.add_subcommand("new", "print a commented description to edit");
  line.new_command = &command;
  command.add_option("CODE", line.letters, "a known robot, or its joints by their letters: RRP")
      ->type_name("ROBOT")
      ->required();
  command.add_option("--wrist", line.wrist, "euler: three more revolute joints whose axes meet")
      ->check(CLI::IsMember({"euler", "none"}))
      ->capture_default_str();
  command.add_option("--name", line.name, "the robot's name")->type_name("NAME")->capture_default_str();
}

/// Adds the commands about the tool itself.
void add_documents(CommandLine& line) {
  line.list_command = line.app.add_subcommand("list", "print the names of the known robots");
  line.languages_command =
      line.app.add_subcommand("languages", "print which parts each language has, and why not");
  line.manual_command = line.app.add_subcommand("man", "print this help as a man page");
  line.completion_command =
      line.app.add_subcommand("completion", "print a script that completes this command line in a shell");
  line.completion_command->add_option("SHELL", line.shell, "the shell")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->required();
}

}  // namespace

CommandLine::CommandLine() {
  app.footer(std::string("\nexamples:") + examples + "\nexit codes: " + exit_codes + "\n");
  app.set_version_flag("--version", "qvgen " QVGEN_VERSION);
  app.require_subcommand(1);
  add_generate(*this);
  add_remove(*this);
  add_show(*this);
  add_counts(*this);
  add_compare(*this);
  add_report(*this);
  add_map(*this);
  calibrate_command = add_calibrate(app, calibrate);
  identify_command = add_identify(app, identified, identify);
  path_command = add_path(app, path);
  add_check(*this);
  add_import(*this);
  add_new(*this);
  add_documents(*this);
}

}  // namespace qvgen::cli
