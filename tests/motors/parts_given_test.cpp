// SPDX-License-Identifier: MIT
// Several given joints beside a part of a pose, in C++ and C: rows keep the given values and reach that part,
// the joints that it was made from are there. The reference has equations of its own.
#include <iterator>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/held_level.h>
#include <qvgen/robots/held_pitch.h>
#include <qvgen/robots/held_place.h>
#include <qvgen/robots/held_torch.h>
#include <qvgen/robots/rail_pitch.h>
#include <qvgen/robots/torso_torch.h>
#include <qvgen/robots/turned_level.h>
#include <qvgen_held_level_inverse.h>
#include <qvgen_held_pitch_inverse.h>
#include <qvgen_held_place_inverse.h>
#include <qvgen_held_torch_inverse.h>
#include <qvgen_rail_pitch_inverse.h>
#include <qvgen_torso_torch_inverse.h>
#include <qvgen_turned_level_inverse.h>

#include "reference/load.h"

namespace qvgen::test {
namespace {

using Eigen::Vector3d;
constexpr double pi = 3.14159265358979323846;

/// An arm by the reference's chain, which has a reader of its own.
class Reference {
 public:
  explicit Reference(const std::string& name)
      : chain_(reference::load(std::string(QVGEN_MOTOR_ARMS) + "/" + name + ".toml")) {}
  [[nodiscard]] Eigen::Isometry3d tool(const Eigen::VectorXd& q) const {
    return reference::forward_kinematics(chain_, q);
  }
  [[nodiscard]] Vector3d axis(const Eigen::VectorXd& q, std::size_t joint) const {
    return reference::joint_places(chain_, q)[joint].axis;
  }

