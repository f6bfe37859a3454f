// SPDX-License-Identifier: MIT
#include "emit/code.h"

#include <map>

namespace qvgen::emit {

Code code_of(const ast::Straight& code, const ast::Printer& language) {
  Code result;
  for (const auto& [name, expression] : code.temporaries)
    result.temporaries.push_back({name, language.text(expression)});
  for (const auto& [name, expression] : code.outputs)
    result.outputs.push_back({name, language.text(expression)});
  return result;
}

std::vector<Assignment> assignments(const std::vector<std::string>& targets,
                                    const std::vector<Code::Value>& outputs) {
  std::vector<Assignment> list;
  std::map<std::string, std::size_t> place;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto [at, is_new] = place.emplace(outputs[i].expression, list.size());
    if (is_new)
      list.push_back({targets.at(i), outputs[i].expression});
    else
      list[at->second].targets += " = " + targets.at(i);
  }
  return list;
}

Code straight_code(const dag::Function& function, const ast::Leaves& leaves, const ast::Printer& language,
                   int longest_inline) {
  return code_of(ast::straight(function, leaves, longest_inline), language);
}

}  // namespace qvgen::emit
