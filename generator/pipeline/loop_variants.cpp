// SPDX-License-Identifier: MIT
#include "pipeline/loop_variants.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace qvgen::pipeline {
namespace {

using nlohmann::ordered_json;

const std::string inverse = "inverse_kinematics";

std::vector<std::size_t> joints_of(const model::Mechanism& mechanism, std::size_t tip) {
  return model::path(mechanism.robot, model::base_link, mechanism.tips[tip].joint);
}

template <class List, class Given>
auto with_given(const List& list, const Given& given_of, const std::vector<std::size_t>& joints) {
  return std::find_if(list.begin(), list.end(), [&](const auto& each) { return given_of(each) == joints; });
}

/// Says why a limb has no solutions for poses; empty if none was asked for.
std::string lack_of_solutions(const RobotOutput& limb) {
  if (limb.counts.contains("targets"))
    return "a pose leaves joints of the limb open; solve it with one of them given, and pass its joints to " +
           std::string("assemble_from_joints_of_...");
  const auto missing = std::find_if(limb.missing.begin(), limb.missing.end(),
                                    [](const Missing& each) { return each.part == "inverse"; });
  return missing == limb.missing.end() ? "" : "the limb has none: " + missing->reason;
}

/// Says why a limb's joints do not lead to the motors: where these are fewer, they move the joints together.
std::string lack_of_assemblies(const model::Mechanism& mechanism, const PlannedVariant& planned) {
  const std::size_t motors = mechanism.loops.actuated.size(), joints = planned.variant.given.size();
  if (joints <= motors) return fmt::format("{}", fmt::join(planned.assembly.reasons, "; "));
  std::vector<std::string> names;
  for (const std::size_t joint : planned.variant.given)
    names.push_back(mechanism.robot.joints[joint].variable);
  return fmt::format(
      "{} joints lead to the tip ({}), and {} cannot follow them one by one; solve `assemble` for "
      "values of the {}",
      joints, fmt::join(names, ", "), motors == 1 ? "one motor" : fmt::format("{} motors", motors),
      motors == 1 ? "motor" : "motors");
}

}  // namespace

bool solves_poses(const RobotOutput& robot) {
  const ordered_json targets = robot.counts.value("targets", ordered_json::object());
  const ordered_json taken = targets.value(inverse, ordered_json::array());
  return std::find(taken.begin(), taken.end(), "pose") != taken.end();
}

std::vector<LoopVariant> loop_variants(const model::Loops& loops) {
  std::vector<LoopVariant> variants{{"assemble", loops.actuated, "Assembled", "assembly", "a"}};
  if (!loops.outputs.empty())
    variants.push_back(
        {"assemble_from_outputs", loops.outputs, "AssembledFromOutputs", "assembly_from_outputs", "outputs"});
  return variants;
}

std::vector<LoopVariant> limb_variants(const model::Mechanism& mechanism) {
  std::vector<LoopVariant> all = loop_variants(mechanism.loops);
  const auto first = static_cast<std::ptrdiff_t>(all.size());
  for (std::size_t i = 0; i < mechanism.tips.size(); ++i) {
    const std::vector<std::size_t> joints = joints_of(mechanism, i);
    const auto given_of = [](const LoopVariant& each) { return each.given; };
    if (with_given(all, given_of, joints) != all.end()) continue;
    const std::string& tip = mechanism.tips[i].name;
    all.push_back({"assemble_from_joints_of_" + tip, joints, "AssembledFromJointsOf_" + tip,
                   "assembly_from_joints_of_" + tip, "joints", true});
  }
  return {all.begin() + first, all.end()};
}

LimbInverse limb_inverse(const model::Mechanism& mechanism, std::size_t tip, const RobotOutput& limb,
                         const std::vector<PlannedVariant>& plans) {
  if (!solves_poses(limb)) return {"", "", lack_of_solutions(limb)};
  const auto given_of = [](const PlannedVariant& each) { return each.variant.given; };
  const auto found = with_given(plans, given_of, joints_of(mechanism, tip));
  if (found == plans.end()) return {};
  if (!found->assembly.found) return {"", "", lack_of_assemblies(mechanism, *found)};
  return {found->variant.function, found->variant.type, "", found->variant.space,
          found->assembly.has_gears()};
}

}  // namespace qvgen::pipeline
