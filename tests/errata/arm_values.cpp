// SPDX-License-Identifier: MIT
#include "arm_values.h"

#include <vector>

#include <Eigen/Geometry>

namespace qvgen::test::sources {
namespace {

using Eigen::Vector3d;

/// The rotation of one joint is by less than half a turn, which tells a quaternion from its opposite.
Pair pair_of(const Eigen::Isometry3d& motion) {
  const Eigen::Quaterniond q(motion.linear());
  const double sign = q.w() < 0 ? -1 : 1;
  return {{sign * q.w(), sign * q.vec()}, motion.translation()};
}

/// The displacement of each link from the one before.
std::vector<Pair> links(const reference::Chain& chain, const Eigen::VectorXd& q) {
  const std::vector<Eigen::Isometry3d> frames = reference::frames(chain, q);
  std::vector<Pair> result;
  Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    result.push_back(pair_of(before.inverse() * frames[i]));
    before = frames[i];
  }
  return result;
}

/// Under a name for the whole and one for each of the seven components.
void add_product(const std::string& name, const Pair& pair, Known& known) {
  known[name] = pair;
  const std::size_t letters = 1;
  known[name.substr(0, letters) + "P" + name.substr(letters)] = pair.p;
  known[name.substr(0, letters) + "V" + name.substr(letters)] = pair.q.v;
  known[name + "1"] = pair.q.s;
  for (int i = 0; i < 3; ++i) {
    known[name + std::to_string(i + 2)] = pair.q.v[i];
    known[name + std::to_string(i + 5)] = pair.p[i];
  }
}

void add_pose(const Pair& pose, Known& known) {
  const char* const rotation[] = {"a", "b", "c"};
  const char* const position[] = {"px", "py", "pz"};
  const char* const vector[] = {"vi16", "vj16", "vk16"};
  known["Q16"] = pose;
  known["s16"] = known["w"] = pose.q.s;
  known["p16"] = pose.p;
  for (int i = 0; i < 3; ++i) {
    known[rotation[i]] = known[vector[i]] = pose.q.v[i];
    known[position[i]] = known[std::string(position[i]) + "16"] = pose.p[i];
  }
}

}  // namespace

Known arm_values(const reference::Chain& chain, const reference::Values& lengths, const Eigen::VectorXd& q) {
  Known known;
  for (const auto& [name, value] : lengths) known[name] = value;
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    known[chain.joints[i].variable] = q[static_cast<Eigen::Index>(i)];
  const std::vector<Pair> link = links(chain, q);
  Pair product;
  for (std::size_t i = link.size(); i > 0; --i) {
    known["Q" + std::to_string(i)] = link[i - 1];
    known["q" + std::to_string(i)] = link[i - 1].q;
    known["p" + std::to_string(i)] = link[i - 1].p;
    product = link[i - 1] * product;
    add_product("M" + std::to_string(i), product, known);
  }
  add_pose(product, known);
  for (std::size_t i = 1; i <= link.size(); ++i) {
    add_product("N" + std::to_string(i), product, known);
    product = inverse(link[i - 1]) * product;
  }
  return known;
}

}  // namespace qvgen::test::sources
