// SPDX-License-Identifier: MIT
// Forward kinematics joint by joint, from the base to the tool. A base or tool frame that is the identity is
// not multiplied: whoever writes such a program knows that there is none.
#include <optional>

#include "canonical/right_angles.h"
#include "compare/chain.h"
#include "compare/exact_arm.h"
#include "compare/formulation.h"
#include "derive/dynamics/chain.h"
#include "derive/kinematics/forward_kinematics.h"
#include "optimise/optimise.h"
#include "optimise/pose.h"

namespace qvgen::compare {
namespace {

Results results(const Quaternion& q, const Vector& p) {
  return {{"w", q.w}, {"x", q.v[0]}, {"y", q.v[1]}, {"z", q.v[2]}, {"px", p[0]}, {"py", p[1]}, {"pz", p[2]}};
}

Results results(const Transform& t) {
  Results list;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      list.push_back({"r" + std::to_string(i + 1) + std::to_string(k + 1), t.r[i][k]});
  list.push_back({"px", t.p[0]});
  list.push_back({"py", t.p[1]});
  list.push_back({"pz", t.p[2]});
  return list;
}

/// Thesis 1.9, 1.10, 1.12: Q_i = ([cos, sin axis], offset), or (1, offset + axis d).
Results pairs(Recorder& recorder, const model::Robot& robot) {
  const ParallelArm arm = parallel_arm(robot, recorder.graph());
  Chain<Pair> chain;
  for (const auto& joint : arm.joints) {
    const Vector offset = stored(joint.offset, recorder), axis = stored(joint.axis, recorder);
    if (joint.revolute)
      chain.append({rotation(axis, recorder.circle(half(joint.variable))), offset});
    else
      chain.append({identity_quaternion(recorder), offset + recorder.argument(joint.variable) * axis});
  }
  if (!arm.ends_in_tool()) chain.append({stored(arm.home_quaternion, recorder), stored(arm.tool, recorder)});
  return results(chain.value().q, chain.value().p);
}

/// Gupta 1986: the same frames, the rotations about the axes of the zero reference position as matrices.
Results zero_reference(Recorder& recorder, const model::Robot& robot) {
  const ParallelArm arm = parallel_arm(robot, recorder.graph());
  Chain<Transform> chain;
  for (const auto& joint : arm.joints) {
    const Vector offset = stored(joint.offset, recorder), axis = stored(joint.axis, recorder);
    if (joint.revolute)
      chain.append({rotation(axis, recorder.circle(variable(joint.variable)), recorder), offset});
    else
      chain.append({identity(recorder), offset + recorder.argument(joint.variable) * axis});
  }
  if (!arm.ends_in_tool()) chain.append(stored({arm.home, arm.tool}, recorder));
  return results(chain.value());
}

/// Points on the axes in the world at zero, and the tool's position there.
std::vector<ExactVector> points_of(const ParallelArm& arm) {
  std::vector<ExactVector> points;
  ExactVector point;
  for (const auto& joint : arm.joints) points.push_back(point = point + joint.offset);
  points.push_back(point + arm.tool);
  return points;
}

/// exp([w] theta) with its point r: (R, r - R r); of a slide (1, axis d). The tool's pose at zero is the last
/// factor.
Results exponentials(Recorder& recorder, const model::Robot& robot) {
  const ParallelArm arm = parallel_arm(robot, recorder.graph());
  const auto points = points_of(arm);
  Chain<Transform> chain;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const auto& joint = arm.joints[i];
    const Vector axis = stored(joint.axis, recorder);
    if (joint.revolute) {
      const Vector point = stored(points[i], recorder);
      const Matrix r = rotation(axis, recorder.circle(variable(joint.variable)), recorder);
      chain.append({r, point - r * point});
    } else {
      chain.append({identity(recorder), recorder.argument(joint.variable) * axis});
    }
  }
  chain.append(stored({arm.home, points.back()}, recorder));
  return results(chain.value());
}

/// Multiplies the screws as dual quaternions: cos + sin (w + e m), m = r x w; of a slide 1 + e axis d/2.
Results dual_quaternions(Recorder& recorder, const model::Robot& robot) {
  const ParallelArm arm = parallel_arm(robot, recorder.graph());
  const auto points = points_of(arm);
  const Value one_half = recorder.literal(cln::cl_RA(1) / 2);
  Chain<DualQuaternion> chain;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const auto& joint = arm.joints[i];
    const Vector axis = stored(joint.axis, recorder);
    if (joint.revolute) {
      const Vector moment = stored(cross(points[i], joint.axis), recorder);
      const auto angle = recorder.circle(half(joint.variable));
      chain.append({rotation(axis, angle), {recorder.entry(0), angle.sine * moment}});
    } else {
      chain.append({identity_quaternion(recorder),
                    {recorder.entry(0), (one_half * recorder.argument(joint.variable)) * axis}});
    }
  }
  const Exact exact_half(recorder.graph(), recorder.graph().constant(cln::cl_RA(1) / 2));
  const ExactVector p = exact_half * points.back();
  const ExactQuaternion dual = product({Exact(), p[0], p[1], p[2]}, arm.home_quaternion);
  chain.append({stored(arm.home_quaternion, recorder), stored(dual, recorder)});
  const DualQuaternion& tool = chain.value();
  return results(tool.real, recorder.literal(2) * (tool.dual * conjugate(tool.real)).v);
}

