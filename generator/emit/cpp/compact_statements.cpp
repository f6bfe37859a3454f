// SPDX-License-Identifier: MIT
// Bodies of compact functions: zeros first, then values and outputs in an order (compact_order.h) that leaves
// compilers few values to keep. Outputs that are stored as soon as what they read is known take a fourteenth
// of the instructions from the derivatives of a humanoid's inverse dynamics, and a quarter of the time to
// compile.
#include <algorithm>
#include <tuple>

#include "emit/cpp/compact.h"
#include "emit/cpp/compact_order.h"
#include "emit/cpp/compact_text.h"

namespace qvgen::emit {
namespace {

/// A matrix with a larger part of other entries gets zeros column by column: set twice they would cost
/// instructions.
constexpr std::size_t zeros_an_entry = 3;
/// Zeros below one another from which on one call for all of them is shorter.
constexpr std::size_t least_to_fill = 4;

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

/// Column and row of an index "(row,column)"; column 0 of "[row]".
std::pair<std::size_t, std::size_t> column_and_row(const std::string& index) {
  const std::size_t comma = index.find(',');
  const std::size_t row = std::stoul(index.substr(1));
  return {comma == std::string::npos ? 0 : std::stoul(index.substr(comma + 1)), row};
}

/// Sets so many entries below one another to zero. Blocks of matrices become stores of whole registers, where
/// compilers repeat one instruction for a call that fills as many numbers.
std::string zeros_below(const std::string& object, const std::string& index, const std::string& count) {
  if (index.front() == '(') return object + ".template block<" + count + ",1>" + index + ".setZero()";
  return "std::fill_n(&" + object + index + "," + count + "," + std::string(zero_of_scalar) + ")";
}

/// Statements that set places of objects' entries to zero: those below one another in memory at once.
std::vector<std::string> set_to_zero(std::vector<Place> places) {
  const auto key = [](const Place& place) {
    return std::tuple_cat(std::tuple(place.object), column_and_row(place.index));
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](const Place& a, const Place& b) { return key(a) < key(b); });
  std::vector<std::string> result;
  std::string single;
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    const auto [object, column, row] = key(places[begin]);
    while (end < places.size() && key(places[end]) == std::tuple(object, column, row + (end - begin))) ++end;
    const bool fills = end - begin >= least_to_fill;
    if (fills) result.push_back(zeros_below(object, places[begin].index, std::to_string(end - begin)));
    for (std::size_t k = begin; k < end && !fills; ++k) single += object + places[k].index + "=";
  }
  if (!single.empty()) result.push_back(single + std::string(zero_of_scalar));
  return result;
}

/// Short names of the objects that results consist of, and which of them begin as zeros.
class Objects {
 public:
  explicit Objects(const std::vector<Assignment>& assignments) {
    for (const auto& [targets, expression] : assignments)
      for (const Place& place : places_in(targets)) count(place, expression == zero_of_scalar);
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

  /// Returns what assigns a value to all places that do not have it yet.
  [[nodiscard]] std::vector<std::string> assigned(const Assignment& assignment) const {
    const bool is_zero = assignment.expression == zero_of_scalar;
    std::vector<Place> zeros;
    std::string others;
    for (const Place& place : places_in(assignment.targets)) {
      const Object& object = *find(place.object);
      if (is_zero && object.begins_as_zero()) continue;
      if (is_zero && object.entries)
        zeros.push_back({object.name, place.index});
      else
        others += (object.entries ? object.name : object.path) + place.index + "=";
    }
    std::vector<std::string> result = set_to_zero(zeros);
    if (!others.empty()) result.push_back(others + assignment.expression);
    return result;
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

std::vector<std::size_t> from_tips_to_base(const std::vector<std::string>& places) {
  using Key = std::tuple<std::size_t, std::size_t, std::size_t>;
  std::vector<std::pair<Key, std::size_t>> keys;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [column, row] = column_and_row(places_in(places[i]).front().index);
    keys.push_back({{std::max(row, column), column, row}, i});
  }
  std::stable_sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::size_t> order;
  for (const auto& [key, output] : keys) order.push_back(output);
  return order;
}

std::vector<std::string> compact_angles(const std::vector<std::string>& lines) {
  std::vector<std::string> references, notes;
  for (const std::string& line : lines)
    if (line.starts_with("//"))
      notes.push_back(line);
    else
      for (std::size_t at = line.find('&'); at != std::string::npos; at = line.find('&', at + 1))
        references.push_back(line.substr(at, line.find(']', at) + 1 - at) + ",");
  for (std::string& reference : references)
    for (const std::string array : {"sine", "cosine"}) {
      const std::string usual = " = angles." + array + "[";
      if (const std::size_t at = reference.find(usual); at != std::string::npos)
        reference.replace(at, usual.size(), "=" + array.substr(0, 1) + "[");
    }
  std::vector<std::string> result;
  const std::string type = "const Scalar ";
  if (!references.empty()) result.push_back(type + filled(references, compact_indent + type.size()) + ";");
  result.insert(result.end(), notes.begin(), notes.end());
  return result;
}

std::string compact_statements(const std::vector<Code::Value>& values,
                               const std::vector<Assignment>& assignments) {
  const Objects objects(assignments);
  std::vector<std::string> pieces;
  const auto add = [&](const std::vector<std::string>& statements) {
    for (const std::string& statement : statements) pieces.push_back(statement + ";");
  };
  add(objects.statements());
  std::vector<Assignment> others;
  for (const Assignment& assignment : assignments)
    if (assignment.expression == zero_of_scalar)
      add(objects.assigned(assignment));
    else
      others.push_back(assignment);
  const std::vector<StatementIndex> order = statement_order(values, others);
  const auto is_value = [&](std::size_t at) { return at < order.size() && order[at] < values.size(); };
  for (std::size_t at = 0; at < order.size(); ++at) {
    if (!is_value(at)) {
      add(objects.assigned(others[order[at] - values.size()]));
      continue;
    }
    const bool declares = at > 0 && is_value(at - 1);
    const Code::Value& value = values[order[at]];
    pieces.push_back((declares ? "" : "N ") + value.name + "=" + value.expression +
                     (is_value(at + 1) ? "," : ";"));
  }
  return filled(pieces, compact_indent);
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
  Body body{{}, {compact_statements(shorter.temporaries, assignments(places, shorter.outputs))}};
  if (has_short_numbers(shorter) || !shorter.temporaries.empty())
    body.declarations.emplace_back("using N=Scalar");
  return body;
}

}  // namespace qvgen::emit
