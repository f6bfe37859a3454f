// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <qvgen/inverse/solutions.h>

#include "arm_benchmarks.h"
#include "kdl_inverse.h"
#include "reference/chain.h"

namespace comparison {

/// A pose with the joints that it was made from; `start` is where iterative solvers begin.
template <class Arm>
struct Goal {
  typename Arm::Joints q, start;
  qvgen::Pose<double> pose;
  std::array<double, 12> numbers;  ///< of the pose, as KDL's
};

template <class Arm>
std::vector<Goal<Arm>> goals(const reference::Chain& chain, KdlArm& kdl, std::size_t count) {
  const auto q = configurations<typename Arm::Joints>(chain, count);
  std::vector<Goal<Arm>> result;
  for (std::size_t i = 0; i < q.size(); ++i) {
    Goal<Arm> goal{q[i], q[(i + 85) % q.size()], Arm::forward_kinematics(q[i]), {}};
    std::copy_n(kdl.forward_kinematics(q[i].data()), 12, goal.numbers.begin());
    result.push_back(goal);
  }
  return result;
}

/// Each pose moved away from the base until it is out of reach by a billionth; empty if the arm reaches
/// everything.
template <class Arm>
std::vector<qvgen::Pose<double>> just_unreachable(const std::vector<Goal<Arm>>& all) {
  std::vector<qvgen::Pose<double>> result;
  for (const Goal<Arm>& goal : all) {
    const auto moved = [&](double factor) {
      return qvgen::Pose<double>{goal.pose.orientation, factor * goal.pose.position};
    };
    const auto is_reached = [&](double factor) { return !Arm::inverse_kinematics(moved(factor)).empty(); };
    double inside = 1;
    double outside = 1000;
    if (is_reached(outside)) return {};
    while (outside - inside > 1e-12 * inside) {
      const double middle = (inside + outside) / 2;
      (is_reached(middle) ? inside : outside) = middle;
    }
    result.push_back(moved(outside * (1 + 1e-9)));
    if (is_reached(outside * (1 + 1e-9))) return {};
  }
  return result;
}

/// Statistics of the solutions of all poses: how many, how far off, whether the sampled joints are among
/// them.
struct Agreement {
  double solutions = 0;  ///< a pose
  double error = 0;      ///< largest difference of position (m) or of an entry of the rotation matrix
  bool complete = true;  ///< and the same in both forms
};

/// The branches in lanes and one after the other give the same bits.
template <class Arm>
bool forms_agree(const qvgen::Pose<double>& pose) {
  const auto fastest = Arm::inverse_kinematics(pose);
  const auto scalar = Arm::inverse_kinematics(pose, qvgen::inverse::Form::scalar);
  bool same = fastest.size() == scalar.size();
  for (int i = 0; same && i < fastest.size(); ++i) same = fastest[i].q == scalar[i].q;
  return same;
}

template <class Arm>
Agreement agreement(const reference::Chain& chain, const std::vector<Goal<Arm>>& all) {
  Agreement result;
  for (const Goal<Arm>& goal : all) {
    const Eigen::Isometry3d truth = reference::forward_kinematics(chain, goal.q);
    const auto found = Arm::inverse_kinematics(goal.pose);
    bool contains = false;
    for (const auto& row : found) {
      const Eigen::Isometry3d reached = reference::forward_kinematics(chain, row.q);
      result.error = std::max(result.error, (reached.matrix() - truth.matrix()).cwiseAbs().maxCoeff());
      double distance = 0;
      for (Eigen::Index i = 0; i < row.q.size(); ++i) {
        const double difference = row.q[i] - goal.q[i];
        const bool revolute = chain.joints[static_cast<std::size_t>(i)].revolute;
        distance = std::max(
            distance,
            std::abs(revolute ? std::remainder(difference, 2 * 3.14159265358979323846) : difference));
      }
      contains = contains || distance < 1e-6;
    }
    result.complete = result.complete && contains && forms_agree<Arm>(goal.pose);
    result.solutions += found.size() / static_cast<double>(all.size());
  }
  return result;
}

/// The share of the poses that a method reaches to 1e-5, judged by the reference.
template <class Arm, class Method>
double share_reached(const reference::Chain& chain, const std::vector<Goal<Arm>>& all, KdlInverse& kdl,
                     Method method) {
  double reached = 0;
  for (const Goal<Arm>& goal : all) {
    if (method(goal) < 0) continue;
    const Eigen::VectorXd joints = Eigen::Map<const Eigen::VectorXd>(kdl.result(), chain.size());
    const Eigen::Isometry3d pose = reference::forward_kinematics(chain, joints);
    const Eigen::Isometry3d truth = reference::forward_kinematics(chain, goal.q);
    reached += (pose.matrix() - truth.matrix()).cwiseAbs().maxCoeff() < 1e-5 ? 1 : 0;
  }
  return reached / static_cast<double>(all.size());
}

/// More than a branch predictor learns by heart, since a robot's next pose is one that it has not seen.
inline constexpr std::size_t poses_in_turn = 1024;

/// All solutions of random reachable poses, the branches one after the other and in lanes, and poses just out
/// of reach, against one solution by KDL's iterations.
template <class Arm>
bool add_arm_inverse() {
  add_setup([] {
    const std::string robot = Arm::name;
    const reference::Chain chain = load_robot(robot);
    KdlArm model(description_of(robot));
    const auto all = std::make_shared<std::vector<Goal<Arm>>>(goals<Arm>(chain, model, poses_in_turn));
    const auto outside = std::make_shared<std::vector<qvgen::Pose<double>>>(just_unreachable(*all));
    const auto kdl = std::make_shared<KdlInverse>(description_of(robot));
    const auto lma = [kdl](const Goal<Arm>& goal) {
      return kdl->levenberg_marquardt(goal.start.data(), goal.numbers.data());
    };
    const auto newton = [kdl](const Goal<Arm>& goal) {
      return kdl->newton(goal.start.data(), goal.numbers.data());
    };
    const Agreement found = agreement(chain, goals<Arm>(chain, model, 20000));
    require_agreement(robot + " inverse kinematics", found.complete ? found.error : 1);
    std::fprintf(stderr,
                 "%s: %.4f solutions a pose; KDL LMA finds one of %.0f %%, NR of %.0f %% of the poses\n",
                 robot.c_str(), found.solutions, 100 * share_reached(chain, *all, *kdl, lma),
                 100 * share_reached(chain, *all, *kdl, newton));

    const std::string name = "inverse kinematics/" + robot + "/";
    measure(
        name + "KDL LMA", [=](std::size_t i) { return lma((*all)[i]); }, poses_in_turn);
    measure(
        name + "KDL NR", [=](std::size_t i) { return newton((*all)[i]); }, poses_in_turn);
    measure(
        name + "scalar",
        [=](std::size_t i) { return Arm::inverse_kinematics((*all)[i].pose, qvgen::inverse::Form::scalar); },
        poses_in_turn);
    if (Arm::has_lanes) {
      measure(
          name + "lanes", [=](std::size_t i) { return Arm::inverse_kinematics((*all)[i].pose); },
          poses_in_turn);
    }
    if (!outside->empty()) {
      measure(
          name + "out of reach", [=](std::size_t i) { return Arm::inverse_kinematics((*outside)[i]); },
          poses_in_turn);
    }
  });
  return true;
}

}  // namespace comparison
