// SPDX-License-Identifier: MIT
// Which elements of M_i = N_i a step of the inverse kinematics names: with the joints that are known by then
// no other joint but the step's own moves what it compares. Frames are the reference's.
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "derive/inverse/inverse.h"
#include "description/reader.h"
#include "reference/load.h"

namespace qvgen::test {
namespace {

using derive::inverse::Step;
using Eigen::Vector3d;
using Eigen::VectorXd;
using reference::Isometry3d;

std::string file_of(const std::string& robot) {
  return std::string(QVGEN_SOURCE_DIR "/generator/robots/") + robot + ".toml";
}

/// The point of one line that is nearest to another.
Vector3d nearest(const reference::JointPlace& of, const reference::JointPlace& to) {
  const Vector3d normal = of.axis.cross(to.axis);
  const double along = (to.point - of.point).cross(to.axis).dot(normal) / normal.squaredNorm();
  return of.point + along * of.axis;
}

/// An arm whose last three axes meet, both sides of M_i = N_i moved apart.
class Arm {
 public:
  explicit Arm(const std::string& robot) : chain_(lengths(robot)) {
    for (Eigen::Index i = 0; i < 6; ++i) q_[i] = number_(random_);
    wrist_ = wrist(q_);
  }

  /// True if joint j moves what the step compares.
  bool moves(Eigen::Index j, const Step& step) {
    const Eigen::Index i = step.elements.joint;
    const double before = compared(q_, step, j < i ? wrist_ : wrist(q_));
    VectorXd other = q_;
    other[j] += 0.7;
    return std::abs(compared(other, step, j < i ? wrist_ : wrist(other)) - before) > 1e-9;
  }

 private:
  static reference::Chain lengths(const std::string& robot) {
    reference::Values values;
    const auto described = description::read_file(file_of(robot), {}).robot;
    double length = 0.3;
    for (const model::Parameter& symbol : described->geometry) values[symbol.name] = length += 0.13;
    return reference::load(file_of(robot), values);
  }

  Vector3d wrist(const VectorXd& q) const {
    const auto places = reference::joint_places(chain_, q);
    return nearest(places[3], places[4]);
  }

  /// The wrist's centre from the frame of joint i, whose axis it sees as the model gives it.
  Vector3d seen(const VectorXd& q, Eigen::Index i, const Vector3d& point) const {
    const auto at = static_cast<std::size_t>(i);
    const Isometry3d frame =
        (i == 0 ? chain_.base : reference::frames(chain_, q)[at - 1]) * chain_.joints[at].before;
    return frame.inverse() * point;
  }

  /// One element; of two or three the distance from where the axis meets another, which the step may turn.
  double compared(const VectorXd& q, const Step& step, const Vector3d& point) const {
    const auto& [joint, indices] = step.elements;
    Vector3d vector = seen(q, joint, point);
    if (indices.size() == 3) {
      const auto places = reference::joint_places(chain_, q);
      const std::size_t other = step.joint == 0 ? 2 : 0;
      vector -= seen(q, joint, nearest(places[static_cast<std::size_t>(joint)], places[other]));
    }
    if (indices.size() == 1) return vector[indices.front() - 5];
    double square = 0;
    for (const int index : indices) square += vector[index - 5] * vector[index - 5];
    return square;
  }

  std::mt19937 random_{7};
  std::uniform_real_distribution<double> number_{0.3, 1.2};
  reference::Chain chain_;
  VectorXd q_ = VectorXd::Zero(6);
  Vector3d wrist_;
};

class Elements : public testing::TestWithParam<const char*> {};

TEST_P(Elements, NamedByAStepHoldItsJointAndKnownOnes) {
  const auto robot = description::read_file(file_of(GetParam()), {}).robot;
  const auto derivation = derive::inverse::derive(*robot);
  ASSERT_TRUE(derivation.found);
  Arm arm(GetParam());
  std::set<Eigen::Index> known;
  int vectors = 0;
  for (const Step& step : derivation.plan.steps) {
    if (step.wrist() != nullptr) {
      EXPECT_EQ(step.elements.joint, 3);
      EXPECT_EQ(step.elements.indices, (std::vector<int>{1, 2, 3, 4}));
    } else if (step.joint >= 0) {
      ASSERT_TRUE(step.elements.of_vector()) << step.unknown;
      known.insert(step.joint);
      for (Eigen::Index j = 0; j < 6; ++j)
        EXPECT_TRUE(known.count(j) == 1 || !arm.moves(j, step)) << step.unknown << ", joint " << j + 1;
      EXPECT_TRUE(arm.moves(step.joint, step) || step.elements.joint == step.joint) << step.unknown;
      ++vectors;
    }
  }
  EXPECT_EQ(vectors, 3);
}

INSTANTIATE_TEST_SUITE_P(SixteenCodesAndOthers, Elements,
                         testing::Values("ss", "sc", "sn", "sr", "cs", "cc", "cn", "cr", "ns", "nc", "nn",
                                         "nr", "rs", "rc", "rn", "rr", "puma560", "stanford", "poe_6r",
                                         "irb6640"),
                         [](const auto& arm) { return std::string(arm.param); });

}  // namespace
}  // namespace qvgen::test
