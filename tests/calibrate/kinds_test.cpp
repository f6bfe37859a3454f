// SPDX-License-Identifier: MIT
// Every kind of data, with one target and several, finds the true arm: what it predicts at other joints is
// true.
#include <gtest/gtest.h>

#include "reference/dynamics.h"
#include "simulate.h"

namespace calibrate_test {
namespace {

Calibration calibrated_kind(const Scene& scene, const DataSet& set, const Options& options) {
  DataError error;
  auto found = calibrate(scene.robot, set, options, error);
  if (!found) throw std::runtime_error(error.message + "; " + error.hint);
  return std::move(*found);
}

/// Returns the greatest residual (m or rad) of measurements without noise that the fit has not seen.
double greatest_residual(const Scene& scene, const Calibration& found, std::size_t count = 30) {
  double greatest = 0;
  Scene exact = scene;
  exact.noise = 0;
  for (const Measurement& other : measure(exact, count).rows) {
    const Residual residual = residual_of(found.identifiable.model, scene.data, found.state, other, false);
    greatest = std::max(greatest, residual.value.cwiseAbs().maxCoeff());
  }
  return greatest;
}

TEST(Kinds, AllFindTheTrueArm) {
  for (const char* robot : {"ur5", "scara", "puma560"})
    for (const Data data : {Data::pose, Data::position, Data::camera}) {
      Scene scene = scene_of(robot, 4);
      scene.data = data;
      stand_anywhere(scene);
      const Calibration found = calibrated_kind(scene, measure(scene, 150), {});
      EXPECT_LE(greatest_residual(scene, found), 1e-8) << robot << " " << static_cast<int>(data);
      EXPECT_GE(found.before.position, 1e-4) << robot;
    }
}

TEST(Kinds, DistancesAndTouchedSurfaces) {
  for (const char* robot : {"ur5", "scara"})
    for (const Data data : {Data::distance, Data::plane, Data::sphere}) {
      if (data == Data::plane && robot == std::string("scara"))
        continue;  // its plane of motion is one already
      Scene scene = scene_with_tool(robot, 4);
      scene.data = data;
      const Calibration found =
          calibrated_kind(scene, measure(scene, 200), {Errors::all, false, false, true});
      EXPECT_LE(greatest_residual(scene, found), 1e-8)
          << robot << " " << static_cast<int>(data) << ": " << found.active.size() << " of "
          << found.identifiable.candidates.size() << testing::PrintToString(found.untold);
      EXPECT_GE(found.before.position, 1e-4) << robot;
    }
}

TEST(Kinds, SeveralTargetsOnTheTool) {
  Scene scene = scene_of("ur5", 8);
  stand_anywhere(scene, 3);
  scene.data = Data::position;
  scene.noise = 5e-5;
  const Calibration found = calibrated_kind(scene, measure(scene, 120), {});
  EXPECT_LE(found.after.position, 1.1e-4);
  EXPECT_LE(greatest_residual(scene, found), 2e-4);
}

/// Rows of a worse instrument count as little as they say: mixed with others they do no harm.
TEST(Kinds, DeviationsOfRowsWeighThem) {
  Scene scene = scene_of("ur5", 12);
  stand_anywhere(scene);
  scene.noise = 5e-5;
  DataSet set = measure(scene, 60);
  Scene coarse = scene;
  coarse.noise = 5e-3;
  for (Measurement row : measure(coarse, 60).rows) {
    row.sigma = row.sigma_angle = coarse.noise;
    set.rows.push_back(row);
  }
  for (std::size_t i = 0; i < 60; ++i) set.rows[i].sigma = set.rows[i].sigma_angle = scene.noise;
  set.sigma_known = true;
  DataSet equal = set;
  for (Measurement& row : equal.rows) row.sigma = row.sigma_angle = scene.noise;
  const Calibration found = calibrated_kind(scene, set, {});
  EXPECT_NEAR(found.misfit, 1, 0.1);
  EXPECT_LE(found.outliers.size(), 1U);
  EXPECT_LE(greatest_residual(scene, found), 3e-4);
  EXPECT_GE(calibrated_kind(scene, equal, {}).outliers.size(), 50U)
      << "the coarse rows stand out of equal ones";
}

TEST(Kinds, GearsThatAreEccentric) {
  Scene scene = scene_of("ur5", 9, 0);
  stand_anywhere(scene);
  DataSet set = measure(scene, 80);
  // The encoders report other values than the joints have.
  for (Measurement& row : set.rows) {
    const double true_angle = row.q[2];
    row.q[2] = true_angle - 2e-3 * std::cos(true_angle) + 1e-3 * std::sin(true_angle);
  }
  const Calibration found = calibrated_kind(scene, set, {Errors::all, true, false, false});
  for (std::size_t i = 0; i < found.active.size(); ++i) {
    const Parameter& each = found.identifiable.model.parameters[found.active[i]];
    if (each.gap != 3 || each.nuisance) continue;
    const double value = found.state.values[found.active[i]];
    if (each.kind == Kind::eccentric_cosine) {
      EXPECT_NEAR(value, 2e-3, 1e-5);
    } else if (each.kind == Kind::eccentric_sine) {
      EXPECT_NEAR(value, -1e-3, 1e-5);
    }
  }
}

/// Joints that bend under the weight of the links, by the tests' own dynamics.
TEST(Kinds, JointsThatBendUnderTheirLoad) {
  Scene scene = scene_of("iiwa14", 11);
  stand_anywhere(scene);
  constexpr double stiffness = 2e4;  // Nm/rad
  const VectorXd none = VectorXd::Zero(7);
  const auto bent = [&](const VectorXd& q) -> VectorXd {
    return q - reference::inverse_dynamics(scene.nominal, q, none, none, Vector3d(0, 0, 9.80665)) / stiffness;
  };
  DataSet set = measure(scene, 0);
  for (int i = 0; i < 150; ++i) {
    const VectorXd q = random_joints(scene);
    set.rows.push_back(measured(scene, bent(q), 0));
    set.rows.back().q.assign(q.data(), q.data() + q.size());
  }
  Options options;
  const Calibration stiff = calibrated_kind(scene, set, options);
  options.bending = true;
  const Calibration found = calibrated_kind(scene, set, options);
  EXPECT_GT(stiff.after.position, 1e-4);
  EXPECT_LT(found.after.position, 1e-6);
  int bends = 0;
  for (const std::size_t index : found.active) {
    const Parameter& each = found.identifiable.model.parameters[index];
    if (each.kind != Kind::bend) continue;
    ++bends;
    const double torque = std::stod(each.name.substr(each.name.find("under") + 6));
    EXPECT_NEAR(found.state.values[index] / torque, 1 / stiffness, 1e-3 / stiffness) << each.name;
  }
  EXPECT_GE(bends, 5) << "the first joint carries nothing, the last hardly anything";
}

TEST(Kinds, ZerosAloneLeaveTheRest) {
  Scene scene = scene_of("ur5", 10, 0);
  scene.truth.joints[2].before =
      scene.truth.joints[2].before * Isometry3d(Eigen::AngleAxisd(4e-3, Vector3d::UnitZ()));
  stand_anywhere(scene);
  const Calibration found = calibrated_kind(scene, measure(scene, 30), {Errors::zeros, false, false, false});
  for (std::size_t i = 0; i < found.active.size(); ++i) {
    const Parameter& each = found.identifiable.model.parameters[found.active[i]];
    if (each.nuisance) continue;
    EXPECT_EQ(each.kind, Kind::zero);
    EXPECT_NEAR(found.state.values[found.active[i]], each.gap == 3 ? 4e-3 : 0, 1e-9) << each.name;
  }
}

}  // namespace
}  // namespace calibrate_test
