// SPDX-License-Identifier: MIT
// The class of an arm comes from its axes alone: its workspace is prismatic without a turn, cylindrical if
// all turns share a direction, else spherical.
#include "arm_class.h"

#include <cmath>
#include <random>

#include <Eigen/Core>

#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace qvgen::test::sources {
namespace {

std::string relation(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double cosine = std::abs(a.dot(b));
  if (cosine > 1 - 1e-9) return "parallel";
  return cosine < 1e-9 ? "perpendicular" : "oblique";
}

/// The axes of three joints at a few configurations, zero for slides.
constexpr int states = 3;
using Axes = Eigen::Matrix<double, 3, 3 * states>;

int directions_of(const Axes& axes) {
  if (axes.isZero()) return 0;
  return static_cast<int>(reference::rank(axes, 1e-6));
}

Eigen::VectorXd random_joints(std::size_t size) {
  static std::mt19937 engine(317);
  std::uniform_real_distribution<double> number(0.2, 1.3);
  Eigen::VectorXd q(static_cast<Eigen::Index>(size));
  for (double& x : q) x = number(engine);
  return q;
}

}  // namespace

std::string ArmClass::workspace() const {
  if (directions == 0) return "prismatic";
  return directions == 1 ? "cylindrical" : "spherical";
}

ArmClass class_of(const std::string& robot) {
  const reference::Chain chain = reference::load(QVGEN_SOURCE_DIR "/generator/robots/" + robot + ".toml");
  ArmClass result;
  Axes turning = Axes::Zero();
  for (int state = 0; state < states; ++state) {
    const auto places = reference::joint_places(chain, random_joints(chain.joints.size()));
    for (std::size_t i = 0; i < 3; ++i)
      if (chain.joints[i].revolute) turning.col(3 * state + static_cast<int>(i)) = places[i].axis;
    result.relations =
        relation(places[0].axis, places[1].axis) + ", " + relation(places[1].axis, places[2].axis);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const bool turns = chain.joints[i].revolute;
    result.types += turns ? 'R' : 'P';
    result.joints += (i > 0 ? ", " : "") + chain.joints[i].variable + (turns ? " turns" : " slides");
  }
  result.directions = directions_of(turning);
  return result;
}

}  // namespace qvgen::test::sources
