// SPDX-License-Identifier: MIT
// A model for Pinocchio's headers, of the numbers that peers.py has taken from Pinocchio's reader: a line a
// joint. (Its compiled reader cannot be linked where vectors are wider than in its package.)
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

#include <pinocchio/multibody.hpp>

namespace qvgen::benchmark::trees {

/// The joint types that the robots of the benchmark have.
inline std::size_t add_joint(pinocchio::Model& model, const std::string& type, std::size_t parent,
                             const pinocchio::SE3& at, const std::string& name) {
  if (type == "JointModelFreeFlyer")
    return model.addJoint(parent, pinocchio::JointModelFreeFlyer(), at, name);
  if (type == "JointModelRX") return model.addJoint(parent, pinocchio::JointModelRX(), at, name);
  if (type == "JointModelRY") return model.addJoint(parent, pinocchio::JointModelRY(), at, name);
  if (type == "JointModelRZ") return model.addJoint(parent, pinocchio::JointModelRZ(), at, name);
  throw std::runtime_error("no joint of the type " + type + " is known here");
}

inline pinocchio::Model read_model(const std::string& file) {
  std::ifstream in(file);
  std::string name, type;
  pinocchio::Model model;
  model.gravity.linear(Eigen::Vector3d(0, 0, -9.80665));
  std::size_t parent = 0;
  while (in >> name >> type >> parent) {
    Eigen::Matrix3d rotation, inertia;
    Eigen::Vector3d position, centre;
    double mass = 0;
    const auto read = [&](auto& values) {
      for (Eigen::Index i = 0; i < values.rows(); ++i)
        for (Eigen::Index j = 0; j < values.cols(); ++j) in >> values(i, j);
    };
    read(rotation);
    read(position);
    in >> mass;
    read(centre);
    read(inertia);
    const auto joint = add_joint(model, type, parent, pinocchio::SE3(rotation, position), name);
    model.appendBodyToJoint(joint, pinocchio::Inertia(mass, centre, inertia), pinocchio::SE3::Identity());
  }
  return model;
}

}  // namespace qvgen::benchmark::trees
