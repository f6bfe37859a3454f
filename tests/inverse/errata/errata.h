// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "case.h"

namespace qvgen::test::errata {

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
};

/// The wrist's quaternion from the pose and the arm's joints: four components.
struct QuaternionFormula {
  std::string number;
  std::vector<std::string> printed;
  std::vector<std::string> right;
};

struct Arm {
  std::string robot;
  std::string title;
  QuaternionFormula quaternion;  ///< empty where the source has none
  std::vector<Formula> formulas;
};

struct Source {
  std::string name;
  std::vector<Arm> arms;
};

Source load(const std::filesystem::path& file);
/// All of this folder.
std::vector<Source> sources();

/// Judged with all that a formula refers to at its true value, over every solution of random poses of arms of
/// random lengths: poses at which all branches exist, so that a value which none of them has is not merely
/// out of reach.
struct Verdict {
  int solutions = 0;
  int reached = 0;  ///< solutions whose value the formula gives, with one of its signs
  int spurious =
      0;  ///< solutions beside which it gives a value that no solution with the same earlier joints has
  std::string condition = {};  ///< which holds at exactly the solutions that are reached: "theta5 > 0"
  [[nodiscard]] bool right() const { return solutions > 0 && reached == solutions && spurious == 0; }
  [[nodiscard]] std::string text() const;
};

/// Solutions of random poses, and the verdicts that they give.
class Judge {
 public:
  Judge(const Arm& arm, const InverseUnderTest& robot);

  /// `index` is the formula's place in the arm: the joints of those before it are known.
  [[nodiscard]] Verdict formula(std::size_t index, const Text& text) const;
  [[nodiscard]] Verdict quaternion(std::size_t component, const std::vector<std::string>& texts) const;
  /// Whether a formula needs a joint that itself is computed from this one.
  [[nodiscard]] bool circular(std::size_t index) const;

 private:
  struct Place {
    std::vector<Eigen::VectorXd> solutions;
    std::vector<reference::Values> values;  ///< of each solution
  };
  void add_pose(Case& drawn);
  [[nodiscard]] std::set<int> joints_in(const Text& text) const;
  [[nodiscard]] int joint(const std::string& name) const;
  /// Whether the formula gives the solution's value; what else it gives counts in the verdict.
  bool judge(const Place& place, std::size_t solution, const std::string& of, const Text& text,
             const std::set<int>& known, Verdict& verdict) const;

  const Arm& arm_;
  Case case_;
  std::vector<Place> places_;
};

/// The whole table, as Markdown.
std::string table();

}  // namespace qvgen::test::errata
