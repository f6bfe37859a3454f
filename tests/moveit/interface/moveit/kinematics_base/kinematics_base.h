// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <moveit/robot_model/robot_model.h>
#include <moveit/robot_state/robot_state.h>
#include <rclcpp/rclcpp.hpp>

/// Stands in for MoveIt's header of this name and the messages that it includes: the declarations that a
/// plugin overrides or uses, with their published signatures.
namespace geometry_msgs::msg {

struct Point {
  double x = 0, y = 0, z = 0;
};
struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};
struct Pose {
  Point position;
  Quaternion orientation;
};

}  // namespace geometry_msgs::msg

namespace moveit_msgs::msg {

struct MoveItErrorCodes {
  static constexpr int SUCCESS = 1;
  static constexpr int TIMED_OUT = -6;
  static constexpr int NO_IK_SOLUTION = -31;
  int val = 0;
};

}  // namespace moveit_msgs::msg

namespace kinematics {

namespace DiscretizationMethods {
enum DiscretizationMethod {
  NO_DISCRETIZATION = 1,
  ALL_DISCRETIZED,
  SOME_DISCRETIZED,
  ALL_RANDOM_SAMPLED,
  SOME_RANDOM_SAMPLED
};
}
using DiscretizationMethod = DiscretizationMethods::DiscretizationMethod;

namespace KinematicErrors {
enum KinematicError {
  OK = 1,
  UNSUPORTED_DISCRETIZATION_REQUESTED,
  DISCRETIZATION_NOT_INITIALIZED,
  MULTIPLE_TIPS_NOT_SUPPORTED,
  EMPTY_TIP_POSES,
  IK_SEED_OUTSIDE_LIMITS,
  SOLVER_NOT_ACTIVE,
  NO_SOLUTION
};
}
using KinematicError = KinematicErrors::KinematicError;

struct KinematicsQueryOptions {
  bool lock_redundant_joints = false;
  bool return_approximate_solution = false;
  DiscretizationMethod discretization_method = DiscretizationMethods::NO_DISCRETIZATION;
};

struct KinematicsResult {
  KinematicError kinematic_error = KinematicErrors::OK;
  double solution_percentage = 0;
};

class KinematicsBase {
 public:
  using Pose = geometry_msgs::msg::Pose;
  using ErrorCode = moveit_msgs::msg::MoveItErrorCodes;
  using Joints = std::vector<double>;
  using Options = KinematicsQueryOptions;
  using IKCallbackFn = std::function<void(const Pose&, const Joints&, ErrorCode&)>;

  KinematicsBase() = default;
  KinematicsBase(const KinematicsBase&) = delete;
  KinematicsBase& operator=(const KinematicsBase&) = delete;
  virtual ~KinematicsBase() = default;

  virtual bool getPositionIK(const Pose& pose, const Joints& seed, Joints& solution, ErrorCode& error,
                             const Options& options = Options()) const = 0;
  virtual bool getPositionIK(const std::vector<Pose>& poses, const Joints& seed,
                             std::vector<Joints>& solutions, KinematicsResult& result,
                             const Options& options) const = 0;
  virtual bool searchPositionIK(const Pose& pose, const Joints& seed, double timeout, Joints& solution,
                                ErrorCode& error, const Options& options = Options()) const = 0;
  virtual bool searchPositionIK(const Pose& pose, const Joints& seed, double timeout,
                                const Joints& consistency_limits, Joints& solution, ErrorCode& error,
                                const Options& options = Options()) const = 0;
  virtual bool searchPositionIK(const Pose& pose, const Joints& seed, double timeout, Joints& solution,
                                const IKCallbackFn& callback, ErrorCode& error,
                                const Options& options = Options()) const = 0;
  virtual bool searchPositionIK(const Pose& pose, const Joints& seed, double timeout,
                                const Joints& consistency_limits, Joints& solution,
                                const IKCallbackFn& callback, ErrorCode& error,
                                const Options& options = Options()) const = 0;
  /// MoveIt calls this one; it hands a single pose on.
  virtual bool searchPositionIK(const std::vector<Pose>& poses, const Joints& seed, double timeout,
                                const Joints& consistency_limits, Joints& solution,
                                const IKCallbackFn& callback, ErrorCode& error,
                                const Options& options = Options(),
                                const moveit::core::RobotState* /*context*/ = nullptr) const {
    return poses.size() == 1 && searchPositionIK(poses.front(), seed, timeout, consistency_limits, solution,
                                                 callback, error, options);
  }
  virtual bool getPositionFK(const std::vector<std::string>& links, const Joints& joints,
                             std::vector<Pose>& poses) const = 0;
  virtual bool initialize(const rclcpp::Node::SharedPtr& node, const moveit::core::RobotModel& robot_model,
                          const std::string& group_name, const std::string& base_frame,
                          const std::vector<std::string>& tip_frames, double search_discretization) = 0;
  virtual const std::vector<std::string>& getJointNames() const = 0;
  virtual const std::vector<std::string>& getLinkNames() const = 0;

 protected:
  void storeValues(const moveit::core::RobotModel& robot_model, const std::string& group_name,
                   const std::string& base_frame, const std::vector<std::string>& tip_frames,
                   double /*search_discretization*/) {
    robot_model_ = robot_model.shared_from_this();
    group_name_ = group_name;
    base_frame_ = base_frame;
    tip_frames_ = tip_frames;
  }

  rclcpp::Node::SharedPtr node_;
  moveit::core::RobotModelConstPtr robot_model_;
  std::string group_name_, base_frame_;
  std::vector<std::string> tip_frames_;
};

}  // namespace kinematics