 private:
  reference::Chain chain_;
};

struct RailPitch {
  static constexpr const char* name = "rail_pitch";
  static constexpr int dof = 6, given[] = {0, 5};
  static constexpr auto& info = robots::rail_pitch::inverse_info_given_rail_roll;
  using Task = PositionAndPitch<double>;
  using Set = rail_pitch_solutions;
  static Task task(const Reference& arm, const Eigen::VectorXd& q) {
    const Vector3d base = arm.axis(q, 1), across = arm.axis(q, 2), along = arm.tool(q).linear().col(0);
    return {arm.tool(q).translation(), std::atan2(across.dot(base.cross(along)), base.dot(along))};
  }
  static double miss(const Task& a, const Task& b) { return std::remainder(a.pitch - b.pitch, 2 * pi); }
  template <class Asked, class... More>
  static auto solve(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::rail_pitch::inverse_kinematics_given_rail_roll(asked, q[0], q[5], more...);
  }
  template <class Asked, class... More>
  static auto near(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::rail_pitch::inverse_kinematics_near_given_rail_roll(asked, q[0], q[5], more...);
  }
  static void solve_in_c(const Task& task, const Eigen::VectorXd& q, const double* seed, Set* found) {
    rail_pitch_inverse_kinematics_given_rail_roll_of_position_and_pitch(
        task.position.data(), task.pitch, q[0], q[5], seed, nullptr, rail_pitch_default_tolerance, found);
  }
};

struct TurnedLevel {
  static constexpr const char* name = "turned_level";
  static constexpr int dof = 7, given[] = {0, 1};
  static constexpr auto& info = robots::turned_level::inverse_info_given_rail_table;
  using Task = PositionAndInclination<double>;
  using Set = turned_level_solutions;
  static Task task(const Reference& arm, const Eigen::VectorXd& q) {
    return {arm.tool(q).translation(), arm.tool(q).linear().transpose() * arm.axis(q, 2)};
  }
  static double miss(const Task& a, const Task& b) { return (a.up - b.up).norm(); }
  template <class Asked, class... More>
  static auto solve(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::turned_level::inverse_kinematics_given_rail_table(asked, q[0], q[1], more...);
  }
  template <class Asked, class... More>
  static auto near(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::turned_level::inverse_kinematics_near_given_rail_table(asked, q[0], q[1], more...);
  }
  static void solve_in_c(const Task& task, const Eigen::VectorXd& q, const double* seed, Set* found) {
    turned_level_inverse_kinematics_given_rail_table_of_position_and_inclination(
        task.position.data(), task.up.data(), q[0], q[1], seed, nullptr, turned_level_default_tolerance,
        found);
  }
};

struct TorsoTorch {
  static constexpr const char* name = "torso_torch";
  static constexpr int dof = 7, given[] = {0, 6};
  static constexpr auto& info = robots::torso_torch::inverse_info_given_torso_q6;
  using Task = PositionAndDirection<double>;
  using Set = torso_torch_solutions;
  static Task task(const Reference& arm, const Eigen::VectorXd& q) {
    return {arm.tool(q).translation(), arm.tool(q).linear().col(0)};
  }
  static double miss(const Task& a, const Task& b) { return (a.direction - b.direction).norm(); }
  template <class Asked, class... More>
  static auto solve(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::torso_torch::inverse_kinematics_given_torso_q6(asked, q[0], q[6], more...);
  }
  template <class Asked, class... More>
  static auto near(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::torso_torch::inverse_kinematics_near_given_torso_q6(asked, q[0], q[6], more...);
  }
  static void solve_in_c(const Task& task, const Eigen::VectorXd& q, const double* seed, Set* found) {
    torso_torch_inverse_kinematics_given_torso_q6_of_position_and_direction(
        task.position.data(), task.direction.data(), q[0], q[6], seed, nullptr, torso_torch_default_tolerance,
        found);
  }
};

struct HeldPitch {
  static constexpr const char* name = "held_pitch";
  static constexpr int dof = 6, given[] = {2, 5};
  static constexpr auto& info = robots::held_pitch::inverse_info_given_boom_roll;
  using Task = PositionAndPitch<double>;
  using Set = held_pitch_solutions;
  static Task task(const Reference& arm, const Eigen::VectorXd& q) {
    const Vector3d base = arm.axis(q, 0), across = arm.axis(q, 1), along = arm.tool(q).linear().col(0);
    return {arm.tool(q).translation(), std::atan2(across.dot(base.cross(along)), base.dot(along))};
  }
  static double miss(const Task& a, const Task& b) { return std::remainder(a.pitch - b.pitch, 2 * pi); }
  template <class Asked, class... More>
  static auto solve(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::held_pitch::inverse_kinematics_given_boom_roll(asked, q[2], q[5], more...);
  }
  template <class Asked, class... More>
  static auto near(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::held_pitch::inverse_kinematics_near_given_boom_roll(asked, q[2], q[5], more...);
  }
  static void solve_in_c(const Task& task, const Eigen::VectorXd& q, const double* seed, Set* found) {
    held_pitch_inverse_kinematics_given_boom_roll_of_position_and_pitch(
        task.position.data(), task.pitch, q[2], q[5], seed, nullptr, held_pitch_default_tolerance, found);
  }
};

struct HeldLevel {
  static constexpr const char* name = "held_level";
  static constexpr int dof = 7, given[] = {2, 4};
  static constexpr auto& info = robots::held_level::inverse_info_given_boom_knuckle;
  using Task = PositionAndInclination<double>;
  using Set = held_level_solutions;
  static Task task(const Reference& arm, const Eigen::VectorXd& q) {
    return {arm.tool(q).translation(), arm.tool(q).linear().transpose() * arm.axis(q, 0)};
  }
  static double miss(const Task& a, const Task& b) { return (a.up - b.up).norm(); }
  template <class Asked, class... More>
  static auto solve(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::held_level::inverse_kinematics_given_boom_knuckle(asked, q[2], q[4], more...);
  }
  template <class Asked, class... More>
  static auto near(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::held_level::inverse_kinematics_near_given_boom_knuckle(asked, q[2], q[4], more...);
  }
  static void solve_in_c(const Task& task, const Eigen::VectorXd& q, const double* seed, Set* found) {
    held_level_inverse_kinematics_given_boom_knuckle_of_position_and_inclination(
        task.position.data(), task.up.data(), q[2], q[4], seed, &held_level_default_geometry,
        held_level_default_tolerance, found);
  }
};

struct HeldTorch {
  static constexpr const char* name = "held_torch";
  static constexpr int dof = 8, given[] = {0, 3, 5};
  static constexpr auto& info = robots::held_torch::inverse_info_given_table_boom_second;
  using Task = PositionAndDirection<double>;
  using Set = held_torch_solutions;
  static Task task(const Reference& arm, const Eigen::VectorXd& q) {
    return {arm.tool(q).translation(), arm.tool(q).linear().col(0)};
  }
  static double miss(const Task& a, const Task& b) { return (a.direction - b.direction).norm(); }
  template <class Asked, class... More>
  static auto solve(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::held_torch::inverse_kinematics_given_table_boom_second(asked, q[0], q[3], q[5], more...);
  }
  template <class Asked, class... More>
  static auto near(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::held_torch::inverse_kinematics_near_given_table_boom_second(asked, q[0], q[3], q[5],
                                                                               more...);
  }
  static void solve_in_c(const Task& task, const Eigen::VectorXd& q, const double* seed, Set* found) {
    held_torch_inverse_kinematics_given_table_boom_second_of_position_and_direction(
        task.position.data(), task.direction.data(), q[0], q[3], q[5], seed, nullptr,
        held_torch_default_tolerance, found);
  }
};

/// A position, and no more.
struct Place {
  Vector3d position;
};
inline const Vector3d& place_of(const Place& place) { return place.position; }
inline const Pose<double>& place_of(const Pose<double>& pose) { return pose; }

struct HeldPlace {
  static constexpr const char* name = "held_place";
  static constexpr int dof = 5, given[] = {2, 4};
  static constexpr auto& info = robots::held_place::inverse_info_given_boom_roll;
  using Task = Place;
  using Set = held_place_solutions;
  static Task task(const Reference& arm, const Eigen::VectorXd& q) { return {arm.tool(q).translation()}; }
  static double miss(const Task& /*a*/, const Task& /*b*/) { return 0; }
  template <class Asked, class... More>
  static auto solve(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::held_place::inverse_kinematics_given_boom_roll(place_of(asked), q[2], q[4], more...);
  }
  template <class Asked, class... More>
  static auto near(const Asked& asked, const Eigen::VectorXd& q, const More&... more) {
    return robots::held_place::inverse_kinematics_near_given_boom_roll(place_of(asked), q[2], q[4], more...);
  }
  static void solve_in_c(const Task& task, const Eigen::VectorXd& q, const double* seed, Set* found) {
    held_place_inverse_kinematics_given_boom_roll_of_position(task.position.data(), q[2], q[4], seed, nullptr,
                                                              held_place_default_tolerance, found);
  }
};

template <class Arm>
class PartsGiven : public testing::Test {
 protected:
  using Vector = Eigen::Matrix<double, Arm::dof, 1>;
  Reference reference_{Arm::name};

