// SPDX-License-Identifier: MIT
// Paths that leave coordinates free: a turn about a tool axis, tolerances, a rail, a joint of seven, or the
// arm angle. The best motion comes from a program that is compiled for the arm (qvgen/path/free_program.h).
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "path/arm_program.h"
#include "path/result.h"

namespace qvgen::path {

/// A freedom by its name: tool_x to tool_z (turns about the tool's axes), shift_x to shift_z (ways along
/// them), base_x to base_z (ways along the base's axes), rail_x to rail_z (ways of the base), cone_x to
/// cone_z (the tool's axis tilts), arm_angle, or a joint.
struct FreeItem {
  std::string name;
  std::optional<std::pair<double, double>> range;  ///< rad or m; of a cone up to its half angle; all without

  [[nodiscard]] bool is(const char* what) const;  ///< "tool": tool_x, tool_y or tool_z
  [[nodiscard]] bool is_seventh() const;          ///< the arm angle, or a joint
};

/// One coordinate as results have it.
struct FreeColumn {
  std::string name;
  bool turns = true;  ///< an angle
};

/// Freedoms of a path, and wishes for the motion.
struct FreeTask {
  std::vector<FreeItem> free;
  std::vector<MovingJoint> joints;   ///< all of the arm
  int values = 72;                   ///< of a free coordinate that is alone, at each pose
  std::string between = "straight";  ///< as in Task
  std::vector<double> preferred;     ///< joints to be near to; empty for none
  std::filesystem::path motion;      ///< CSV to write; empty for none

  [[nodiscard]] std::string names() const;
  [[nodiscard]] std::string seventh() const;  ///< what of seven joints is free; empty for nothing
  [[nodiscard]] const MovingJoint* joint(const std::string& name) const;  ///< null if there is none
  /// A cone has two.
  [[nodiscard]] std::vector<FreeColumn> columns() const;
};

/// The motion that was found.
struct FreeMotion {
  std::size_t samples = 0;
  double seconds = 0;
  double followed = -1;  ///< path coordinate up to which it is continuous; -1: nothing reaches the first pose
  double cost = std::numeric_limits<double>::infinity();  ///< if there is one
  struct Place {
    std::vector<double> values;  ///< of the columns
    std::vector<double> q;
  };
  std::vector<Place> places{};  ///< at the poses
};

programs::Program free_program(const model::Robot& robot, const FreeTask& task, const std::string& key,
                               const toolchain::Runtime& runtime, const programs::Progress& progress);

/// Runs the program; throws std::runtime_error if it fails.
FreeMotion follow_free(const programs::Program& program, const FreeTask& task, const Poses& poses);

/// Returns the motion with the names of what moves.
nlohmann::ordered_json json_of(const FreeMotion& motion, const FreeTask& task, const std::string& robot);

/// A free motion as pictures take motions: each free coordinate that is no joint is one more joint.
struct Shown {
  Result result;
  Task panels;
};
Shown shown_of(const FreeMotion& motion, const FreeTask& task);

/// Draws each joint against the path, as SVG, and each free coordinate that is no joint.
std::string picture_of(const FreeMotion& motion, const FreeTask& task, const std::string& title);

}  // namespace qvgen::path
