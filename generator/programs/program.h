// SPDX-License-Identifier: MIT
// Programs compiled for one arm: its functions are generated, compiled by the machine's compiler with a main
// function, and kept in the cache under a key of all that they depend on. Maps and paths are computed so.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/robot.h"
#include "pipeline/robot_output.h"
#include "toolchain/generated.h"

namespace qvgen::programs {

/// Parts of a program besides the arm's functions.
struct Prepared {
  std::string main;                        ///< text of its main source, which is written as NAME_program.cpp
  std::vector<toolchain::Source> sources;  ///< with that one
  std::vector<std::string> libraries;      ///< the last words of the linker's command
  nlohmann::ordered_json about;            ///< kept beside the program
};

struct Recipe {
  std::string kind;                ///< "map": begins the name of the folder in the cache
  std::string key;                 ///< differs with the description, the tool and the machine
  std::vector<std::string> parts;  ///< of the generated code
  /// Prepares the program from the generated code, or throws std::runtime_error with the reason why not.
  std::function<Prepared(const pipeline::RobotOutput& output)> prepare;
};

/// A program that is there.
struct Program {
  std::filesystem::path file;
  nlohmann::ordered_json about;  ///< the recipe's, and "fingerprint": a number of all sources
};

/// Called with what is being done.
using Progress = std::function<void(const std::string& what)>;

/// Returns the program of an arm, from the cache if it is there. Throws std::runtime_error with the recipe's
/// reason, or with the words of a compiler that is not there or fails.
Program program_for(const model::Robot& robot, const Recipe& recipe, const toolchain::Runtime& runtime,
                    const Progress& progress);

/// Returns the reason why a robot has no inverse kinematics or Jacobian.
std::string reason_of(const pipeline::RobotOutput& output);

}  // namespace qvgen::programs