/// Rz(theta) Tx(a) Rx(alpha) written out, with the products that a table's row needs.
struct RowMotion {
  Matrix r;
  Value x, y;  ///< a cos, a sin
};

/// The row's cosines and sines: of the variable, or of a slide's constant angle.
RowMotion row_motion(const TableRow& row, Recorder& recorder) {
  dag::Graph& graph = recorder.graph();
  const auto constant = [&](const dag::Angle& angle) {
    const auto c = derive::dynamics::circle(angle, graph);
    return Recorder::Circle{recorder.stored(c.cosine), recorder.stored(c.sine)};
  };
  const auto theta = row.revolute ? recorder.circle(row.theta + variable(row.variable)) : constant(row.theta);
  const auto alpha = constant(row.alpha);
  const Value a = recorder.stored(row.a), none = recorder.entry(0);
  const Value &c = theta.cosine, &s = theta.sine, &ca = alpha.cosine, &sa = alpha.sine;
  return {{{{c, -(s * ca), s * sa}, {s, c * ca, -(c * sa)}, {none, sa, ca}}}, a * c, a * s};
}

Value shift(const TableRow& row, Recorder& recorder) {
  const Value d = recorder.stored(row.d);
  return row.revolute ? d : d + recorder.argument(row.variable);
}

/// Rz(theta) Tz(d) Tx(a) Rx(alpha).
Results denavit_hartenberg_matrices(Recorder& recorder, const model::Robot& robot) {
  const Table table = denavit_hartenberg(robot, recorder.graph());
  Chain<Transform> chain;
  if (!table.base.is_identity()) chain.append(stored(table.base, recorder));
  for (const TableRow& row : table.rows) {
    const RowMotion motion = row_motion(row, recorder);
    chain.append({motion.r, {motion.x, motion.y, shift(row, recorder)}});
    if (!row.rest.is_identity()) chain.append(stored(row.rest, recorder));
  }
  return results(chain.value());
}

/// Thesis, section 1.3.1: seen from axis i+1, d and alpha have changed places: Rz(theta) Rx(alpha) Tx(a)
/// Tz(d), d along the next axis. What lies along the first axis, or an axis behind a constant frame, stands
/// alone.
Results pieper_roth(Recorder& recorder, const model::Robot& robot) {
  const Table table = denavit_hartenberg(robot, recorder.graph());
  Chain<Transform> chain;
  const auto along = [&](const TableRow& row) {
    if (!row.revolute || !row.d.is_zero())
      chain.append({identity(recorder), {recorder.entry(0), recorder.entry(0), shift(row, recorder)}});
  };
  if (!table.base.is_identity()) chain.append(stored(table.base, recorder));
  along(table.rows.front());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const TableRow& row = table.rows[i];
    const RowMotion motion = row_motion(row, recorder);
    const bool last = i + 1 == table.rows.size();
    const Vector x{motion.x, motion.y, recorder.entry(0)};
    if (last || !row.rest.is_identity()) {
      chain.append({motion.r, x});
      if (!row.rest.is_identity()) chain.append(stored(row.rest, recorder));
      if (!last) along(table.rows[i + 1]);
    } else {
      const Value d = shift(table.rows[i + 1], recorder);
      const Vector z = column(motion.r, 2);
      chain.append({motion.r, {motion.x + d * z[0], motion.y + d * z[1], d * z[2]}});
    }
  }
  return results(chain.value());
}

