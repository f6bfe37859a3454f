// SPDX-License-Identifier: MIT
#include "compare/exact_arm.h"

#include <algorithm>

#include "derive/dynamics/chain.h"
#include "exact/constant_angle.h"
#include "exact/named_constant.h"
#include "passes/constants.h"

namespace qvgen::compare {

using derive::dynamics::circle;
using derive::dynamics::recomposed;
using derive::dynamics::reduced;
using derive::dynamics::RotationSequence;
using derive::dynamics::to_scalar;
using derive::dynamics::to_sequence;

ExactVector exact(const model::Vector3& v, dag::Graph& graph) {
  return {to_scalar(v[0], graph), to_scalar(v[1], graph), to_scalar(v[2], graph)};
}

ExactVector turned(const RotationSequence& turns, ExactVector v, dag::Graph& graph) {
  for (auto turn = turns.rbegin(); turn != turns.rend(); ++turn)
    v = rotate(turn->axis, circle(turn->angle, graph), v);
  return v;
}

ExactMatrix matrix_of(const RotationSequence& turns, dag::Graph& graph) {
  ExactMatrix rows;
  const Exact one(graph, graph.constant(1));
  for (std::size_t k = 0; k < 3; ++k) {
    ExactVector unit;
    unit[k] = one;
    const ExactVector image = turned(turns, unit, graph);
    for (std::size_t i = 0; i < 3; ++i) rows[i][k] = image[i];
  }
  return rows;
}

ExactQuaternion product(const ExactQuaternion& a, const ExactQuaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}

Exact dot(const ExactVector& a, const ExactVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
ExactVector product(const ExactMatrix& m, const ExactVector& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}
ExactMatrix transposed(const ExactMatrix& m) { return {column(m, 0), column(m, 1), column(m, 2)}; }
ExactMatrix product(const ExactMatrix& a, const ExactMatrix& b) {
  return transposed({product(a, column(b, 0)), product(a, column(b, 1)), product(a, column(b, 2))});
}

int sign(const Exact& number, const dag::Graph& graph) {
  if (number.is_zero()) return 0;
  dag::Function function{graph, {}};
  function.outputs.push_back({"", number.in(function.graph)});
  function = passes::fold_constants(function);
  const dag::Edge edge = function.outputs.front().value;
  if (function.graph.is_constant(edge)) return function.graph.value_of(edge).sign();
  const dag::Node& node = function.graph.node(edge);
  if (node.op != dag::Op::symbol) return 0;
  const auto value = exact::named_value(function.graph.symbol_of(node));
  return !value ? 0 : cln::minusp(*value) != edge.negative ? -1 : 1;
}

namespace {

/// A constant way along the chain: orientation and place in a frame parallel to the world's.
struct Walk {
  dag::Graph& graph;
  RotationSequence orientation;
  ExactQuaternion quaternion;
  ExactVector offset;

  void step(const model::Displacement& displacement) {
    offset = offset + turned(orientation, exact(displacement.translation, graph), graph);
    orientation = recomposed(reduced(orientation * to_sequence(displacement.turns)));
    for (const model::Turn& turn : displacement.turns) {
      const auto half = circle(cln::cl_RA(1) / 2 * derive::dynamics::to_angle(turn.angle), graph);
      const ExactVector v = half.sine * exact(turn.axis, graph);
      quaternion = product(quaternion, {half.cosine, v[0], v[1], v[2]});
    }
  }
};

bool is_zero(const ExactVector& v) {
  return std::all_of(v.begin(), v.end(), [](const Exact& e) { return e.is_zero(); });
}

}  // namespace

ParallelArm parallel_arm(const model::Robot& robot, dag::Graph& graph) {
  ParallelArm arm;
  Walk walk{graph, {}, {Exact(graph, graph.constant(1)), {}, {}, {}}, {}};
  walk.step(robot.base);
  for (const model::Joint& joint : robot.joints) {
    walk.step(joint.before);
    arm.joints.push_back({joint.type == model::JointType::revolute,
                          joint.variable,
                          walk.offset,
                          turned(walk.orientation, exact(joint.axis, graph), graph),
                          {}});
    walk.offset = {};
    walk.step(joint.after);
    arm.joints.back().link = {walk.orientation, walk.offset};
  }
  walk.step(robot.tool);
  arm.tool = walk.offset;
  arm.home = walk.orientation;
  arm.home_quaternion = walk.quaternion;
  return arm;
}

bool ParallelArm::ends_in_tool() const { return home.empty() && is_zero(tool); }

bool ExactFrame::is_identity() const { return turns.empty() && is_zero(offset); }

namespace {

dag::Angle quarter(long count) { return {{}, cln::cl_RA(count) / 2}; }

dag::Angle take(RotationSequence& sequence, std::size_t axis) {
  if (sequence.empty() || sequence.front().axis != axis) return {};
  const dag::Angle angle = sequence.front().angle;
  sequence.erase(sequence.begin());
  return angle;
}

ExactVector turned_back(const dag::Angle& angle, const ExactVector& v, dag::Graph& graph) {
  return unrotate(2, circle(angle, graph), v);
}

/// The way from one joint, its axis z, to the next: Rz(phi) T(0,0,d) T(a,0,0) Rx(alpha), then `rest`, whose
/// offset along z and first turn about it belong to the next row.
struct Passage {
  dag::Angle phi, alpha;
  Exact d, a;
  ExactFrame rest;
};

Passage passage_of(RotationSequence turns, const ExactVector& offset, dag::Graph& graph) {
  Passage passage;
  turns = recomposed(reduced(std::move(turns)));
  passage.phi = take(turns, 2);
  passage.alpha = take(turns, 0);
  ExactVector t = turned_back(passage.phi, offset, graph);
  const auto [cosine, sine] = circle(passage.alpha, graph);
  const bool parallel = sine.is_zero();
  if (parallel && t[0].is_zero() && !t[1].is_zero()) {
    // The common normal is free where axes are parallel: along y. Rz(1/4) before a half turn is Rz(-1/4)
    // behind it.
    passage.phi = passage.phi + quarter(1);
    const bool flipped = !cosine.is_one();
    turns = reduced(RotationSequence{{2, quarter(flipped ? 1 : -1)}} * turns);
    t = {t[1], -t[0], t[2]};
  }
  passage.a = t[0];
  passage.d = t[2];
  passage.rest.turns = std::move(turns);
  if (t[1].is_zero()) return passage;
  const bool known = exact::radians(passage.alpha).has_value();
  if (!parallel && known) {
    // y = -e sin(alpha), z = d + e cos(alpha): from the foot of the common normal by e along the next axis
    const Exact e = -t[1] / sine;
    passage.d = t[2] - e * cosine;
    passage.rest.offset[2] = e;
    return passage;
  }
  passage.rest.turns = reduced(RotationSequence{{0, passage.alpha}} * passage.rest.turns);
  passage.rest.offset[1] = t[1];
  passage.alpha = {};
  return passage;
}

bool is_along_z(const ExactFrame& frame) {
  const bool turns_about_z =
      frame.turns.empty() || (frame.turns.size() == 1 && frame.turns.front().axis == 2);
  return turns_about_z && frame.offset[0].is_zero() && frame.offset[1].is_zero();
}

class TableBuilder {
 public:
  TableBuilder(const model::Robot& robot, dag::Graph& graph) : robot_(robot), graph_(graph) {}

  Table build() {
    const auto& joints = robot_.joints;
    Table table;
    table.base = way(robot_.base, joints.front().before, to_sequence(robot_.base.turns));
    const auto first = derive::dynamics::from_z_to(joints.front().axis);
    table.base.turns = recomposed(reduced(table.base.turns * first));
    ExactFrame* behind = &table.base;
    table.rows.reserve(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      TableRow row;
      row.revolute = joints[i].type == model::JointType::revolute;
      row.variable = joints[i].variable;
      begin(row, *behind);
      finish(row, i);
      table.rows.push_back(row);
      behind = &table.rows.back().rest;
    }
    return table;
  }

 private:
  [[nodiscard]] ExactFrame way(const model::Displacement& first, const model::Displacement& second,
                               const RotationSequence& turns) const {
    return {turns * to_sequence(second.turns),
            exact(first.translation, graph_) + turned(turns, exact(second.translation, graph_), graph_)};
  }

  /// Takes from what is left behind the row before what lies along this row's axis.
  void begin(TableRow& row, ExactFrame& left) const {
    if (!left.turns.empty() && left.turns.back().axis == 2) {
      row.theta = left.turns.back().angle;
      left.turns.pop_back();
    }
    if (!left.turns.empty() || !is_along_z(left)) return;
    row.d = left.offset[2];
    left.offset[2] = {};
  }

  void finish(TableRow& row, std::size_t i) const {
    const model::Joint& here = robot_.joints[i];
    const bool last = i + 1 == robot_.joints.size();
    const RotationSequence back = inverse(derive::dynamics::from_z_to(here.axis));
    const auto after = to_sequence(here.after.turns);
    const model::Displacement& next = last ? robot_.tool : robot_.joints[i + 1].before;
    ExactFrame between = way(here.after, next, after);
    between.turns = back * between.turns;
    if (!last) between.turns = between.turns * derive::dynamics::from_z_to(robot_.joints[i + 1].axis);
    const Passage passage = passage_of(between.turns, turned(back, between.offset, graph_), graph_);
    row.theta = row.theta + passage.phi;
    row.d = row.d + passage.d;
    row.a = passage.a;
    row.alpha = passage.alpha;
    row.rest = passage.rest;
  }

  const model::Robot& robot_;
  dag::Graph& graph_;
};

}  // namespace

Table denavit_hartenberg(const model::Robot& robot, dag::Graph& graph) {
  return TableBuilder(robot, graph).build();
}

Vector stored(const ExactVector& v, Recorder& recorder) {
  return {recorder.stored(v[0]), recorder.stored(v[1]), recorder.stored(v[2])};
}

Quaternion stored(const ExactQuaternion& q, Recorder& recorder) {
  return {recorder.stored(q[0]), stored(ExactVector{q[1], q[2], q[3]}, recorder)};
}

Matrix stored(const ExactMatrix& m, Recorder& recorder) {
  return {stored(m[0], recorder), stored(m[1], recorder), stored(m[2], recorder)};
}

Transform stored(const ExactFrame& frame, Recorder& recorder) {
  return {stored(matrix_of(frame.turns, recorder.graph()), recorder), stored(frame.offset, recorder)};
}

}  // namespace qvgen::compare
