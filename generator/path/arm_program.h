// SPDX-License-Identifier: MIT
// The program that follows paths for one arm (qvgen/path/program.h): compiled once, run with a file of poses.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/robot.h"
#include "path/poses.h"
#include "programs/program.h"

namespace qvgen::path {

/// A joint of seven that stays at a value, rad or m.
struct HeldJoint {
  std::string name;
  double value = 0;
};

/// A joint that moves along the path.
struct MovingJoint {
  std::string name;
  bool revolute = true;
  std::pair<double, double> limits;                        ///< infinite without
  double speed = std::numeric_limits<double>::infinity();  ///< the largest, rad/s or m/s
  double acceleration = 0;  ///< the largest, rad/s^2 or m/s^2, if least times are wanted
  double force = std::numeric_limits<double>::infinity();  ///< the largest, N m or N, likewise
  double jerk = std::numeric_limits<double>::infinity();   ///< the largest, rad/s^3 or m/s^3, likewise
};

/// Joints that follow a path, and the ways between its poses.
struct Task {
  std::optional<HeldJoint> held;
  std::vector<MovingJoint> joints;   ///< six, or the motors that move them
  std::vector<MovingJoint> coupled;  ///< joints that motors move and that have limits of their own
  std::vector<std::string> axes;     ///< names of the six joints that motors move; empty without motors
  std::string between = "straight";  ///< "screw", "spline", or the radius of blends, m
  bool least_times = false;          ///< of each motion
  bool jerks = false;                ///< limit the least times; not beside `bearing`
  std::vector<MovingJoint> bearing;  ///< all joints, if their forces limit the least times; else empty
  bool proofs = false;               ///< of each motion
  std::filesystem::path motions;     ///< CSV to write; empty for none

  [[nodiscard]] std::vector<MovingJoint> limited() const;  ///< all that has limits, in this order
  [[nodiscard]] std::vector<std::string> turning() const;  ///< names of what is free at a singular pose
};

/// Returns the program of an arm, from the cache if it is there. Throws std::runtime_error if the arm cannot
/// follow poses, with the reason.
programs::Program arm_program(const model::Robot& robot, const Task& task, const std::string& key,
                              const toolchain::Runtime& runtime, const programs::Progress& progress);

/// Runs the program; returns its JSON. Throws std::runtime_error if it fails.
nlohmann::ordered_json follow(const programs::Program& program, const Task& task, const Poses& poses);

}  // namespace qvgen::path
