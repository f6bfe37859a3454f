// SPDX-License-Identifier: MIT
#include "emit/inverse/branch_tree.h"

#include <algorithm>

#include "derive/inverse/inverse.h"
#include "derive/inverse/schedule.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::Plan;
using derive::inverse::Step;
using Kind = BranchNode::Kind;
using Order = std::vector<std::size_t>;

void append(BranchTree& statements, BranchTree&& more) {
  std::move(more.begin(), more.end(), std::back_inserter(statements));
  more.clear();
}

BranchTree own_joints(const Plan& plan, std::size_t index) {
  if (plan.steps[index].joints().empty()) return {};
  return {{Kind::joints, index}};
}

/// The joints of all steps before one.
BranchTree joints_before(const Plan& plan, const Order& order, std::size_t end) {
  BranchTree joints;
  for (std::size_t at = 0; at < end; ++at) append(joints, own_joints(plan, order[at]));
  return joints;
}

/// From a place in the order on; `written`: whether joints' values are final there.
BranchTree tree_from(const Plan& plan, const Order& order, std::size_t at, bool written) {
  BranchTree tree;
  for (; at < order.size(); ++at) {
    const std::size_t index = order[at];
    const Step& step = plan.steps[index];
    if (step.ends_plan()) {
      tree.push_back({Kind::last_wrist, index});
      return tree;
    }
    const bool newton = step.is<kind::Newton>();
    BranchTree joints = newton    ? joints_before(plan, order, at)
                        : written ? own_joints(plan, index)
                                  : BranchTree{};
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

bool is_half(const Plan& plan, const BranchNode& statement) {
  return statement.kind == Kind::solve && plan.steps[statement.step].is<kind::Half>();
}

/// True if half angles must be there before a step.
bool needs_halves(const Plan& plan, const BranchNode& statement) {
  const Step& step = plan.steps[statement.step];
  return step.wrist() != nullptr || derive::inverse::reads_halves(plan, step);
}

bool is_fork_of_signs(const Plan& plan, const BranchNode& statement) {
  return statement.kind == Kind::fork && !plan.steps[statement.step].is_quartic();
}

/// True if all that waits must be done before a statement.
bool needs_all(const Plan& plan, const BranchNode& statement) {
  if (statement.kind == Kind::row || statement.kind == Kind::last_wrist) return true;
  if (statement.kind == Kind::fork) return plan.steps[statement.step].wrist() != nullptr;
  return statement.kind == Kind::solve && needs_halves(plan, statement);
}

BranchTree late(const Plan& plan, const BranchTree& tree, BranchTree waiting) {
  BranchTree result;
  for (const BranchNode& statement : tree) {
    if (statement.kind == Kind::joints || is_half(plan, statement)) {
      waiting.push_back(statement);
      continue;
    }
    if (needs_all(plan, statement)) append(result, std::move(waiting));
    BranchNode& copy = result.emplace_back(BranchNode{statement.kind, statement.step});
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

  BranchTree arranged(const BranchTree& tree) {
    BranchTree result;
    for (const BranchNode& statement : tree) arrange(statement, result);
    return result;
  }

 private:
  void arrange(const BranchNode& statement, BranchTree& result) {
    if (statement.kind == Kind::joints) return joints_.push_back(statement);
    if (is_half(plan_, statement)) return (leaves_ ? halves_ : result).push_back(statement);
    if (statement.kind == Kind::row || statement.kind == Kind::last_wrist) {
      flush(result);
      return result.push_back(statement);
    }
    if (needs_halves(plan_, statement)) append(result, std::move(halves_));
    BranchNode& copy = result.emplace_back(BranchNode{statement.kind, statement.step});
    leaves_ = may_leave_after(statement.step);
    if (statement.kind == Kind::solve) {
      if (!leaves_) flush(result);
      return;
    }
    if (!leaves_) flush(copy.body);
    append(copy.body, arranged(statement.body));
  }

  void flush(BranchTree& result) {
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
  BranchTree halves_, joints_;
  bool leaves_ = true;
};

}  // namespace

BranchTree branch_tree(const Plan& plan, bool careful) {
  return tree_from(plan, derive::inverse::order(plan, careful), 0, !careful);
}

BranchTree with_late_angles(const Plan& plan, const BranchTree& tree) { return late(plan, tree, {}); }

BranchTree with_late_angles_in_lanes(const Plan& plan, const BranchTree& tree) {
  return LateInLanes(plan).arranged(tree);
}

}  // namespace qvgen::emit
