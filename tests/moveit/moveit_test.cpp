// SPDX-License-Identifier: MIT
// The emitted plugins through MoveIt's interface, against homogeneous matrices. Never inside MoveIt itself.
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <moveit/kinematics_base/kinematics_base.h>
#include <pluginlib/class_list_macros.hpp>

#include "reference/chain.h"
#include "reference/load.h"

namespace {

using Numbers = std::vector<double>;
using Pose = geometry_msgs::msg::Pose;
using ErrorCode = moveit_msgs::msg::MoveItErrorCodes;
using kinematics::KinematicsBase;
using moveit::core::JointModel;

constexpr double infinity = std::numeric_limits<double>::infinity();
const Numbers limits_of_joints{2.9, 2.1, 2.9, 2.8, 2.9, 3.5, 2.7};  // rad, of both signs

Pose message_of(const Eigen::Isometry3d& place) {
  const Eigen::Quaterniond q(place.linear());
  const Eigen::Vector3d p = place.translation();
  return {{p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z(), q.w()}};
}

Eigen::Isometry3d place_of(const Pose& message) {
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  const auto& [x, y, z, w] = message.orientation;
  place.linear() = Eigen::Quaterniond(w, x, y, z).toRotationMatrix();
  place.translation() << message.position.x, message.position.y, message.position.z;
  return place;
}

Eigen::VectorXd vector_of(const Numbers& q) {
  return Eigen::Map<const Eigen::VectorXd>(q.data(), Eigen::Index(q.size()));
}

double distance(const Numbers& a, const Numbers& b) {
  return (vector_of(a) - vector_of(b)).lpNorm<Eigen::Infinity>();
}

struct Arm {
  const char* name;
  int given;  ///< the joint that a search chooses, -1 for none
};

class MoveIt : public testing::TestWithParam<Arm> {
 protected:
  reference::Chain chain =
      reference::load(QVGEN_SOURCE_DIR "/generator/robots/" + std::string(GetParam().name) + ".toml");
  std::size_t dof = chain.joints.size();
  std::shared_ptr<moveit::core::RobotModel> model = model_of(limits_of_joints, 0);
  std::unique_ptr<KinematicsBase> plugin = loaded();
  bool has_given = GetParam().given >= 0;
  std::size_t given = has_given ? static_cast<std::size_t>(GetParam().given) : 0;
  std::mt19937 random{1};

  [[nodiscard]] Eigen::Isometry3d tool(const Numbers& q) const {
    return reference::forward_kinematics(chain, vector_of(q));
  }

  /// `off`: how far the model's tip is from where the arm has it, m.
  std::shared_ptr<moveit::core::RobotModel> model_of(const Numbers& limits, double off,
                                                     int slide = -1) const {
    std::vector<JointModel> joints;
    for (std::size_t i = 0; i < dof; ++i)
      joints.emplace_back("joint_" + std::to_string(i + 1),
                          int(i) == slide ? JointModel::PRISMATIC : JointModel::REVOLUTE,
                          moveit::core::VariableBounds{-limits[i], limits[i], limits[i] < infinity});
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
    base.translation() << 1, 2, 3;
    const auto place = [this, base, off](const std::string& link, const Numbers& q) {
      if (link == "base") return base;
      const Eigen::Isometry3d moved = base * Eigen::Translation3d(0, 0, off);
      return link == "tool0" ? moved * tool(q) : moved * reference::frames(chain, vector_of(q))[1];
    };
    return std::make_shared<moveit::core::RobotModel>(
        joints, std::vector<std::string>{"base", "link_2", "tool0"}, place);
  }

  static std::unique_ptr<KinematicsBase> made() {
    const auto& classes = pluginlib::exported<KinematicsBase>();
    return classes.at("qvgen_" + std::string(GetParam().name) + "_kinematics::Plugin")();
  }
  static bool initialize(KinematicsBase& plugin, const moveit::core::RobotModel& model,
                         const std::string& group = "arm", const std::vector<std::string>& tips = {"tool0"}) {
    return plugin.initialize(std::make_shared<rclcpp::Node>(), model, group, "base", tips, 0.1);
  }
  [[nodiscard]] std::unique_ptr<KinematicsBase> loaded() const {
    auto made_plugin = made();
    EXPECT_TRUE(initialize(*made_plugin, *model)) << rclcpp::last_error;
    return made_plugin;
  }

  Numbers random_joints(double share = 0.95) {
    Numbers q;
    for (std::size_t i = 0; i < dof; ++i)
      q.push_back(std::uniform_real_distribution<double>(-share, share)(random) * limits_of_joints[i]);
    return q;
  }
  Numbers beside(Numbers q, double by) {
    for (double& each : q) each += std::uniform_real_distribution<double>(-by, by)(random);
    return q;
  }

