// SPDX-License-Identifier: MIT
#include "cli/reading_options.h"

namespace qvgen::cli {

void add_reading(CLI::App& command, description::ReadOptions& options) {
  command.add_option("--base", options.base, "URDF, MJCF: link where the chain begins; the root without")
      ->type_name("LINK");
  command
      .add_option("--tip", options.tip,
                  "URDF, MJCF: link where it ends; the only one that can be meant without")
      ->type_name("LINK");
  command
      .add_option("--fixed", options.fixed, "URDF, MJCF: joints that are held at zero, as if they were fixed")
      ->type_name("JOINTS")
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_option("--name", options.name, "the robot's name instead of the file's")->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--snap",
          [&options](const std::string& text) {
            const auto snap = description::parse_snap(text);
            if (snap)
              options.snap = *snap;
            else
              throw CLI::ValidationError(
                  "--snap", "'" + text + "' is neither a tolerance such as 1e-4, nor off, nor auto");
          },
          "URDF, MJCF: read numbers that near to an exact one as that one; off: none; auto: those rounded to "
          "it")
      ->type_name("TOLERANCE");
  command
      .add_option("--xacro-arg", options.xacro_arguments,
                  "URDF with macros: an argument for xacro, NAME:=VALUE; may be repeated")
      ->type_name("ARGUMENT")
      ->allow_extra_args(false)
      ->check(CLI::Validator(
          [](const std::string& text) {
            const std::size_t mark = text.find(":=");
            return mark == std::string::npos || mark == 0 ? "'" + text + "' is not NAME:=VALUE"
                                                          : std::string();
          },
          "", "argument"));
  command
      .add_option("--package-path", options.package_folders,
                  "URDF with macros: folder in which ROS packages are, for $(find NAME); may be repeated; "
                  "ROS_PACKAGE_PATH and the folders around the file are searched as well")
      ->type_name("FOLDER")
      ->allow_extra_args(false);
}

void add_tips(CLI::App& command, description::ReadOptions& options) {
  command
      .add_option(
          "--tips", options.tips,
          "URDF, MJCF: the whole robot in place of one chain, its limbs to these links; all: to every end")
      ->type_name("LINKS")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->excludes("--tip");
  command
      .add_flag(
          "--floating", options.floating,
          "URDF, MJCF: the whole robot, whose base moves freely: the body with a free joint, else --base, "
          "else the root")
      ->excludes("--tip");
  command
      .add_option("--actuated", options.actuated,
                  "MJCF with loops: the joints with motors, in place of those that its actuators drive")
      ->type_name("JOINTS")
      ->allow_extra_args(false)
      ->delimiter(',');
}

}  // namespace qvgen::cli
