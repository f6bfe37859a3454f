// SPDX-License-Identifier: MIT
#include "identify/prior.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "matrices/decompositions.h"
#include "model/evaluate.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Thickness of a rod as a share of the longest link's length.
constexpr double thickness = 0.1;
/// Share of a typical moment that a drive without a description is taken to have.
constexpr double drive_share = 0.1;

double value_of(const model::Expression& expression, const model::Bindings& values) {
  return model::to_double(model::evaluate(expression, values));
}

std::optional<PseudoInertia> described(const model::Inertia& inertia, const model::Bindings& values) {
  try {
    const double mass = value_of(inertia.mass, values);
    Vector3d c;
    Eigen::Matrix<double, 6, 1> i;
    for (Index k = 0; k < 3; ++k)
      c[k] = value_of(inertia.centre_of_mass[static_cast<std::size_t>(k)], values);
    for (Index k = 0; k < 6; ++k) i[k] = value_of(inertia.inertia[static_cast<std::size_t>(k)], values);
    Matrix3d about_centre;
    about_centre << i[0], i[3], i[5], i[3], i[1], i[4], i[5], i[4], i[2];
    const Matrix3d moments = about_centre.trace() / 2 * Matrix3d::Identity() - about_centre;
    const double least = matrices::principal_axes(moments).values[0];
    if (!(mass > 0) || !(least > 1e-9 * moments.trace())) return std::nullopt;
    PseudoInertia result;
    result << moments + mass * c * c.transpose(), mass * c, mass * c.transpose(), mass;
    return result;
  } catch (const model::EvaluationError&) {
    return std::nullopt;
  }
}

/// Ends of the links, in their frames: where the next joint is.
std::vector<Vector3d> ends_of(const model::Robot& robot, const model::Bindings& values) {
  std::vector<Vector3d> ends;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const bool last = i + 1 == robot.joints.size();
    const model::Vector3& way = last ? robot.tool.translation : robot.joints[i + 1].before.translation;
    Vector3d end;
    for (Index k = 0; k < 3; ++k) end[k] = value_of(way[static_cast<std::size_t>(k)], values);
    if (end.norm() == 0)  // the frame is at the link's end: its begin is behind
      for (Index k = 0; k < 3; ++k)
        end[k] = -value_of(robot.joints[i].after.translation[static_cast<std::size_t>(k)], values);
    ends.push_back(end);
  }
  return ends;
}

/// A rod of mass one from the origin to its end.
PseudoInertia rod(const Vector3d& end, double radius) {
  PseudoInertia result;
  const Vector3d c = end / 2;
  const Matrix3d moments = end * end.transpose() / 3 + radius * radius / 4 * Matrix3d::Identity();
  result << moments, c, c.transpose(), 1;
  return result;
}

std::vector<PseudoInertia> rods_of(const model::Robot& robot, const model::Bindings& values) {
  const std::vector<Vector3d> ends = ends_of(robot, values);
  double longest = 0;
  for (const Vector3d& end : ends) longest = std::max(longest, end.norm());
  if (longest == 0) longest = 0.3;
  std::vector<PseudoInertia> rods;
  for (const Vector3d& end : ends) rods.push_back(rod(end, thickness * longest));
  return rods;
}

/// All values of links: so many drives are zero.
VectorXd values_of_links(const std::vector<PseudoInertia>& links, std::size_t drives) {
  VectorXd values = VectorXd::Zero(static_cast<Index>(10 * links.size() + 4 * drives));
  for (std::size_t i = 0; i < links.size(); ++i)
    values.segment<10>(10 * static_cast<Index>(i)) = standard_of(links[i]);
  return values;
}

