// SPDX-License-Identifier: MIT
#include "emit/cpp/geometry_code.h"

#include "emit/cpp/symbol_table.h"

namespace qvgen::emit {

Code geometry_code(const model::Robot& robot, const dag::Function& function) {
  const SymbolTable plain = symbol_table(robot, {});
  const auto angle = [plain](const std::string& name) {
    return [name, plain](const dag::Angle& value) { return name + "(" + angle_code(value, plain) + ")"; };
  };
  return straight_code(function, {plain.symbol, angle("std::sin"), angle("std::cos")});
}

}  // namespace qvgen::emit