/// Takes z to b, in the one way that is continuous in b where b_z >= 0.
ExactMatrix rotation_to(const ExactVector& b, dag::Graph& graph) {
  const Exact one(graph, graph.constant(1));
  const Exact k = one / (one + b[2]);
  return {{{one - k * b[0] * b[0], -(k * b[0] * b[1]), b[0]},
           {-(k * b[0] * b[1]), one - k * b[1] * b[1], b[1]},
           {-b[0], -b[1], b[2]}}};
}

/// Zhuang, Roth and Hamano 1992: T = V_0 Q_1 V_1 ... Q_n V_n. Q_i turns about z or slides along it; V_i takes
/// z to the next axis in the way above, of its two senses the nearer one, and goes to the next joint. The
/// last leads to the tool.
Results complete_and_continuous(Recorder& recorder, const model::Robot& robot) {
  dag::Graph& graph = recorder.graph();
  const ParallelArm arm = parallel_arm(robot, graph);
  Chain<Transform> chain;
  ExactMatrix frame = matrix_of({}, graph);  // at zero, in the world
  const auto leave = [&](const ExactMatrix& turn, const ExactVector& offset) {
    chain.append({stored(turn, recorder), stored(product(transposed(frame), offset), recorder)});
    frame = product(frame, turn);
  };
  for (const auto& joint : arm.joints) {
    const bool reversed = sign(dot(joint.axis, column(frame, 2)), graph) < 0;
    const ExactVector b = product(transposed(frame), reversed ? -joint.axis : joint.axis);
    leave(rotation_to(b, graph), joint.offset);
    Transform motion{identity(recorder), zero(recorder)};
    if (joint.revolute) {
      const auto angle = recorder.circle(variable(joint.variable));
      const Value s = reversed ? -angle.sine : angle.sine;
      motion.r[0] = {angle.cosine, -s, recorder.entry(0)};
      motion.r[1] = {s, angle.cosine, recorder.entry(0)};
    } else {
      const Value d = recorder.argument(joint.variable);
      motion.p[2] = reversed ? -d : d;
    }
    chain.append(motion);
  }
  leave(product(transposed(frame), matrix_of(arm.home, graph)), arm.tool);
  return results(chain.value());
}

}  // namespace

namespace {

dag::Function emitted(const model::Robot& robot, const derive::Quantity& derived) {
  optimise::OptimiseOptions options;
  options.also_fewest = false;
  optimise::Quantity quantity = optimise::lowered(derived);
  quantity.is_free = free_symbols(robot);
  return optimise::optimise(quantity, options).function;
}

dag::Function emitted_pose(const model::Robot& robot) {
  std::optional<dag::Function> best;
  for (const canonical::Arm& arm : optimise::arms_for_pose(robot)) {
    dag::Function function = emitted(robot, derive::forward_kinematics(arm.robot));
    const auto cost = [&](const dag::Function& f) {
      return passes::cost(dag::count(f, free_symbols(robot)));
    };
    if (!best || cost(function) < cost(*best)) best = std::move(function);
  }
  return *best;
}

dag::Function emitted_matrix(const model::Robot& robot) {
  return emitted(robot, derive::homogeneous_transform(canonical::whatever_notation(robot).robot));
}

}  // namespace

std::vector<Formulation> forward_formulations() {
  return {{"pairs", "quaternion/vector pairs", pairs},
          {"dh", "Denavit-Hartenberg matrices", denavit_hartenberg_matrices, true},
          {"poe", "product of exponentials, rotation matrices", exponentials},
          {"zero_reference", "zero reference position", zero_reference},
          {"pieper_roth", "Pieper-Roth matrices", pieper_roth, true},
          {"cpc", "complete and parametrically continuous", complete_and_continuous},
          {"dual_quaternions", "dual quaternions", dual_quaternions},
          {"emitted_pose", "as generated, quaternion", {}, false, emitted_pose},
          {"emitted_matrix", "as generated, matrix", {}, false, emitted_matrix}};
}

}  // namespace qvgen::compare