  void expect_solution(const Numbers& q, const Pose& pose) const {
    ASSERT_EQ(q.size(), dof);
    EXPECT_TRUE(tool(q).isApprox(place_of(pose), 1e-9)) << vector_of(q).transpose();
    for (std::size_t i = 0; i < dof; ++i) EXPECT_LE(std::abs(q[i]), limits_of_joints[i]);
  }
};

TEST_P(MoveIt, TakesTheGroupsJoints) {
  EXPECT_EQ(plugin->getJointNames().size(), dof);
  EXPECT_EQ(plugin->getJointNames()[1], "joint_2");
  EXPECT_EQ(plugin->getLinkNames(), std::vector<std::string>{"tool0"});
}

TEST_P(MoveIt, RefusesAnotherArm) {
  const auto refuses = [](const moveit::core::RobotModel& other, const std::string& why,
                          const std::string& group = "arm",
                          const std::vector<std::string>& tips = {"tool0"}) {
    rclcpp::last_error.clear();
    EXPECT_FALSE(initialize(*made(), other, group, tips));
    EXPECT_NE(rclcpp::last_error.find(why), std::string::npos) << rclcpp::last_error;
  };
  refuses(*model, "no such group", "leg");
  refuses(*model, "one tip", "arm", {"tool0", "link_2"});
  refuses(*model, "base and tip", "arm", {"link_2"});
  refuses(*model, "base and tip", "arm", {"elbow"});
  refuses(*model_of(limits_of_joints, 1e-3), "base and tip");
  refuses(*model_of(limits_of_joints, 0, 2), "a joint's type");
  auto plugin_of_similar = made();
  EXPECT_TRUE(initialize(*plugin_of_similar, *model_of(limits_of_joints, 1e-5)));
  dof -= 1;
  const auto smaller = model_of(limits_of_joints, 0);
  refuses(*smaller, "the number of joints");
}

TEST_P(MoveIt, PlacesLinks) {
  for (int i = 0; i < 20; ++i) {
    const Numbers q = random_joints();
    std::vector<Pose> poses;
    ASSERT_TRUE(plugin->getPositionFK({"tool0", "link_2"}, q, poses));
    ASSERT_EQ(poses.size(), 2U);
    EXPECT_TRUE(place_of(poses[0]).isApprox(tool(q), 1e-12));
    EXPECT_TRUE(place_of(poses[1]).isApprox(reference::frames(chain, vector_of(q))[1], 1e-12));
    EXPECT_FALSE(plugin->getPositionFK({"elbow"}, q, poses));
    EXPECT_FALSE(plugin->getPositionFK({"tool0"}, Numbers(dof + 1), poses));
  }
}

TEST_P(MoveIt, FindsTheSolutionNextToTheSeed) {
  for (int i = 0; i < 200; ++i) {
    const Numbers q = random_joints();
    Numbers seed = beside(q, 0.01), solution;
    if (has_given) seed[given] = q[given];
    const Pose pose = message_of(tool(q));
    ErrorCode error;
    ASSERT_TRUE(plugin->getPositionIK(pose, seed, solution, error));
    EXPECT_EQ(error.val, ErrorCode::SUCCESS);
    expect_solution(solution, pose);
    EXPECT_LT(distance(solution, seed), 0.5);
    if (has_given) {
      EXPECT_EQ(solution[given], seed[given]);
    }
  }
}

TEST_P(MoveIt, FindsSolutionsFarFromTheSeed) {
  for (int i = 0; i < 200; ++i) {
    const Pose pose = message_of(tool(random_joints()));
    Numbers solution;
    ErrorCode error;
    ASSERT_TRUE(plugin->searchPositionIK(pose, random_joints(), 1, solution, error));
    expect_solution(solution, pose);
  }
}

TEST_P(MoveIt, AsksTheCallback) {
  const Pose pose = message_of(tool(random_joints(0.5)));
  const Numbers seed = random_joints(0.5);
  ErrorCode error;
  Numbers first, solution;
  ASSERT_TRUE(plugin->getPositionIK(pose, seed, first, error));
  std::vector<Numbers> asked;
  const auto third = [&](const Pose& asked_pose, const Numbers& q, ErrorCode& code) {
    expect_solution(q, pose);
    EXPECT_EQ(asked_pose.position.x, pose.position.x);
    asked.push_back(q);
    code.val = asked.size() == 3 ? ErrorCode::SUCCESS : -12;
  };
  ASSERT_TRUE(plugin->searchPositionIK({pose}, seed, 10, {}, solution, third, error));
  EXPECT_EQ(error.val, ErrorCode::SUCCESS);
  ASSERT_EQ(asked.size(), 3U);
  EXPECT_EQ(solution, asked[2]);
  EXPECT_EQ(asked[0], first);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT(distance(asked[i], asked[k]), 1e-6);
}

TEST_P(MoveIt, EndsWhenNothingIsAccepted) {
  const Pose pose = message_of(tool(random_joints(0.5)));
  const Numbers seed = random_joints(0.5);
  ErrorCode error;
  Numbers solution{1, 2};
  int asked = 0;
  const auto none = [&asked](const Pose&, const Numbers&, ErrorCode& code) {
    ++asked;
    code.val = -12;
  };
  EXPECT_FALSE(plugin->searchPositionIK(pose, seed, 100, solution, none, error));
  EXPECT_EQ(error.val, ErrorCode::NO_IK_SOLUTION);
  EXPECT_EQ(solution, (Numbers{1, 2}));
  EXPECT_GT(asked, !has_given ? 1 : 50);
  const int of_all = asked;
  EXPECT_FALSE(plugin->searchPositionIK(pose, seed, -1, solution, none, error));
  EXPECT_EQ(error.val, ErrorCode::TIMED_OUT);
  if (has_given) {
    EXPECT_LT(asked - of_all, of_all / 5);
  }
  asked = 0;
  kinematics::KinematicsQueryOptions locked;
  locked.lock_redundant_joints = true;
  EXPECT_FALSE(plugin->searchPositionIK(pose, seed, 100, solution, none, error, locked));
  EXPECT_LE(asked, 16);
}

TEST_P(MoveIt, KeepsToTheConsistencyLimits) {
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const Numbers q = random_joints(), seed = beside(q, 0.1), near(dof, 0.15);
    const Pose pose = message_of(tool(q));
    Numbers solution;
    ErrorCode error;
    if (!plugin->searchPositionIK(pose, seed, 1, near, solution, error)) continue;
    ++found;
    expect_solution(solution, pose);
    EXPECT_LE(distance(solution, seed), 0.15);
  }
  EXPECT_GT(found, !has_given ? 90 : 50);
  ErrorCode error;
  Numbers solution;
  EXPECT_FALSE(plugin->searchPositionIK(message_of(tool(random_joints())), random_joints(), 1,
                                        Numbers(dof, 1e-6), solution, error));
  EXPECT_FALSE(
      plugin->searchPositionIK(message_of(tool(random_joints())), random_joints(), 1, {1}, solution, error));
}

