// SPDX-License-Identifier: MIT
// Batches of assemblies: bit for bit the rows of single calls, in threads and in parts, and nothing behind
// the shortest batch is touched.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/batch/threads.h>
#include <qvgen/robots/arm_with_parallelogram/assembly_batch.h>
#include <qvgen/robots/delta/assembly_batch.h>
#include <qvgen/robots/gripper/assembly_batch.h>

namespace qvgen::test::loops_batch {
namespace {

namespace arm = qvgen::robots::arm_with_parallelogram;
namespace delta = qvgen::robots::delta;
namespace gripper = qvgen::robots::gripper;

constexpr std::size_t inputs = 3000;

/// Numbers side by side, a vector for each input.
class Numbers {
 public:
  Numbers(std::size_t rows, double low, double high, unsigned seed) : values_(rows * inputs) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(low, high);
    for (double& value : values_) value = any(random);
  }
  [[nodiscard]] Batch<double> view() { return {values_.data(), inputs}; }

 private:
  std::vector<double> values_;
};

/// Places for the assemblies of all inputs, filled with what no result is.
struct Places {
  Places(int capacity, int dof)
      : q(static_cast<std::size_t>(capacity * dof) * inputs, 7),
        branch(static_cast<std::size_t>(capacity) * inputs, 77),
        marks(static_cast<std::size_t>(capacity) * inputs, 77),
        count(inputs, 77),
        status(inputs, Status::incomplete) {}
  [[nodiscard]] BatchOfAssemblies view() {
    return {{q.data(), inputs},
            {count.data(), inputs},
            {status.data(), inputs},
            {branch.data(), inputs},
            {marks.data(), inputs}};
  }

  std::vector<double> q;
  std::vector<int> branch;
  std::vector<unsigned char> marks;
  std::vector<int> count;
  std::vector<Status> status;
};

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Compares input `k` with a single call. Returns the number of its rows.
template <int dof, int capacity>
int expect_rows(const BatchOfAssemblies& found, std::size_t k, const Assemblies<dof, capacity>& single) {
  EXPECT_EQ(found.count(0, k), single.size());
  EXPECT_EQ(found.status(0, k), single.status);
  for (int s = 0; s < capacity; ++s) {
    const auto place = static_cast<std::size_t>(s);
    for (int i = 0; i < dof; ++i) {
      const double q = found.q(static_cast<std::size_t>(s * dof + i), k);
      if (s < single.size())
        EXPECT_EQ(bits(q), bits(single[s].q[i]));
      else
        EXPECT_TRUE(std::isnan(q));
    }
    EXPECT_EQ(found.branch(place, k), s < single.size() ? single[s].branch : -1);
    const int mark =
        s < single.size() ? (single[s].continuum ? 1 : 0) + (single.meets(single[s]) ? 2 : 0) : 0;
    EXPECT_EQ(found.marks(place, k), mark);
  }
  return single.size();
}

/// Solves in threads, and compares every input with `single(k)`.
template <class Set, class Solve, class Single>
int expect_same(int dof, const Solve& solve, const Single& single) {
  Places places(Set::max_size, dof);
  const BatchOfAssemblies found = places.view();
  in_threads(
      inputs, [&](std::size_t first, std::size_t part) { solve(first, part, found.part(first, part)); }, 64);
  int rows = 0;
  for (std::size_t k = 0; k < inputs; ++k) rows += expect_rows(found, k, single(k));
  return rows;
}

TEST(BatchOfAssemblies, HasTheRowsOfSingleCallsFromMotorsAndFromThePlatform) {
  Numbers motors(3, -1.5, 1.5, 1), places(3, -0.4, 0.4, 2);
  motors.view()(1, 5) = std::numeric_limits<double>::quiet_NaN();
  motors.view()(0, 6) = std::numeric_limits<double>::infinity();
  const Batch<const double> a = motors.view(), x = places.view();
  EXPECT_GT(
      expect_same<delta::Assembled>(
          delta::dof,
          [&](auto first, auto part, const auto& found) { delta::assemble(a.part(first, part), found); },
          [&](std::size_t k) { return delta::assemble(batch::joints_at<3>(a, k)); }),
      1000);
  EXPECT_GT(expect_same<delta::AssembledFromOutputs>(
                delta::dof,
                [&](auto first, auto part, const auto& found) {
                  delta::assemble_from_outputs(x.part(first, part), found);
                },
                [&](std::size_t k) { return delta::assemble_from_outputs(batch::joints_at<3>(x, k)); }),
            100);
}

TEST(BatchOfAssemblies, IsNextToSeeds) {
  Numbers motors(1, -10, 10, 3), joints(gripper::dof, -20, 20, 4);
  const Batch<const double> a = motors.view(), seeds = joints.view();
  EXPECT_GT(expect_same<gripper::Assembled>(
                gripper::dof,
                [&](auto first, auto part, const auto& found) {
                  gripper::assemble(a.part(first, part), seeds.part(first, part), found);
                },
                [&](std::size_t k) {
                  return gripper::assemble(batch::joints_at<1>(a, k),
                                           batch::joints_at<gripper::dof>(seeds, k));
                }),
            1000);
}

TEST(BatchOfAssemblies, SolvesPosesOfATip) {
  Numbers joints(arm::dof, -1.2, 1.2, 5), poses(7, -1, 1, 6);
  for (std::size_t k = 0; k < inputs; k += 2) {  // every second one in reach
    const auto set = arm::assemble(batch::joints_at<arm::dof>(joints.view(), k).head<arm::driven_count>());
    if (!set.empty()) batch::put_pose(arm::pose_of_tool(set[0].q), poses.view(), k);
  }
  const Batch<const double> at = poses.view(), seeds = joints.view();
  EXPECT_GT(expect_same<arm::SolutionsOf_tool>(
                arm::dof,
                [&](auto first, auto part, const auto& found) {
                  arm::inverse_kinematics_of_tool(at.part(first, part), found);
                },
                [&](std::size_t k) { return arm::inverse_kinematics_of_tool(batch::pose_at(at, k)); }),
            1000);
  EXPECT_GT(expect_same<arm::SolutionsOf_tool>(
                arm::dof,
                [&](auto first, auto part, const auto& found) {
                  arm::inverse_kinematics_of_tool(at.part(first, part), seeds.part(first, part), found);
                },
                [&](std::size_t k) {
                  return arm::inverse_kinematics_of_tool(batch::pose_at(at, k),
                                                         batch::joints_at<arm::dof>(seeds, k));
                }),
            1000);
}

TEST(BatchOfAssemblies, TakesAsManyInputsAsTheShortestBatchHas) {
  Numbers motors(3, -1, 1, 7);
  Places places(delta::Assembled::max_size, delta::dof);
  BatchOfAssemblies found = places.view();
  found.branch = {};
  found.marks = {};
  found.status = found.status.part(0, 10);
  delta::assemble(motors.view(), found);
  for (std::size_t k = 0; k < inputs; ++k) EXPECT_EQ(found.count(0, k) == 77, k >= 10);
  delta::assemble(motors.view().part(0, 0), places.view());
  EXPECT_EQ(places.branch[0], 77);
}

}  // namespace
}  // namespace qvgen::test::loops_batch
