// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "reference/chain.h"
#include "reference/expression.h"

/// Closed loops in numbers: gaps between points of links, by homogeneous matrices, and motions that keep them
/// closed, by multipliers. Nothing is solved for joints here but by Newton's steps.
namespace reference {

/// Two points of links: together, or a length apart. Of a weld and a slide the links themselves are together,
/// but for the way along the slide's line.
struct Closure {
  std::array<Eigen::Index, 2> links{-1, -1};  ///< joints that move them, -1: the base
  std::array<Vector3d, 2> points{};           ///< in the links' frames
  double length = 0;                          ///< of a rod; 0: the points are one
  Eigen::Index length_joint = -1;             ///< slide whose value is the length of a rod, -1: none
  bool is_rigid = false;                      ///< a weld or a slide
  Eigen::Matrix3d turn;                       ///< of such: the second link as seen from the first
  std::optional<Vector3d> line = {};          ///< of a slide, in the first link's frame
  [[nodiscard]] bool is_rod() const { return length > 0 || length_joint >= 0; }
};

/// A joint that follows others: its value is a sum of theirs, each times a factor, and a constant.
struct Gear {
  Eigen::Index joint = 0;
  std::vector<std::pair<Eigen::Index, double>> leaders;
  double offset = 0;            ///< rad or m
  std::string polynomial = {};  ///< of the only leader, in place of factor and offset
  std::string variable = {};    ///< of that, in the polynomial
};

/// Every joint has a value of its own here. Motors are the last joints, and move nothing.
struct LoopMechanism {
  Chain chain;
  std::vector<Closure> closures;
  std::vector<Gear> gears;
  std::vector<Eigen::Index> driven, outputs, passive;
  double size = 1;  ///< m: all lengths together
};

LoopMechanism load_loops(const std::filesystem::path& file, const Values& values = {});

/// Three gaps for points that are one, m (two across the line of a slide), and a rotation vector for links
/// that are, in the world's frame; for a rod how much longer it is than it should be; at the end one for each
/// joint that follows others.
VectorXd gaps(const LoopMechanism& mechanism, const VectorXd& q);
/// Puts joints that follow others where those are.
VectorXd followed(const LoopMechanism& mechanism, VectorXd q);
/// Value of a joint that follows, and its derivative by a leader: that of a polynomial by differences, of
/// which four in a row are exact up to the eighth power.
double value_of(const Gear& gear, const VectorXd& q);
double derivative_of(const Gear& gear, const std::pair<Eigen::Index, double>& leader, const VectorXd& q);
/// Derivatives of the gaps by all joints, by cross products; that of a rotation vector is the angular
/// velocity.
MatrixXd gap_jacobian(const LoopMechanism& mechanism, const VectorXd& q);

/// A pose, in the world's frame, that a frame has to be in.
struct Reached {
  NamedFrame frame;
  Isometry3d pose;
};

/// Joints other than the given ones (indices) at which all gaps vanish and, if asked for, a frame is in its
/// pose, from many starts: each once, angles in (-pi, pi].
std::vector<VectorXd> assemblies(const LoopMechanism& mechanism, const VectorXd& q,
                                 const std::vector<Eigen::Index>& given, int starts, unsigned seed,
                                 const std::optional<Reached>& reached = {});

/// Accelerations of all joints under forces of all joints, with multipliers that hold the loops together.
VectorXd constrained_acceleration(const LoopMechanism& mechanism, const VectorXd& q, const VectorXd& qd,
                                  const VectorXd& forces);

}  // namespace reference
