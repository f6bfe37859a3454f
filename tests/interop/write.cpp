// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include <Eigen/Geometry>

#include "arm.h"

namespace arms {
namespace {

using Eigen::Vector3d;

std::string number(double value, int digits) {
  char text[64];
  if (digits == 0)
    std::snprintf(text, sizeof text, "%.17g", value);
  else
    std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// As the table has it: short.
std::string number(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string triple(const Vector3d& v) { return number(v[0]) + " " + number(v[1]) + " " + number(v[2]); }
std::string triple(const Vector3d& v, int digits) {
  return number(v[0], digits) + " " + number(v[1], digits) + " " + number(v[2], digits);
}

/// Integers stay what they are, other axes are made unit vectors.
std::string axis_text(const Vector3d& axis, int digits) {
  return axis.cwiseAbs().sum() == 1 ? triple(axis) : triple(axis.normalized(), digits);
}

std::string origin(const Vector3d& xyz, const Vector3d& rpy, int digits) {
  return "<origin xyz=\"" + triple(xyz) + "\" rpy=\"" + triple(rpy * (EIGEN_PI / 180), digits) + "\"/>";
}

/// The next frame's distance, for where the mass of a link may be.
Vector3d next(const Arm& arm, std::size_t link) {
  return link + 1 < arm.joints.size() ? arm.joints[link + 1].xyz : arm.tool_xyz;
}

/// Half-way to the next joint, a little aside; lighter towards the tool.
struct Mass {
  double mass;
  Vector3d centre, moments, products;
};
Mass mass_of(const Arm& arm, std::size_t link) {
  const double weight = 1.0 / static_cast<double>(link + 2);
  const double mass = std::round(1000 * arm.mass * weight / 3) / 1000;
  const auto rounded = [](const Vector3d& v) -> Vector3d { return (v * 1e6).array().round() / 1e6; };
  return {mass, rounded(next(arm, link) / 2 + Vector3d(0.01, -0.02, 0.015)),
          rounded(mass * Vector3d(0.012, 0.01, 0.008)), rounded(mass * Vector3d(0.0005, -0.0003, 0.0002))};
}
const Vector3d skew(0.1, 0.2, -0.3);  // of the second link's inertia, radians

std::string inertial(const Arm& arm, std::size_t link) {
  const Mass m = mass_of(arm, link);
  return "<inertial><origin xyz=\"" + triple(m.centre) + "\" rpy=\"" +
         triple(link == 1 ? skew : Vector3d::Zero()) + "\"/><mass value=\"" + number(m.mass) +
         "\"/><inertia ixx=\"" + number(m.moments[0]) + "\" iyy=\"" + number(m.moments[1]) + "\" izz=\"" +
         number(m.moments[2]) + "\" ixy=\"" + number(m.products[0]) + "\" ixz=\"" + number(m.products[1]) +
         "\" iyz=\"" + number(m.products[2]) + "\"/></inertial>";
}

Eigen::Quaterniond rotation(const Vector3d& rpy) {
  return Eigen::AngleAxisd(rpy[2], Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy[1], Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy[0], Vector3d::UnitX());
}

std::string quaternion(const Vector3d& rpy_degrees, int digits) {
  const Eigen::Quaterniond q = rotation(rpy_degrees * (EIGEN_PI / 180));
  return number(q.w(), digits) + " " + triple(q.vec(), digits);
}

/// Principal moments: MuJoCo finds those of a full tensor to eleven digits only.
std::string mjcf_inertial(const Arm& arm, std::size_t link) {
  const Mass m = mass_of(arm, link);
  return "<inertial pos=\"" + triple(m.centre) + "\" quat=\"" +
         quaternion(static_cast<double>(10 * link) * skew, 0) + "\" mass=\"" + number(m.mass) +
         "\" diaginertia=\"" + triple(m.moments) + "\"/>";
}

}  // namespace

std::string urdf(const Arm& arm, int digits) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<robot name=\"" + arm.name + "\">\n  <link name=\"base_link\"/>\n";
  std::string parent = "base_link";
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    const std::string index = std::to_string(i + 1), link = "link" + index;
    text += "  <link name=\"" + link + "\">" + inertial(arm, i) + "</link>\n  <joint name=\"joint" + index +
            "\" type=\"" + (joint.revolute ? "revolute" : "prismatic") + "\">\n    <parent link=\"" + parent +
            "\"/><child link=\"" + link + "\"/>" + origin(joint.xyz, joint.rpy, digits) +
            "\n    <axis xyz=\"" + axis_text(joint.axis, digits) +
            "\"/><limit lower=\"-2.5\" upper=\"2.5\" effort=\"100\" velocity=\"3\"/><dynamics "
            "damping=\"0.3\"/>\n  </joint>\n";
    parent = link;
  }
  return text + "  <link name=\"tool0\">" + inertial(arm, 8) +
         "</link>\n  <joint name=\"tool\" type=\"fixed\"><parent link=\"" + parent +
         "\"/><child link=\"tool0\"/>" + origin(arm.tool_xyz, arm.tool_rpy, digits) + "</joint>\n</robot>\n";
}

std::string mjcf(const Arm& arm, int digits) {
  std::string text =
      "<mujoco model=\"" + arm.name +
      "\">\n  <compiler angle=\"radian\"/>\n  <default><joint damping=\"0.3\" armature=\"0.05\"/></default>\n"
      "  <worldbody>\n";
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    const std::string index = std::to_string(i + 1);
    text += "  <body name=\"link" + index + "\" pos=\"" + triple(joint.xyz) + "\" quat=\"" +
            quaternion(joint.rpy, digits) + "\">\n    <joint name=\"joint" + index + "\" type=\"" +
            (joint.revolute ? "hinge" : "slide") + "\" axis=\"" + axis_text(joint.axis, digits) +
            "\"/>\n    " + mjcf_inertial(arm, i) + "\n";
  }
  text += "  <body name=\"tool0\" pos=\"" + triple(arm.tool_xyz) + "\" quat=\"" +
          quaternion(arm.tool_rpy, digits) + "\">" + mjcf_inertial(arm, 8) + "</body>\n";
  for (std::size_t i = 0; i < arm.joints.size(); ++i) text += "  </body>\n";
  return text + "  </worldbody>\n</mujoco>\n";
}

}  // namespace arms
