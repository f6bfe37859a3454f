// SPDX-License-Identifier: MIT
#include "pipeline/products/frame_functions.h"

#include "canonical/right_angles.h"
#include "derive/jacobian/frame_poses.h"
#include "derive/jacobian/quantities.h"
#include "derive/kinematics/forward_kinematics.h"
#include "model/followers.h"
#include "model/frames.h"
#include "optimise/described.h"
#include "optimise/pose.h"
#include "verify/accuracy.h"
#include "verify/same_pose.h"

namespace qvgen::pipeline {
namespace {

constexpr int accuracy_points = 16;

const verify::OutputGroup position{"px", "py", "pz"};
const verify::OutputGroup rotation{"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"};

optimise::OptimiseOptions options() {
  optimise::OptimiseOptions result;
  result.also_fewest = false;
  result.certificate_points = 3;
  return result;
}

std::string place(const std::string& what, std::size_t row, std::size_t column) {
  return what + "(" + std::to_string(row) + ", " + std::to_string(column) + ")";
}

std::vector<std::string> transform_targets(const std::string& what) {
  std::vector<std::string> targets;
  for (std::size_t i = 0; i < 9; ++i) targets.push_back(place(what, i / 3, i % 3));
  for (std::size_t i = 0; i < 3; ++i) targets.push_back(place(what, i, 3));
  return targets;
}

/// In terms of the description's joints that follow none, counted anew where that changes something.
optimise::Optimised frames_in_terms_of_leaders(const model::Robot& described, optimise::Optimised optimised) {
  if (!model::has_followers(described)) return optimised;
  optimised.function = optimise::in_terms_of_leaders(optimised.function, described);
  optimised.counts = dag::count(optimised.function);
  return optimised;
}

/// A column for each joint that follows none: those of the chain's joints up to the frame by their ratios,
/// and zeros for joints that do not move it.
void gather_columns(const model::Robot& described, std::size_t joints, dag::Function& function) {
  const std::vector<std::vector<model::Share>> shares = model::shares(described);
  const std::size_t columns = model::driven_count(described);
  std::vector<dag::Output> gathered;
  for (std::size_t row = 0; row < 6; ++row) {
    std::vector<dag::Edge> sums(columns, function.graph.constant(0));
    for (std::size_t i = 0; i < joints; ++i) {
      const dag::Edge entry = function.outputs.at(row * joints + i).value;
      for (const model::Share& share : shares[i]) {
        const dag::Edge ratio = function.graph.constant(exact::Number(share.ratio));
        dag::Edge& sum = sums[share.driven];
        sum = function.graph.sum({sum, function.graph.product({ratio, entry})});
      }
    }
    for (std::size_t column = 0; column < columns; ++column)
      gathered.push_back({derive::jacobian_entry(row, column), sums[column]});
  }
  function.outputs = std::move(gathered);
}

/// The frame as the tool of an arm that ends there.
struct Ending {
  model::Robot robot;
  canonical::Arm arm;
};

Ending ending_at(const model::Robot& described, const model::Frame& frame) {
  model::Robot robot = model::up_to(described, frame);
  canonical::Arm arm = canonical::whatever_notation(robot);
  verify::certify_same_pose(robot, arm);
  return {std::move(robot), std::move(arm)};
}

emit::JacobianFunction pose_function(const model::Robot& described, const model::Frame& frame) {
  optimise::Pose pose = optimise::forward_kinematics(model::up_to(described, frame), options());
  pose.function.largest_error = verify::largest_error_in_ulps(
      pose.function.function, {{"w", "x", "y", "z"}, position}, accuracy_points);
  return {"forward_kinematics_of_" + frame.name,
          "Pose",
          {},
          {"Pose of the frame " + frame.name + " in the world frame: unit quaternion and position (m)."},
          "",
          {"result.orientation.w()", "result.orientation.x()", "result.orientation.y()",
           "result.orientation.z()", "result.position[0]", "result.position[1]", "result.position[2]"},
          frames_in_terms_of_leaders(described,
                                     optimise::in_terms_of_description(std::move(pose.function), pose.arm))};
}

emit::JacobianFunction transform_function(const model::Robot& described, const model::Frame& frame) {
  const auto [robot, arm] = ending_at(described, frame);
  optimise::Optimised found = optimise::optimise(derive::homogeneous_transform(arm.robot), options());
  found.largest_error = verify::largest_error_in_ulps(found.function, {rotation, position}, accuracy_points);
  return {"homogeneous_transform_of_" + frame.name,
          "FrameTransform",
          {},
          {"Pose of the frame " + frame.name + " in the world frame as a homogeneous transformation (m)."},
          "result.makeAffine();",
          transform_targets("result"),
          frames_in_terms_of_leaders(described, optimise::in_terms_of_description(std::move(found), arm))};
}

emit::JacobianFunction jacobian_function(const model::Robot& described, const model::Frame& frame) {
  const auto [robot, arm] = ending_at(described, frame);
  const std::size_t joints = robot.joints.size();
  optimise::OptimiseOptions search = options();
  search.simplify_forms = false;
  optimise::Optimised found = optimise::optimise(derive::jacobian(arm.robot), search);
  std::vector<verify::OutputGroup> groups;
  for (std::size_t joint = 0; joint < joints; ++joint)
    for (std::size_t half = 0; half < 6; half += 3)
      groups.push_back({derive::jacobian_entry(half, joint), derive::jacobian_entry(half + 1, joint),
                        derive::jacobian_entry(half + 2, joint)});
  found.largest_error = verify::largest_error_in_ulps(found.function, groups, accuracy_points);
  found = optimise::in_terms_of_description(std::move(found), arm);
  gather_columns(described, joints, found.function);
  std::vector<std::string> targets;
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t column = 0; column < model::driven_count(described); ++column)
      targets.push_back(place("result", row, column));
  return {"jacobian_of_" + frame.name,
          "FrameJacobian",
          {},
          {"Jacobian of the frame " + frame.name + " at its origin, in the world frame; linear rows first."},
          "",
          targets,
          frames_in_terms_of_leaders(described, std::move(found))};
}

}  // namespace