  Vector joints() {
    std::uniform_real_distribution<double> uniform(-3, 3);
    return Vector::NullaryExpr([&] { return uniform(random_); });
  }
  [[nodiscard]] static double way(const Vector& a, const Vector& b) {
    return (a - b).unaryExpr([](double x) { return std::abs(std::remainder(x, 2 * pi)); }).maxCoeff();
  }
  void expect_reached(const Vector& row, const Vector& q, const typename Arm::Task& task) {
    const auto at = Arm::task(reference_, row);
    EXPECT_LT((at.position - task.position).norm(), 1e-9);
    EXPECT_LT(std::abs(Arm::miss(at, task)), 1e-9);
    for (const int i : Arm::given) EXPECT_EQ(row[i], q[i]);
  }

 private:
  std::mt19937 random_{11};
};
using PartArms =
    testing::Types<RailPitch, TurnedLevel, TorsoTorch, HeldPitch, HeldLevel, HeldTorch, HeldPlace>;
TYPED_TEST_SUITE(PartsGiven, PartArms);

TYPED_TEST(PartsGiven, AreToldByTheInfo) {
  EXPECT_EQ(TypeParam::info.given_joint, TypeParam::given[0]);
  EXPECT_EQ(TypeParam::info.more_given, static_cast<int>(std::size(TypeParam::given)) - 1);
}

TYPED_TEST(PartsGiven, RowsReachThePartThatIsAskedFor) {
  for (int k = 0; k < 300; ++k) {
    const auto q = this->joints();
    const auto task = TypeParam::task(this->reference_, q);
    const auto found = TypeParam::solve(task, q);
    ASSERT_EQ(found.status, Status::solved);
    bool is_there = false;
    for (const auto& row : found) {
      this->expect_reached(row.q, q, task);
      is_there = is_there || this->way(row.q, q) < 1e-6;
    }
    EXPECT_TRUE(is_there) << q.transpose();
  }
}

TYPED_TEST(PartsGiven, APoseGivesTheSameRows) {
  for (int k = 0; k < 50; ++k) {
    const auto q = this->joints();
    const auto pose = Pose<double>::from_isometry(this->reference_.tool(q));
    const auto found = TypeParam::solve(pose, q, q);
    ASSERT_FALSE(found.empty());
    EXPECT_LT(this->way(found[0].q, q), 1e-6);
    if (TypeParam::info.task == Task::position_and_direction) continue;  // whole poses alone
    EXPECT_EQ(found.size(), TypeParam::solve(TypeParam::task(this->reference_, q), q).size());
  }
}

TYPED_TEST(PartsGiven, TakeSeedsAndLimits) {
  for (int k = 0; k < 100; ++k) {
    const auto q = this->joints();
    const auto task = TypeParam::task(this->reference_, q);
    const auto seeded = TypeParam::solve(task, q, q);
    ASSERT_FALSE(seeded.empty());
    EXPECT_LT(this->way(seeded[0].q, q), 1e-6);
    const auto near = TypeParam::near(task, q, q);
    ASSERT_EQ(near.size(), 1);
    EXPECT_LT((near[0].q - q).norm(), 1e-6);
    JointLimits<TypeParam::dof> limits{q.array() - 0.05, q.array() + 0.05};
    const auto inside = TypeParam::solve(task, q, q, limits);
    ASSERT_GE(inside.size(), 1);
    EXPECT_LT((inside[0].q - q).norm(), 1e-6);
    const int given = TypeParam::given[1];
    limits.lower[given] = q[given] + 0.01;  // the given value is outside
    EXPECT_TRUE(TypeParam::solve(task, q, q, limits).empty());
  }
}

TYPED_TEST(PartsGiven, CHasTheRowsOfCpp) {
  for (int k = 0; k < 100; ++k) {
    const auto q = this->joints();
    const auto task = TypeParam::task(this->reference_, q);
    const auto wanted = TypeParam::solve(task, q, q);
    typename TypeParam::Set found;
    TypeParam::solve_in_c(task, q, q.data(), &found);
    ASSERT_EQ(found.count, wanted.size());
    for (int i = 0; i < found.count; ++i)
      EXPECT_LT(this->way(Eigen::Map<const typename TestFixture::Vector>(found.rows[i].q), wanted[i].q),
                1e-9);
  }
}

TYPED_TEST(PartsGiven, AreNoneForWhatIsNoNumberOrFar) {
  const auto q = this->joints();
  auto task = TypeParam::task(this->reference_, q);
  for (const int i : TypeParam::given) {
    auto odd = q;
    odd[i] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(TypeParam::solve(task, odd).status, Status::invalid);
  }
  task.position.x() = 1e4;
  EXPECT_EQ(TypeParam::solve(task, q).status, Status::unreachable);
  task.position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(TypeParam::solve(task, q).status, Status::invalid);
}

}  // namespace
}  // namespace qvgen::test
