// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <random>
#include <string>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <qvgen/inverse/arm_angle.h>

namespace qvgen::test {

using inverse::arm_angle::Arm;
using inverse::arm_angle::Found;
using inverse::arm_angle::Row;

/// How a spherical arm is built.
struct Build {
  bool right_angles;   ///< between neighbouring axes of shoulder and wrist
  bool planar;         ///< shoulder and wrist are in one plane across the elbow's axis
  bool plain_elbow;    ///< axis 3 goes through the elbow, axis 5 too
  bool equal_lengths;  ///< the wrist can fold onto the shoulder
};

struct NamedBuild {
  const char* name;
  Build build;

  friend void PrintTo(const NamedBuild& named, std::ostream* out) { *out << named.name; }
};
/// The end of a test's name: how the arm is built.
inline std::string name_of(const testing::TestParamInfo<NamedBuild>& info) { return info.param.name; }
inline constexpr NamedBuild builds[] = {
    {"plain", {true, true, true, false}},     {"equal", {true, true, true, true}},
    {"offset", {true, true, false, false}},   {"twisted", {true, false, false, false}},
    {"oblique", {false, true, false, false}}, {"oblique_twisted", {false, false, false, false}}};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
  Eigen::Vector3d vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
  Eigen::Vector3d direction();
  Row joints(double most = 3.14159) {
    return Row::NullaryExpr([&](auto) { return between(-most, most); });
  }
  JointLimits<7> limits();
  ArmAngleReference reference();
  Arm arm(const Build& build);

 private:
  std::mt19937_64 engine_;
};

/// By the definition: a product of exponentials as matrices.
Eigen::Isometry3d tool_at(const Arm& arm, const Row& q);
/// By the definition: the dihedral angle at the line from shoulder to wrist between reference and elbow.
double arm_angle_at(const Arm& arm, const Row& q, const ArmAngleReference& reference);

/// How far the row is from the pose: position as a share of the arm's size, orientation as a rotation's
/// entries.
double miss(const Arm& arm, const Row& q, const Pose<double>& pose);
Pose<double> pose_at(const Arm& arm, const Row& q);
/// The largest difference of two rows, whole turns left out.
double apart(const Row& a, const Row& b);

}  // namespace qvgen::test
