// SPDX-License-Identifier: MIT
#include "emit/cpp/compact.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "emit/cpp/tidy.h"
#include "model/coordinates.h"

namespace qvgen::emit {
namespace {

/// More than any arm's function has.
constexpr std::size_t many_values = 700;
/// Robots of more joints are whole ones, or limbs from their base on.
constexpr std::size_t most_joints_of_an_arm = 8;
/// A number that is used less often is not worth a name.
constexpr int fewest_uses = 3;
/// A matrix with a larger part of other entries gets zeros one by one: set twice they would cost
/// instructions.
constexpr std::size_t zeros_an_entry = 3;

/// Spaces in front of a function's statements.
constexpr std::size_t indent = 2;

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

/// Leaves out spaces, but not between two signs or two words.
std::string without_spaces(const std::string& text) {
  const auto needed = [&](std::size_t at) {
    if (at == 0 || at + 1 == text.size()) return false;
    const char before = text[at - 1], behind = text[at + 1];
    return before == behind || (continues_word(before) && continues_word(behind));
  };
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] != ' ' || needed(at)) result += text[at];
  return result;
}

/// Pieces with a separator between them, in lines that begin at the margin; the first one goes on behind so
/// many characters.
std::string filled(const std::vector<std::string>& pieces, char separator, std::size_t first) {
  std::string result;
  std::size_t length = first;
  for (const std::string& piece : pieces) {
    if (!result.empty()) result += separator;
    length += piece.size() + 1;
    if (length > line_width && !result.empty()) {
      result += '\n';
      length = piece.size() + 1;
    }
    result += piece;
  }
  return result;
}

/// A declaration of all, without a semicolon.
std::string declared(const std::string& type, const std::vector<std::string>& values) {
  return type + filled(values, ',', indent + type.size());
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
    [[nodiscard]] bool begins_as_zero() const { return entries && zeros > zeros_an_entry * (all - zeros); }
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

bool bytes_count(const model::Robot& robot, const Code& code) {
  return code.temporaries.size() >= many_values || model::coordinate_count(robot) > most_joints_of_an_arm;
}

Code compact(const Code& code) {
  Code result = with_short_names(with_named_numbers(code));
  for_each_expression(result, [](std::string& text) { text = without_spaces(text); });
  return result;
}

std::string compact_declarations(const Code& compact) {
  std::vector<std::string> values;
  for (const auto& [name, expression] : compact.temporaries) values.push_back(name + "=" + expression);
  return declared("const Scalar ", values);
}

std::vector<std::string> compact_angles(const std::vector<std::string>& lines) {
  std::vector<std::string> references, notes;
  for (const std::string& line : lines)
    if (line.starts_with("//"))
      notes.push_back(line);
    else
      for (std::size_t at = line.find('&'); at != std::string::npos; at = line.find('&', at + 1))
        references.push_back(line.substr(at, line.find(']', at) + 1 - at));
  std::vector<std::string> result;
  for (const std::string array : {"sine", "cosine"}) {
    const std::string usual = " = angles." + array + "[", name = array.substr(0, 1);
    bool is_used = false;
    for (std::string& reference : references)
      if (const std::size_t at = reference.find(usual); at != std::string::npos) {
        reference.replace(at, usual.size(), "=" + name + "[");
        is_used = true;
      }
    if (is_used) result.push_back("const auto& " + name + "=angles." + array + ";");
  }
  if (!references.empty()) result.push_back(declared("const Scalar ", references) + ";");
  result.insert(result.end(), notes.begin(), notes.end());
  return result;
}

std::string compact_statements(const std::vector<Assignment>& assignments) {
  const Objects objects(assignments);
  std::vector<std::string> statements = objects.statements();
  for (const Assignment& assignment : assignments)
    if (const std::string statement = objects.assigned(assignment); !statement.empty())
      statements.push_back(statement);
  return filled(statements, ';', indent);
}

Body body_of(const Code& code, const std::vector<std::string>& places) {
  Body body;
  for (const auto& [name, expression] : code.temporaries)
    body.declarations.push_back("const Scalar " + name + " = " + expression);
  for (const auto& [targets, expression] : assignments(places, code.outputs))
    body.statements.push_back(targets + " = " + expression);
  return body;
}

Body compact_body_of(const Code& code, const std::vector<std::string>& places) {
  const Code shorter = compact(code);
  Body body{{compact_declarations(shorter)}, {compact_statements(assignments(places, shorter.outputs))}};
  if (shorter.temporaries.empty()) body.declarations.clear();
  return body;
}

}  // namespace qvgen::emit
