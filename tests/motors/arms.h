// SPDX-License-Identifier: MIT
// The arms under test, generated and compiled, as values of one type: laws are compiled once, not once an
// arm. Joints have any number here, so that nothing but arms.cpp and arms_in_c.cpp, which copy, knows the
// fixed sizes. Each arm has its description as the reference reads it, too.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/pose.h>

#include "reference/load.h"

namespace qvgen::test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Limits of motors.
struct Bounds {
  VectorXd lower, upper;
};

/// One solution.
struct Row {
  VectorXd q;
  int branch = 0;
  bool continuum = false;
};

/// A set of solutions, in its order. Of all representatives `branches` says how many branches they are of,
/// and `size` how many there are, of which `rows` keeps the first `most_kept`.
struct Rows {
  static constexpr std::size_t most_kept = 5000;
  Status status = Status::invalid;
  std::vector<Row> rows;
  std::size_t size = 0, branches = 0;

  [[nodiscard]] bool empty() const { return rows.empty(); }
  const Row& operator[](std::size_t index) const { return rows.at(index); }
  [[nodiscard]] auto begin() const { return rows.begin(); }
  [[nodiscard]] auto end() const { return rows.end(); }
  void append(const double* q, int dof, int branch, bool continuum);
};

/// A seed and limits, which a caller may give beside the pose; null: not given.
struct Asked {
  const VectorXd* seed = nullptr;
  const Bounds* limits = nullptr;
};

/// The compiled functions of an arm. `at` are motors whose values those that are given have.
struct Functions {
  std::function<qvgen::Pose<double>(const VectorXd& q)> pose;
  std::function<MatrixXd(const VectorXd& q)> jacobian;  ///< empty: it is not generated
  std::function<Rows(const VectorXd&at, const qvgen::Pose<double>&pose, const Asked&asked)> solve, near;
};

/// The functions in C, and the library in C++ on rows that C has found: limits alone then make a difference.
struct FunctionsInC {
  std::function<Rows(const VectorXd&at, const qvgen::Pose<double>&pose, const Asked&asked)> solve, near;
  /// Representatives of all rows; after the last nothing may come.
  std::function<Rows(const VectorXd& at, const qvgen::Pose<double>& pose, const Bounds& limits)>
      representatives;
  std::function<Rows(const VectorXd& at, const qvgen::Pose<double>& pose, const Bounds& limits)>
      representatives_of_cxx;
  std::function<Rows(const VectorXd& at, const qvgen::Pose<double>& pose, const VectorXd& seed,
                     const Bounds& limits)>
      nearest_of_cxx;
};

class Arm {
 public:
  Arm(const std::string& file, InverseInfo of_inverse, std::vector<std::string> of_joints,
      std::vector<int> given_joints, Functions compiled);

  std::string name;
  InverseInfo info;
  std::vector<std::string> names;
  std::vector<int> given;
  Functions functions;
  FunctionsInC in_c;  ///< empty: not compared
  reference::Chain chain;
  MatrixXd coupling;
  int dof;

  [[nodiscard]] qvgen::Pose<double> pose(const VectorXd& q) const { return functions.pose(q); }
  [[nodiscard]] Rows solve(const VectorXd& at, const qvgen::Pose<double>& pose) const {
    return functions.solve(at, pose, {});
  }
  [[nodiscard]] Rows solve(const VectorXd& at, const qvgen::Pose<double>& pose, const VectorXd& seed) const {
    return functions.solve(at, pose, {&seed, nullptr});
  }
  [[nodiscard]] Rows solve(const VectorXd& at, const qvgen::Pose<double>& pose, const Bounds& limits) const {
    return functions.solve(at, pose, {nullptr, &limits});
  }
  [[nodiscard]] Rows solve(const VectorXd& at, const qvgen::Pose<double>& pose, const VectorXd& seed,
                           const Bounds& limits) const {
    return functions.solve(at, pose, {&seed, &limits});
  }
  [[nodiscard]] Rows near(const VectorXd& at, const qvgen::Pose<double>& pose, const VectorXd& seed) const {
    return functions.near(at, pose, {&seed, nullptr});
  }
  [[nodiscard]] Rows near(const VectorXd& at, const qvgen::Pose<double>& pose, const VectorXd& seed,
                          const Bounds& limits) const {
    return functions.near(at, pose, {&seed, &limits});
  }

  [[nodiscard]] VectorXd joints(const VectorXd& motors) const;
  [[nodiscard]] VectorXd random_motors(std::mt19937& random, double size) const;
  [[nodiscard]] VectorXd constant(double value) const;
  /// Bounds that are the same for all motors.
  [[nodiscard]] Bounds within(double lower, double upper) const { return {constant(lower), constant(upper)}; }
  [[nodiscard]] bool is_revolute(int joint) const {
    return chain.joints[static_cast<std::size_t>(joint)].revolute;
  }
  /// How far a row's tool is from a pose, by the reference.
  [[nodiscard]] double error_of(const VectorXd& motors, const qvgen::Pose<double>& pose) const;
  /// True if joints differ by whole turns.
  [[nodiscard]] bool is_same(const VectorXd& a, const VectorXd& b) const;
};

/// How far two vectors are apart.
double distance(const VectorXd& a, const VectorXd& b);

/// Adds the functions in C to arms, by their names.
void add_functions_in_c(std::map<std::string, Arm>& arms);

/// Arms by their names; those that end in "_by_the_last" have another joint given.
const Arm& arm_named(const std::string& name);

/// A test of each of some arms, by name.
class OfEachArm : public testing::TestWithParam<const char*> {
 protected:
  const Arm& arm_ = arm_named(GetParam());
};
inline std::string name_of(const testing::TestParamInfo<const char*>& arm) { return arm.param; }

}  // namespace qvgen::test
