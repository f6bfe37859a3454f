// SPDX-License-Identifier: MIT
// The sequence of Paden and Kahan's subproblems that `show --inverse` prints: its points and axes, read as a
// reader would, put through the runtime's subproblems in its order, find the joints of random poses.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/paden_kahan.h>

#include "description/reader.h"
#include "emit/math/describe.h"
#include "pipeline/products/inverse_derivation.h"
#include "printed.h"
#include "reference/load.h"

namespace qvgen::test {
namespace {

using namespace reference;
using Joints = Eigen::Matrix<double, 6, 1>;

std::vector<std::string> lines_of(const std::string& robot) {
  const auto described = description::read_file(file_of(robot)).robot.value();
  const auto derivation = pipeline::derive_inverse(described);
  return emit::describe(derivation.closed_forms.at(0), emit::Notation::text);
}

/// "    W = <x, y, z>" -> "W = [ x, y, z ]"; nothing else of the lines.
std::vector<std::string> vectors_in(const std::vector<std::string>& lines) {
  std::vector<std::string> found;
  for (const std::string& line : lines) {
    const std::size_t begin = line.find_first_not_of(' ');
    const std::size_t open = line.find(" = <");
    if (open == std::string::npos || line.back() != '>') continue;
    found.push_back(line.substr(begin, open - begin) + " = [ " +
                    line.substr(open + 4, line.size() - open - 5) + " ]");
  }
  return found;
}

std::vector<std::string> steps_in(const std::vector<std::string>& lines) {
  std::vector<std::string> steps;
  for (const std::string& line : lines)
    if (const std::size_t at = line.find(": subproblem "); at != std::string::npos)
      steps.push_back(line.substr(0, at + 14));
  return steps;
}

/// The arm as printed, and the sequence with all of its branches.
class Sequence {
 public:
  Sequence(const std::vector<std::string>& lines, const Values& values)
      : printed_(vectors_in(lines), values) {
    for (int i = 0; i < 6; ++i) {
      const std::string index = "_" + std::to_string(i + 1);
      axes_.push_back({printed_.vector("omega" + index), printed_.vector(i < 3 ? "r" + index : "W")});
    }
  }

  std::vector<Joints> solve(const Isometry3d& motion) {
    found_.clear();
    const Vector3d wrist = printed_.vector("W");
    const Vector3d goal = motion * wrist;
    if (printed_.has("S_x"))
      by_shoulder(motion, wrist, goal, printed_.vector("S"));
    else
      by_parallel_pair(motion, wrist, goal);
    return found_;
  }

 private:
  [[nodiscard]] Isometry3d e(std::size_t i, double angle) const {
    Isometry3d turn = Isometry3d::Identity();
    turn.translate(axes_[i].point);
    turn.rotate(Eigen::AngleAxisd(angle, axes_[i].direction));
    turn.translate(-axes_[i].point);
    return turn;
  }

  void by_shoulder(const Isometry3d& motion, const Vector3d& w, const Vector3d& p, const Vector3d& s) {
    for (const auto& third : paden_kahan_3(axes_[2], w, s, (p - s).norm()))
      for (const auto& both :
           paden_kahan_2(axes_[0].direction, axes_[1].direction, s, (e(2, third[0]) * w).eval(), p))
        turn_wrist(motion, w, both[0], both[1], third[0]);
  }

  void by_parallel_pair(const Isometry3d& motion, const Vector3d& w, const Vector3d& p) {
    const Vector3d r1 = axes_[0].point;
    const Vector3d r2 = axes_[1].point;
    const Vector3d along = axes_[1].direction;
    const double square = (p - r1).squaredNorm() - 2 * along.dot(w - r1) + 1;
    for (const auto& back : paden_kahan_3(axes_[0], p, (r1 + along).eval(), std::sqrt(square))) {
      const Vector3d left = e(0, back[0]) * p;
      for (const auto& third : paden_kahan_3(axes_[2], w, r2, (left - r2).norm()))
        for (const auto& second : paden_kahan_1(axes_[1], (e(2, third[0]) * w).eval(), left))
          turn_wrist(motion, w, -back[0], second[0], third[0]);
    }
  }

  void turn_wrist(const Isometry3d& motion, const Vector3d& w, double q1, double q2, double q3) {
    const Isometry3d rest = (e(0, q1) * e(1, q2) * e(2, q3)).inverse() * motion;
    const Vector3d on_axis = w + axes_[5].direction;
    const Vector3d beside = w + axes_[4].direction;
    for (const auto& both :
         paden_kahan_2(axes_[3].direction, axes_[4].direction, w, on_axis, (rest * on_axis).eval())) {
      const Vector3d to = (e(3, both[0]) * e(4, both[1])).inverse() * rest * beside;
      for (const auto& last : paden_kahan_1(axes_[5], beside, to))
        found_.push_back((Joints() << q1, q2, q3, both[0], both[1], last[0]).finished());
    }
  }

  Printed printed_;
  std::vector<TurnAxis<double>> axes_;
  std::vector<Joints> found_;
};

class SubproblemsOf : public testing::TestWithParam<const char*> {};

TEST_P(SubproblemsOf, FindTheJointsOfPoses) {
  const auto lines = lines_of(GetParam());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.3, 1.2);
  Values values;
  const auto described = description::read_file(file_of(GetParam())).robot.value();
  for (const model::Parameter& parameter : described.geometry) values[parameter.name] = uniform(random);
  const Chain chain = load(file_of(GetParam()), values);
  Sequence sequence(lines, values);
  for (int pose = 0; pose < 20; ++pose) {
    Joints q;
    for (double& angle : q) angle = 2 * uniform(random) - 1.5;
    const Isometry3d goal = forward_kinematics(chain, q);
    const auto found = sequence.solve(goal * forward_kinematics(chain, Joints::Zero()).inverse());
    EXPECT_GE(found.size(), 2U);
    bool has_it = false;
    for (const Joints& other : found) {
      EXPECT_TRUE(forward_kinematics(chain, other).isApprox(goal, 1e-6)) << other.transpose();
      has_it = has_it || (other - q).array().abs().maxCoeff() < 1e-5;
    }
    EXPECT_TRUE(has_it) << q.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Arms, SubproblemsOf, testing::Values("poe_6r", "puma560", "rx90", "nn"),
                         [](const auto& arm) { return std::string(arm.param); });

TEST(Subproblems, AreNamedInTheirOrder) {
  using Steps = std::vector<std::string>;
  EXPECT_EQ(steps_in(lines_of("poe_6r")),
            (Steps{"theta1: subproblem 3", "theta3: subproblem 3", "theta2: subproblem 1",
                   "theta4, theta5: subproblem 2", "theta6: subproblem 1"}));
  EXPECT_TRUE(steps_in(lines_of("ur5")).empty()) << "an arm without a spherical wrist";
  EXPECT_TRUE(steps_in(lines_of("stanford")).empty()) << "an arm with a slide";
}

}  // namespace
}  // namespace qvgen::test
