// SPDX-License-Identifier: MIT
// Whole turns of random arms with motors, from the generator's basis, against brute force: every turn of
// every joint, one after the other. A row stands for any solution, so no arm is solved here.
#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Core>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <qvgen/inverse/metrics.h>
#include <qvgen/inverse/motors.h>

#include "description/reader.h"
#include "model/evaluate.h"
#include "model/followers.h"
#include "model/motor_turns.h"
#include "reference/linear_algebra.h"

namespace qvgen::test::random_turns {
namespace {

constexpr int dof = 3;
constexpr double endless = std::numeric_limits<double>::infinity();
using Vector = Joints<dof>;
using Bounds = JointLimits<dof>;

using Rows = Solutions<dof, 4>;

template <class Scalar>
using JointsOf = Eigen::Matrix<Scalar, dof, 1>;

template <int rows, class Scalar>
Eigen::Matrix<Scalar, rows, 1> product(const Eigen::Matrix<double, rows, dof>& matrix,
                                       const JointsOf<Scalar>& vector) {
  Eigen::Matrix<Scalar, rows, 1> result;
  for (int i = 0; i < rows; ++i)
    result[i] = matrix(i, 0) * vector[0] + matrix(i, 1) * vector[1] + matrix(i, 2) * vector[2];
  return result;
}

/// Relations as generated code has them, of the arm that was drawn last.
template <int bounded_>
struct DrawnMap {
  static constexpr int dof = random_turns::dof, bounded = bounded_;
  static inline std::array<int, bounded> motor_of;
  static inline std::array<double, bounded> own_lower, own_upper;
  static inline MotorTurns<bounded> turns;
  static inline Eigen::Matrix<double, bounded, dof> matrix;
  template <class Scalar>
  static Eigen::Matrix<Scalar, bounded, 1> values(const JointsOf<Scalar>& motors) {
    return product(matrix, motors);
  }
  static inline Eigen::Matrix3d by_motors, by_joints;
  static constexpr std::array<bool, dof> is_revolute{true, true, true};
  static Vector joints(const Vector& motors) { return by_motors * motors; }
  template <class Scalar>
  static JointsOf<Scalar> motors(const JointsOf<Scalar>& joints) {
    return product(by_joints, joints);
  }
};

struct Arm {
  Eigen::Matrix3d matrix, inverse;
  std::array<double, dof> lower, upper;  ///< of joints: infinite where a joint has none of its own
  std::vector<std::vector<cln::cl_RA>> exact;
  model::Robot robot;
};

/// A random arm of turns, each of which follows two motors at most.
std::string description(std::mt19937& random) {
  const std::array<const char*, 6> factors{"1", "-1", "1/2", "-2/3", "3/2", "-1/2"};
  std::uniform_int_distribution<std::size_t> factor(0, factors.size() - 1);
  std::uniform_int_distribution<int> motor(1, dof), die(0, 2);
  std::uniform_real_distribution<double> limit(0.5, 5);
  std::string text = "name = \"arm\"\ntitle = \"t\"\n";
  for (int i = 1; i <= dof; ++i) {
    const int other = motor(random);
    std::string sum = fmt::format("{} m{}", factors[factor(random)], i);
    if (other != i) sum += fmt::format(" + {} m{}", factors[factor(random)], other);
    text += fmt::format(
        "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"q{}\"\nfollows = \"{}\"\n", i, sum);
    if (die(random) == 0) text += fmt::format("limits = [{}, {}]\n", -limit(random), limit(random));
  }
  for (int i = 1; i <= dof; ++i) text += fmt::format("[[motor]]\nvariable = \"m{}\"\n", i);
  return text;
}

/// The bound of a joint that keeps its own limits: those of one motor alone have become the motor's.
double bound_of(const model::Robot& robot, std::size_t joint, bool is_lower) {
  const auto& limits = robot.joints[joint].limits;
  if (robot.joints[joint].follows.empty() || !limits) return is_lower ? -endless : endless;
  return model::to_double(
      model::evaluate(is_lower ? limits->lower : limits->upper, model::default_bindings(robot)));
}

std::optional<Arm> arm_of(const std::string& text) {
  const description::ReadResult read = description::read_text(text, "arm.toml");
  if (!read.robot) return std::nullopt;
  const auto inverse = model::inverse_shares(*read.robot);
  if (!inverse) return std::nullopt;
  Arm arm{Eigen::Matrix3d::Zero(), {}, {}, {}, *inverse, *read.robot};
  const auto shares = model::shares(arm.robot);
  for (std::size_t i = 0; i < dof; ++i) {
    for (const model::Share& share : shares[i])
      arm.matrix(static_cast<int>(i), static_cast<int>(share.driven)) = cln::double_approx(share.ratio);
    arm.lower[i] = bound_of(arm.robot, i, true);
    arm.upper[i] = bound_of(arm.robot, i, false);
  }
  arm.inverse = reference::inverse(arm.matrix);
  return arm;
}

template <class Map>
void set_map(const Arm& arm, const model::MotorTurns& found) {
  Map::turns = {};
  Map::by_motors = arm.matrix;
  Map::by_joints = arm.inverse;
  Map::turns.count = static_cast<int>(found.turns.size());
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    const model::LimitedValue& value = found.values[i];
    const int index = static_cast<int>(value.index), row = static_cast<int>(i);
    Map::motor_of[i] = value.is_motor ? index : -1;
    Map::own_lower[i] = value.is_motor ? -endless : arm.lower[value.index];
    Map::own_upper[i] = value.is_motor ? endless : arm.upper[value.index];
    if (value.is_motor)
      Map::matrix.row(row).setUnit(index);
    else
      Map::matrix.row(row) = arm.matrix.row(index);
  }
  for (std::size_t k = 0; k < found.turns.size(); ++k) {
    Map::turns.pivot[k] = static_cast<int>(found.turns[k].pivot);
    Map::turns.ends_block[k] = found.turns[k].ends_block;
    for (std::size_t i = 0; i < found.values.size(); ++i)
      Map::turns.motion[k][i] = cln::double_approx(found.turns[k].motion[i]) * inverse::whole_turn;
  }
  Map::turns.pivot[found.turns.size()] = Map::bounded;
}

bool is_inside(const Arm& arm, const Vector& motors, const Bounds& limits) {
  const Vector joints = arm.matrix * motors;
  for (int i = 0; i < dof; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (motors[i] < limits.lower[i] || motors[i] > limits.upper[i]) return false;
    if (joints[i] < arm.lower[at] || joints[i] > arm.upper[at]) return false;
  }
  return true;
}

/// Every representative of a row inside finite limits.
std::vector<Vector> representatives(const Arm& arm, const Vector& row, const Bounds& limits) {
  const double farthest = limits.lower.cwiseAbs().cwiseMax(limits.upper.cwiseAbs()).maxCoeff();
  const Vector joints = arm.matrix * row;
  Vector most;
  for (int i = 0; i < dof; ++i)
    most[i] = std::ceil((arm.matrix.row(i).cwiseAbs().sum() * farthest + std::abs(joints[i])) / (2 * M_PI));
  std::vector<Vector> inside;
  for (double a = -most[0]; a <= most[0]; ++a)
    for (double b = -most[1]; b <= most[1]; ++b)
      for (double c = -most[2]; c <= most[2]; ++c) {
        const Vector turned = row + arm.inverse * (2 * M_PI * Vector(a, b, c));
        if (is_inside(arm, turned, limits)) inside.push_back(turned);
      }
  return inside;
}

Vector random_vector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> between(-size, size);
  return Vector::NullaryExpr([&] { return between(random); });
}

