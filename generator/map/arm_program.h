// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "map/about.h"
#include "model/robot.h"
#include "toolchain/generated.h"

namespace qvgen::map {

/// A compiled program that computes blocks of an arm's map (qvgen/map/program.h).
struct ArmProgram {
  std::filesystem::path file;
  std::string fingerprint;  ///< of the sources that it is made of
  std::string task;
  std::string given;  ///< the joint that is given; empty without
};

/// The program of an arm, from the cache if it is there. `key` is of all that its description says and of
/// this build of the tool. Throws std::runtime_error with the reason if the arm has no inverse kinematics
/// that could be mapped, or with the words of a compiler that is not there or fails.
ArmProgram arm_program(const model::Robot& robot, const std::string& key, const toolchain::Runtime& runtime,
                       const std::function<void(const std::string& what)>& progress);

/// Has the program compute blocks; they come in any order.
void compute(const ArmProgram& program, const Plan& plan, const std::vector<int>& blocks, int threads,
             const std::function<void(int block, std::vector<Cell> cells)>& take);

}  // namespace qvgen::map
