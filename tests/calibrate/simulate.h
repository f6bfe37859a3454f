// SPDX-License-Identifier: MIT
// Arms that differ from their descriptions, and measurements of them, by the tests' own chain. Each gap of
// the true arm has a turn and a shift of its own, so the generator's choice of errors plays no part.
#pragma once

#include <random>
#include <string>

#include "calibrate/calibration.h"
#include "reference/load.h"

namespace calibrate_test {

using namespace qvgen::calibrate;
using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A true arm, its description, and what stands around it.
struct Scene {
  qvgen::model::Robot robot;
  reference::Chain nominal, truth;
  Isometry3d tracker = Isometry3d::Identity();
  std::vector<Isometry3d> targets;
  Data data = Data::pose;
  Vector3d point{0.3, -0.2, 0.4};  ///< of a plane, a sphere or a fixed end
  double radius = 0.5;             ///< m, of the sphere
  double noise = 0;                ///< m and rad
  mutable std::mt19937 random{1};
};

/// Returns an arm of the folder of robots whose gaps err by about so many metres and five times so many
/// radians.
Scene scene_of(const std::string& robot, unsigned seed, double error = 1e-3);
Scene scene_of_text(const std::string& toml, unsigned seed, double error = 1e-3);

/// Returns such an arm whose tool is off all axes: distances to a point on an axis do not see that axis turn.
Scene scene_with_tool(const std::string& robot, unsigned seed);

/// Places the tracker and so many targets anywhere.
void stand_anywhere(Scene& scene, std::size_t targets = 1);

VectorXd random_joints(const Scene& scene);
/// Returns the target's true pose as the instrument would see it, without noise.
Isometry3d seen(const Scene& scene, const VectorXd& q, std::size_t target);
/// Returns one measurement with noise.
Measurement measured(const Scene& scene, VectorXd q, std::size_t target);
/// Returns measurements at random joints; `held` keeps one joint at a value.
DataSet measure(const Scene& scene, std::size_t count, int held = -1);

/// Returns the derivative of everything measured (rows as in the data) by six errors of every gap, the
/// tracker's and the targets' frames and surfaces, by differences; known frames are left out.
MatrixXd derivative(const Scene& scene, const Measurement& at, bool tracker_known, bool target_known);

/// Returns how many instances are drawn: QVGEN_TRIALS, or the usual number.
int trial_count(int usual);

Rigid<double> rigid(const Isometry3d& m);
Isometry3d motion(const Rigid<double>& m);

}  // namespace calibrate_test
