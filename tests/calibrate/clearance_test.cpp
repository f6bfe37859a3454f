// SPDX-License-Identifier: MIT
// Plans that keep links apart: distances between spheres are those of the tests' own chain, at postures and
// all the way between them, and the plans stay as telling as they can.
#include <complex>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibrate/plan.h"
#include "simulate.h"

namespace calibrate_test {
namespace {

using testing::HasSubstr;

/// A sphere in the frame of its link, as the description has it.
struct Ball {
  std::size_t link;
  Vector3d centre;
  double radius;
};
using Balls = std::vector<Ball>;

SpheresResult read(const std::string& text, const qvgen::model::Robot& robot) {
  const auto path =
      std::filesystem::temp_directory_path() / ("qvgen_spheres_" + std::to_string(::getpid()) + ".csv");
  std::ofstream(path) << text;
  SpheresResult result = read_spheres(path, robot, 1);
  std::filesystem::remove(path);
  return result;
}

std::vector<Sphere> spheres_of(const Scene& scene, const Balls& balls) {
  std::ostringstream text;
  text.precision(17);
  text << "link, x, y, z, radius [mm]\n";
  for (const Ball& each : balls)
    text << each.link << ", " << each.centre[0] << ", " << each.centre[1] << ", " << each.centre[2] << ", "
         << 1e3 * each.radius << "\n";
  const SpheresResult result = read(text.str(), scene.robot);
  EXPECT_TRUE(result.good);
  return result.spheres;
}

/// Returns the least distance between balls of links that are not neighbours, by the tests' own chain.
double least_distance(const Scene& scene, const Balls& balls, const VectorXd& q) {
  std::vector<Vector3d> centres;
  for (const Ball& each : balls) {
    const bool still = each.link == 0;
    const reference::NamedFrame frame{"", still ? 0 : each.link - 1, Isometry3d::Identity()};
    centres.push_back(still ? each.centre : reference::pose_of(scene.nominal, frame, q) * each.centre);
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < balls.size(); ++a)
    for (std::size_t b = 0; b < balls.size(); ++b)
      if (balls[a].link + 1 < balls[b].link)
        least = std::min(least, (centres[a] - centres[b]).norm() - balls[a].radius - balls[b].radius);
  return least;
}

/// Returns the least distance on a straight motion of the joints, by many postures on it.
double least_on_the_way(const Scene& scene, const Balls& balls, const VectorXd& from, const VectorXd& to) {
  constexpr int parts = 300;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= parts; ++k)
    least = std::min(least, least_distance(scene, balls, from + (to - from) * k / parts));
  return least;
}

std::vector<double> list(const VectorXd& q) { return {q.data(), q.data() + q.size()}; }

/// Returns two balls on every link and on the base, anywhere near them.
Balls random_balls(Scene& scene) {
  std::uniform_real_distribution<double> place(-0.15, 0.15), radius(0.02, 0.06);
  Balls balls;
  for (std::size_t link = 0; link <= scene.truth.joints.size(); ++link)
    for (int i = 0; i < 2; ++i)
      balls.push_back({link, Vector3d(place(scene.random), place(scene.random), place(scene.random)),
                       radius(scene.random)});
  return balls;
}

Geometry<double> geometry_of_scene(const Scene& scene) {
  return geometry_of(scene.robot, classes_of(scene.robot));
}

const std::vector<std::string> arms{"ur5", "scara", "puma560", "stanford", "iiwa14"};

TEST(Clearance, DistancesAreTheReferences) {
  for (const std::string& arm : arms) {
    Scene scene = scene_of(arm, 2, 0);
    const Balls balls = random_balls(scene);
    const std::vector<Sphere> spheres = spheres_of(scene, balls);
    const Geometry<double> geometry = geometry_of_scene(scene);
    for (int i = 0; i < 50; ++i) {
      const VectorXd q = random_joints(scene);
      const double least = least_distance(scene, balls, q);
      EXPECT_TRUE(Clearance(geometry, spheres, least - 1e-9).kept_at(list(q))) << arm;
      EXPECT_FALSE(Clearance(geometry, spheres, least + 1e-9).kept_at(list(q))) << arm;
    }
  }
}

TEST(Clearance, NoMeetingOnTheWayIsMissed) {
  int kept = 0, met = 0;
  for (const std::string& arm : arms) {
    Scene scene = scene_of(arm, 3, 0);
    const Balls balls = random_balls(scene);
    const std::vector<Sphere> spheres = spheres_of(scene, balls);
    const Geometry<double> geometry = geometry_of_scene(scene);
    for (int i = 0; i < 60; ++i) {
      const VectorXd from = random_joints(scene), to = from + 0.3 * (random_joints(scene) - from);
      const double least = least_on_the_way(scene, balls, from, to);
      // Once the distance itself, which steps of the motion may touch, and once a centimetre less and more.
      EXPECT_TRUE(Clearance(geometry, spheres, least - 0.01).kept_between(list(from), list(to))) << arm;
      EXPECT_FALSE(Clearance(geometry, spheres, least + 1e-9).kept_between(list(from), list(to))) << arm;
      (Clearance(geometry, spheres, 0).kept_between(list(from), list(to)) ? kept : met) += 1;
    }
  }
  EXPECT_GT(kept, 20);
  EXPECT_GT(met, 20);
}

Plan planned(const Scene& scene, const std::vector<Sphere>& spheres, std::size_t count) {
  DataSet none;
  none.targets = {1};
  const Identifiable can = identifiable(scene.robot, setup_of(none, {}));
  return plan(scene.robot, can, state_without_data(can), none, count,
              Clearance(can.model.geometry, spheres, 0.01));
}

/// Returns the least distance at the postures of a plan and on the ways between them.
double least_of(const Scene& scene, const Balls& balls, const Plan& plan) {
  const auto vector = [](const std::vector<double>& q) -> VectorXd {
    return VectorXd::Map(q.data(), static_cast<Eigen::Index>(q.size()));
  };
  double least = least_distance(scene, balls, vector(plan.postures.front()));
  for (std::size_t i = 1; i < plan.postures.size(); ++i)
    least = std::min(least,
                     least_on_the_way(scene, balls, vector(plan.postures[i - 1]), vector(plan.postures[i])));
  return least;
}

/// The UR5's links in the frames of its table.
const Balls ur5{{1, {0, -0.01, 0}, 0.08},    {2, {0.425, 0, 0.136}, 0.06}, {2, {0.28, 0, 0.136}, 0.06},
                {2, {0.14, 0, 0.136}, 0.06}, {3, {0.392, 0, 0.016}, 0.05}, {3, {0.26, 0, 0.016}, 0.05},
                {3, {0.13, 0, 0.016}, 0.05}, {4, {0, 0, 0}, 0.05},         {5, {0, 0, 0}, 0.05},
                {6, {0, 0, 0}, 0.045},       {0, {0.05, 0, -0.25}, 0.2},   {0, {-0.4, 0.3, 0.2}, 0.15}};

TEST(Clearance, PlansKeepIt) {
  const Scene scene = scene_of("ur5", 1, 0);
  const std::vector<Sphere> spheres = spheres_of(scene, ur5);
  const Plan plan = planned(scene, spheres, 30), any = planned(scene, {}, 30);
  EXPECT_TRUE(plan.touching.empty());
  EXPECT_GE(least_of(scene, ur5, plan), 0.01);
  EXPECT_LT(least_of(scene, ur5, any), 0) << "this arm meets itself in plans without spheres";
  EXPECT_LT(plan.after, 1.3 * any.after) << "what it tells suffers";
  const Plan shorter = planned(scene, spheres, 10);
  EXPECT_TRUE(std::equal(shorter.postures.begin(), shorter.postures.end(), plan.postures.begin()));
}

TEST(Clearance, SpheresThatAlwaysMeetAreLeftOutAndNamed) {
  const Scene scene = scene_of("ur5", 1, 0);
  Balls balls = ur5;
  balls.push_back({0, {0, 0, 0.089}, 0.1});
  balls.push_back({2, {-0.425, 0, 0.136}, 0.05});
  const Plan plan = planned(scene, spheres_of(scene, balls), 5);
  EXPECT_THAT(plan.touching, testing::ElementsAre("the base and link 2"));
  EXPECT_GE(least_of(scene, ur5, plan), 0.01);
}

TEST(Clearance, CrampedArmsAreRefused) {
  std::string text = "name = \"arm\"\ntitle = \"cramped\"\n";
  for (const char* variable : {"t1", "t2", "t3"})
    text += std::string("[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"") + variable +
            "\"\nlink = [0.3, 0, 0]\n";
  const Scene scene = scene_of_text(text, 1, 0);
  // Joints 2 and 3 must both be stretched out to within 3.6 degrees, which happens once in 2500 postures.
  const double reach = std::abs(0.3 + std::polar(0.3, 0.063)), radius = (reach - 0.01) / 2;
  const Balls balls{
      {0, {0, 0, 0}, radius}, {1, {0, 0, 0}, radius}, {2, {0, 0, 0}, radius}, {3, {0, 0, 0}, radius}};
  try {
    planned(scene, spheres_of(scene, balls), 5);
    FAIL() << "there is a plan";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                testing::MatchesRegex("[0-9][0-9]? of 100000 random postures keep the spheres apart: "
                                      "(the base and link 2|link 1 and link 3) meet most often; .*"));
  }
}

TEST(Clearance, MistakesOfTablesHaveTheirLine) {
  const Scene scene = scene_of("ur5", 1, 0);
  const auto mistakes = [&](const std::string& text) {
    const SpheresResult result = read(text, scene.robot);
    std::string all = result.good ? "good" : "";
    for (const auto& each : result.diagnostics) all += to_string(each) + "\n";
    return all;
  };
  const std::string header = "link, x [mm], y [mm], z [mm], radius [mm]\n";
  EXPECT_THAT(mistakes(header + "0, 0, 0, 0, 10\n7, 0, 0, 0, 10\n"),
              HasSubstr("csv:3:1: error: there is no link 7; links are numbered 1 to 6, and 0 is the base"));
  EXPECT_THAT(mistakes(header + "1.5, 0, 0, 0, 10\n"), HasSubstr("csv:2:1: error: there is no link 1.5"));
  EXPECT_THAT(mistakes(header + "1, 0, 0, 0, 0\n"),
              HasSubstr("csv:2:1: error: a sphere with a radius of 0 m"));
  EXPECT_THAT(mistakes("link, x, y, z, radius\n1, 0, 0, 0, 60\n"), HasSubstr("write radius [mm]"));
  EXPECT_THAT(mistakes("link, x, y, z\n1, 0, 0, 0\n"), HasSubstr("radius"));
  EXPECT_THAT(mistakes(header + "1, nan, 0, 0, 10\n"), HasSubstr("csv:2:1: error: 'x' is nan"));
  std::string many = header;
  for (int i = 0; i < 201; ++i) many += "1, 0, 0, 0, 10\n";
  EXPECT_THAT(mistakes(many), HasSubstr("csv:202:1: error: 201 spheres; at most 200 are taken"));
}

/// Links, in order: a base with a pedestal, a moving one with a bracket beside a fixed one of the chain, and
/// a finger that moves beside the chain.
const char* const arm_with_bracket = R"(<robot name="arm">
  <link name="base"><collision><origin xyz="0.1 0 0"/><geometry><sphere radius="0.2"/></geometry></collision></link>
  <link name="pedestal"><collision><geometry><sphere radius="0.3"/></geometry></collision>
    <collision><geometry><box size="1 1 1"/></geometry></collision></link>
  <link name="l1"><collision><origin xyz="0 0 0.05" rpy="1 2 3"/><geometry><sphere radius="0.04"/></geometry></collision></link>
  <link name="mount"/>
  <link name="bracket"><collision><origin xyz="0 0.1 0"/><geometry><sphere radius="0.05"/></geometry></collision></link>
  <link name="l2"><collision><geometry><sphere radius="0.06"/></geometry></collision></link>
  <link name="finger"><collision><geometry><sphere radius="0.07"/></geometry></collision></link>
  <joint name="stand" type="fixed"><parent link="base"/><child link="pedestal"/><origin xyz="0 0 -1"/></joint>
  <joint name="j1" type="continuous"><parent link="base"/><child link="l1"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/></joint>
  <joint name="plate" type="fixed"><parent link="l1"/><child link="mount"/><origin xyz="0 0 0.2" rpy="0 0 1.5707963267948966"/></joint>
  <joint name="hold" type="fixed"><parent link="mount"/><child link="bracket"/><origin xyz="0.4 0 0"/></joint>
  <joint name="j2" type="continuous"><parent link="mount"/><child link="l2"/><origin xyz="0 0 0.5"/><axis xyz="0 1 0"/></joint>
  <joint name="grip" type="prismatic"><parent link="l1"/><child link="finger"/><axis xyz="1 0 0"/><limit lower="0" upper="0.1" effort="1" velocity="1"/></joint>
</robot>)";

