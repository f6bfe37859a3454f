// SPDX-License-Identifier: MIT
#include "emit/cpp/compact.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <string_view>

#include "emit/cpp/tidy.h"
#include "model/coordinates.h"

namespace qvgen::emit {
namespace {

/// More than any arm's function has.
constexpr std::size_t many_values = 700;
/// Robots of more joints are whole ones, or limbs from their base on.
constexpr std::size_t most_joints_of_an_arm = 8;
/// Characters that a name of a number takes where it is used, and beside the number where it is declared.
constexpr std::size_t named_use = 3, named_declaration = 5;
/// A matrix with a larger part of other entries gets zeros one by one: set twice they would cost
/// instructions.
constexpr std::size_t zeros_an_entry = 3;

/// Spaces in front of a function's statements.
constexpr std::size_t indent = 2;

constexpr std::string_view begin_of_number = "Scalar(";
constexpr std::string_view zero = "Scalar(0)";
/// Another name of Scalar for numbers.
constexpr std::string_view short_number = "N(";

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
    if (number == zero || !deserves_name(number, uses[number])) return number;
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
      if (number == zero) return number;
      std::string digits = number.substr(begin_of_number.size());
      if (digits.starts_with("0.")) digits.erase(0, 1);
      return std::string(short_number) + digits;
    });
  });
  return code;
}

bool has_short_numbers(const Code& code) {
  const auto has = [](const Code::Value& value) {
    return value.expression.find(short_number) != std::string::npos;
  };
  return std::any_of(code.temporaries.begin(), code.temporaries.end(), has) ||
         std::any_of(code.outputs.begin(), code.outputs.end(), has);
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
      objects_.push_back({place.object, at == 0 ? "r" : "r" + std::to_string(at), !place.index.empty()});
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
  Code result = with_short_numbers(with_short_names(with_named_numbers(code)));
  for_each_expression(result, [](std::string& text) { text = without_first_brackets(without_spaces(text)); });
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
  Body body{{}, {compact_statements(assignments(places, shorter.outputs))}};
  if (has_short_numbers(shorter)) body.declarations.emplace_back("using N=Scalar");
  if (!shorter.temporaries.empty()) body.declarations.push_back(compact_declarations(shorter));
  return body;
}

}  // namespace qvgen::emit
