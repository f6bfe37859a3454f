// SPDX-License-Identifier: MIT
// The joint torques of an arm as a linear function of parameters that motions can tell apart, tau = Y(q, q',
// q'') p, ready to be evaluated over a log. Derived as for the generated `regressor_with_drives`, with the
// numbers of the description put in.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "derive/dynamics/drive_parameters.h"
#include "identify/tape.h"
#include "model/robot.h"

namespace qvgen::identify {

using derive::dynamics::DriveParameter;

/// Standard parameters of a link: mass, first moments x y z, inertia about the origin of the link frame
/// xx yy zz xy yz xz.
inline constexpr Eigen::Index standard_count = 10;

/// Columns that no description has (extra_columns.h).
enum class ExtraKind { stribeck, viscous_by_temperature, coulomb_by_temperature };
struct ExtraColumn {
  std::size_t joint;  ///< index among those that follow none
  ExtraKind kind;
};

struct ArmRegressor {
  std::size_t joints = 0;              ///< joints that follow none, and motors: rows of Y, torques
  std::size_t links = 0;               ///< of the whole chain
  std::vector<std::string> motors;     ///< that are no joints, in the description's order
  std::vector<std::string> names;      ///< of the identifiable parameters p: "Sxx2", "hx3", "Ia3", "fv1", ...
  std::vector<DriveParameter> drives;  ///< kinds that the joints are taken to have
  /// p = combination * x, with x the standard parameters of all links, then the drive parameters of all
  /// joints, then those of the motors that are no joints.
  Eigen::MatrixXd combination;
  /// Sentences on drive parameters that show as parts of others only.
  std::vector<std::string> left_out;
  /// Outputs y<row>_<column>, column by column; inputs q, q', q'' and directions of rates, each by joint.
  Tape tape;
  /// For each joint the columns that are not zero for every motion.
  std::vector<std::vector<Eigen::Index>> columns;
  std::vector<ExtraColumn> extra = {};  ///< the last columns, which the tape does not compute
  Eigen::VectorXd stribeck_rate = {};   ///< rad/s or m/s, a joint each
  double temperature = 0;               ///< degrees Celsius, at which friction is what the drives have

  [[nodiscard]] Eigen::Index parameters() const { return static_cast<Eigen::Index>(names.size()); }
  /// Parameters of bodies and drives, which come first.
  [[nodiscard]] Eigen::Index plain() const { return parameters() - static_cast<Eigen::Index>(extra.size()); }
  [[nodiscard]] Eigen::Index standard() const { return static_cast<Eigen::Index>(links) * standard_count; }
  /// How many drives there are: of joints, then of motors that are no joints.
  [[nodiscard]] std::size_t drive_units() const { return links + motors.size(); }
  /// Returns the name of such a drive: the joint's number, from 1, or the motor's name.
  [[nodiscard]] std::string drive_name(std::size_t unit) const {
    return unit < links ? std::to_string(unit + 1) : motors.at(unit - links);
  }
};

/// Returns the names of the motors that are no joints.
std::vector<std::string> names_of_motors(const model::Robot& robot);

/// The kinds of drive parameters, all four.
std::vector<DriveParameter> all_drives();

/// Derives the regressor; gravity in m/s^2 along the world's -z. Throws std::runtime_error if a length of the
/// description has no value.
ArmRegressor arm_regressor(const model::Robot& described, const std::vector<DriveParameter>& drives,
                           double gravity = 9.80665);

}  // namespace qvgen::identify
