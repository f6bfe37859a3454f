// SPDX-License-Identifier: MIT
#include <map>
#include <numbers>

#include "cli/calibrate_command.h"
#include "cli/examples.h"
#include "cli/reading_options.h"

namespace qvgen::cli {
namespace {

using calibrate::Errors;

void add_units(CLI::App& command, calibrate::DataOptions& options) {
  const std::map<std::string, double> lengths{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"in", 0.0254}};
  const std::map<std::string, double> angles{{"rad", 1}, {"deg", std::numbers::pi / 180}};
  command.add_option("--unit", options.length_unit, "of lengths whose column states none; m without")
      ->transform(CLI::CheckedTransformer(lengths).description("{m,cm,mm,in}"));
  command.add_option("--angle-unit", options.angle_unit, "of angles whose column states none; rad without")
      ->transform(CLI::CheckedTransformer(angles).description("{rad,deg}"));
  command
      .add_option("--sigma", options.sigma,
                  "standard deviation of lengths; from a column 'sigma', or from the residuals, without")
      ->type_name("METRES")
      ->check(CLI::PositiveNumber.description(""));
  command.add_option("--sigma-angle", options.sigma_angle, "standard deviation of angles, likewise")
      ->type_name("RADIANS")
      ->check(CLI::PositiveNumber.description(""));
  command.add_option("--ignore", options.ignored, "columns to leave out")
      ->type_name("COLUMNS")
      ->allow_extra_args(false)
      ->delimiter(',');
}

void add_planning(CLI::App& command, CalibrateArguments& arguments) {
  command
      .add_option("--plan", arguments.plan,
                  "print so many postures that tell most, after those of DATA; without DATA for poses")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, 1000).description(""));
  command
      .add_option("--spheres", arguments.spheres,
                  "table of spheres, link x y z radius, that --plan keeps apart; those of a URDF's collision "
                  "geometry without")
      ->type_name("FILE");
  command.add_option("--clearance", arguments.clearance, "distance between these spheres; 0.01 without")
      ->type_name("METRES")
      ->check(CLI::Range(0.0, 10.0).description(""));
}

}  // namespace

CLI::App* add_calibrate(CLI::App& app, CalibrateArguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "calibrate",
      "find the errors of an arm's geometry from measurements, and write the description of this very arm");
  command.add_option("ROBOT", arguments.robot, "name of a known robot, or a description")
      ->type_name("ROBOT")
      ->required();
  command
      .add_option("DATA", arguments.data,
                  "table of joint values q1, q2, ... and what was measured there: x y z, with qw qx qy qz or "
                  "roll pitch yaw or rx ry rz for poses; or distance; or the number of a plane or sphere")
      ->type_name("FILE");
  add_planning(command, arguments);
  command.add_option("-o,--output", arguments.output, "description to write; only the report without")
      ->type_name("FILE");
  command.add_option("--page", arguments.page, "the report as a page of HTML with plots, to write")
      ->type_name("FILE");
  const std::map<std::string, CalibratedFormat> formats{{"toml", CalibratedFormat::toml},
                                                        {"urdf", CalibratedFormat::urdf},
                                                        {"dh", CalibratedFormat::dh},
                                                        {"hayati", CalibratedFormat::hayati}};
  command
      .add_option(
          "--format", arguments.format,
          "of the output: a description; the input's URDF with other origins; or a table of Denavit and "
          "Hartenberg with the differences, with a fifth number for parallel axes by 'hayati'; toml without")
      ->transform(CLI::CheckedTransformer(formats).description("{toml,urdf,dh,hayati}"));
  const std::map<std::string, Errors> errors{
      {"zeros", Errors::zeros}, {"lengths", Errors::lengths}, {"all", Errors::all}};
  command.add_option("--errors", arguments.errors, "zeros of joints, these and lengths, or all; all without")
      ->transform(CLI::CheckedTransformer(errors).description("{zeros,lengths,all}"));
  command.add_flag("--gears", arguments.gears,
                   "also the eccentricity of each joint's gear, its first harmonic");
  command.add_flag(
      "--bending", arguments.bending,
      "also how far each joint bends under the weight of the links, whose masses the description has");
  command
      .add_option(
          "--known", arguments.known,
          "frames that are not fitted: tracker, if it measures in the description's world; target, if "
          "it is the tool's frame")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->check(CLI::IsMember({"tracker", "target"}));
  command.add_flag("--camera", arguments.options.camera,
                   "poses are those of a board that stands still, seen by a camera on the tool");
  add_units(command, arguments.options);
  add_reading(command, arguments.read);
  command.footer(std::string("\nexamples:") + calibrate_examples);
  return &command;
}

}  // namespace qvgen::cli
