// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "canonical/arm.h"
#include "compare/certify.h"
#include "compare/formulation.h"
#include "dag/counts.h"
#include "passes/cost.h"

namespace qvgen::compare {

enum class Level {
  textbook,     ///< joint by joint, as a library multiplies that does not know the robot
  specialised,  ///< these steps with the robot's numbers: zeros and ones gone, what is written twice once
  optimised     ///< that, after all passes and the search
};
/// "textbook", ...
const std::vector<std::string>& level_names();

/// Costs of a formulation at a level.
struct Measured {
  dag::OperationCounts counts;
  int constants = 0;  ///< numbers kept for the robot
  int alive = 0;      ///< most intermediate values needed at the same time, in the order of the steps
  dag::Function function;
  friend bool operator==(const Measured& a, const Measured& b) {
    return a.counts == b.counts && a.constants == b.constants && a.alive == b.alive;
  }
};

using passes::cost;

/// A robot as formulations take it, with what the quantity is by definition.
struct Subject {
  Subject(const model::Robot& described, What what);
  What what;
  struct View {
    canonical::Arm arm;
    Definition definition;
  };
  View plain;          ///< as the derivations see the arm
  View along_normals;  ///< with frames on the common normals of its axes
  [[nodiscard]] const View& of(const Formulation& formulation) const {
    return formulation.along_normals ? along_normals : plain;
  }
};

/// Runs the formulation and certifies what came of it against the definition, at every level, with tolerance
/// zero. Arithmetic on numbers of the robot alone is done once and costs nothing. Throws
/// verify::CertificateError.
Measured measure(const Subject& subject, const Formulation& formulation, Level level);

}  // namespace qvgen::compare
