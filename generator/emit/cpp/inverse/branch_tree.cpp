// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/branch_tree.h"

#include <algorithm>

#include "derive/inverse/inverse.h"
#include "derive/inverse/schedule.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::Plan;
using derive::inverse::Step;
using Kind = Statement::Kind;
using Order = std::vector<std::size_t>;

void append(Statements& statements, Statements&& more) {
  std::move(more.begin(), more.end(), std::back_inserter(statements));
  more.clear();
}

Statements own_joints(const Plan& plan, std::size_t index) {
  if (plan.steps[index].joints().empty()) return {};
  return {{Kind::joints, index}};
}

/// The joints of all steps before one.
Statements joints_before(const Plan& plan, const Order& order, std::size_t end) {
  Statements joints;
  for (std::size_t at = 0; at < end; ++at) append(joints, own_joints(plan, order[at]));
  return joints;
}

/// From a place in the order on; `written`: whether joints' values are final there.
Statements tree_from(const Plan& plan, const Order& order, std::size_t at, bool written) {
  Statements tree;
  for (; at < order.size(); ++at) {
    const std::size_t index = order[at];
    const Step& step = plan.steps[index];
    if (step.ends_plan()) {
      tree.push_back({Kind::last_wrist, index});
      return tree;
    }
    const bool newton = step.is<kind::Newton>();
    Statements joints = newton    ? joints_before(plan, order, at)
                        : written ? own_joints(plan, index)
                                  : Statements{};
    if (newton || step.branches > 1) {
      append(joints, tree_from(plan, order, at + 1, written || newton));
      tree.push_back({newton ? Kind::newton : Kind::fork, index, std::move(joints)});
      return tree;
    }
    tree.push_back({Kind::solve, index});
    append(tree, std::move(joints));
  }
  tree.push_back({Kind::row});
  return tree;
}

bool is_half(const Plan& plan, const Statement& statement) {
  return statement.kind == Kind::solve && plan.steps[statement.step].is<kind::Half>();
}

/// True if half angles must be there before a step.
bool needs_halves(const Plan& plan, const Statement& statement) {
  const Step& step = plan.steps[statement.step];
  return step.wrist() != nullptr || derive::inverse::reads_halves(plan, step);
}

bool is_fork_of_signs(const Plan& plan, const Statement& statement) {
  return statement.kind == Kind::fork && !plan.steps[statement.step].is_quartic();
}

/// True if all that waits must be done before a statement.
bool needs_all(const Plan& plan, const Statement& statement) {
  if (statement.kind == Kind::row || statement.kind == Kind::last_wrist) return true;
  if (statement.kind == Kind::fork) return plan.steps[statement.step].wrist() != nullptr;
  return statement.kind == Kind::solve && needs_halves(plan, statement);
}

Statements late(const Plan& plan, const Statements& tree, Statements waiting) {
  Statements result;
  for (const Statement& statement : tree) {
    if (statement.kind == Kind::joints || is_half(plan, statement)) {
      waiting.push_back(statement);
      continue;
    }
    if (needs_all(plan, statement)) append(result, std::move(waiting));
    Statement& copy = result.emplace_back(Statement{statement.kind, statement.step});
    if (statement.body.empty()) continue;
    if (is_fork_of_signs(plan, statement) && !waiting.empty()) {
      copy.body.push_back({Kind::once, 0, waiting});
      waiting.clear();
    }
    append(copy.body, late(plan, statement.body, waiting));
  }
  return result;
}

class LateInLanes {
 public:
  explicit LateInLanes(const Plan& plan) : plan_(plan) {}

  Statements arranged(const Statements& tree) {
    Statements result;
    for (const Statement& statement : tree) arrange(statement, result);
    return result;
  }

 private:
  void arrange(const Statement& statement, Statements& result) {
    if (statement.kind == Kind::joints) return joints_.push_back(statement);
    if (is_half(plan_, statement)) return (leaves_ ? halves_ : result).push_back(statement);
    if (statement.kind == Kind::row || statement.kind == Kind::last_wrist) {
      flush(result);
      return result.push_back(statement);
    }
    if (needs_halves(plan_, statement)) append(result, std::move(halves_));
    Statement& copy = result.emplace_back(Statement{statement.kind, statement.step});
    leaves_ = may_leave_after(statement.step);
    if (statement.kind == Kind::solve) {
      if (!leaves_) flush(result);
      return;
    }
    if (!leaves_) flush(copy.body);
    append(copy.body, arranged(statement.body));
  }

  void flush(Statements& result) {
    append(result, std::move(halves_));
    append(result, std::move(joints_));
  }

  [[nodiscard]] bool may_leave_after(std::size_t index) const {
    return std::any_of(plan_.steps.begin() + static_cast<std::ptrdiff_t>(index) + 1, plan_.steps.end(),
                       [](const Step& step) {
                         return (step.branches == 2 && !step.ends_plan()) || step.is<kind::Require>();
                       });
  }

  const Plan& plan_;
  Statements halves_, joints_;
  bool leaves_ = true;
};

/// True if a label needs no brackets in a product.
bool is_simple(const std::string& label) { return label.find(' ') == std::string::npos; }

}  // namespace

Statements branch_tree(const Plan& plan, bool careful) {
  return tree_from(plan, derive::inverse::order(plan, careful), 0, !careful);
}

Statements with_late_angles(const Plan& plan, const Statements& tree) { return late(plan, tree, {}); }

Statements with_late_angles_in_lanes(const Plan& plan, const Statements& tree) {
  return LateInLanes(plan).arranged(tree);
}

std::string times(int factor, const std::string& label) {
  return std::to_string(factor) + " * " + (is_simple(label) ? label : "(" + label + ")");
}

std::string branch_label(const std::string& above, int branches, const std::string& loop_variable) {
  return above.empty() ? loop_variable : times(branches, above) + " + " + loop_variable;
}

std::string indented(int depth, const std::string& line) {
  return std::string(static_cast<std::size_t>(2 * depth), ' ') + line;
}

}  // namespace qvgen::emit
