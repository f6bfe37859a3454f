// SPDX-License-Identifier: MIT
#pragma once

#include "emit/inverse/branch_tree.h"
#include "emit/inverse/places.h"

namespace qvgen::emit {

/// The way along a plan's branches as statements. A policy says what happens at a fork, at a wrist and at the
/// end of a row: it follows every branch in turn (`every_branch`), in lanes (`in_lanes`), or the seed's alone
/// (`seed_branch`).
class Walk {
 public:
  Walk(const derive::inverse::LoweredPlan& plan, ast::Element number) : plan_(plan), number_(number) {}
  virtual ~Walk() = default;

 protected:
  /// Surroundings of a statement.
  struct Place {
    int forks = 0;              ///< around it
    std::string loop_variable;  ///< of the innermost loop, empty outside of loops
    ast::Expression label;      ///< of the branch, nothing outside of forks
    // Behind Newton's steps the joints are those of a copy, for the goal: the next branch starts from what
    // the closed form has found.
    ast::Expression work, target;
  };

  /// Value that the function returns where no branch is left.
  [[nodiscard]] virtual ast::Expression result() const = 0;
  virtual void fork(const BranchNode& node, const Place& at, ast::Statements& to) = 0;
  virtual void quartic(const BranchNode& node, const Place& at, ast::Statements& to) = 0;
  virtual void newton(const BranchNode& node, const Place& at, ast::Statements& to) = 0;
  virtual void wrist(std::size_t step, const Place& at, ast::Statements& to) = 0;
  virtual void row(const Place& at, ast::Statements& to) = 0;
  virtual void joints(std::size_t step, const Place& at, ast::Statements& to);
  /// A step with one value.
  virtual void solve(std::size_t step, const Place& at, ast::Statements& to);

  [[nodiscard]] Place top() const;
  void follow(const BranchTree& tree, const Place& at, ast::Statements& to);
  /// A loop over a fork's two signs, in which the branch around it is put back in every round.
  void loop_of_signs(const BranchNode& node, const Place& at, bool unrolled, ast::Statements& to);
  /// Head of a loop over a step's values, and the place in its body.
  struct Loop {
    ast::Statement head;
    Place in;
  };
  [[nodiscard]] Loop open(const derive::inverse::Step& step, const ast::Expression& rounds, const Place& at,
                          ast::Statements& to) const;

  [[nodiscard]] ast::Expression call(std::size_t step, const Place& at,
                                     const ast::Expression& sign = {}) const {
    return step_call(plan_, step, at.target, sign, at.work);
  }
  [[nodiscard]] const derive::inverse::Step& step(std::size_t i) const { return plan_.plan.steps[i]; }
  [[nodiscard]] ast::Statement leave(const Place& at) const;
  [[nodiscard]] ast::Statement leave_if_none(const Place& at) const;
  /// The value of a joint that the caller fixes goes to the row.
  void put_given(const ast::Expression& target, ast::Statements& to) const;

  const derive::inverse::LoweredPlan& plan_;
  ast::Element number_;
};

/// A branch's label in a fork with that loop variable, by the label of the branch around it (nothing if
/// none).
ast::Expression branch_label(const ast::Expression& above, int branches, const std::string& loop_variable);
/// A label times a number; 0 of none.
ast::Expression times(int factor, const ast::Expression& label);

}  // namespace qvgen::emit
