// SPDX-License-Identifier: MIT
#include "emit/cpp/compact.h"

#include <map>
#include <string_view>

namespace qvgen::emit {
namespace {

/// More than any arm's function has.
constexpr std::size_t many_values = 700;
constexpr std::size_t values_together = 16;
/// A number that is used less often is not worth a name.
constexpr int fewest_uses = 3;

constexpr std::string_view begin_of_number = "Scalar(";

/// Copies the text with every number, `Scalar(0.5)`, as `change` gives it.
template <class Change>
std::string with_numbers(const std::string& text, const Change& change) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = text.find(begin_of_number); at != std::string::npos;
       at = text.find(begin_of_number, done)) {
    const std::size_t end = text.find(')', at) + 1;
    result += text.substr(done, at - done) + change(text.substr(at, end - at));
    done = end;
  }
  return result + text.substr(done);
}

template <class Use>
void for_each_expression(Code& code, const Use& use) {
  for (std::vector<Code::Value>* values : {&code.temporaries, &code.outputs})
    for (Code::Value& value : *values) use(value.expression);
}

/// Names the numbers that are used often, n0, n1, ... in the order of their first use.
Code with_named_numbers(Code code) {
  std::map<std::string, int> uses;
  for_each_expression(code, [&](std::string& text) {
    with_numbers(text, [&](const std::string& number) { return ++uses[number], number; });
  });
  std::map<std::string, std::string> names;
  std::vector<Code::Value> numbers;
  const auto named = [&](const std::string& number) {
    if (uses[number] < fewest_uses) return number;
    const auto [place, is_new] = names.emplace(number, "n" + std::to_string(names.size()));
    if (is_new) numbers.push_back({place->second, number});
    return place->second;
  };
  for_each_expression(code, [&](std::string& text) { text = with_numbers(text, named); });
  code.temporaries.insert(code.temporaries.begin(), numbers.begin(), numbers.end());
  return code;
}

std::vector<Code::Value> together(const std::vector<Code::Value>& values) {
  std::vector<Code::Value> result;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % values_together == 0)
      result.push_back(values[i]);
    else
      result.back().expression += ", " + values[i].name + " = " + values[i].expression;
  return result;
}

}  // namespace

Code compact(const Code& code) {
  if (code.temporaries.size() < many_values) return code;
  Code result = with_named_numbers(code);
  result.temporaries = together(result.temporaries);
  return result;
}

}  // namespace qvgen::emit
