// SPDX-License-Identifier: MIT
// The Jacobian of the tool point in the base frame by the three methods of the Jacobian lecture
// (section 5.4), as they stand there, over the frames of exact_arm.h that are parallel to the world's at
// zero.
#include "canonical/right_angles.h"
#include "compare/chain.h"
#include "compare/exact_arm.h"
#include "compare/formulation.h"
#include "derive/jacobian/quantities.h"
#include "optimise/optimise.h"

namespace qvgen::compare {
namespace {

struct Column {
  Vector linear, angular;
};

Results results(const std::vector<Column>& columns) {
  Results list;
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t j = 0; j < columns.size(); ++j)
      list.push_back(
          {derive::jacobian_entry(row, j), row < 3 ? columns[j].linear[row] : columns[j].angular[row - 3]});
  return list;
}

/// A joint's numbers, stored, and what it does at this moment.
struct JointMatrices {
  bool revolute;
  Vector axis, way;  ///< from the joint before: the offset, with the slide
  Matrix rotation;
};

std::vector<JointMatrices> joints_of(const ParallelArm& arm, Recorder& recorder) {
  std::vector<JointMatrices> list;
  for (const auto& joint : arm.joints) {
    const Vector offset = stored(joint.offset, recorder), axis = stored(joint.axis, recorder);
    if (joint.revolute)
      list.push_back(
          {true, axis, offset, rotation(axis, recorder.circle(variable(joint.variable)), recorder)});
    else
      list.push_back({false, axis, offset + recorder.argument(joint.variable) * axis, identity(recorder)});
  }
  return list;
}

/// Link velocities from joint to joint, v' = R^T (v + omega x P), omega' = R^T omega, for the unit rate of
/// each joint; those of the tool are turned into the base frame. Slides turn nothing: whoever writes the
/// program knows them.
Results propagation(Recorder& recorder, const model::Robot& robot) {
  const ParallelArm arm = parallel_arm(robot, recorder.graph());
  const auto joints = joints_of(arm, recorder);
  const Vector tool = stored(arm.tool, recorder);
  Chain<Matrix> whole;
  for (const auto& joint : joints)
    if (joint.revolute) whole.append(joint.rotation);
  std::vector<Column> columns;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    Column twist{joints[j].axis, zero(recorder)};
    if (joints[j].revolute) std::swap(twist.linear, twist.angular);
    for (std::size_t k = j + 1; k < joints.size(); ++k) {
      twist.linear = twist.linear + cross(twist.angular, joints[k].way);
      if (!joints[k].revolute) continue;
      const Matrix back = transpose(joints[k].rotation);
      twist = {back * twist.linear, back * twist.angular};
    }
    twist.linear = twist.linear + cross(twist.angular, tool);
    if (whole.empty())
      columns.push_back(twist);
    else
      columns.push_back({whole.value() * twist.linear, whole.value() * twist.angular});
  }
  return results(columns);
}

/// z_i x (p - p_i) and z_i, by the frames in the base.
Results cross_products(Recorder& recorder, const model::Robot& robot) {
  const ParallelArm arm = parallel_arm(robot, recorder.graph());
  const auto joints = joints_of(arm, recorder);
  Chain<Transform> chain;
  std::vector<Vector> axes, points;
  for (const auto& joint : joints) {
    axes.push_back(chain.empty() ? joint.axis : chain.value().r * joint.axis);
    chain.append({joint.rotation, joint.way});
    points.push_back(chain.value().p);
  }
  const Vector tool = chain.value().r * stored(arm.tool, recorder) + chain.value().p;
  std::vector<Column> columns;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].revolute)
      columns.push_back({cross(axes[j], tool - points[j]), axes[j]});
    else
      columns.push_back({axes[j], zero(recorder)});
  }
  return results(columns);
}

