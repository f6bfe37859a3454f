// SPDX-License-Identifier: MIT
#include "emit/geometry_code.h"

#include "emit/ast/angle.h"
#include "emit/leaves.h"

namespace qvgen::emit {

ast::Straight geometry_tree(const model::Robot& robot, const dag::Function& function) {
  const auto symbol = robot_leaves(robot, {}).symbol;
  const auto called = [&](const char* name) {
    return [symbol, name](const dag::Angle& angle) {
      return ast::call(ast::Expression::Kind::mathematical, name, {ast::angle_value(angle, symbol)});
    };
  };
  return ast::straight(function, {symbol, called("sin"), called("cos")});
}

Code geometry_code(const model::Robot& robot, const dag::Function& function, const ast::Printer& language) {
  return code_of(geometry_tree(robot, function), language);
}

}  // namespace qvgen::emit
