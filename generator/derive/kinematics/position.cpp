// SPDX-License-Identifier: MIT
#include "derive/kinematics/position.h"

#include <map>
#include <set>

#include "derive/kinematics/turns.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

/// Names intermediate vectors, or leaves them written out.
using Name = std::function<Vector(const Vector&)>;
using Rotate = std::function<Vector(const Turn&, const Vector&)>;

/// A revolute joint and all that lies between the one before it and itself: constant offsets and prismatic
/// joints.
struct Pivot {
  Vector before;
  Vector axis;
  ex variable;
};

struct Pivots {
  std::vector<Pivot> joints;
  Vector beyond;  ///< from the last one to the tool
};

Pivots pivots(const ZeroReferenceChain& chain) {
  Pivots result;
  Vector walk;
  for (const auto& joint : chain.joints) {
    walk = walk + joint.offset;
    if (joint.type == model::JointType::prismatic) {
      walk = walk + symbol(joint.variable) * joint.axis;
    } else {
      result.joints.push_back({walk, joint.axis, symbol(joint.variable)});
      walk = {};
    }
  }
  result.beyond = walk + chain.tool_offset;
  return result;
}

bool extends_group(const std::vector<Pivot>& joints, std::size_t i) {
  return i > 0 && parallel(joints[i - 1].axis, joints[i].axis) != 0;
}

/// sum over the group's joints m of R(phi_m) v_m, phi_m the sum of the angles up to m; v_m leads to the next
/// joint, and for the last one it is what comes beyond the group.
Vector group_motion(const std::vector<Pivot>& joints, std::size_t first, std::size_t last,
                    const Vector& beyond, const Rotate& rotate_by) {
  Vector sum;
  ex angle = 0;
  for (std::size_t m = first; m <= last; ++m) {
    angle += parallel(joints[first].axis, joints[m].axis) * joints[m].variable;
    sum = sum + rotate_by({joints[first].axis, angle}, m == last ? beyond : joints[m + 1].before);
  }
  return sum;
}

Vector nested(const ZeroReferenceChain& chain, const Rotate& rotate_by, const Name& name) {
  const Pivots all = pivots(chain);
  Vector v = all.beyond;
  for (std::size_t i = all.joints.size(); i-- > 0;) {
    const std::size_t last = i;
    while (extends_group(all.joints, i)) --i;
    v = name(group_motion(all.joints, i, last, name(v), rotate_by) + all.joints[i].before);
  }
  return v;
}

using Angles = std::set<ex, GiNaC::ex_is_less>;

/// The angles whose sines a value reads.
void read_angles(const ex& value, Angles& angles) {
  for (auto it = value.preorder_begin(); it != value.preorder_end(); ++it)
    if (GiNaC::is_a<GiNaC::function>(*it) && GiNaC::ex_to<GiNaC::function>(*it).get_name() == "sin")
      angles.insert(it->op(0));
}

Angles angles_of(const Program& program, const Quaternion& q) {
  Angles angles;
  for (const auto& step : program.steps()) read_angles(step.value, angles);
  for (const ex& component : {q.w, q.x, q.y, q.z}) read_angles(component, angles);
  return angles;
}

/// The turn with sin = 2 s c and cos = 1 - 2 s^2 of the half angle where its sine and cosine are there
/// already: no second sine and cosine. Each angle once.
class HalfAngleTurn {
 public:
  HalfAngleTurn(Program& program, const Quaternion& orientation)
      : program_(program), halves_(angles_of(program, orientation)) {}

  Vector operator()(const Turn& turn, const Vector& v) {
    if (halves_.count(turn.angle / 2) + halves_.count(-turn.angle / 2) == 0) return turned(turn, v);
    const Turn placeholder{turn.axis, symbol("turn.angle")};
    const Vector shape = turned(placeholder, v);
    const auto [s, c] = sine_cosine(turn.angle);
    const GiNaC::exmap values{{GiNaC::sin(placeholder.angle), s}, {GiNaC::cos(placeholder.angle), c}};
    const auto put = [&](const ex& e) { return e.subs(values, GiNaC::subs_options::no_pattern); };
    return {put(shape.x), put(shape.y), put(shape.z)};
  }

 private:
  std::pair<ex, ex> sine_cosine(const ex& angle) {
    const auto place = known_.find(angle);
    if (place != known_.end()) return place->second;
    const ex s = GiNaC::sin(angle / 2);
    const ex twice = program_.let(2 * s);
    const std::pair<ex, ex> values{program_.let(twice * GiNaC::cos(angle / 2)), program_.let(1 - twice * s)};
    return known_.emplace(angle, values).first->second;
  }

  Program& program_;
  Angles halves_;
  std::map<ex, std::pair<ex, ex>, GiNaC::ex_is_less> known_;
};

bool is_zero(const Vector& v) { return v.x.is_zero() && v.y.is_zero() && v.z.is_zero(); }

Vector by_orientation(const ZeroReferenceChain& chain, Program& program, const Quaternion& orientation) {
  const Name name = [&](const Vector& v) { return program.let(v); };
  ZeroReferenceChain arm = chain;
  arm.tool_offset = {};
  const Vector in_tool = rotate(inverse(chain.home), chain.tool_offset);
  const Vector offset{in_tool.x.expand(), in_tool.y.expand(), in_tool.z.expand()};
  const Vector axis{orientation.x, orientation.y, orientation.z};
  // q v q^-1 = v + 2 (w t + axis x t), t = axis x v (thesis, below 1.12)
  const Vector t = program.let(ex(2) * cross(axis, offset));
  const Vector turned_offset = offset + orientation.w * t + cross(axis, t);
  return program.let(program.let(turned_offset) + nested(arm, HalfAngleTurn(program, orientation), name));
}

}  // namespace

std::vector<PositionForm> position_forms(const ZeroReferenceChain& chain) {
  std::vector<PositionForm> forms;
  forms.push_back({"position in full angles", [=](Program& program, const Quaternion&) {
                     return nested(chain, turned, [&](const Vector& v) { return program.let(v); });
                   }});
  forms.push_back({"position in doubled half angles where there are",
                   [=](Program& program, const Quaternion& orientation) {
                     return nested(chain, HalfAngleTurn(program, orientation),
                                   [&](const Vector& v) { return program.let(v); });
                   }});
  if (!is_zero(chain.tool_offset))
    forms.push_back({"tool offset by the quaternion", [=](Program& program, const Quaternion& orientation) {
                       return by_orientation(chain, program, orientation);
                     }});
  return forms;
}

Vector written_out_position(const ZeroReferenceChain& chain) {
  const Vector v = nested(chain, turned, [](const Vector& value) { return value; });
  return {v.x.expand(), v.y.expand(), v.z.expand()};
}

}  // namespace qvgen::derive
