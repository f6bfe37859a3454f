// SPDX-License-Identifier: MIT
// Limbs that are images of each other in mirrors: random chains, copied, mirrored and renamed, are found and
// derived once; their poses, of numbers, are each other's seen in the mirror. What differs by anything else
// is derived on its own.
#include "pipeline/images.h"

#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "model/arithmetic.h"
#include "model/evaluate.h"
#include "model/image.h"

namespace qvgen::pipeline {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using model::Displacement;
using model::Expression;
using model::Robot;
using model::Vector3;

class RandomLimb {
 public:
  explicit RandomLimb(unsigned seed) : random_(seed) {}

  Robot limb() {
    Robot robot;
    robot.name = "robot_1";
    robot.base = displacement();
    robot.tool = displacement();
    const int joints = 1 + number(6);
    for (int i = 0; i < joints; ++i) {
      model::Joint joint;
      joint.variable = "one" + std::to_string(i);
      joint.type = number(3) == 0 ? model::JointType::prismatic : model::JointType::revolute;
      joint.axis = number(3) == 0
                       ? Vector3{cln::cl_RA(3) / 5, cln::cl_RA(0), cln::cl_RA(4) / 5}
                       : model::unit_vector(static_cast<std::size_t>(number(3)), number(2) == 0 ? 1 : -1);
      joint.before = displacement();
      joint.after = displacement();
      robot.joints.push_back(joint);
    }
    return robot;
  }

  /// The limb in the mirror, with other names. Axes of joints and turns are turned over at random.
  Robot image(const Robot& of, const std::array<int, 3>& mirror, const std::string& name) {
    Robot robot = of;
    robot.name = "robot_" + name;
    const int sense = mirror[0] * mirror[1] * mirror[2];
    const auto seen = [&](const Vector3& v, int sign) {
      Vector3 result;
      for (std::size_t i = 0; i < 3; ++i) result[i] = sign * mirror[i] > 0 ? v[i] : model::negate(v[i]);
      return result;
    };
    const auto see = [&](Displacement& displacement) {
      displacement.translation = seen(displacement.translation, 1);
      for (model::Turn& turn : displacement.turns) {
        const int over = number(2) == 0 ? 1 : -1;
        turn.axis = seen(turn.axis, over * sense);
        if (over < 0) turn.angle = model::negate(turn.angle);
      }
    };
    see(robot.base);
    see(robot.tool);
    if (number(2) == 0)  // axes of the tool turned over
      robot.tool.turns.push_back({model::unit_vector(static_cast<std::size_t>(number(3))), Expression::pi()});
    for (model::Joint& joint : robot.joints) {
      joint.variable = name + joint.variable.substr(3);
      see(joint.before);
      see(joint.after);
      joint.axis = seen(joint.axis, number(2) == 0 ? 1 : -1);
    }
    return robot;
  }

  std::array<int, 3> mirror() {
    const auto sign = [&] { return number(2) == 0 ? 1 : -1; };
    return {sign(), sign(), sign()};
  }
  int number(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  double angle() { return std::uniform_real_distribution<double>(-3, 3)(random_); }

 private:
  Expression length() { return cln::cl_RA(number(2) == 0 ? 0 : number(400) - 200) / 1000; }
  Displacement displacement() {
    Displacement result;
    for (int k = number(3); k > 0; --k) {
      const Expression angle = number(2) == 0
                                   ? model::multiply(cln::cl_RA(number(7) - 3) / 2, Expression::pi())
                                   : Expression(cln::cl_RA(number(100) + 1) / 100);
      result.turns.push_back({model::unit_vector(static_cast<std::size_t>(number(3))), angle});
    }
    result.translation = {length(), length(), length()};
    return result;
  }

  std::mt19937 random_;
};

double number_of(const Expression& e) { return model::to_double(model::evaluate(e)); }
Vector3d numbers_of(const Vector3& v) { return {number_of(v[0]), number_of(v[1]), number_of(v[2])}; }

Isometry3d moved(const Displacement& displacement) {
  Isometry3d result = Isometry3d::Identity();
  for (const model::Turn& turn : displacement.turns)
    result.rotate(Eigen::AngleAxisd(number_of(turn.angle), numbers_of(turn.axis)));
  result.translation() = numbers_of(displacement.translation);
  return result;
}

Isometry3d pose_of(const Robot& robot, const std::vector<double>& q) {
  Isometry3d pose = moved(robot.base);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const model::Joint& joint = robot.joints[i];
    pose = pose * moved(joint.before);
    if (joint.type == model::JointType::revolute)
      pose.rotate(Eigen::AngleAxisd(q[i], numbers_of(joint.axis)));
    else
      pose.translate(q[i] * numbers_of(joint.axis));
    pose = pose * moved(joint.after);
  }
  return pose * moved(robot.tool);
}

TEST(Images, OfRandomLimbsAreFoundAndHaveThePosesSeenInTheMirror) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    RandomLimb random(seed);
    const Robot limb = random.limb();
    const Robot other = random.image(limb, random.mirror(), "two");
    const auto image = model::image_of(limb, other);
    ASSERT_TRUE(image) << seed;
    EXPECT_EQ(image->name, "robot_two");
    std::vector<double> q, seen;
    for (std::size_t i = 0; i < limb.joints.size(); ++i) {
      EXPECT_EQ(image->variables[i], "two" + std::to_string(i));
      q.push_back(random.angle());
      seen.push_back(image->signs[i] * q.back());
    }
    const Vector3d mirror(image->mirror[0], image->mirror[1], image->mirror[2]);
    const Isometry3d there = pose_of(limb, seen), here = pose_of(other, q);
    EXPECT_TRUE(here.translation().isApprox(mirror.asDiagonal() * there.translation(), 1e-12)) << seed;
    const Vector3d tool(image->tool[0], image->tool[1], image->tool[2]);
    EXPECT_TRUE(here.linear().isApprox(mirror.asDiagonal() * there.linear() * tool.asDiagonal(), 1e-12))
        << seed;
  }
}

