// SPDX-License-Identifier: MIT
// Arms of several structures behind functions of one type, paths of their tools, and a way along them that
// knows nothing of the library's: all solutions at places that lie dense, joined by distance.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include <qvgen/path/follow.h>

namespace path_test {

using namespace qvgen;
using namespace qvgen::path;

using Solve = std::function<Solutions<6, 16>(const Pose<double>&)>;
using Forward = std::function<Pose<double>(const Values&)>;
using JacobianOf = std::function<Eigen::Matrix<double, 6, 6>(const Values&)>;
using AnyArm = path::Arm<Solve, Forward, JacobianOf>;

struct NamedArm {
  std::string name;
  AnyArm arm;
};
/// One of each structure; fifteen in builds for long runs.
const std::vector<NamedArm>& arms();
std::vector<std::string> names_of_arms();
const NamedArm& arm_called(const std::string& name);

inline JointLimits<6> no_limits() {
  const double far = std::numeric_limits<double>::infinity();
  return {Values::Constant(-far), Values::Constant(far)};
}

/// All that is found along a path.
struct Whole {
  static constexpr int capacity = 16;
  Whole(const AnyArm& arm, std::vector<Pose<double>> samples, const JointLimits<6>& limits = no_limits(),
        Between between = Between::straight, const Options& options = {}, double radius = 0);
  Whole(const Whole&) = delete;
  /// Follows the path anew.
  void follow(const AnyArm& arm, const Options& options);

  std::vector<Pose<double>> samples;
  Curve curve;
  JointLimits<6> limits;
  std::vector<double> q;
  std::vector<int> rows;
  std::vector<Track> tracks;
  std::vector<Event> events;
  Record<capacity> record;
  long places = 0;

  [[nodiscard]] std::vector<Track> found() const {
    return {tracks.begin(), tracks.begin() + record.tracks()};
  }
};

/// Joints anywhere, slides within a metre.
Values random_joints(const AnyArm& arm, std::mt19937& random);

/// Poses of a bent way through a pose that the arm reaches.
std::vector<Pose<double>> random_path(const AnyArm& arm, std::mt19937& random, std::size_t count,
                                      double length);

/// Poses of joints that go evenly along a line.
std::vector<Pose<double>> path_of_joints(const AnyArm& arm, const Values& from, const Values& to,
                                         std::size_t count);

/// Number of paths for each arm: QVGEN_PATHS, or the usual one.
int path_count(int usual);

}  // namespace path_test