Rows rows_of(std::mt19937& random) {
  Rows rows;
  for (int i = 0; i < 4; ++i) rows.append() = {random_vector(random, 3), i, false};
  rows.conclude();
  return rows;
}

/// Numbers over all arms, which show that the cases are there.
struct Seen {
  int arms = 0, own_limits = 0, searched = 0, none = 0, several = 0;
};

/// Answers of the library about rows within limits and next to a seed.
struct Within {
  std::vector<Solution<dof>> all;
  std::size_t size;
  int branches;
  Status status;
  Rows nearest, nearest_of_all;
  std::vector<std::optional<Solution<dof>>> best;  ///< by each metric
  bool are_same;                                   ///< rows one by one and side by side, bit by bit
};
/// Answers of the library about rows next to a seed, without limits.
struct Ways {
  std::array<Vector, 4> ways;
  Vector best, next;
  bool has_next;
  Rows sorted;
};

const std::array<LargestJoint<dof>, 2> metrics{LargestJoint<dof>{}, LargestJoint<dof>{Vector(1, 3, 0.2)}};

/// Law: a lane has the bits of a row alone.
template <class Map>
bool are_same(const Rows& rows, const Vector& seed, const Bounds& limits) {
  const inverse::WithinMotors<Map> within(limits, seed);
  const auto itself = [](const auto& motors) { return motors; };
  const inverse::RowsInside<Map, 4, double> alone(rows, within, itself);
  const inverse::RowsInside<Map, 4> together(rows, within, itself);
  bool result = alone.count == together.count && alone.is_cut == together.is_cut;
  for (std::size_t k = 0; result && k < static_cast<std::size_t>(alone.count); ++k) {
    Vector one, other;
    alone.copy_motors(k, one);
    together.copy_motors(k, other);
    result = alone.kept[k] == together.kept[k] && alone.squares[k] == together.squares[k] && one == other;
  }
  return result;
}

