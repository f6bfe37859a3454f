// SPDX-License-Identifier: MIT
#include "emit/cpp/compact.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "emit/cpp/compact_text.h"
#include "model/coordinates.h"

namespace qvgen::emit {
namespace {

/// More than any arm's function has.
constexpr std::size_t many_values = 700;
/// Robots of more joints are whole ones, or limbs from their base on.
constexpr std::size_t most_joints_of_an_arm = 8;
/// Characters that a name of a number takes where it is used, and beside the number where it is declared.
constexpr std::size_t named_use = 3, named_declaration = 5;
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

/// Names of temporaries, the shortest first. None is a keyword or the name of a parameter, of an object of
/// results (r, r1, ...), of an angle (c1, s1, ...) or of a macro of usual headers.
class ShortNames {
 public:
  std::string next() {
    if (place_ < singles.size()) return std::string{singles[place_++]};
    for (;; ++place_) {
      const std::string name = longer(place_ - singles.size());
      if (std::find(taken.begin(), taken.end(), name) != taken.end()) continue;
      ++place_;
      return name;
    }
  }

 private:
  static constexpr std::string_view singles = "tuvwxzabdefhilop", firsts = "tuvwxzabdefghilmnop";
  static constexpr std::string_view capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ",
                                    small = "abcdefghijklmnopqrstuvwxyz";
  static constexpr std::string_view digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  static constexpr std::array<std::string_view, 4> taken{"at", "do", "if", "or"};
  /// Digits and capitals, which stand in no keyword.
  static constexpr std::size_t no_small_letter = 36;

  /// A small letter and a character; a capital and a small letter; then a small letter and two or more
  /// others.
  static std::string longer(std::size_t index) {
    const std::size_t of_small = firsts.size() * digits.size(), of_capitals = capitals.size() * small.size();
    if (index < of_small) return pair(firsts, digits, index);
    if (index < of_small + of_capitals) return pair(capitals, small, index - of_small);
    index -= of_small + of_capitals;
    std::string name = pair(firsts, digits.substr(0, no_small_letter), index);
    index /= firsts.size() * no_small_letter;
    do {
      name += digits[index % digits.size()];
      index /= digits.size();
    } while (index > 0);
    return name;
  }
  static std::string pair(std::string_view first, std::string_view second, std::size_t index) {
    return {first[index % first.size()], second[index / first.size() % second.size()]};
  }

  std::size_t place_ = 0;
};

/// True if a name for the number makes the code shorter.
bool deserves_name(const std::string& number, std::size_t uses) {
  return uses * number.size() > uses * named_use + number.size() + named_declaration;
}

/// Declares numbers that are used often, in the order of their first use.
Code with_named_numbers(Code code) {
  std::map<std::string, std::size_t> uses;
  for_each_expression(code, [&](std::string& text) {
    with_numbers(text, [&](const std::string& number) { return ++uses[number], number; });
  });
  std::map<std::string, std::string> names;
  std::vector<Code::Value> numbers;
  const auto named = [&](const std::string& number) {
    if (number == zero_of_scalar || !deserves_name(number, uses[number])) return number;
    const auto [place, is_new] = names.emplace(number, "t_n" + std::to_string(names.size()));
    if (is_new) numbers.push_back({place->second, number});
    return place->second;
  };
  for_each_expression(code, [&](std::string& text) { text = with_numbers(text, named); });
  code.temporaries.insert(code.temporaries.begin(), numbers.begin(), numbers.end());
  return code;
}

/// Numbers by the other name of Scalar, without a zero in front of the point: N(.5).
Code with_short_numbers(Code code) {
  for_each_expression(code, [](std::string& text) {
    text = with_numbers(text, [](const std::string& number) {
      if (number == zero_of_scalar) return number;
      std::string digits = number.substr(begin_of_number.size());
      if (digits.starts_with("0.")) digits.erase(0, 1);
      return std::string(short_number) + digits;
    });
  });
  return code;
}

/// Gives temporaries t0, t1, ... short names, the shortest to those that are used most. Those of angles begin
/// with c and s, parameters are q and k.
Code with_short_names(Code code) {
  std::map<std::string, std::size_t> uses;
  for_each_expression(code, [&](std::string& text) {
    with_words(text, [&](const std::string& word) { return ++uses[word], word; });
  });
  std::vector<std::string> order;
  for (const Code::Value& value : code.temporaries)
    if (value.name.front() == 't') order.push_back(value.name);
  std::stable_sort(order.begin(), order.end(),
                   [&](const std::string& a, const std::string& b) { return uses[a] > uses[b]; });
  std::map<std::string, std::string> names;
  ShortNames unused;
  for (const std::string& name : order) names.emplace(name, unused.next());
  const auto renamed = [&](const std::string& word) {
    const auto known = names.find(word);
    return known == names.end() ? word : known->second;
  };
  for (Code::Value& value : code.temporaries) value.name = renamed(value.name);
  for_each_expression(code, [&](std::string& text) { text = with_words(text, renamed); });
  return code;
}

/// Index of the bracket that closes the one at `begin`; nothing if what it holds is more than sums and
/// products.
std::optional<std::size_t> end_of_sum(std::string_view text, std::size_t begin) {
  std::size_t depth = 0;
  for (std::size_t at = begin; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) return at;
    if (std::string_view("?,<>{};&=|").find(c) != std::string_view::npos) return std::nullopt;
  }
  return std::nullopt;
}

/// Leaves out brackets around the first terms of a sum, which are added first without them as well:
/// (a+b)-c becomes a+b-c. Text without spaces.
std::string without_first_brackets(std::string text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    while (text[at] == '(' && (at == 0 || text[at - 1] == '(')) {
      const auto end = end_of_sum(text, at);
      if (!end || *end + 1 >= text.size() || (text[*end + 1] != '+' && text[*end + 1] != '-')) break;
      text.erase(*end, 1);
      text.erase(at, 1);
    }
  }
  return text;
}

}  // namespace

bool bytes_count(const model::Robot& robot, const Code& code) {
  return code.temporaries.size() >= many_values || model::coordinate_count(robot) > most_joints_of_an_arm;
}

bool has_short_numbers(const Code& code) {
  const auto has = [](const Code::Value& value) {
    return value.expression.find(short_number) != std::string::npos;
  };
  return std::any_of(code.temporaries.begin(), code.temporaries.end(), has) ||
         std::any_of(code.outputs.begin(), code.outputs.end(), has);
}

Code compact(const Code& code) {
  Code result = with_short_numbers(with_short_names(with_named_numbers(code)));
  for_each_expression(result, [](std::string& text) { text = without_first_brackets(without_spaces(text)); });
  return result;
}

}  // namespace qvgen::emit