TEST(Clearance, UrdfsHaveSpheresOfTheirOwn) {
  const qvgen::description::ReadOptions options{.tip = "l2"};
  const auto found = qvgen::description::read_text(arm_with_bracket, "arm.urdf", options);
  ASSERT_TRUE(found.robot);
  const std::vector<Sphere> spheres = spheres_of_urdf(arm_with_bracket, options, *found.robot);
  const Balls expected{{0, {0.1, 0, 0}, 0.2},
                       {0, {0, 0, -1}, 0.3},
                       {1, {0, 0, 0.05}, 0.04},
                       {1, {-0.1, 0.4, 0.2}, 0.05},
                       {2, {0, 0, 0}, 0.06}};
  ASSERT_EQ(spheres.size(), expected.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    EXPECT_EQ(spheres[i].link, expected[i].link) << i;
    EXPECT_EQ(spheres[i].radius, expected[i].radius) << i;
    EXPECT_LT((Vector3d(spheres[i].centre.data()) - expected[i].centre).norm(), 1e-12) << i;
  }
  EXPECT_TRUE(spheres_of_urdf("name = \"arm\"", options, *found.robot).empty());
  // A joint that is held takes what is behind it along.
  const qvgen::description::ReadOptions held{.tip = "l2", .fixed = {"j1"}};
  const auto with_one = qvgen::description::read_text(arm_with_bracket, "arm.urdf", held);
  ASSERT_TRUE(with_one.robot);
  EXPECT_EQ(spheres_of_urdf(arm_with_bracket, held, *with_one.robot).back().link, 1U);
}

}  // namespace
}  // namespace calibrate_test
