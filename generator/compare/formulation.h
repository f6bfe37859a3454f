// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/recorder.h"
#include "model/robot.h"

namespace qvgen::compare {

/// The quantity that formulations compute.
enum class What { forward, jacobian, dynamics };
/// "forward", ...
const std::vector<std::string>& what_names();

/// A named result of an algorithm.
struct Result {
  std::string name;
  Value value;
};
using Results = std::vector<Result>;

/// One way to compute a quantity: its algorithm as a textbook has it, over numbers that it knows nothing
/// about.
struct Formulation {
  std::string name;   ///< for command lines: "pairs"
  std::string title;  ///< for people
  /// The recorder must outlive the results. None for what the generator emits, all its forms together:
  /// `emitted`.
  std::function<Results(Recorder&, const model::Robot&)> run;
  /// True if it wants its frames on the common normals of the axes (canonical::along_normals).
  bool along_normals = false;
  /// The certified function of the generator, for formulations without an algorithm.
  std::function<dag::Function(const model::Robot&)> emitted = {};
};

/// The formulations of a quantity in the order of the sources that name them (SOURCES.md: thesis,
/// section 1.3).
const std::vector<Formulation>& formulations(What what);

/// Returns the symbols on which arithmetic is free: all but joint variables, their rates and accelerations.
dag::IsFree free_symbols(const model::Robot& robot);

/// Forward kinematics: outputs w x y z px py pz or r11 ... r33 px py pz, the tool in the world.
std::vector<Formulation> forward_formulations();
/// Outputs v1_1 ... w3_n, the twist's rows in the base frame at the tool point.
std::vector<Formulation> jacobian_formulations();
/// Inverse dynamics under gravity along -z: outputs tau1 ... taun. Throws std::domain_error for an arm
/// without inertia.
std::vector<Formulation> dynamics_formulations();

}  // namespace qvgen::compare
