// SPDX-License-Identifier: MIT
#pragma once

#include "description/tree/tree.h"
#include "description/xml/snap.h"

namespace qvgen::description::xml {

/// The numbers of a URDF's links and joints.
class UrdfNumbers {
 public:
  explicit UrdfNumbers(Context& context) : context_(&context), snap_(context) {}
  /// Nothing if the joint is of a type that no chain has.
  [[nodiscard]] std::optional<tree::Segment> segment(const Element& link, const Element& joint) const;
  /// The link's inertia in its own frame.
  [[nodiscard]] tree::Body body(const Element& link) const;

 private:
  [[nodiscard]] model::Displacement origin(const Element& parent) const;
  [[nodiscard]] model::Vector3 axis(const Element& joint) const;
  [[nodiscard]] std::optional<model::Limits> limits(const Element& joint, model::JointType type) const;
  /// `velocity` or `effort` of a joint's limits: rad/s or m/s, Nm or N.
  [[nodiscard]] std::optional<model::Expression> greatest(const Element& joint, const std::string& key) const;
  [[nodiscard]] model::Drive drive(const Element& joint) const;
  [[nodiscard]] tree::MovingJoint moving(const Element& joint, const std::string& type) const;
  [[nodiscard]] std::optional<tree::Mimic> mimic(const Element& joint, model::JointType type) const;

  Context* context_;
  Snap snap_;
};

}  // namespace qvgen::description::xml
