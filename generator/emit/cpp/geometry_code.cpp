// SPDX-License-Identifier: MIT
#include "emit/cpp/geometry_code.h"

#include "emit/cpp/symbol_table.h"

namespace qvgen::emit {

Code geometry_code(const model::Robot& robot, const dag::Function& function, const Dialect& dialect) {
  const SymbolTable plain = symbol_table(robot, {}, {}, dialect.spelling());
  const auto angle = [&](const std::string& name) {
    return [name = dialect.mathematical(name), plain](const dag::Angle& value) {
      return name + "(" + angle_code(value, plain) + ")";
    };
  };
  return straight_code(function, {plain.symbol, angle("sin"), angle("cos"), dialect.spelling()});
}

}  // namespace qvgen::emit