TEST_P(MoveIt, GivesAllSolutions) {
  const Pose pose = message_of(tool(random_joints(0.5)));
  const Numbers seed = random_joints(0.5);
  std::vector<Numbers> solutions;
  kinematics::KinematicsResult result;
  ASSERT_TRUE(plugin->getPositionIK(std::vector<Pose>{pose}, seed, solutions, result, {}));
  EXPECT_EQ(result.solution_percentage, 1);
  const std::size_t of_one_value = solutions.size();
  for (const Numbers& q : solutions) expect_solution(q, pose);
  kinematics::KinematicsQueryOptions options;
  options.discretization_method = kinematics::DiscretizationMethods::ALL_DISCRETIZED;
  ASSERT_TRUE(plugin->getPositionIK(std::vector<Pose>{pose}, seed, solutions, result, options));
  std::set<double> values;
  for (const Numbers& q : solutions) {
    expect_solution(q, pose);
    if (has_given) values.insert(q[given]);
  }
  if (!has_given)
    EXPECT_EQ(solutions.size(), of_one_value);
  else
    EXPECT_GT(values.size(), 10U);
  options.discretization_method = kinematics::DiscretizationMethods::ALL_RANDOM_SAMPLED;
  EXPECT_FALSE(plugin->getPositionIK(std::vector<Pose>{pose}, seed, solutions, result, options));
  EXPECT_EQ(result.kinematic_error, kinematics::KinematicErrors::UNSUPORTED_DISCRETIZATION_REQUESTED);
  EXPECT_FALSE(plugin->getPositionIK(std::vector<Pose>{pose, pose}, seed, solutions, result, {}));
  EXPECT_EQ(result.kinematic_error, kinematics::KinematicErrors::MULTIPLE_TIPS_NOT_SUPPORTED);
}

TEST_P(MoveIt, SaysWhatCannotBeReached) {
  Pose far = message_of(tool(random_joints()));
  far.position.x += 10;
  Pose broken = far;
  broken.orientation.w = std::nan("");
  ErrorCode error;
  Numbers solution;
  for (const Pose& pose : {far, broken}) {
    EXPECT_FALSE(plugin->getPositionIK(pose, random_joints(), solution, error));
    EXPECT_EQ(error.val, ErrorCode::NO_IK_SOLUTION);
  }
  EXPECT_FALSE(plugin->getPositionIK(message_of(tool(random_joints())), {0, 0}, solution, error));
}

TEST_P(MoveIt, ContinuousJointsStayBesideTheSeed) {
  model = model_of(Numbers(dof, infinity), 0);
  plugin = loaded();
  Numbers q = random_joints(), solution;
  q[0] += 4 * std::acos(-1.0);
  Numbers seed = beside(q, 0.01);
  if (has_given) seed[given] = q[given];
  ErrorCode error;
  ASSERT_TRUE(plugin->getPositionIK(message_of(tool(q)), seed, solution, error));
  EXPECT_LT(distance(solution, q), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Arms, MoveIt, testing::Values(Arm{"puma560", -1}, Arm{"iiwa14", 2}),
                         [](const auto& arm) { return arm.param.name; });

}  // namespace
