// SPDX-License-Identifier: MIT
#include "cli/path_options.h"

#include "cli/examples.h"
#include "cli/reading_options.h"

namespace qvgen::cli {
namespace {

/// Checks a number above zero, infinity too.
std::string positive_or_infinite(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return *end == '\0' && value > 0 ? "" : "'" + word + "' is no number above zero";
}

/// Adds the arm, the path, and the files to write.
void add_files(CLI::App& command, PathArguments& arguments) {
  command.add_option("ROBOT", arguments.robot, "name of a known robot, or a description")
      ->type_name("ROBOT")
      ->required();
  command
      .add_option("POSES", arguments.poses,
                  "table of poses: columns x y z and qw qx qy qz, or roll pitch yaw, or rx ry rz (rotation "
                  "vector), or ax ay az (direction of the tool's z axis); t, if there are times. A header "
                  "may state units: x [mm], roll [deg]")
      ->type_name("FILE")
      ->required();
  command
      .add_option("-o,--output", arguments.outputs,
                  "file to write: .csv (the motions at the poses), .json (everything), .svg (each joint "
                  "along the path) or .html (a page on which the arm moves along it); may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

/// Adds what joints may do.
void add_joints(CLI::App& command, PathArguments& arguments) {
  command
      .add_option(
          "--limit", arguments.limits,
          "limits of a joint in place of the description's, NAME=LOWER:UPPER, rad or m, or with deg or "
          "mm behind: theta1=-170:170deg; may be repeated")
      ->type_name("LIMIT")
      ->allow_extra_args(false);
  command.add_flag("--without-limits", arguments.without_limits, "as if joints had no limits");
  command
      .add_option("--hold", arguments.held,
                  "seven joints: the one that stays, NAME=VALUE, rad or m, or with deg or mm behind")
      ->type_name("JOINT");
}

/// Adds what the path leaves open, of which the best is looked for.
void add_free(CLI::App& command, PathArguments& arguments) {
  command
      .add_option(
          "--free", arguments.free,
          "what the path leaves open, several with commas: turns about the tool's axes, tool_z or "
          "tool_z=-10:20deg; a tilt of such an axis in a cone, cone_z=15deg; ways along the tool's axes, "
          "shift_x=2mm, or along the base's, base_x=-1:2mm; where the base is on a rail along one of its "
          "axes, "
          "rail_x=0:3; of seven joints one by its name, or arm_angle. The best motion is found, and the "
          "values "
          "that it takes")
      ->type_name("WHAT")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->excludes("--hold");
  command
      .add_option("--range", arguments.range,
                  "for one --free: its lower and upper end, LOWER:UPPER, rad or m, or with deg or mm behind")
      ->type_name("RANGE")
      ->needs("--free");
  command.add_option("--values", arguments.values, "for one --free: how many are tried at each pose")
      ->type_name("NUMBER")
      ->check(CLI::Range(4, 100000).description(""))
      ->capture_default_str();
  command
      .add_option("--prefer", arguments.preferred, "for --free: joints to be near to, rad or m, with commas")
      ->type_name("JOINTS")
      ->allow_extra_args(false)
      ->delimiter(',');
}

/// Adds how the tool goes from pose to pose, and whether that is proven.
void add_course(CLI::App& command, PathArguments& arguments) {
  command.add_flag("--screw", arguments.screw,
                   "screw motions between poses, in place of straight lines with an even turn");
  command.add_flag("--spline", arguments.spline, "a cubic spline through the poses, likewise")
      ->excludes("--screw");
  command
      .add_option("--blend", arguments.blend,
                  "straight lines with rounded corners, which begin so far from the poses, m")
      ->type_name("RADIUS")
      ->check(CLI::PositiveNumber)
      ->excludes("--screw")
      ->excludes("--spline");
  command
      .add_flag(
          "--prove", arguments.prove,
          "prove by interval arithmetic that each motion is continuous, and that no other one follows the "
          "path; stretches that cannot be proven are reported")
      ->excludes("--free");
}

/// Adds what the least time of a motion depends on.
void add_time(CLI::App& command, PathArguments& arguments) {
  command
      .add_option(
          "--time", arguments.accelerations,
          "the least time of each motion, from rest to rest, under these joint accelerations, rad/s^2 "
          "or m/s^2 (inf for no limit), and the joints' speeds: one for all or one for each, with commas")
      ->type_name("ACCELERATIONS")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->check(positive_or_infinite)
      ->excludes("--free");
  const auto add_largest = [&](const char* name, std::vector<double>& numbers, const char* text,
                               const char* type) {
    command.add_option(name, numbers, text)
        ->type_name(type)
        ->allow_extra_args(false)
        ->delimiter(',')
        ->check(CLI::PositiveNumber)
        ->needs("--time");
  };
  add_largest("--joint-speeds", arguments.joint_speeds,
              "for --time: the largest ones in place of the description's, rad/s or m/s, likewise", "SPEEDS");
  add_largest("--joint-jerks", arguments.joint_jerks,
              "for --time: the largest jerks of the joints, rad/s^3 or m/s^3, likewise; the time is near the "
              "least one",
              "JERKS");
  command
      .add_option(
          "--joint-torques", arguments.joint_torques,
          "for --time: the largest torques or forces of the joints, N m or N, likewise, or 'description' for "
          "those that it states; the arm's masses and friction are taken into account")
      ->type_name("TORQUES")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->needs("--time")
      ->excludes("--joint-jerks");
}

/// Adds the tool's speed, and units of the table.
void add_tool_speed(CLI::App& command, PathArguments& arguments) {
  command.add_option("--speed", arguments.speed, "the tool's speed, m/s, where the poses have no times")
      ->type_name("SPEED")
      ->check(CLI::PositiveNumber);
  command.add_option("--length-unit", arguments.length_unit, "of lengths whose header states none")
      ->check(CLI::IsMember({"m", "mm"}))
      ->capture_default_str();
  command.add_option("--angle-unit", arguments.angle_unit, "of angles whose header states none")
      ->check(CLI::IsMember({"rad", "deg"}))
      ->capture_default_str();
}

}  // namespace

CLI::App* add_path(CLI::App& app, PathArguments& arguments) {
  CLI::App& command = *app.add_subcommand("path",
                                          "all continuous motions of the joints that follow a path of the "
                                          "tool: where each begins and ends, and why; "
                                          "or the fewest that follow it one after the other");
  add_files(command, arguments);
  add_joints(command, arguments);
  add_free(command, arguments);
  add_course(command, arguments);
  add_time(command, arguments);
  add_tool_speed(command, arguments);
  add_reading(command, arguments.read);
  command.footer(std::string("\nexamples:") + path_examples);
  return &command;
}

}  // namespace qvgen::cli
