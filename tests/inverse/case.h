// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <random>
#include <string>

#include "reference/load.h"
#include "robot_under_test.h"

namespace qvgen::test {

inline constexpr double pi = 3.14159265358979323846;

/// One robot with its reference chain, which shares no code with the generator: samples joints, measures
/// rows.
class Case {
 public:
  explicit Case(const InverseUnderTest& robot);
  /// An arm without a description.
  Case(const InverseUnderTest& robot, reference::Chain chain) : robot_(robot), chain_(std::move(chain)) {}

  [[nodiscard]] const InverseUnderTest& robot() const { return robot_; }
  [[nodiscard]] const reference::Chain& chain() const { return chain_; }
  [[nodiscard]] int dof() const { return robot_.dof; }
  [[nodiscard]] bool revolute(int joint) const {
    return chain_.joints[static_cast<std::size_t>(joint)].revolute;
  }

  /// True if a joint slides whose value is not given: then every place may be in reach.
  [[nodiscard]] bool slides_besides_given() const {
    for (int i = 0; i < robot_.dof; ++i)
      if (!revolute(i) && i != robot_.info.given_joint) return true;
    return false;
  }

  void seed(unsigned number) { random_.seed(number); }

  /// Counts how often a pose of a set was searched for, and how often one was found.
  struct Searches {
    int tried = 0, found = 0;
  };
  Searches& searches(const std::string& set) { return searches_[set]; }

  /// Uniform in [-pi, pi), metres for slides.
  Eigen::VectorXd joints();
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  [[nodiscard]] Eigen::Isometry3d tool(const Eigen::VectorXd& q) const {
    return reference::forward_kinematics(chain_, q);
  }
  [[nodiscard]] double given(const Eigen::VectorXd& q) const {
    return robot_.info.given_joint < 0 ? 0 : q[robot_.info.given_joint];
  }
  [[nodiscard]] Found solve(const Eigen::VectorXd& q) const {
    return robot_.solve(Pose<double>::from_isometry(tool(q)), given(q), inverse::default_tolerance);
  }

  [[nodiscard]] bool asks_position() const;

  struct Miss {
    double position = 0;     ///< m
    double orientation = 0;  ///< rad; 0 if the solver leaves it out
    [[nodiscard]] double largest() const { return std::max(position, orientation); }
  };
  [[nodiscard]] Miss miss(const Eigen::VectorXd& q, const Eigen::Isometry3d& target) const;

  /// Returns the residual to the target, in the rows of `jacobian`: displacement, then rotation vector.
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& q, const Eigen::Isometry3d& target) const;

  /// Joints and pitch of an arm that is asked for a pitch: the first that turns all of it, the first of those
  /// that the pitch is counted about, and the pitch, by the axes as they are with the first joint at zero.
  [[nodiscard]] int base_joint() const;
  [[nodiscard]] int pitch_joint() const;
  [[nodiscard]] double pitch(const Eigen::VectorXd& q) const;

  /// b - a, revolute joints the short way round.
  [[nodiscard]] Eigen::VectorXd difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  [[nodiscard]] double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return difference(a, b).cwiseAbs().maxCoeff();
  }

  /// The Jacobian of what the pose fixes with respect to the joints that are solved for.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& q) const;
  /// q moved by a step of the joints that are solved for.
  [[nodiscard]] Eigen::VectorXd moved(const Eigen::VectorXd& q, const Eigen::VectorXd& step) const;

  /// The axis of the first joint that turns and is not given, as a tool there sees it; of the given one where
  /// the others cannot incline the tool about that.
  [[nodiscard]] Eigen::Vector3d base_seen(const Eigen::VectorXd& q, const Eigen::Isometry3d& tool) const {
    return tool.linear().transpose() * axis(base_joint(), q);
  }

 private:
  [[nodiscard]] bool asks_orientation() const;
  [[nodiscard]] bool asks_direction() const;
  [[nodiscard]] bool asks_pitch() const { return robot_.info.task == Task::position_and_pitch; }
  [[nodiscard]] bool leaves_heading() const { return asks_pitch() || asks_inclination(); }
  [[nodiscard]] bool asks_inclination() const { return robot_.info.task == Task::position_and_inclination; }
  [[nodiscard]] Eigen::Vector3d tool_axis() const;
  /// Direction of a joint's axis in the base frame.
  [[nodiscard]] Eigen::Vector3d axis(int joint, const Eigen::VectorXd& q) const;
  /// Number of the residual's parts, three rows each.
  [[nodiscard]] int parts() const {
    return (asks_position() ? 1 : 0) + (asks_orientation() || asks_direction() || leaves_heading() ? 1 : 0);
  }

  InverseUnderTest robot_;
  reference::Chain chain_;
  std::mt19937_64 random_{20070711};
  std::map<std::string, Searches> searches_;
  mutable std::optional<int> base_;
};

}  // namespace qvgen::test
