// SPDX-License-Identifier: MIT
#include "emit/cpp/compact.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "emit/cpp/tidy.h"

namespace qvgen::emit {
namespace {

/// More than any arm's function has.
constexpr std::size_t many_values = 700;
constexpr std::size_t values_together = 64;
/// A number that is used less often is not worth a name.
constexpr int fewest_uses = 3;
/// A matrix with fewer zeros, compared with its other entries, gets them one by one.
constexpr std::size_t entries_a_zero = 3;

constexpr std::string_view begin_of_number = "Scalar(";
constexpr std::string_view zero = "Scalar(0)";

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

/// Name `index` of those that begin with one of the letters: two characters, then three. The second is no
/// small letter, as in every keyword.
std::string short_name(std::string_view letters, std::size_t index) {
  constexpr std::string_view digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  constexpr std::size_t second = 36;
  std::string name{letters[index % letters.size()]};
  index /= letters.size();
  name += digits[index % second];
  for (index /= second; index > 0; index /= digits.size()) name += digits[index % digits.size()];
  return name;
}

/// Names the numbers that are used often, in the order of their first use.
Code with_named_numbers(Code code) {
  std::map<std::string, int> uses;
  for_each_expression(code, [&](std::string& text) {
    with_numbers(text, [&](const std::string& number) { return ++uses[number], number; });
  });
  std::map<std::string, std::string> names;
  std::vector<Code::Value> numbers;
  const auto named = [&](const std::string& number) {
    if (uses[number] < fewest_uses || number == zero) return number;
    const auto [place, is_new] = names.emplace(number, short_name("n", names.size()));
    if (is_new) numbers.push_back({place->second, number});
    return place->second;
  };
  for_each_expression(code, [&](std::string& text) { text = with_numbers(text, named); });
  code.temporaries.insert(code.temporaries.begin(), numbers.begin(), numbers.end());
  return code;
}

bool continues_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

/// Copies the text with each word, a name or a number, as `change` gives it.
template <class Change>
std::string with_words(const std::string& text, const Change& change) {
  std::string result;
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find_if_not(at, text.end(), continues_word);
    if (end != at) result += change(std::string(at, end));
    if (end != text.end()) result += *end;
    at = end == text.end() ? end : end + 1;
  }
  return result;
}

/// Gives temporaries t0, t1, ... short names. Those of angles begin with c and s, parameters are q and k.
Code with_short_names(Code code) {
  std::map<std::string, std::string> names;
  for (Code::Value& value : code.temporaries)
    if (value.name.front() == 't') {
      const std::string name = short_name("tuvwxzabdefghilmop", names.size());
      names.emplace(value.name, name);
      value.name = name;
    }
  const auto renamed = [&](const std::string& word) {
    const auto known = names.find(word);
    return known == names.end() ? word : known->second;
  };
  for_each_expression(code, [&](std::string& text) { text = with_words(text, renamed); });
  return code;
}

/// Leaves out spaces but those between two signs.
std::string without_spaces(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] != ' ' || (at + 1 < text.size() && !result.empty() && result.back() == text[at + 1]))
      result += text[at];
  return result;
}

std::vector<Code::Value> together(const std::vector<Code::Value>& values) {
  std::vector<Code::Value> result;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % values_together == 0)
      result.push_back(values[i]);
    else
      result.back().expression += ", " + values[i].name + "=" + values[i].expression;
  return result;
}

/// A place of a result, its name and its index: "result.by_rate" and "(3, 4)".
struct Place {
  std::string object, index;
};

std::vector<Place> places_in(const std::string& targets) {
  static const std::string between = " = ";
  std::vector<Place> places;
  for (std::size_t begin = 0; begin < targets.size();) {
    const std::size_t end = std::min(targets.find(between, begin), targets.size());
    const std::string target = targets.substr(begin, end - begin);
    const std::size_t index = std::min(target.find_first_of("(["), target.size());
    places.push_back({target.substr(0, index), without_spaces(target.substr(index))});
    begin = end + between.size();
  }
  return places;
}

/// Short names of the objects that results consist of, and which of them begin as zeros.
class Objects {
 public:
  explicit Objects(const std::vector<Assignment>& assignments) {
    for (const auto& [targets, expression] : assignments)
      for (const Place& place : places_in(targets)) count(place, expression == zero);
  }

  /// Declares the names, and sets zeros.
  [[nodiscard]] std::vector<std::string> statements() const {
    std::vector<std::string> result;
    for (const Object& object : objects_) {
      if (!object.entries) continue;
      result.push_back("auto& " + object.name + "=" + object.path);
      if (object.begins_as_zero()) result.push_back(object.name + ".setZero()");
    }
    return result;
  }

  /// Returns what assigns a value to all places that do not have it yet; empty if all have.
  [[nodiscard]] std::string assigned(const Assignment& assignment) const {
    std::string result;
    for (const Place& place : places_in(assignment.targets)) {
      const Object& object = *find(place.object);
      if (assignment.expression == zero && object.begins_as_zero()) continue;
      result += (object.entries ? object.name : object.path) + place.index + "=";
    }
    return result.empty() ? result : result + assignment.expression;
  }

 private:
  struct Object {
    std::string path, name;
    bool entries;
    std::size_t all = 0, zeros = 0;
    [[nodiscard]] bool begins_as_zero() const {
      return entries && zeros * entries_a_zero >= all && zeros > 0;
    }
  };

  [[nodiscard]] std::vector<Object>::const_iterator find(const std::string& path) const {
    return std::find_if(objects_.begin(), objects_.end(), [&](const Object& o) { return o.path == path; });
  }
  void count(const Place& place, bool is_zero) {
    auto at = find(place.object) - objects_.begin();
    if (at == static_cast<std::ptrdiff_t>(objects_.size()))
      objects_.push_back({place.object, "r" + std::to_string(at), !place.index.empty()});
    Object& object = objects_[static_cast<std::size_t>(at)];
    ++object.all;
    object.zeros += is_zero ? 1 : 0;
  }

  std::vector<Object> objects_;
};

}  // namespace

bool has_many_values(const Code& code) { return code.temporaries.size() >= many_values; }

Code compact(const Code& code) {
  Code result = with_short_names(with_named_numbers(code));
  for_each_expression(result, [](std::string& text) { text = without_spaces(text); });
  result.temporaries = together(result.temporaries);
  return result;
}

std::vector<std::string> compact_statements(const std::vector<Assignment>& assignments) {
  const Objects objects(assignments);
  std::vector<std::string> statements = objects.statements();
  for (const Assignment& assignment : assignments) statements.push_back(objects.assigned(assignment));
  const std::size_t longest = line_width - 3;  // indented by two, with a semicolon
  std::vector<std::string> lines;
  for (const std::string& statement : statements) {
    if (statement.empty()) continue;
    if (lines.empty() || lines.back().size() + 1 + statement.size() > longest)
      lines.push_back(statement);
    else
      lines.back() += ";" + statement;
  }
  return lines;
}

}  // namespace qvgen::emit
