// SPDX-License-Identifier: MIT
#include "emit/cpp/geometry_code.h"

#include "emit/ast/angle.h"
#include "emit/cpp/symbol_table.h"

namespace qvgen::emit {

Code geometry_code(const model::Robot& robot, const dag::Function& function, const ast::Printer& language) {
  const auto symbol = symbol_table(robot, {}).symbol;
  const auto called = [&](const char* name) {
    return [symbol, name](const dag::Angle& angle) {
      return ast::call(ast::Expression::Kind::mathematical, name, {ast::angle_value(angle, symbol)});
    };
  };
  return straight_code(function, {symbol, called("sin"), called("cos")}, language);
}

}  // namespace qvgen::emit
