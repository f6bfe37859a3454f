// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compare/library.h"
#include "derive/dynamics/rotation_sequence.h"
#include "derive/dynamics/scalar.h"
#include "model/robot.h"

/// Numbers of an arm that the formulations need, in exact arithmetic.
namespace qvgen::compare {

using Exact = derive::dynamics::Scalar;
using ExactVector = derive::dynamics::Vector3;
using ExactMatrix = derive::dynamics::Matrix3;
using ExactQuaternion = std::array<Exact, 4>;  ///< w, x, y, z

ExactVector exact(const model::Vector3& v, dag::Graph& graph);
ExactVector turned(const derive::dynamics::RotationSequence& turns, ExactVector v, dag::Graph& graph);
ExactMatrix matrix_of(const derive::dynamics::RotationSequence& turns, dag::Graph& graph);

ExactQuaternion product(const ExactQuaternion& a, const ExactQuaternion& b);
ExactVector product(const ExactMatrix& m, const ExactVector& v);
ExactMatrix product(const ExactMatrix& a, const ExactMatrix& b);
ExactMatrix transposed(const ExactMatrix& m);
Exact dot(const ExactVector& a, const ExactVector& b);
/// Returns the sign of a number without symbols of the description; 0 for others, and for zero.
int sign(const Exact& number, const dag::Graph& graph);

/// A constant displacement.
struct ExactFrame {
  derive::dynamics::RotationSequence turns;
  ExactVector offset;
  [[nodiscard]] bool is_identity() const;
};

/// The arm with all frames parallel to the world's when its joints are at zero, each at its joint:
/// frame(i) = frame(i-1) * translation by offset * motion about or along axis; tool = frame(n) * (home,
/// tool).
struct ParallelArm {
  struct Joint {
    bool revolute = true;
    std::string variable;
    ExactVector offset, axis;
    ExactFrame link;  ///< of the described link in this frame, at zero
  };
  std::vector<Joint> joints;
  ExactVector tool;
  derive::dynamics::RotationSequence home;
  ExactQuaternion home_quaternion;
  /// True if the tool's frame is the last one.
  [[nodiscard]] bool ends_in_tool() const;
};
ParallelArm parallel_arm(const model::Robot& robot, dag::Graph& graph);

/// A row of a Denavit-Hartenberg table, Rz(theta) Tz(d) Tx(a) Rx(alpha), the variable added to theta or d.
struct TableRow {
  bool revolute = true;
  std::string variable;
  dag::Angle theta, alpha;
  Exact d, a;
  /// Displacement that four parameters cannot express: behind the last row, and elsewhere if an axis has a
  /// symbol for its twist or is displaced from a parallel one in two directions.
  ExactFrame rest;
};
struct Table {
  ExactFrame base;
  std::vector<TableRow> rows;
};
Table denavit_hartenberg(const model::Robot& robot, dag::Graph& graph);

/// The exact numbers as stored ones of the recorder.
Vector stored(const ExactVector& v, Recorder& recorder);
Quaternion stored(const ExactQuaternion& q, Recorder& recorder);
Matrix stored(const ExactMatrix& m, Recorder& recorder);
Transform stored(const ExactFrame& frame, Recorder& recorder);

}  // namespace qvgen::compare
