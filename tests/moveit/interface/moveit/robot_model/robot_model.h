// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

/// Stands in for MoveIt's header of this name: what a kinematics plugin asks of a robot model, and no more.
namespace moveit::core {

struct VariableBounds {
  double min_position_ = 0;
  double max_position_ = 0;
  bool position_bounded_ = false;
};

class JointModel {
 public:
  enum JointType { UNKNOWN, REVOLUTE, PRISMATIC, PLANAR, FLOATING, FIXED };
  JointModel(std::string name, JointType type, const VariableBounds& bounds)
      : name_(std::move(name)), type_(type), bounds_{bounds} {}
  [[nodiscard]] JointType getType() const { return type_; }
  [[nodiscard]] const std::string& getName() const { return name_; }
  [[nodiscard]] const std::vector<VariableBounds>& getVariableBounds() const { return bounds_; }

 private:
  std::string name_;
  JointType type_;
  std::vector<VariableBounds> bounds_;
};

class JointModelGroup {
 public:
  explicit JointModelGroup(const std::vector<JointModel>& joints) : joints_(joints) {
    for (const JointModel& joint : joints_) active_.push_back(&joint);
  }
  JointModelGroup(const JointModelGroup&) = delete;
  JointModelGroup& operator=(const JointModelGroup&) = delete;
  [[nodiscard]] const std::vector<const JointModel*>& getActiveJointModels() const { return active_; }
  [[nodiscard]] unsigned int getVariableCount() const { return static_cast<unsigned int>(active_.size()); }

 private:
  std::vector<JointModel> joints_;
  std::vector<const JointModel*> active_;
};

/// Model of one group, "arm". The places of links come from the test.
class RobotModel : public std::enable_shared_from_this<RobotModel> {
 public:
  using Places = std::function<Eigen::Isometry3d(const std::string& link, const std::vector<double>& joints)>;
  RobotModel(const std::vector<JointModel>& joints, std::vector<std::string> links, Places places)
      : group_(joints), links_(std::move(links)), places_(std::move(places)) {}
  [[nodiscard]] const JointModelGroup* getJointModelGroup(const std::string& name) const {
    return name == "arm" ? &group_ : nullptr;
  }
  [[nodiscard]] bool hasLinkModel(const std::string& name) const {
    for (const std::string& link : links_)
      if (link == name) return true;
    return false;
  }
  [[nodiscard]] const Places& places() const { return places_; }

 private:
  JointModelGroup group_;
  std::vector<std::string> links_;
  Places places_;
};
using RobotModelConstPtr = std::shared_ptr<const RobotModel>;

}  // namespace moveit::core
