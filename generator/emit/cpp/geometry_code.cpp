// SPDX-License-Identifier: MIT
#include "emit/cpp/geometry_code.h"

#include "emit/cpp/symbol_table.h"

namespace qvgen::emit {
namespace {

/// How sin and cos of an angle are written.
using Call = std::function<std::string(const std::string& function, const std::string& value)>;

Code code_of(const model::Robot& robot, const dag::Function& function, const Spelling& spelling,
             const Call& call) {
  const SymbolTable plain = symbol_table(robot, {}, {}, spelling);
  const auto angle = [&](const std::string& name) {
    return [name, call, plain](const dag::Angle& value) { return call(name, angle_code(value, plain)); };
  };
  return straight_code(function, {plain.symbol, angle("sin"), angle("cos"), spelling});
}

}  // namespace

Code geometry_code(const model::Robot& robot, const dag::Function& function, const Spelling& spelling) {
  return code_of(robot, function, spelling, spelling.call);
}

Code geometry_code(const model::Robot& robot, const dag::Function& function, const Dialect& dialect) {
  return code_of(robot, function, dialect.spelling(), [&](const std::string& name, const std::string& value) {
    return dialect.mathematical(name) + "(" + value + ")";
  });
}

}  // namespace qvgen::emit
