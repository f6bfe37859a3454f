// SPDX-License-Identifier: MIT
#include "derive/jacobian/definition.h"

#include "derive/jacobian/rates.h"
#include "derive/kinematics/forward_kinematics.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;

PlainJacobian plain_jacobian(const model::Robot& robot, Program& program) {
  PlainJacobian result;
  Program pose;
  result.tool = pair_product(robot, pose);
  program = pose;
  for (const model::Joint& joint : robot.joints) {
    // Each joint's derivatives start from the pose alone, not from those of the joints before it.
    Program partial = pose;
    const Rates rate(partial, {{symbol(joint.variable), 1}});
    const Quaternion spin = rate(result.tool.q) * inverse(result.tool.q);
    const Vector linear = rate(result.tool.p);
    for (std::size_t i = pose.steps().size(); i < partial.steps().size(); ++i)
      program.append(partial.steps()[i]);
    result.columns.push_back(
        {program.let(linear), program.let(GiNaC::ex(2) * Vector{spin.x, spin.y, spin.z})});
  }
  return result;
}

}  // namespace qvgen::derive
