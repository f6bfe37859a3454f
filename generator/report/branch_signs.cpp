// SPDX-License-Identifier: MIT
#include "report/branch_signs.h"

#include <cctype>

#include <nlohmann/json.hpp>

#include "report/html.h"

namespace qvgen::report {
namespace {

/// The names of joints in a sentence as they are set.
std::string with_letters(const std::string& sentence) {
  std::string result, word;
  for (const char letter : sentence + ' ') {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) {
      word += letter;
      continue;
    }
    result += typeset(word) + letter;
    word.clear();
  }
  result.pop_back();
  return result;
}

}  // namespace

using derive::inverse::Step;

std::vector<BranchSign> branch_signs(const derive::inverse::Plan& plan) {
  std::vector<BranchSign> signs;
  for (const std::size_t i : derive::inverse::order(plan, plan.quartic())) {
    const Step& step = plan.steps[i];
    if (step.branches > 1)
      signs.push_back(
          {step.wrist() != nullptr ? "wrist" : typeset(step.unknown), step.branches, step.degenerate});
  }
  return signs;
}

std::string branch_signs_html(const std::vector<BranchSign>& signs) {
  if (signs.empty()) return "";
  nlohmann::json list = nlohmann::json::array();
  for (const BranchSign& sign : signs)
    list.push_back({{"name", sign.name}, {"values", sign.values}, {"meet", with_letters(sign.meet)}});
  return "<script type=\"application/json\" id=\"branch-signs\">" + list.dump() + "</script>\n";
}

}  // namespace qvgen::report
