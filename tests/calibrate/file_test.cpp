// SPDX-License-Identifier: MIT
// Files of measurements: every way to write an orientation is the same, and mistakes have a line and a
// remedy.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulate.h"

namespace calibrate_test {
namespace {

using testing::HasSubstr;

class File : public testing::Test {
 protected:
  DataResult read(const std::string& text, const DataOptions& options = {}) {
    const auto path =
        std::filesystem::temp_directory_path() / ("qvgen_calibrate_" + std::to_string(::getpid()) + ".csv");
    std::ofstream(path) << text;
    DataResult result = read_data(path, scene_.robot, options);
    std::filesystem::remove(path);
    return result;
  }

  std::string mistakes(const std::string& text, const DataOptions& options = {}) {
    std::string all;
    for (const auto& each : read(text, options).diagnostics) all += to_string(each) + "\n";
    return all;
  }

  /// Returns what the calibration of a changed data set says.
  template <class Change>
  std::string refusal(Change change) {
    Scene scene = scene_of("ur5", 3);
    stand_anywhere(scene);
    DataSet set = measure(scene, 50);
    for (Measurement& row : set.rows) change(row);
    DataError error;
    return calibrate(scene.robot, set, {}, error) ? "" : error.message + "; " + error.hint;
  }

  Scene scene_ = scene_of("scara", 1);
  const std::string joints_ = "theta1 [deg],theta2 [deg],q3 [mm],q4 [deg]";
};

TEST_F(File, OrientationsAreReadInEveryForm) {
  const std::string start = joints_ + ",x [mm],y [mm],z [mm],";
  const std::string values = "\n10,20,30,40,1,2,3,";
  const Isometry3d expected(Eigen::AngleAxisd(1.2, Vector3d(2, -1, 3).normalized()));
  const Eigen::Quaterniond q(expected.linear());
  const Vector3d r = 1.2 * Vector3d(2, -1, 3).normalized();
  const Vector3d ypr = expected.linear().eulerAngles(2, 1, 0);
  const auto numbers = [](std::initializer_list<double> list) {
    std::ostringstream text;
    text.precision(17);
    for (const double each : list) text << (text.str().empty() ? "" : ",") << each;
    return text.str();
  };
  for (const std::string& text : {start + "qw,qx,qy,qz" + values + numbers({q.w(), q.x(), q.y(), q.z()}),
                                  start + "rx,ry,rz" + values + numbers({r.x(), r.y(), r.z()}),
                                  start + "roll,pitch,yaw" + values + numbers({ypr[2], ypr[1], ypr[0]})}) {
    const DataResult result = read(text);
    ASSERT_TRUE(result.good) << mistakes(text);
    EXPECT_EQ(result.set.data, Data::pose);
    EXPECT_TRUE(motion(result.set.rows[0].pose).linear().isApprox(expected.linear(), 1e-12)) << text;
    EXPECT_NEAR(result.set.rows[0].pose.position[1], 2e-3, 1e-15);
    EXPECT_NEAR(result.set.rows[0].q[2], 30e-3, 1e-15);
  }
}

TEST_F(File, MistakesHaveALineAndARemedy) {
  const std::string header = joints_ + ",x,y,z";
  EXPECT_THAT(mistakes("q1,q2,q3,q4,x,y,z\n1,2,3,4,1,1,1\n90,2,3,4,1,1,1\n"),
              HasSubstr("csv:3:1: error: 'q1' is 90 rad; write q1 [deg] in the header for degrees"));
  EXPECT_THAT(mistakes(header + "\n1,2,3,4,1200,1,1\n"),
              HasSubstr("csv:2:1: error: a position of 1200 m; write x [mm]"));
  EXPECT_THAT(mistakes(header + ",qw,qx,qy,qz\n1,2,3,4,1,1,1,30,0,0,0\n"),
              HasSubstr("csv:2:1: error: the quaternion has length 30"));
  EXPECT_THAT(mistakes(header + ",qw,qx\n1,2,3,4,1,1,1,1,0\n"),
              HasSubstr("some of qw, qx, qy, qz, not qy, qz"));
  EXPECT_THAT(mistakes(joints_ + "\n1,2,3,4\n"), HasSubstr("must have one kind of measurement"));
  EXPECT_THAT(mistakes(header + ",distance\n1,2,3,4,1,1,1,1\n"),
              HasSubstr("must have one kind of measurement"));
  EXPECT_THAT(mistakes(header + ",target\n1,2,3,4,1,1,1,1.5\n"),
              HasSubstr("csv:2:1: error: 'target' is 1.5; number them 1, 2, ..."));
  EXPECT_THAT(mistakes(header + "\n1,2,3,4,1,nan,1\n1,2,3\n"),
              testing::AllOf(HasSubstr("csv:2:1: error: 'y' is nan"), HasSubstr("csv:3:1: error: 3 cells")));
  EXPECT_THAT(mistakes(header + ",sigma\n1,2,3,4,1,1,1,0\n"),
              HasSubstr("a standard deviation that is not above 0"));
}

TEST_F(File, WhatDoesNotFitIsFoundOut) {
  EXPECT_EQ(refusal([](Measurement&) {}), "");
  EXPECT_THAT(refusal([](Measurement& row) { std::swap(row.q[1], row.q[2]); }),
              HasSubstr("columns q2 and q3 seem to be swapped"));
  EXPECT_THAT(refusal([](Measurement& row) { row.q[0] *= -1; }),
              HasSubstr("joint 1 seems to have the other sign"));
  EXPECT_THAT(refusal([](Measurement& row) {
                for (double& each : row.q) each *= 180 / 3.14159265358979;
              }),
              HasSubstr("seem to be degrees"));
  EXPECT_THAT(refusal([](Measurement& row) { row.pose.position = 1000.0 * row.pose.position; }),
              HasSubstr("seem to be millimetres"));
  EXPECT_THAT(refusal([](Measurement& row) { row.pose = inverse(row.pose); }),
              HasSubstr("the other way round"));
  EXPECT_THAT(refusal([](Measurement& row) { std::swap(row.pose.position[0], row.pose.position[1]); }),
              HasSubstr("columns x and y seem to be swapped"));
  EXPECT_THAT(refusal([](Measurement& row) {
                const Eigen::Quaterniond q(motion(row.pose).linear());
                Isometry3d read = motion(row.pose);
                read.linear() = Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()).toRotationMatrix();
                row.pose = rigid(read);
              }),
              HasSubstr("have w first"));
}

TEST_F(File, TooFewRowsAreRefused) {
  Scene scene = scene_of("ur5", 3);
  stand_anywhere(scene);
  DataError error;
  EXPECT_FALSE(calibrate(scene.robot, measure(scene, 2), {}, error));
  EXPECT_THAT(error.message, HasSubstr("2 rows are too few"));
  EXPECT_FALSE(calibrate(scene.robot, DataSet{}, {}, error));
  for (std::size_t count = 3; count < 12; ++count) {
    const auto found = calibrate(scene.robot, measure(scene, count), {}, error);
    EXPECT_TRUE(!found || found->covariance.allFinite());
  }
}

}  // namespace
}  // namespace calibrate_test