/// Position and quaternion of Q_1 ... Q_n differentiated by the product rule: A Q_j' B with the products A
/// before and B behind the joint; omega is the vector part of 2 q' q^-1.
class Differentiation {
 public:
  Differentiation(Recorder& recorder, const model::Robot& robot)
      : recorder_(recorder), arm_(parallel_arm(robot, recorder.graph())) {}

  Results run() {
    for (const auto& joint : arm_.joints) pairs_.push_back(pair_of(joint));
    before_.emplace_back();
    for (std::size_t j = 0; j + 1 < pairs_.size(); ++j) {
      Chain<Pair> next = before_.back();
      next.append(pairs_[j].pair);
      before_.push_back(next);
    }
    Pair behind{stored(arm_.home_quaternion, recorder_), stored(arm_.tool, recorder_)};
    std::vector<Column> columns(pairs_.size(), {zero(recorder_), zero(recorder_)});
    for (std::size_t j = pairs_.size(); j-- > 0;) {
      columns[j] = column(j, behind);
      if (j > 0) behind = pairs_[j].pair * behind;
    }
    return results(columns);
  }

 private:
  struct JointPair {
    bool revolute;
    Vector axis;
    Recorder::Circle half_angle;
    Pair pair;
  };

  JointPair pair_of(const ParallelArm::Joint& joint) {
    const Vector offset = stored(joint.offset, recorder_), axis = stored(joint.axis, recorder_);
    if (joint.revolute) {
      const auto angle = recorder_.circle(half(joint.variable));
      return {true, axis, angle, {rotation(axis, angle), offset}};
    }
    const Value none = recorder_.entry(0);
    return {false,
            axis,
            {none, none},
            {identity_quaternion(recorder_), offset + recorder_.argument(joint.variable) * axis}};
  }

  Vector turned_before(std::size_t j, const Vector& v) const {
    return before_[j].empty() ? v : turned(before_[j].value().q, v);
  }

  Column column(std::size_t j, const Pair& behind) {
    const JointPair& joint = pairs_[j];
    if (!joint.revolute) return {turned_before(j, joint.axis), zero(recorder_)};
    const Value one_half = recorder_.literal(cln::cl_RA(1) / 2), two = recorder_.literal(2);
    const Quaternion rate{-(one_half * joint.half_angle.sine),
                          (one_half * joint.half_angle.cosine) * joint.axis};
    const Quaternion swept = rate * Quaternion{recorder_.entry(0), behind.p} * conjugate(joint.pair.q);
    const Quaternion from_here = rate * behind.q, all = joint.pair.q * behind.q;
    const bool first = before_[j].empty();
    const Quaternion change = first ? from_here : before_[j].value().q * from_here;
    const Quaternion whole = first ? all : before_[j].value().q * all;
    return {turned_before(j, two * swept.v), two * (change * conjugate(whole)).v};
  }

  Recorder& recorder_;
  ParallelArm arm_;
  std::vector<JointPair> pairs_;
  std::vector<Chain<Pair>> before_;  ///< each joint
};

Results differentiation(Recorder& recorder, const model::Robot& robot) {
  return Differentiation(recorder, robot).run();
}

/// All forms together, as large functions are searched.
dag::Function emitted(const model::Robot& robot) {
  optimise::OptimiseOptions options;
  options.also_fewest = false;
  options.simplify_forms = false;
  options.search.iterations = 100'000;
  optimise::Quantity quantity =
      optimise::lowered(derive::jacobian(canonical::whatever_notation(robot).robot));
  quantity.is_free = free_symbols(robot);
  return optimise::optimise(quantity, options).function;
}

}  // namespace

std::vector<Formulation> jacobian_formulations() {
  return {{"propagation", "link velocities from joint to joint", propagation},
          {"cross_products", "cross products of axes", cross_products},
          {"differentiation", "differentiation of position and quaternion", differentiation},
          {"emitted", "as generated", {}, false, emitted}};
}

}  // namespace qvgen::compare
