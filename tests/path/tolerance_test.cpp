// SPDX-License-Identifier: MIT
// Tolerances of a path: kept at the samples and between them, by matrices that share nothing with the
// library; none at all is the path itself; a motion within them costs no more than one without, and is there
// where the path itself cannot be followed; the way back is like the way.
#include <Eigen/Geometry>
#include <qvgen/robots/iiwa14.h>
#include <qvgen/robots/iiwa14/arm_angle.h>

#include "free_paths.h"

namespace path_test {
namespace {

using Matrix = Eigen::Matrix3d;

Matrix matrix_of(const Pose<double>& pose) {
  const auto& q = pose.orientation;
  return Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized().toRotationMatrix();
}

/// How the tool is off from where it should be, in the frame where it should be.
struct Off {
  Eigen::Vector3d way, turn;
  Off(const Pose<double>& reached, const Pose<double>& wanted) {
    const Matrix frame = matrix_of(wanted);
    way = frame.transpose() * (reached.position - wanted.position);
    const Eigen::AngleAxisd about(Matrix(frame.transpose() * matrix_of(reached)));
    turn = about.angle() * about.axis();
    tilt = std::acos(std::min(1.0, frame.col(2).dot(matrix_of(reached).col(2))));
  }
  double tilt;  ///< of the tool's z axis
};

const JointLimits<6> usual{Values::Constant(-2.8), Values::Constant(2.8)};

/// Calls with the pose that is wanted and the joints, at the samples and at places between them.
void for_each_place(const AnyArm& arm, const FreeRequest<6>& request, const Result& result,
                    const std::function<void(const Pose<double>& wanted, const Values& q)>& see) {
  const Curve curve = curve_of(request.path);
  for (std::size_t i = 0; i + 1 < result.places.size(); ++i) {
    const auto &a = result.places[i], &b = result.places[i + 1];
    Values here = a.q;
    for (int k = 0; k < 16; ++k) {
      const double u = k / 16.0, s = static_cast<double>(i) + u;
      const auto found = arm.solve(request.freedoms.moved(curve.at(s), a.values + u * (b.values - a.values)));
      const Nearest next = Nearest::of(found, here, arm.revolute);
      ASSERT_LT(next.first, 0.1) << s;
      here += difference(found[next.row].q, here, arm.revolute);
      see(curve.at(s), here);
    }
    ASSERT_LT((b.q - here).cwiseAbs().maxCoeff(), 0.1) << i;
  }
}

TEST(Tolerance, AConeIsKeptEverywhere) {
  std::mt19937 random(3);
  int followed = 0;
  for (int i = 0; i < path_count(6); ++i) {
    const AnyArm& arm = arm_called(i % 2 == 0 ? "ur5" : "irb6640").arm;
    const auto request = request_of(random_path(arm, random, 40, 0.3), usual, {{"cone_z", -0.2, 0.2}});
    const Result result = best_of(arm, request);
    if (result.followed < 39) continue;
    ++followed;
    double widest = 0;
    for_each_place(arm, request, result, [&](const Pose<double>& wanted, const Values& q) {
      ASSERT_TRUE((q.cwiseAbs().array() <= 2.8 + 1e-9).all());
      const Off off(arm.forward(q), wanted);
      ASSERT_LT(off.way.norm(), 1e-8);
      ASSERT_LE(off.tilt, 0.2 + 1e-7);
      ASSERT_LT(std::abs(off.turn.z()), 1e-7);  // without tool_z it does not turn about its axis
      widest = std::max(widest, off.tilt);
    });
    EXPECT_GT(widest, 0.02);  // what is free is used
  }
  EXPECT_GT(followed, 2);
}

TEST(Tolerance, ABoxIsKeptEverywhere) {
  std::mt19937 random(4);
  int followed = 0;
  for (int i = 0; i < path_count(4); ++i) {
    const AnyArm& arm = arm_called(i % 2 == 0 ? "ur5" : "stanford").arm;
    const auto request =
        request_of(random_path(arm, random, 30, 0.3), usual,
                   {{"shift_x", -0.004, 0.001}, {"shift_z", -0.002, 0.003}, {"tool_y", -0.01, 0.06}});
    const Result result = best_of(arm, request);
    if (result.followed < 29) continue;
    ++followed;
    for_each_place(arm, request, result, [&](const Pose<double>& wanted, const Values& q) {
      const Off off(arm.forward(q), wanted);
      const Eigen::Vector3d low(-0.004, 0, -0.002), high(0.001, 0, 0.003);
      ASSERT_TRUE((off.way.array() >= low.array() - 1e-8).all() &&
                  (off.way.array() <= high.array() + 1e-8).all());
      ASSERT_LT(std::abs(off.turn.x()) + std::abs(off.turn.z()), 1e-7);
      ASSERT_TRUE(off.turn.y() >= -0.01 - 1e-7 && off.turn.y() <= 0.06 + 1e-7);
    });
  }
  EXPECT_GT(followed, 1);
}

/// The joints of a motion that follows the whole path are among those of all motions.
void expect_among(const Result& result, const Whole& whole) {
  std::vector<bool> is_same(static_cast<std::size_t>(whole.record.tracks()), true);
  for (std::size_t i = 0; i < result.places.size(); ++i)
    for (std::size_t track = 0; track < is_same.size(); ++track) {
      Values q;
      is_same[track] = is_same[track] && whole.record.at(i, static_cast<int>(track), q) &&
                       distance(q, result.places[i].q, arm_called("ur5").arm.revolute) < 1e-9;
    }
  EXPECT_NE(std::find(is_same.begin(), is_same.end(), true), is_same.end());
}

TEST(Tolerance, NoneAtAllIsThePathItself) {
  std::mt19937 random(5);
  const AnyArm& arm = arm_called("ur5").arm;
  for (int i = 0; i < path_count(6); ++i) {
    const auto samples = random_path(arm, random, 40, 0.3);
    const Whole whole(arm, samples, usual);
    bool is_followed = false;
    const auto take = [&](const Motion& motion) {
      is_followed = is_followed || (motion.begin.s <= 0 && motion.end.s >= 39);
    };
    MotionsOf<Whole::capacity, decltype(take)>(whole.record, usual, arm.revolute, take).run();
    for (const std::vector<Named>& none :
         {std::vector<Named>{{"cone_z", 0, 0}}, {{"shift_x", 0, 0}, {"base_z", 0, 0}, {"tool_y", 0, 0}}}) {
      const Result result = best_of(arm, request_of(samples, usual, none));
      EXPECT_EQ(result.followed >= 39, is_followed) << i;
      if (result.followed >= 39) expect_among(result, whole);
    }
  }
}

/// Returns the cost of a motion, by the words of the documentation.
double cost_of(const Result& result, const JointLimits<6>& limits) {
  double sum = 0;
  for (std::size_t i = 0; i < result.places.size(); ++i) {
    const auto& place = result.places[i];
    for (int k = 0; k < 6; ++k) {
      const double half = (limits.upper[k] - limits.lower[k]) / 2;
      const double room = std::min(place.q[k] - limits.lower[k], limits.upper[k] - place.q[k]) / half;
      sum += 0.02 / (1 + 100 * room * room);
    }
    if (i == 0) continue;
    const auto& before = result.places[i - 1];
    sum += (place.q - before.q).squaredNorm() + 0.1 * (place.values - before.values).squaredNorm();
  }
  return sum;
}

TEST(Tolerance, MoreFreedomNeverCostsMore) {
  std::mt19937 random(6);
  int compared = 0;
  for (int i = 0; i < path_count(6); ++i) {
    const AnyArm& arm = arms()[static_cast<std::size_t>(i) % 3].arm;
    const auto samples = random_path(arm, random, 30, 0.3);
    const Result fixed = best_of(arm, request_of(samples, usual, {{"cone_z", 0, 0}}));
    if (fixed.followed < 29) continue;
    ++compared;
    for (const std::vector<Named>& free : {std::vector<Named>{{"cone_z", -0.1, 0.1}},
                                           {{"shift_x", -0.01, 0.01}, {"tool_z", -0.3, 0.1}},
                                           {{"tool_z"}, {"cone_z", -0.1, 0.1}}}) {
      const Result result = best_of(arm, request_of(samples, usual, free));
      EXPECT_EQ(result.followed, 29);
      EXPECT_LE(cost_of(result, usual), cost_of(fixed, usual) * (1 + 1e-12));
      EXPECT_NEAR(result.cost, cost_of(result, usual), 1e-9);
    }
  }
  EXPECT_GT(compared, 1);
}

/// A line whose middle is two millimetres beyond the reach.
TEST(Tolerance, AnExcursionBeyondReachIsCut) {
  const AnyArm& arm = arm_called("ur5").arm;
  const auto pose = [](double x, double y) { return Pose<double>{{0, 1, 0, 0}, {x, y, 0.2}}; };
  double inside = 0.5, outside = 1.2;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (inside + outside);
    (arm.solve(pose(middle, 0)).size() > 0 ? inside : outside) = middle;
  }
  std::vector<Pose<double>> samples;
  for (int i = 0; i <= 60; ++i) {
    const double u = (i - 30) / 30.0;
    samples.push_back(pose(inside + 0.002 - 0.01 * u * u, 0.05 * u));
  }
  EXPECT_LT(best_of(arm, request_of(samples, no_limits(), {{"cone_z", 0, 0}})).followed, 30);
  for (const char* name : {"shift_x", "base_x"})
    EXPECT_EQ(best_of(arm, request_of(samples, no_limits(), {{name, -0.005, 0.005}, {"tool_y", -0.02, 0.02}}))
                  .followed,
              60);
}

/// The last joint would leave its limit by 0.05 rad; a turn of the tool within 0.1 rad spares that.
TEST(Tolerance, AnExcursionBeyondALimitIsCut) {
  const AnyArm& arm = arm_called("ur5").arm;
  std::vector<Pose<double>> samples;
  for (int i = 0; i <= 40; ++i) {
    Values q;
    q << 0.3 + 0.002 * i, -1.2, 1.4, -0.5, 0.8, 1 - 1e-4 * (i - 20) * (i - 20);
    samples.push_back(arm.forward(q));
  }
  JointLimits<6> limits;  // of one posture
  limits.lower << 0.1, -1.7, 0.9, -1, 0.3, 0.5;
  limits.upper << 0.6, -0.7, 1.9, 0, 1.3, 0.98;
  EXPECT_LT(best_of(arm, request_of(samples, limits, {{"cone_z", 0, 0}})).followed, 40);
  EXPECT_EQ(
      best_of(arm, request_of(samples, limits, {{"cone_z", -0.05, 0.05}, {"tool_z", -0.1, 0.1}})).followed,
      40);
}

TEST(Tolerance, TheWayBackIsLikeTheWay) {
  std::mt19937 random(7);
  const AnyArm& arm = arm_called("irb6640").arm;
  int compared = 0;
  for (int i = 0; i < path_count(3); ++i) {
    auto samples = random_path(arm, random, 30, 0.3);
    const std::vector<Named> free{{"cone_z", -0.1, 0.1}, {"tool_z"}};
    const Result there = best_of(arm, request_of(samples, usual, free));
    std::reverse(samples.begin(), samples.end());
    const Result back = best_of(arm, request_of(samples, usual, free));
    EXPECT_EQ(there.followed >= 29, back.followed >= 29) << i;
    if (there.followed < 29 || back.followed < 29) continue;
    ++compared;
    EXPECT_NEAR(there.cost / back.cost, 1, 0.02) << i;
  }
  EXPECT_GT(compared, 0);
}

/// Joints with limits of two whole turns go on without a jump.
TEST(Tolerance, WholeTurnsAreSettled) {
  const AnyArm& arm = arm_called("ur5").arm;
  std::vector<Pose<double>> samples;
  for (int i = 0; i <= 80; ++i) {
    Values q;
    q << 2.6 + 0.02 * i, -1.2, 1.4, -0.5, 0.8, 3 - 0.05 * i;
    samples.push_back(arm.forward(q));
  }
  const JointLimits<6> limits{Values::Constant(-6.28), Values::Constant(6.28)};
  const Result result = best_of(arm, request_of(samples, limits, {{"cone_z", -0.02, 0.02}}));
  EXPECT_EQ(result.followed, 80);
  for (std::size_t i = 1; i < result.places.size(); ++i) {
    EXPECT_LT((result.places[i].q - result.places[i - 1].q).cwiseAbs().maxCoeff(), 0.5);
    EXPECT_LE(result.places[i].q.cwiseAbs().maxCoeff(), 6.28);
  }
}

/// Seven joints: the elbow, a turn of the tool, and a shift, all at once.
TEST(Tolerance, SevenJointsHaveTwoFreedomsMore) {
  namespace arm = robots::iiwa14;
  std::vector<Pose<double>> samples;
  for (int i = 0; i <= 40; ++i) samples.push_back({{0, 1, 0, 0}, {0.5, -0.2 + 0.01 * i, 0.3}});
  const JointLimits<7> limits{Joints<7>::Constant(-2), Joints<7>::Constant(2)};
  const auto solve = [](const Pose<double>& pose, double value) {
    return arm::inverse_kinematics_arm_angle(pose, value);
  };
  constexpr int capacity = decltype(solve({}, 0))::max_size;
  const auto request = request_of<7>(samples, limits, {{"joint"}, {"tool_z"}, {"shift_z", -0.002, 0.002}});
  const FreeResult<7, capacity, decltype(solve)> result(solve, request, arm::is_revolute);
  ASSERT_EQ(result.followed, 40);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& q = result.places[i].q;
    EXPECT_LE(q.cwiseAbs().maxCoeff(), 2);
    const Off off(arm::forward_kinematics<double>(q), samples[i]);
    EXPECT_LT(std::hypot(off.way.x(), off.way.y()), 1e-8);
    EXPECT_LE(std::abs(off.way.z()), 0.002 + 1e-8);
    EXPECT_LT(off.tilt, 1e-7);
  }
}

/// Twelve poses with all that a name may say: bounded, and an answer.
TEST(Tolerance, EightCoordinatesAreTheMost) {
  Freedoms freedoms;
  for (const char* name : {"shift_x", "shift_y", "shift_z", "tool_x", "tool_y", "tool_z", "rail_x"})
    EXPECT_TRUE(add_named(freedoms, name, {-0.1, 0.1}));
  EXPECT_FALSE(add_named(freedoms, "cone_z", {-0.1, 0.1}));
  FreeSpace space = freedoms.space;
  set_counts(space, 2000);
  double points = 1;
  for (int i = 0; i < space.size; ++i) points *= space[i].count;
  EXPECT_LE(points, 2000);
  EXPECT_GT(points, 100);
}

}  // namespace
}  // namespace path_test
