// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/arm_angle_code.h"

#include "emit/cpp/code.h"
#include "emit/cpp/symbol_table.h"
#include "emit/cpp/template_values.h"

namespace qvgen::emit {

using nlohmann::json;

json arm_angle_values(const model::Robot& robot, const derive::inverse::SphericalArm& arm) {
  const SymbolTable plain = symbol_table(robot, {});
  const auto angle = [plain](const std::string& name) {
    return [name, plain](const dag::Angle& value) { return name + "(" + angle_code(value, plain) + ")"; };
  };
  const Code code = straight_code(arm.values, {plain.symbol, angle("std::sin"), angle("std::cos")});
  json axes = json::array();
  for (std::size_t i = 1; i <= robot.joints.size(); ++i)
    axes.push_back({{"number", i}, {"last", i == robot.joints.size()}});
  return {{"temporaries", values_of(code.temporaries)},
          {"outputs", values_of(code.outputs)},
          {"axes", axes},
          {"planar", arm.planar ? "true" : "false"}};
}

}  // namespace qvgen::emit