emit::JacobianFunction frame_function(const model::Robot& described, const model::Frame& frame,
                                      FrameFunction kind) {
  switch (kind) {
    case FrameFunction::pose:
      return pose_function(described, frame);
    case FrameFunction::transform:
      return transform_function(described, frame);
    case FrameFunction::jacobian:
      break;
  }
  return jacobian_function(described, frame);
}

emit::JacobianFunction frame_poses_function(const model::Robot& described, const std::string& name,
                                            const std::vector<model::Frame>& frames) {
  const model::Robot robot = canonical::for_dynamics(described);
  optimise::OptimiseOptions search = options();
  search.simplify_forms = false;
  derive::Quantity quantity = derive::frame_poses(robot, frames);
  quantity.name = name;
  optimise::Optimised found = optimise::optimise(quantity, search);
  std::vector<verify::OutputGroup> groups;
  std::vector<std::string> targets;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const verify::OutputGroup& group : {rotation, position}) {
      groups.emplace_back();
      for (const std::string& entry : group) groups.back().push_back(derive::frame_entry(i, entry));
    }
    for (const std::string& target : transform_targets("result[" + std::to_string(i) + "]"))
      targets.push_back(target);
  }
  found.largest_error = verify::largest_error_in_ulps(found.function, groups, accuracy_points);
  found.function = optimise::with_definitions(found.function, robot);
  found.counts = dag::count(found.function);
  return {name,
          name == "link_poses" ? "LinkPoses" : "FramePoses",
          {},
          {name == "link_poses"
               ? "Poses of all links in the world frame at once, base to tool (m)."
               : "Poses of all frames in the world frame at once, as `frame_names` has them (m)."},
          "for (auto& pose : result) pose.makeAffine();",
          targets,
          frames_in_terms_of_leaders(described, std::move(found))};
}

}  // namespace qvgen::pipeline
