// SPDX-License-Identifier: MIT
// What a calibration promises: an error next to the bound of Cramér and Rao, deviations that are those of
// repetitions, nothing found in an arm that is exact, outliers by their lines.
#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../identify/random_arm.h"
#include "calibrate/result.h"
#include "description/write.h"
#include "reference/linear_algebra.h"
#include "simulate.h"

namespace calibrate_test {
namespace {

Calibration calibrated(const Scene& scene, const DataSet& set, const Options& options = {}) {
  DataError error;
  auto found = calibrate(scene.robot, set, options, error);
  if (!found) throw std::runtime_error(error.message + "; " + error.hint);
  return std::move(*found);
}

/// Returns the pseudo-inverse of the information that the data have on the redundant model.
MatrixXd bound_of(const Scene& scene, const DataSet& set) {
  MatrixXd information;
  for (const Measurement& row : set.rows) {
    const MatrixXd rows = derivative(scene, row, false, false) / scene.noise;
    if (information.size() == 0) information = MatrixXd::Zero(rows.cols(), rows.cols());
    information += rows.transpose() * rows;
  }
  const reference::SingularValues parts = reference::singular_values(information);
  const VectorXd inverse =
      parts.values.unaryExpr([&](double value) { return value > 1e-11 * parts.values[0] ? 1 / value : 0; });
  return reference::product(parts.v * inverse.asDiagonal(), parts.u.transpose());
}

struct HoldOut {
  double position = 0, bound = 0, seconds = 0;
};

/// Returns the error of predicted positions at other joints, and what no unbiased estimate can be better
/// than.
HoldOut hold_out(const std::string& robot, Data data, int repetitions) {
  HoldOut result;
  constexpr int others = 40;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    Scene scene = scene_of(robot, static_cast<unsigned>(100 + repetition));
    stand_anywhere(scene);
    scene.data = data;
    scene.noise = 5e-5;
    const DataSet set = measure(scene, 60);
    const auto start = std::chrono::steady_clock::now();
    const Calibration found = calibrated(scene, set);
    result.seconds = std::max(
        result.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    const MatrixXd bound = bound_of(scene, set);
    for (int i = 0; i < others; ++i) {
      const Measurement other = measured(scene, random_joints(scene), 0);
      const VectorXd q = VectorXd::Map(other.q.data(), static_cast<Eigen::Index>(other.q.size()));
      const Model<double>& model = found.identifiable.model;
      const Rigid<double> pose = predict(model, posture_of(model.geometry, other.q.data()),
                                         found.state.frames, 0, found.state.values)
                                     .pose;
      const MatrixXd rows = derivative(scene, other, false, false).topRows(3);
      result.position += (motion(pose).translation() - seen(scene, q, 0).translation()).squaredNorm();
      result.bound += (rows * bound * rows.transpose()).trace();
    }
  }
  result.position = std::sqrt(result.position);
  result.bound = std::sqrt(result.bound);
  return result;
}

TEST(Law, HoldOutIsNextToTheBound) {
  for (const char* robot : {"ur5", "scara"})
    for (const Data data : {Data::pose, Data::position}) {
      const HoldOut result = hold_out(robot, data, trial_count(6));
      EXPECT_LE(result.position, 1.2 * result.bound) << robot;
      EXPECT_GE(result.position, 0.8 * result.bound) << robot << ": better than can be";
      EXPECT_LE(result.seconds, 1) << robot;
      RecordProperty(std::string(robot) + (data == Data::pose ? "_pose" : "_position"),
                     std::to_string(result.position / result.bound));
    }
}

TEST(Law, DeviationsAreThoseOfRepetitions) {
  Scene scene = scene_of("ur5", 7);
  stand_anywhere(scene);
  scene.noise = 5e-5;
  const DataSet set = measure(scene, 40);
  const Calibration first = calibrated(scene, set);
  constexpr int repetitions = 200;
  const auto count = static_cast<Eigen::Index>(first.active.size());
  VectorXd sum = VectorXd::Zero(count), squares = VectorXd::Zero(count);
  for (int i = 0; i < repetitions; ++i) {
    DataSet again = set;
    for (Measurement& row : again.rows) {
      const int line = row.line;
      row = measured(scene, VectorXd::Map(row.q.data(), static_cast<Eigen::Index>(row.q.size())), row.target);
      row.line = line;
    }
    const Calibration found = calibrated(scene, again);
    ASSERT_EQ(found.active, first.active);
    for (Eigen::Index k = 0; k < count; ++k) {
      const double value = found.state.values[found.active[static_cast<std::size_t>(k)]];
      sum[k] += value;
      squares[k] += value * value;
    }
  }
  int compared = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    if (first.identifiable.model.parameters[first.active[static_cast<std::size_t>(k)]].nuisance) continue;
    const double mean = sum[k] / repetitions;
    const double spread = std::sqrt(squares[k] / repetitions - mean * mean);
    // The spread of 200 values is known to a twentieth: four of those.
    EXPECT_NEAR(spread / std::sqrt(first.covariance(k, k)), 1, 0.2);
    ++compared;
  }
  EXPECT_EQ(compared, 18);
}

TEST(Law, AnExactArmStaysAsItIs) {
  for (const double noise : {0.0, 5e-5}) {
    Scene scene = scene_of("ur5", 5, 0);
    stand_anywhere(scene);
    scene.noise = noise;
    const Calibration found = calibrated(scene, measure(scene, 60));
    for (std::size_t k = 0; k < found.active.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      const double most = noise > 0 ? 5 * std::sqrt(found.covariance(i, i)) : 1e-9;
      EXPECT_LE(std::abs(found.state.values[found.active[k]]), most)
          << found.identifiable.model.parameters[found.active[k]].name;
    }
  }
}

TEST(Law, ExactDataGiveTheTrueArm) {
  for (const char* robot : {"ur5", "scara", "puma560", "stanford", "iiwa14", "ns"}) {
    Scene scene = scene_of(robot, 11);
    for (auto& joint : scene.robot.joints)
      joint.inertia = {};  // symbols, which the reference wants values of
    const Calibration found = calibrated(scene, measure(scene, 80), {Errors::all, false, true, true});
    const std::string text = qvgen::description::write_text(calibrated_robot(scene.robot, found, "mine"));
    const reference::Chain again = reference::load_text(text);
    for (int i = 0; i < 20; ++i) {
      const VectorXd q = random_joints(scene);
      EXPECT_TRUE(reference::forward_kinematics(again, q).isApprox(
          reference::forward_kinematics(scene.truth, q), 1e-9))
          << robot << "\n"
          << text;
    }
  }
}

/// Readings are motors'; the description that is written has the same motors.
TEST(Law, ExactDataOfMotorsGiveTheTrueArm) {
  for (unsigned seed = 1; seed <= static_cast<unsigned>(trial_count(4)); ++seed) {
    const std::string before =
        qvgen::test::ArmWriter(seed).with_motors(seed % 2 == 0 ? "RRRRRR" : "RRPR", false);
    Scene scene = scene_of_text(before, seed);
    for (auto& joint : scene.robot.joints) joint.inertia = {};
    const Calibration found = calibrated(scene, measure(scene, 80), {Errors::all, false, true, true});
    const std::string text = qvgen::description::write_text(calibrated_robot(scene.robot, found, "mine"));
    const reference::Chain again = reference::load_text(text);
    ASSERT_EQ(again.driven(), scene.truth.driven());
    for (int i = 0; i < 20; ++i) {
      const VectorXd q = random_joints(scene);
      EXPECT_TRUE(reference::forward_kinematics(again, q).isApprox(
          reference::forward_kinematics(scene.truth, q), 1e-9))
          << before << text;
    }
  }
}

TEST(Law, SixJointsNameTheirIdealArm) {
  for (const auto& [robot, ideal] :
       {std::pair{"ur5", "ur5"}, {"puma560", "puma560"}, {"scara", ""}, {"general_6r", ""}}) {
    Scene scene = scene_of(robot, 3);
    const Calibration found = calibrated(scene, measure(scene, 60));
    EXPECT_EQ(calibrated_robot(scene.robot, found, "mine").ideal, ideal) << robot;
  }
}

TEST(Law, OutliersAreNamedByLine) {
  for (unsigned seed = 1; seed <= static_cast<unsigned>(trial_count(8)); ++seed) {
    Scene scene = scene_of("ur5", seed);
    stand_anywhere(scene);
    scene.noise = 5e-5;
    DataSet set = measure(scene, 60);
    set.sigma_known = seed % 2 == 0;
    set.rows[7].pose.position[0] += 0.02;
    set.rows[31].q[2] += 0.01;
    set.rows[44].pose.position[2] -= 0.1;
    const Calibration found = calibrated(scene, set);
    std::vector<int> lines;
    for (const Outlier& each : found.outliers) lines.push_back(each.line);
    EXPECT_THAT(lines, testing::IsSupersetOf({9, 33, 46})) << seed;
    EXPECT_LE(lines.size(), 4U) << seed;
    EXPECT_LE(found.after.position, 1.2e-4) << seed;
  }
}

}  // namespace
}  // namespace calibrate_test
