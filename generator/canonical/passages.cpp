// SPDX-License-Identifier: MIT
#include "canonical/passages.h"

#include <algorithm>

#include "model/evaluate.h"

namespace qvgen::canonical {

using cln::cl_R;

namespace {

bool has_symbols(const model::Displacement& displacement) {
  return std::any_of(displacement.turns.begin(), displacement.turns.end(),
                     [](const model::Turn& turn) { return !model::symbols(turn.angle).empty(); });
}

}  // namespace

bool has_symbolic_turns(const model::Robot& robot) {
  return has_symbols(robot.base) || has_symbols(robot.tool) ||
         std::any_of(robot.joints.begin(), robot.joints.end(), [](const model::Joint& joint) {
           return has_symbols(joint.before) || has_symbols(joint.after);
         });
}

std::vector<Placement> passages(const model::Robot& robot, Definitions& definitions) {
  std::vector<Placement> result;
  Placement way = to_placement(robot.base, definitions);
  for (const model::Joint& joint : robot.joints) {
    const Rotation axis = from_z_to(joint.axis);
    result.push_back(way * to_placement(joint.before, definitions) * Placement{axis, {}});
    way = Placement{transpose(axis), {}} * to_placement(joint.after, definitions);
  }
  result.push_back(way * to_placement(robot.tool, definitions));
  return result;
}

std::optional<cl_R> heading(const LengthVector& v) {
  const Length& x = v[0];
  const Length& y = v[1];
  if (x.empty() && y.empty()) return std::nullopt;
  const auto angle = [](const cl_R& c, const cl_R& s) {
    const cln::float_format_t format = cln::float_format(model::evaluation_digits);
    return wrapped(cln::atan(cln::cl_float(c, format), cln::cl_float(s, format)));
  };
  if (y.empty()) return cl_R(0);
  if (x.empty()) return angle(0, 1);
  // The polynomials may differ by a factor.
  const cl_R ratio = y.begin()->second / x.begin()->second;
  const Length rest = y + cl_R(-1) * (ratio * x);
  if (!rest.empty()) return std::nullopt;
  return angle(1, ratio);
}

}  // namespace qvgen::canonical
