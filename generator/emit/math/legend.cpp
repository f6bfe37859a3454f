// SPDX-License-Identifier: MIT
#include "emit/math/legend.h"

#include <cln/real.h>
#include <fmt/format.h>

#include "exact/constant_angle.h"

namespace qvgen::emit {

std::vector<std::string> legend(const canonical::Arm& arm) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < arm.phases.size(); ++i) {
    if (arm.phases[i] == exact::Angle{}) continue;
    const double phase = cln::double_approx(*exact::radians(arm.phases[i]));
    const std::string& name = arm.robot.joints[i].variable;
    lines.push_back(fmt::format("below, {} stands for {} {} {:.6g}", name, name, phase < 0 ? "-" : "+",
                                phase < 0 ? -phase : phase));
  }
  return lines;
}

}  // namespace qvgen::emit