/// The mass of each rod that lets the weighted torques fit best, but no less than some share of the one with
/// torques as large as those: rods that point the wrong way would fit best without mass.
double fitting_mass(const ArmRegressor& arm, const Estimate& estimate,
                    const std::vector<PseudoInertia>& known, const std::vector<PseudoInertia>& rods) {
  constexpr double least_share = 0.3;
  const std::size_t drives = arm.drive_units();
  const VectorXd fixed = estimate.information * (arm.combination * values_of_links(known, drives));
  const VectorXd each = estimate.information * (arm.combination * values_of_links(rods, drives));
  const VectorXd rest = estimate.right_side - fixed;
  const double length = each.norm();
  if (!(length > 0)) return 1;
  return std::max({1e-3, least_share * rest.norm() / length, each.dot(rest) / (length * length)});
}

double positive_or(const model::Expression& expression, const model::Bindings& values, double otherwise) {
  try {
    const double value = value_of(expression, values);
    return value > 0 ? value : otherwise;
  } catch (const model::EvaluationError&) {
    return otherwise;
  }
}

/// A joint's drive. `is_behind_motors`: a motor that is no joint moves this joint.
struct PlacedDrive {
  model::Drive drive;
  bool is_behind_motors = false;
};

/// Returns the drives in the order of their parameters.
std::vector<PlacedDrive> all_drives_of(const model::Robot& robot) {
  std::vector<PlacedDrive> drives;
  for (const model::Joint& joint : robot.joints)
    drives.push_back({joint.drive, !joint.follows.empty() && !robot.motors.empty()});
  for (const model::Motor& motor : robot.motors) drives.push_back({motor.drive, false});
  return drives;
}

/// Returns the guess of all drives. What motions do not tell apart, motors have rather than the joints behind
/// them.
VectorXd drives_of(const model::Robot& robot, const model::Bindings& values, double typical) {
  constexpr double share_behind_motors = 0.1;
  const std::vector<PlacedDrive> all = all_drives_of(robot);
  VectorXd drives(4 * static_cast<Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [drive, is_behind_motors] = all[i];
    const double share = is_behind_motors ? share_behind_motors : 1;
    drives.segment<4>(4 * static_cast<Index>(i)) << positive_or(drive.rotor_inertia, values, share * typical),
        positive_or(drive.viscous_friction, values, share),
        positive_or(drive.coulomb_friction, values, share), share;
  }
  return drives;
}

}  // namespace

std::optional<VectorXd> described_parameters(const model::Robot& robot) {
  const model::Bindings values = model::default_bindings(robot);
  std::vector<PseudoInertia> links;
  for (const model::Joint& joint : robot.joints) {
    const auto link = described(joint.inertia, values);
    if (!link) return std::nullopt;
    links.push_back(*link);
  }
  const std::vector<PlacedDrive> drives = all_drives_of(robot);
  VectorXd result = values_of_links(links, drives.size());
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const model::Drive& drive = drives[i].drive;
    result.segment<3>(static_cast<Index>(10 * links.size() + 4 * i))
        << positive_or(drive.rotor_inertia, values, 0),
        positive_or(drive.viscous_friction, values, 0), positive_or(drive.coulomb_friction, values, 0);
  }
  return result;
}

Prior prior_of(const model::Robot& robot, const ArmRegressor& arm, const Estimate& estimate,
               std::optional<double> mass) {
  const model::Bindings values = model::default_bindings(robot);
  std::vector<PseudoInertia> known(robot.joints.size(), PseudoInertia::Zero()), rods = rods_of(robot, values);
  double known_mass = 0;
  Index unknown = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto link = described(robot.joints[i].inertia, values);
    known[i] = link.value_or(PseudoInertia::Zero());
    known_mass += known[i](3, 3);
    if (link) rods[i].setZero();
    if (!link) ++unknown;
  }
  double each = fitting_mass(arm, estimate, known, rods);
  if (mass && unknown > 0 && *mass > known_mass) each = (*mass - known_mass) / static_cast<double>(unknown);
  Prior prior{{}, {}, mass};
  double typical = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    prior.links.push_back(known[i] + each * rods[i]);
    typical += prior.links.back().topLeftCorner<3, 3>().trace() / static_cast<double>(known.size());
  }
  prior.drives = drives_of(robot, values, drive_share * typical);
  return prior;
}

}  // namespace qvgen::identify
