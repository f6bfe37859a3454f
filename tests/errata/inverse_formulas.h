// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "case.h"

namespace qvgen::test::sources {

/// One side of a formula: definitions "name = expression", then the value. Names: the pose (w, a, b, c, px,
/// py, pz; phi its angle about z; r11... its rotation, w11... the wrist's), N41...N44 the quaternion of the
/// wrist, c1, s1, hc1, hs1 cosine and sine of theta1 and of its half, the joints, the arm's lengths; pm and
/// pm2 are printed signs, + and - in turn.
struct Text {
  std::vector<std::string> where;
  std::string value;
  [[nodiscard]] std::string written() const;
  /// Every name that occurs.
  [[nodiscard]] std::set<std::string> names() const;
};

struct Formula {
  std::string number;
  std::string of;  ///< a joint, or an expression such as sin(theta3)
  Text printed;
  Text right;  ///< the printed one, if it is right
  std::string note;
  std::vector<std::string> signs = {};  ///< expressions whose sign may tell when it is right: "l2 - d4*s3"
};

struct Arm {
  std::string robot;
  std::string title;
  std::vector<Formula> formulas;
};

/// With the signs pm and pm2 among the values.
double value_of(const Text& text, reference::Values values);

/// Returns the arms of one file in the folder printed/.
std::vector<Arm> load_inverse_formulas(const std::string& file);
/// The generated inverse kinematics of a robot; throws std::runtime_error if there is none.
const InverseUnderTest& inverse_of(const std::string& robot);

/// Judged with all that a formula refers to at its true value, over every solution of random poses of arms of
/// random lengths: poses at which all branches exist, so that a value which none of them has is not merely
/// out of reach.
struct Verdict {
  int solutions = 0;
  int reached = 0;  ///< solutions whose value the formula gives, with one of its signs
  int spurious =
      0;  ///< solutions beside which it gives a value that no solution with the same earlier joints has
  std::string condition = {};       ///< which holds at exactly the solutions that are reached: "theta5 > 0"
  std::string counterexample = {};  ///< at the first solution where it fails: "gives 0.312 for 0.624"
  [[nodiscard]] bool right() const { return solutions > 0 && reached == solutions && spurious == 0; }
  [[nodiscard]] std::string text() const;
};

/// Solutions of random poses, and the verdicts that they give.
class Judge {
 public:
  Judge(const Arm& arm, const InverseUnderTest& robot);

  /// `index` is the formula's place in the arm: the joints of those before it are known.
  [[nodiscard]] Verdict formula(std::size_t index, const Text& text) const;
  /// True if a formula needs a joint that itself is computed from this one.
  [[nodiscard]] bool circular(std::size_t index) const;

 private:
  struct Place {
    std::vector<Eigen::VectorXd> solutions;
    std::vector<reference::Values> values;  ///< of each solution
  };
  void add_pose(Case& drawn);
  [[nodiscard]] std::set<int> joints_in(const Text& text) const;
  [[nodiscard]] int joint(const std::string& name) const;
  /// True if the formula gives the solution's value; what else it gives counts in the verdict.
  bool judge(const Place& place, std::size_t solution, const std::string& of, const Text& text,
             const std::set<int>& known, Verdict& verdict) const;
  /// Returns when the formula is right, from the solutions that it reaches (in the order of places_).
  [[nodiscard]] std::string condition(const Formula& formula, const std::vector<bool>& reached) const;

  const Arm& arm_;
  Case case_;
  std::vector<Place> places_;
};

}  // namespace qvgen::test::sources
