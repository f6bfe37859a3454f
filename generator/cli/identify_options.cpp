// SPDX-License-Identifier: MIT
#include "cli/identify_options.h"

#include <cmath>
#include <map>

#include "cli/examples.h"
#include "cli/reading_options.h"

namespace qvgen::cli {
namespace {

void add_data(CLI::App& command, IdentifyArguments& arguments) {
  command
      .add_option("LOGS", arguments.logs,
                  "tables with a header: time [s], q1 [deg], ..., torque1 [Nm], ...; also qd1, qdd1, ... if "
                  "they were "
                  "measured")
      ->type_name("FILE");
  command
      .add_option(
          "--payload", arguments.payload,
          "logs of the same arm with a payload, whose mass, centre and inertia are told; LOGS are without it")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--plan", arguments.plan,
          "no log: write a motion of so many seconds that tells much, within limits of position, speed and "
          "torque, as a table")
      ->type_name("SECONDS")
      ->check(CLI::Range(1.0, 3600.0).description(""))
      ->excludes("LOGS");
  command
      .add_option("--hold-out", arguments.hold_out,
                  "logs that are predicted and not fitted: their residual is that of motions to come")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--torque-constants", arguments.torque_constants,
          "the logs have currents, current1 [A], ...: Nm (N) at each joint for an ampere, gear included")
      ->type_name("NUMBERS")
      ->allow_extra_args(false)
      ->delimiter(',');
  command
      .add_option("--window", arguments.window,
                  "samples, an odd number, that a rate and an acceleration are derived from; without, the "
                  "number that "
                  "lets torques be predicted best")
      ->type_name("SAMPLES")
      ->check(CLI::Range(5, 2001).description(""));
  command
      .add_option(
          "--standstill", arguments.standstill,
          "rad/s or m/s: slower samples of a joint are left out, since friction at rest may be anything; "
          "without, a hundredth of its greatest rate")
      ->type_name("RATE")
      ->check(CLI::NonNegativeNumber.description(""));
}

void add_model(CLI::App& command, IdentifyArguments& arguments) {
  command
      .add_option("--drives", arguments.drives,
                  "what the drives have: some of rotor_inertia, viscous_friction, coulomb_friction, offset; "
                  "none; all "
                  "without")
      ->type_name("NAMES")
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_flag("--stribeck", arguments.stribeck,
                   "also friction that is other at low rates: fs sign(rate) exp(-(rate/v)^2) of each joint");
  command.add_flag(
      "--temperature", arguments.temperature,
      "also friction that changes with the column 'temperature' [degC], or temperature1, ... of each joint");
  command.add_option("--gravity", arguments.gravity, "m/s^2 along the world's -z; 9.80665 without")
      ->type_name("NUMBER")
      ->check(CLI::NonNegativeNumber.description(""));
  command.add_option("--mass", arguments.mass, "kg, of all moving links together, which motions do not tell")
      ->type_name("KG")
      ->check(CLI::PositiveNumber.description(""));
}

}  // namespace

CLI::App* add_identify(CLI::App& app, std::string& robot, IdentifyArguments& arguments) {
  CLI::App& command = *app.add_subcommand("identify",
                                          "inertias, rotor inertias and friction of an arm from logs of its "
                                          "motion and torques, with their deviations; "
                                          "and the description with these numbers");
  command.add_option("ROBOT", robot, "name of a known robot, or a description")
      ->type_name("ROBOT")
      ->required();
  add_data(command, arguments);
  command
      .add_option("-o,--output", arguments.output,
                  "description to write, or with --plan the table; none without")
      ->type_name("FILE");
  command.add_option("--page", arguments.page, "the report as a page of HTML with plots, to write")
      ->type_name("FILE");
  const std::map<std::string, bool> formats{{"toml", false}, {"urdf", true}};
  command
      .add_option(
          "--format", arguments.urdf,
          "of the output: a description, or the input's URDF with other inertias and friction; toml without")
      ->transform(CLI::CheckedTransformer(formats).description("{toml,urdf}"));
  command
      .add_option(
          "--table", arguments.table,
          "comma-separated values to write: each parameter with its value, deviation, and what it is made of")
      ->type_name("FILE");
  add_model(command, arguments);
  add_reading(command, arguments.read);
  command.footer(std::string("\nexamples:") + identify_examples);
  return &command;
}

}  // namespace qvgen::cli
