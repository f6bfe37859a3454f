// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/lane_wrist.h"

#include <algorithm>
#include <array>

#include "emit/cpp/inverse/joint_code.h"

namespace qvgen::emit {

using derive::inverse::LoweredPlan;

std::vector<std::string> lane_wrist_lines(const LoweredPlan& plan, std::size_t step, const std::string& lane,
                                          const std::string& label) {
  std::vector<std::string> lines;
  const auto line = [&](const std::string& text) { lines.push_back(text); };
  const auto& joints = plan.plan.steps[step].wrist()->joints;
  const auto place = [&](int joint) { return plan.plan.places[static_cast<std::size_t>(joint)]; };
  const auto set = [&](const std::string& array, const std::string& angles) {
    const std::array<std::string, 3> parts = {"first", "middle", "last"};
    for (std::size_t k = 0; k < 3; ++k)
      line(array + "[" + std::to_string(place(joints[k])) + "] = " + angles + "." + parts[k] + ";");
  };
  const auto copy = [&] {
    line(lane + " twin[" + std::to_string(plan.plan.row_size) + "];");
    for (int j = 0; j < plan.plan.row_size; ++j) {
      const bool turns =
          std::any_of(joints.begin(), joints.end(), [&](int joint) { return place(joint) == j; });
      if (!turns) line("twin[" + std::to_string(j) + "] = q[" + std::to_string(j) + "];");
    }
  };
  const auto call = [&](const std::string& sign) { return step_call(plan, step, sign); };
  if (plan.plan.steps[step].is<derive::inverse::kind::ObliqueWrist>()) {
    line("const inverse::Branch<" + lane + "> before = w.branch;");
    line("const auto angles = " + call(lane + "(1)") + ";");
    line("const inverse::Branch<" + lane + "> branch = w.branch;");
    line("w.branch.resume(before);");
    line("const auto others = " + call(lane + "(-1)") + ";");
    set("q", "angles");
    copy();
    set("twin", "others");
    line("rows.append(q, branch, twin, w.branch, " + label + ");");
    return lines;
  }
  line("const auto angles = " + call("") + ";");
  set("q", "angles.one");
  copy();
  set("twin", "angles.other");
  line("rows.append(q, twin, w.branch, " + label + ");");
  return lines;
}

}  // namespace qvgen::emit
