// SPDX-License-Identifier: MIT
#pragma once

// Laws of arms that are asked for a part of a pose, in C++ and in C.
#include <functional>

#include "robot_in_c.h"
#include "written_arm.h"

namespace qvgen::test {

class PartOfAPose : public WrittenArm {
 protected:
  /// The rows of a part of the pose at joints q, in both languages, are those of the pose. `solve` asks for
  /// that part by the functions of a language.
  void expect_rows_of_pose(const Eigen::VectorXd& q,
                           const std::function<Found(const InverseFunctions&, const Sample&)>& solve) {
    const Sample sample = sample_at(test(), q);
    const Found by_pose = test().robot().solve(sample.pose, test().given(q), inverse::default_tolerance);
    const Found found = solve(GetParam().functions, sample);
    EXPECT_EQ(judge(test(), sample, found).fault, "") << q.transpose();
    EXPECT_EQ(found.rows.size(), by_pose.rows.size()) << q.transpose();
    // By elimination C calls C++: tests/c/inverse_test.cpp.
    if (by_elimination() || in_c_alone().contains(GetParam().name)) return;
    const auto in_c = inverses_in_c().find(GetParam().name);
    ASSERT_NE(in_c, inverses_in_c().end());
    const Found rows = solve(in_c->second, sample);
    ASSERT_EQ(rows.rows.size(), found.rows.size());
    for (std::size_t i = 0; i < rows.rows.size(); ++i)
      EXPECT_LT(test().distance(rows.rows[i].q, found.rows[i].q), 1e-9);
  }
};

}  // namespace qvgen::test