template <class Map>
Within within_of(const Rows& rows, const Vector& seed, const Bounds& limits) {
  const AllWithinMotors<Map, 4> all(rows, limits);
  Within found{{}, all.size(), all.branches(), all.status, {}, {}, {}, are_same<Map>(rows, seed, limits)};
  if (found.size < 100'000)
    for (const auto& row : all) found.all.push_back(row);
  found.nearest = inverse::nearest_within_motors<Map>(rows, seed, limits);
  found.nearest_of_all = nearest_within_limits(all, seed);
  for (const auto& metric : metrics) found.best.push_back(qvgen::nearest(all, seed, metric));
  return found;
}

template <class Map>
Ways ways_of(Rows rows, const Vector& seed) {
  const TurnsOfMotors<Map> turns;
  Ways found;
  found.best = qvgen::nearest(rows, seed, turns, metrics[1])->q;
  for (std::size_t k = 0; k < 4; ++k)
    found.ways[k] = inverse::way_of_motors<Map>(seed, rows, rows[static_cast<int>(k)].q);
  found.has_next = continued(rows, seed, turns, found.next);
  sort_by_distance(rows, seed, turns);
  found.sorted = rows;
  return found;
}

/// The library, for the arm that was drawn last.
struct Library {
  void (*set)(const Arm& arm, const model::MotorTurns& turns);
  Within (*within)(const Rows& rows, const Vector& seed, const Bounds& limits);
  Ways (*ways)(Rows rows, const Vector& seed);
};
template <int bounded>
constexpr Library library_of{set_map<DrawnMap<bounded>>, within_of<DrawnMap<bounded>>,
                             ways_of<DrawnMap<bounded>>};
/// By the number of values that have limits: three motors, and up to three joints, of which usual runs have
/// one.
constexpr std::array<Library, 4> libraries{library_of<3>, library_of<4>,
#ifdef QVGEN_ALL_ARMS
                                           library_of<5>, library_of<6>
#endif
};

void expect_brute_force(const Arm& arm, const Library& library, std::mt19937& random, Seen& seen) {
  const Rows rows = rows_of(random);
  const Vector seed = random_vector(random, 6);
  const Bounds limits{-random_vector(random, 6).cwiseAbs(), random_vector(random, 6).cwiseAbs()};
  const Within found = library.within(rows, seed, limits);
  std::size_t count = 0;
  std::vector<double> expected;
  std::array<double, 2> least_metrics{endless, endless};
  for (const auto& row : rows) {
    const auto inside = representatives(arm, row.q, limits);
    ++(inside.empty() ? seen.none : inside.size() > 1 ? seen.several : seen.searched);
    count += inside.size();
    double least = endless;
    for (const Vector& each : inside) {
      const Vector way = each - seed;
      least = std::min(least, way.norm());
      for (std::size_t i = 0; i < 2; ++i) least_metrics[i] = std::min(least_metrics[i], metrics[i](way));
      EXPECT_TRUE(std::any_of(found.all.begin(), found.all.end(),
                              [&](const auto& other) { return (other.q - each).norm() < 1e-9; }));
    }
    if (!inside.empty()) expected.push_back(least);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& best = found.best[i];
    ASSERT_EQ(best.has_value(), count > 0);
    if (best) {
      EXPECT_NEAR(metrics[i](Vector(best->q - seed)), least_metrics[i], 1e-9);
    }
  }
  EXPECT_TRUE(found.are_same);
  EXPECT_EQ(found.size, count);
  EXPECT_EQ(found.status, count == 0 ? Status::unreachable : Status::solved);
  for (const auto& row : found.all) EXPECT_TRUE(is_inside(arm, row.q, limits));
  const Rows &nearest = found.nearest, &again = found.nearest_of_all;
  ASSERT_EQ(again.size(), nearest.size());
  for (int i = 0; i < again.size(); ++i) EXPECT_EQ(again[i].branch, nearest[i].branch);
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(static_cast<std::size_t>(nearest.size()), expected.size());
  for (int i = 0; i < nearest.size(); ++i) {
    EXPECT_TRUE(is_inside(arm, nearest[i].q, limits));
    EXPECT_NEAR((nearest[i].q - seed).norm(), expected[static_cast<std::size_t>(i)], 1e-9);
  }
}

/// Law: without limits a way leads to the row but for whole turns of joints, each of which goes at most half
/// a turn; orders are those of these ways.
void expect_short_ways(const Arm& arm, const Library& library, std::mt19937 random) {
  const Rows rows = rows_of(random);
  const Vector seed = random_vector(random, 9);
  const Ways found = library.ways(rows, seed);
  const auto way_of = [&](const Vector& q) {
    Vector whole = arm.matrix * (q - seed);
    for (double& joint : whole) joint = std::remainder(joint, 2 * M_PI);
    return Vector(arm.inverse * whole);
  };
  const auto& metric = metrics[1];
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector way = way_of(rows[static_cast<int>(k)].q);
    EXPECT_LE(metric(way_of(found.best)), metric(way));
    EXPECT_LT((found.ways[k] - way).norm(), 1e-9);
  }
  ASSERT_TRUE(found.has_next);
  EXPECT_LT((found.next - seed - way_of(found.sorted[0].q)).norm(), 1e-9);
  for (int i = 1; i < found.sorted.size(); ++i)
    EXPECT_LE(way_of(found.sorted[i - 1].q).norm(), way_of(found.sorted[i].q).norm() + 1e-12);
}