TEST(Images, DifferBySignsAlone) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    RandomLimb random(seed);
    const Robot limb = random.limb();
    Robot longer = random.image(limb, random.mirror(), "two");
    Expression& length = longer.joints.back().after.translation[1];
    length = model::add(length, cln::cl_RA(1) / 3);
    EXPECT_FALSE(model::image_of(limb, longer)) << seed;
    Robot slides = random.image(limb, random.mirror(), "two");
    slides.joints.front().type = limb.joints.front().type == model::JointType::revolute
                                     ? model::JointType::prismatic
                                     : model::JointType::revolute;
    EXPECT_FALSE(model::image_of(limb, slides)) << seed;
    Robot asks = random.image(limb, random.mirror(), "two");
    asks.inverse.task = model::Task::position;
    EXPECT_FALSE(model::image_of(limb, asks)) << seed;
  }
}

/// Stands in for the products: a header for each robot and, of some parts, for its images.
class Derivations {
 public:
  std::vector<RobotOutput> operator()(const std::vector<Original>& robots, bool serves_images) {
    std::vector<RobotOutput> outputs;
    for (const auto& [robot, images] : robots) {
      ++count;
      RobotOutput output{robot.name};
      const auto add = [&output](const std::string& name, const std::string& header) {
        output.files.push_back({"include/qvgen/robots/" + name + "/" + header, ""});
      };
      add(robot.name, "model.h");
      add(robot.name, "kinematics.h");
      output.missing.push_back({"inverse", Missing::Kind::not_derived, "name one0, or two"});
      for (const model::Image& image : images)
        if (serves_images) add(image.name, "kinematics.h");
      outputs.push_back(output);
    }
    return outputs;
  }
  int count = 0;
};

std::vector<Robot> equal_limbs(RandomLimb& random, int count) {
  std::vector<Robot> limbs{random.limb()};
  for (int k = 1; k < count; ++k)
    limbs.push_back(random.image(limbs[0], random.mirror(), std::string(1, static_cast<char>('a' + k))));
  return limbs;
}

TEST(Images, EqualLimbsAreDerivedOnce) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    RandomLimb random(seed);
    std::vector<Robot> robots = equal_limbs(random, 2 + random.number(4));
    Derivations derivations;
    int finished = 0;
    const auto outputs = derived_once(
        robots, std::vector<std::string>(robots.size(), "robot"),
        [&](const std::vector<Original>& some) { return derivations(some, true); },
        [&](const std::string&) { ++finished; });
    EXPECT_EQ(derivations.count, 1);
    EXPECT_EQ(finished + 1, static_cast<int>(robots.size()));
    ASSERT_EQ(outputs.size(), robots.size());
    for (std::size_t i = 0; i < robots.size(); ++i) {
      EXPECT_EQ(outputs[i].robot, robots[i].name);
      for (const OutputFile& file : outputs[i].files)
        EXPECT_NE(file.path.find("/" + robots[i].name + "/"), std::string::npos) << file.path;
      EXPECT_EQ(outputs[i].missing.at(0).reason, "name " + robots[i].joints[0].variable + ", or two");
    }
  }
}

TEST(Images, WhatHasNoHeaderOfTheirsIsDerivedForEach) {
  RandomLimb random(1);
  std::vector<Robot> robots = equal_limbs(random, 3);
  robots.push_back(random.limb());
  robots.back().name = "robot_other";
  const auto derivations_of = [&](const std::string& limb_of, bool serves_images) {
    Derivations derivations;
    const auto derive = [&](const std::vector<Original>& some) { return derivations(some, serves_images); };
    for (const RobotOutput& output :
         derived_once(robots, std::vector<std::string>(robots.size(), limb_of), derive, {}))
      EXPECT_EQ(output.files.size(), 2U) << output.robot;
    return derivations.count;
  };
  EXPECT_EQ(derivations_of("robot", true), 2);
  EXPECT_EQ(derivations_of("robot", false), 4);
  EXPECT_EQ(derivations_of("", true), 4);  // robots of their own
}

}  // namespace
}  // namespace qvgen::pipeline
