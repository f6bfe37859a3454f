// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <random>
#include <vector>

#include <qvgen/batch/solutions.h>

#include "laws.h"

/// Laws of every batch form of inverse kinematics.
namespace qvgen::batch_laws {

/// Request to a solver; `given` is the value of the joint that is given, if one is.
struct Request {
  Pose<double> pose;
  double given = 0;
};

/// Requests of all kinds for an arm.
template <int dof>
struct Requests {
  using Joints = Eigen::Matrix<double, dof, 1>;
  std::function<Pose<double>(const Joints&)> forward;
  std::function<bool(const Request&)> is_reached;
  int given_joint = -1;
  std::mt19937 random{11};

  std::vector<Request> some(int rounds) {
    std::vector<Request> list;
    for (int round = 0; round < rounds; ++round) {
      for (int i = 0; i < 6; ++i) list.push_back(at(any_joints()));
      const Joints q = near_singular(any_joints());
      list.push_back(at(q));
      list.push_back(at(near_singular(q)));
      list.push_back(at_the_boundary(at(any_joints())));
      list.push_back(moved(at(any_joints()), 1 + 0.3 * number(1)));
      list.push_back(moved(at(any_joints()), 100));
      list.push_back(odd(at(any_joints())));
    }
    return list;
  }

 private:
  double number(double most) { return std::uniform_real_distribution<double>(-most, most)(random); }
  Joints any_joints() {
    Joints q;
    for (int i = 0; i < dof; ++i) q[i] = number(3.14);
    return q;
  }
  Request at(const Joints& q) const { return {forward(q), given_joint < 0 ? 0 : q[given_joint]}; }
  static Request moved(Request request, double by) {
    request.pose.position *= by;
    return request;
  }
  /// One joint at a multiple of an eighth of a turn, or next to it.
  Joints near_singular(Joints q) {
    const double off[] = {0, 0, 1e-15, 1e-12, -1e-10, 1e-8, -1e-7, 1e-6, 1e-4};
    const double angle = 0.785398163397448309616 * static_cast<double>(random() % 8);
    q[static_cast<int>(random() % dof)] = angle + off[random() % (sizeof off / sizeof *off)];
    return q;
  }
  /// The position moved outwards to where the arm's reach ends, by as little as rounding or by more.
  Request at_the_boundary(const Request& request) {
    double inside = 1, outside = 8;
    for (int i = 0; i < 60; ++i) {
      const double middle = (inside + outside) / 2;
      (is_reached(moved(request, middle)) ? inside : outside) = middle;
    }
    const double off[] = {0, 1e-16, -1e-15, 1e-13, -1e-12, 1e-10, -1e-8, 1e-7};
    return moved(request, inside * (1 + off[random() % 8]));
  }
  /// Turns a request into an invalid pose, or one that is hardly valid.
  Request odd(Request request) {
    const double limit = std::numeric_limits<double>::infinity();
    const double values[] = {std::nan(""), limit, -limit, 1e200, 0, 1e-320};
    const double value = values[random() % 6];
    const int place = static_cast<int>(random() % 7);
    auto& turn = request.pose.orientation.coeffs();
    if (place < 3)
      request.pose.position[place] = value;
    else if (random() % 2 == 0)
      turn[place - 3] = value;
    else
      turn *= 1 + (random() % 2 == 0 ? 4e-7 : 6e-7);
    return request;
  }
};

/// Batches of `requests` have what single calls have, and nothing else is written: from `first` on,
/// `at.count` of them. `form(poses, given, found, set)`.
template <int dof, int capacity, class Single, class Form>
void expect_single_solutions(const std::vector<Request>& requests, std::size_t first, const Case& at,
                             const Single& single, const Form& form, InstructionSet set, bool everything) {
  constexpr std::size_t n = dof, most = capacity;
  Owned<double> poses(7, at.count, at.stride, 0), given(1, at.count, at.stride, 0);
  Owned<double> q(n * most, at.count, at.stride, -12345), wanted_q = q;
  Owned<int> count(1, at.count, at.stride, -7), branch(most, at.count, at.stride, -7);
  Owned<Status> status(1, at.count, at.stride, Status::incomplete);
  Owned<unsigned> marks(1, at.count, at.stride, 77);
  auto wanted_count = count, wanted_branch = branch;
  auto wanted_status = status;
  auto wanted_marks = marks;
  for (std::size_t k = 0; k < at.count; ++k) {
    const Request& request = requests[(first + k) % requests.size()];
    const auto& turn = request.pose.orientation;
    const Eigen::Vector3d& place = request.pose.position;
    const double numbers[] = {turn.w(), turn.x(), turn.y(), turn.z(), place.x(), place.y(), place.z()};
    for (std::size_t i = 0; i < 7; ++i) poses(i, k) = numbers[i];
    given(0, k) = request.given;
    const auto found = single(request);
    wanted_count(0, k) = found.size();
    wanted_status(0, k) = found.status;
    if (everything) wanted_marks(0, k) = 0;
    for (std::size_t s = 0; s < most; ++s) {
      const bool is_row = static_cast<int>(s) < found.size();
      const auto& row = found[static_cast<int>(s)];
      for (std::size_t i = 0; i < n; ++i)
        wanted_q(s * n + i, k) = is_row ? row.q[static_cast<Eigen::Index>(i)] : std::nan("");
      if (!everything) continue;
      wanted_branch(s, k) = is_row ? row.branch : -1;
      if (is_row && row.continuum) wanted_marks(0, k) |= 1U << s;
    }
  }
  BatchOfSolutions all{q, count, status, {}, {}};
  if (everything) all = {q, count, status, branch, marks};
  form(Batch<const double>(poses), Batch<const double>(given), all, set);
  for (std::size_t i = 0; i < q.numbers().size(); ++i)
    ASSERT_TRUE(same_bits(q.numbers()[i], wanted_q.numbers()[i]))
        << "set " << static_cast<int>(set) << ", " << at.count << " poses, place " << i << ": "
        << q.numbers()[i] << " instead of " << wanted_q.numbers()[i];
  ASSERT_EQ(count.numbers(), wanted_count.numbers());
  ASSERT_EQ(status.numbers(), wanted_status.numbers());
  ASSERT_EQ(branch.numbers(), wanted_branch.numbers());
  ASSERT_EQ(marks.numbers(), wanted_marks.numbers());
}

/// Expects the single calls' rows in every instruction set, for short batches of every size and a long one.
template <int dof, int capacity, class Single, class Form>
void expect_single_solutions(const std::vector<Request>& requests, const Single& single, const Form& form) {
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!batch::machine_has(set)) continue;
    std::vector<Case> all = cases();
    all.push_back({requests.size(), requests.size(), false});
    std::size_t first = 0;
    for (const Case& at : all) {
      expect_single_solutions<dof, capacity>(requests, first, at, single, form, set, at.count % 3 != 0);
      if (testing::Test::HasFatalFailure()) return;
      first += at.count;
    }
  }
}

}  // namespace qvgen::batch_laws
