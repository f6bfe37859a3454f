// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <benchmark/benchmark.h>
#include <qvgen/pose.h>

#include "kdl.h"
#include "reference/chain.h"
#include "reference/load.h"
#include "suite.h"

namespace comparison {

/// Random configurations, uniform in [-pi, pi) or metres in [-1, 1); enough of them that no branch is learnt,
/// few enough to stay in the first-level cache.
template <class Joints>
std::vector<Joints> configurations(const reference::Chain& chain, std::size_t count = 256) {
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Joints> result(count);
  for (Joints& q : result) {
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      q[i] = unit(random) * (chain.joints[static_cast<std::size_t>(i)].revolute ? 3.14159265358979 : 1.0);
    }
  }
  return result;
}

/// Calls `function(i)` for i going round the configurations.
template <class Function>
void measure(const std::string& name, Function function, std::size_t count = 256) {
  add_benchmark(name, [function, count](benchmark::State& state) mutable {
    std::size_t i = 0;
    for (auto _ : state) {
      auto result = function(i);
      benchmark::DoNotOptimize(result);
      i = i + 1 == count ? 0 : i + 1;
    }
  });
  add_counted(name, [function]() mutable {
    for (std::size_t i = 0; i < counted_calls; ++i) {
      auto result = function(i);
      benchmark::DoNotOptimize(result);
    }
  });
}

/// The pose that KDL has given as a position and the rows of a rotation.
inline Eigen::Isometry3d isometry(const double* kdl) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 4>> numbers(kdl);
  Eigen::Isometry3d result;
  result.setIdentity();
  result.translation() = numbers.col(0);
  result.linear() = numbers.rightCols<3>().transpose();
  return result;
}

/// Largest difference in m and rad of what is compared, over all configurations.
template <class Arm>
double disagreement(const reference::Chain& chain, KdlArm& kdl,
                    const std::vector<typename Arm::Joints>& joints) {
  double worst = 0;
  const auto compare = [&](const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
    worst = std::max(worst, (a.matrix() - b.matrix()).cwiseAbs().maxCoeff());
  };
  for (const auto& q : joints) {
    const Eigen::Isometry3d truth = reference::forward_kinematics(chain, q);
    compare(isometry(kdl.forward_kinematics(q.data())), truth);
    compare(Arm::forward_kinematics(q).isometry(), truth);
    compare(Arm::forward_kinematics(q, Arm::angles(q)).isometry(), truth);
    compare(Arm::homogeneous_transform(q), truth);
  }
  return worst;
}

/// Checks and registers the benchmarks of one arm. Names: quantity, then robot, then variant.
template <class Arm>
bool add_arm() {
  add_setup([] {
    using Joints = typename Arm::Joints;
    using Angles = typename Arm::Angles;
    const std::string robot = Arm::name;
    const reference::Chain chain = load_robot(robot);
    const auto joints = std::make_shared<std::vector<Joints>>(configurations<Joints>(chain));
    const auto kdl = std::make_shared<KdlArm>(description_of(robot));
    require_agreement(robot, disagreement<Arm>(chain, *kdl, *joints));

    // The angles behind the sines and cosines, so that a scalar library can be timed on the same work.
    const auto given = std::make_shared<std::vector<Angles>>();
    const auto plain = std::make_shared<std::vector<Angles>>();
    for (const Joints& q : *joints) {
      given->push_back(Arm::angles(q));
      plain->push_back(given->back());
      for (std::size_t i = 0; i < plain->back().sine.size(); ++i) {
        plain->back().sine[i] = std::atan2(given->back().sine[i], given->back().cosine[i]);
      }
    }

    const std::string pose = "forward kinematics/" + robot + "/";
    measure(pose + "KDL", [=](std::size_t i) { return kdl->forward_kinematics((*joints)[i].data()); });
    measure(pose + "qvgen", [=](std::size_t i) { return Arm::forward_kinematics((*joints)[i]); });
    measure(pose + "qvgen matrix", [=](std::size_t i) { return Arm::homogeneous_transform((*joints)[i]); });
    measure(pose + "qvgen libm", [=](std::size_t i) {
      Angles angles;
      for (std::size_t j = 0; j < angles.sine.size(); ++j) {
        const double angle = (*plain)[i].sine[j];  // read once: one call gives both
        angles.sine[j] = std::sin(angle);
        angles.cosine[j] = std::cos(angle);
      }
      return Arm::forward_kinematics((*joints)[i], angles);
    });
    measure(pose + "qvgen given",
            [=](std::size_t i) { return Arm::forward_kinematics((*joints)[i], (*given)[i]); });
  });
  return true;
}

}  // namespace comparison