/// Limits of which some are without end, reversed or no number, and odd seeds: nothing hangs, no row is
/// outside.
void expect_sense(const Arm& arm, const Library& library, std::mt19937& random) {
  const std::array<double, 6> odd{-endless, endless, std::nan(""), 1e300, -1e300, 1};
  std::uniform_int_distribution<std::size_t> which(0, 8);
  const auto drawn = [&](Vector vector) {
    for (int i = 0; i < dof; ++i)
      if (const std::size_t k = which(random); k < odd.size()) vector[i] = odd[k];
    return vector;
  };
  const Bounds limits{drawn(-Vector::Constant(4)), drawn(Vector::Constant(4))};
  const Rows rows = rows_of(random);
  const Within found = library.within(rows, random_vector(random, 4), limits);
  const Within far = library.within(rows, drawn(random_vector(random, 4)), limits);
  EXPECT_LT(found.size, 100'000U);
  EXPECT_EQ(found.nearest.size(), found.branches);
  EXPECT_LE(far.nearest.size(), found.branches);
  EXPECT_TRUE(found.are_same && far.are_same);
  Bounds wider = limits;
  wider.lower.array() -= 1e-9;
  wider.upper.array() += 1e-9;
  for (const auto& row : found.all) EXPECT_TRUE(is_inside(arm, row.q, wider));
  for (const auto& row : found.nearest) EXPECT_TRUE(is_inside(arm, row.q, wider));
}

TEST(RandomMotors, WholeTurnsAreThoseOfBruteForce) {
  std::mt19937 random(11);
  Seen seen;
  for (int k = 0; k < 200; ++k) {
    const auto arm = arm_of(description(random));
    if (!arm) continue;  // motors that do not determine the joints
    const model::MotorTurns turns = model::motor_turns(arm->robot, arm->exact);
    const Library& library = libraries.at(turns.values.size() - dof);
    if (library.set == nullptr) continue;
    ++seen.arms;
    seen.own_limits += turns.values.size() > dof ? 1 : 0;
    library.set(*arm, turns);
    for (int i = 0; i < 10; ++i) expect_brute_force(*arm, library, random, seen);
    for (int i = 0; i < 10; ++i) expect_sense(*arm, library, random);
    for (int i = 0; i < 3; ++i) expect_short_ways(*arm, library, random);
    if (HasFailure()) FAIL() << "arm " << k;
  }
  EXPECT_GT(seen.arms, 80);
  EXPECT_GT(seen.own_limits, 30);
  EXPECT_GT(std::min({seen.none, seen.searched, seen.several}), 200);
}

/// A search that would be long is given up, and the set says that it may lack a row.
TEST(RandomMotors, LongSearchesAreGivenUpAndSaidSo) {
  const auto arm = arm_of(
      "name = \"arm\"\ntitle = \"t\"\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"a\"\n"
      "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"b\"\n"
      "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"c\"\nfollows = \"m + 1/7919 a + 1/6007 "
      "b\"\n"
      "[[motor]]\nvariable = \"m\"\n");
  ASSERT_TRUE(arm);
  libraries[0].set(*arm, model::motor_turns(arm->robot, arm->exact));
  Rows rows;
  rows.append() = {Vector(0.1, 0.2, 3), 0, false};
  rows.conclude();
  const Bounds limits{Vector(-9000, -9000, 0), Vector(9000, 9000, 1e-9)};
  const Within found = libraries[0].within(rows, Vector(0, 0, 0), limits);
  EXPECT_TRUE(found.nearest.empty());
  EXPECT_EQ(found.nearest.status, Status::incomplete);
  EXPECT_TRUE(found.are_same);
  EXPECT_EQ(found.status, Status::incomplete);
}

}  // namespace
}  // namespace qvgen::test::random_turns
