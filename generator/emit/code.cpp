// SPDX-License-Identifier: MIT
#include "emit/code.h"

namespace qvgen::emit {

Code code_of(const ast::Straight& code, const ast::Printer& language) {
  Code result;
  for (const auto& [name, expression] : code.temporaries)
    result.temporaries.push_back({name, language.text(expression)});
  for (const auto& [name, expression] : code.outputs)
    result.outputs.push_back({name, language.text(expression)});
  return result;
}

Code straight_code(const dag::Function& function, const ast::Leaves& leaves, const ast::Printer& language) {
  return code_of(ast::straight(function, leaves), language);
}

}  // namespace qvgen::emit
