// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/arm_angle_code.h"

#include "emit/cpp/printer.h"
#include "emit/geometry_code.h"
#include "emit/template_values.h"

namespace qvgen::emit {

using nlohmann::json;

json arm_angle_values(const model::Robot& robot, const derive::inverse::SphericalArm& arm) {
  const Code code = geometry_code(robot, arm.values, cpp());
  json axes = json::array();
  for (std::size_t i = 1; i <= robot.joints.size(); ++i)
    axes.push_back({{"number", i}, {"last", i == robot.joints.size()}});
  json values = values_of(code);
  values["axes"] = axes;
  values["planar"] = arm.planar ? "true" : "false";
  return values;
}

}  // namespace qvgen::emit
