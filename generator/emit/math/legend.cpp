// SPDX-License-Identifier: MIT
#include "emit/math/legend.h"

#include <cln/real.h>
#include <fmt/format.h>

#include "exact/constant_angle.h"

namespace qvgen::emit {

std::vector<std::string> legend(const model::Robot& described, const canonical::Arm& arm) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < described.joints.size(); ++i) {
    const std::string& name = arm.robot.joints[i].variable;
    const std::string& meant = described.joints[i].variable;
    const bool has_phase = !(arm.phases[i] == exact::Angle{});
    if (name == meant && !has_phase) continue;
    lines.push_back(
        fmt::format("below, {} stands for {}", name, name == meant ? "the joint's value" : meant));
    if (!has_phase) continue;
    const double phase = cln::double_approx(*exact::radians(arm.phases[i]));
    lines.back() += fmt::format(" {} {:.6g} rad", phase < 0 ? "-" : "+", phase < 0 ? -phase : phase);
  }
  return lines;
}

}  // namespace qvgen::emit
