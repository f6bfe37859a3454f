// SPDX-License-Identifier: MIT
// Paths that leave one coordinate free: a turn about a tool axis, a joint of seven, or the arm angle. The
// best motion comes from a program that is compiled for the arm (qvgen/path/free_program.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "path/arm_program.h"
#include "path/result.h"

namespace qvgen::path {

/// The coordinate that is free, and wishes for the motion.
struct FreeTask {
  std::string free;                 ///< tool_x, tool_y, tool_z, rail_x, rail_y, rail_z, arm_angle, or a joint
  std::vector<MovingJoint> joints;  ///< all of the arm
  int values = 72;                  ///< of the free coordinate at each pose
  std::string between = "straight";                ///< as in Task
  std::optional<std::pair<double, double>> range;  ///< of what is free, rad or m, in place of all
  std::vector<double> preferred;                   ///< joints to be near to; empty for none
  std::filesystem::path motion;                    ///< CSV to write; empty for none

  [[nodiscard]] bool turns_tool() const;
  [[nodiscard]] bool is_rail() const;
  [[nodiscard]] bool turns() const;                ///< what is free is an angle
  [[nodiscard]] const MovingJoint* joint() const;  ///< the free one; null if none is
};

/// The motion that was found.
struct FreeMotion {
  std::size_t samples = 0;
  double seconds = 0;
  double followed = -1;  ///< path coordinate up to which it is continuous; -1: nothing reaches the first pose
  struct Place {
    double value;
    std::vector<double> q;
  };
  std::vector<Place> places;  ///< at the poses
};

programs::Program free_program(const model::Robot& robot, const FreeTask& task, const std::string& key,
                               const toolchain::Runtime& runtime, const programs::Progress& progress);

/// Runs the program; throws std::runtime_error if it fails.
FreeMotion follow_free(const programs::Program& program, const FreeTask& task, const Poses& poses);

/// Returns the motion with the names of what moves.
nlohmann::ordered_json json_of(const FreeMotion& motion, const FreeTask& task, const std::string& robot);

/// A free motion as pictures take motions: what is free is one more joint, if it is none.
struct Shown {
  Result result;
  Task panels;
};
Shown shown_of(const FreeMotion& motion, const FreeTask& task);

/// Draws each joint against the path, as SVG, and what is free if it is no joint.
std::string picture_of(const FreeMotion& motion, const FreeTask& task, const std::string& title);

}  // namespace qvgen::path
