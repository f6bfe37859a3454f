// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "emit/c/function.h"
#include "emit/cpp/dynamics_code.h"
#include "emit/cpp/jacobian_function.h"
#include "optimise/optimise.h"

namespace qvgen::emit::c {

/// A constant of the description and its value there, if it has one.
struct Constant {
  std::string name;
  std::optional<double> value;
};

struct Joint {
  std::string name;
  bool revolute;
  std::optional<std::pair<double, double>> limits;  ///< rad or m
  double greatest_velocity;                         ///< rad/s or m/s, infinite if there is none
  double greatest_effort;                           ///< Nm or N, infinite if there is none
};

/// Joints, and the struct of geometric constants.
Part model(const model::Robot& robot, const std::vector<Joint>& joints,
           const std::vector<Constant>& geometry);
/// How many of something there are and their names, as constants called ROBOT_OF_count and ROBOT_OF_names;
/// `text` is their comment. Nothing for no names.
Part names(const model::Robot& robot, const std::string& of, const std::string& text,
           const std::vector<std::string>& list);
/// The struct of inertial parameters.
Part inertia(const model::Robot& robot, const std::vector<Constant>& parameters);

/// The pose as a quaternion and a position, and the same as a homogeneous transformation; `doc` are the lines
/// of the function's comment.
Part pose(const model::Robot& robot, const optimise::Optimised& optimised,
          const std::vector<std::string>& doc);
Part transform(const model::Robot& robot, const optimise::Optimised& optimised,
               const std::vector<std::string>& doc);

Part jacobian(const model::Robot& robot, const std::vector<JacobianFunction>& functions);
/// Header and source of joint rates for twists; `wrist` are the wrist centre's x, y and z in the tool frame
/// as expressions of C, or nothing.
Part velocity(const model::Robot& robot, const std::vector<std::string>& wrist);
/// The places of frames in what `frame_poses` fills in, and functions of frames.
Part frames(const model::Robot& robot, const std::vector<std::string>& names,
            const std::vector<JacobianFunction>& functions);

/// The derivative of the tool's pose by errors of every frame.
Part geometry_jacobian(const model::Robot& robot, const JacobianFunction& function);

/// Functions of dynamics by the names that they have in operation_counts.json: C knows no overloads.
Part dynamics(const model::Robot& robot, const std::vector<optimise::Optimised>& functions);
Part total_mass(const model::Robot& robot);
/// Centre of mass and its Jacobian of a robot whose base floats, made of its momentum matrix.
Part centroidal(const model::Robot& robot);
Part regressor(const model::Robot& robot, const derive::dynamics::Regressor& regressor,
               const optimise::Optimised& function);
Part regressor_with_drives(const model::Robot& robot, const derive::dynamics::DriveRegressor& regressor,
                           const optimise::Optimised& function);

/// A whole file's header and source, of the parts one behind the other. `missing` are lines.
Part file(const std::string& robot, const Part& parts, const std::vector<std::string>& missing);

}  // namespace qvgen::emit::c
