// SPDX-License-Identifier: MIT
// Blocks of arms that are not asked for whole poses, or are given a joint: against plain loops.
#include <gtest/gtest.h>
#include <qvgen/manipulability.h>
#include <qvgen/map/evaluate.h>
#include <qvgen/robots/iiwa14.h>
#include <qvgen/robots/scara.h>

namespace qvgen::map {
namespace {

template <int dof_>
struct SevenOrFour {
  static constexpr int dof = dof_;
  /// Computes a result of the Jacobians, one by one.
  template <class Jacobian>
  static void each(const Batch<const double>& q, const Batch<double>& result, const Jacobian& jacobian) {
    for (std::size_t k = 0; k < q.count; ++k) {
      Eigen::Matrix<double, dof, 1> joints;
      for (int i = 0; i < dof; ++i) joints[i] = q(static_cast<std::size_t>(i), k);
      result(0, k) = manipulability(jacobian(joints)).volume;
    }
  }
};

struct Scara : SevenOrFour<4> {
  static constexpr int capacity = robots::scara::inverse_info.capacity;
  static constexpr Task task = Task::position_and_yaw;
  static Ranges<4> ranges() { return {{-1, -2, 0, -3}, {2, 1.5, 0.3, 3}, robots::scara::is_revolute}; }
  static void solve(const Batch<const double>& targets, const Batch<const double>&,
                    const BatchOfSolutions& found) {
    batch::one_by_one(targets.count, found, [&](std::size_t k) {
      return robots::scara::inverse_kinematics(target_at<task>(targets, k));
    });
  }
  static void volumes(const Batch<const double>& q, const Batch<double>& result) {
    each(q, result, [](const auto& joints) { return robots::scara::jacobian(joints); });
  }
};

struct Iiwa : SevenOrFour<7> {
  static constexpr int capacity = robots::iiwa14::inverse_info_given_theta3.capacity;
  static constexpr Task task = Task::pose;
  static Ranges<7> ranges() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {{-1, -2, -1, -1, -2, -1, -inf}, {1, 2, 1.5, 2, 1.5, 2, inf}, robots::iiwa14::is_revolute};
  }
  static void solve(const Batch<const double>& targets, const Batch<const double>& given,
                    const BatchOfSolutions& found) {
    batch::one_by_one(targets.count, found, [&](std::size_t k) {
      return robots::iiwa14::inverse_kinematics_given_theta3(batch::pose_at(targets, k), given(0, k));
    });
  }
  static void volumes(const Batch<const double>& q, const Batch<double>& result) {
    each(q, result, [](const auto& joints) { return robots::iiwa14::jacobian(joints); });
  }
};

/// Contribution of one target's rows to a cell.
struct Target {
  std::uint32_t found = 0;
  template <class Arm, class Rows, class Jacobian>
  void see(const Plan& plan, const Rows& rows, const Jacobian& jacobian, Cell& cell) {
    for (const auto& row : rows) {
      const double distance = Arm::ranges().limit_distance(row.q);
      if (plan.limits && distance < 0) continue;
      ++found;
      ++cell.solutions;
      cell.manipulability = std::max(cell.manipulability, manipulability(jacobian(row.q)).volume);
      if (!(cell.limit_distance >= distance)) cell.limit_distance = distance;
    }
  }
  void end(Cell& cell) const {
    cell.most = std::max(cell.most, found);
    cell.reached += found > 0 ? 1 : 0;
  }
};

void expect_same(const Cell& cell, const Cell& expected) {
  EXPECT_EQ(cell.reached, expected.reached);
  EXPECT_EQ(cell.solutions, expected.solutions);
  EXPECT_EQ(cell.most, expected.most);
  EXPECT_EQ(cell.manipulability, expected.manipulability);
  EXPECT_TRUE(cell.limit_distance == expected.limit_distance || expected.solutions == 0);
}

/// All blocks, in an order of their own, and for each cell the plain loop's.
template <class Arm, class Expected>
void expect_loops(const Plan& plan, const Expected& expected) {
  const Grid grid(plan.sphere);
  Evaluation<Arm> evaluation(grid, plan);
  std::uint64_t reached = 0, missed = 0;
  for (int n = 0; n < Grid::blocks; ++n) {
    const int block = n * 7 % Grid::blocks;
    const std::vector<Cell> cells = evaluation.block(block);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Cell other = expected(grid.position(grid.first_of(block) + i));
      expect_same(cells[i], other);
      reached += other.reached;
      missed += plan.targets - other.reached;
    }
  }
  EXPECT_GT(reached, 50U);
  EXPECT_GT(missed, 50U);
}

TEST(Evaluation, AsksForAnglesWhatTurnsAboutOneDirection) {
  Plan plan{{{0, 0, 0.1}, 0.8, 0.15}, 5};
  for (const bool limits : {false, true}) {
    plan.limits = limits;
    expect_loops<Scara>(plan, [&](const std::array<double, 3>& at) {
      Cell cell;
      for (int i = 0; i < 5; ++i) {
        Target target;
        const PositionAndYaw<double> wanted{{at[0], at[1], at[2]}, i * (turn / 5)};
        target.see<Scara>(
            plan, robots::scara::inverse_kinematics(wanted),
            [](const auto& q) { return robots::scara::jacobian(q); }, cell);
        target.end(cell);
      }
      return cell;
    });
  }
}

TEST(Evaluation, TriesValuesOfAJointThatIsGiven) {
  Plan plan{{{0, 0, 0.36}, 0.95, 0.3}, 3, 4, -1, 1.5, true};
  expect_loops<Iiwa>(plan, [&](const std::array<double, 3>& at) {
    Cell cell;
    for (std::size_t i = 0; i < 3; ++i) {
      Target target;
      const auto q = even_orientation(i, 3);
      const Pose<double> pose{{q[0], q[1], q[2], q[3]}, {at[0], at[1], at[2]}};
      for (const double theta3 : {-1 + 2.5 / 8, -1 + 7.5 / 8, -1 + 12.5 / 8, -1 + 17.5 / 8})
        target.see<Iiwa>(
            plan, robots::iiwa14::inverse_kinematics_given_theta3(pose, theta3),
            [](const auto& joints) { return robots::iiwa14::jacobian(joints); }, cell);
      target.end(cell);
    }
    return cell;
  });
}

}  // namespace
}  // namespace qvgen::map
