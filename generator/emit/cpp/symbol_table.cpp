// SPDX-License-Identifier: MIT
#include "emit/cpp/symbol_table.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <cln/integer.h>

#include "dag/rebuild.h"
#include "emit/cpp/literal.h"
#include "exact/constant_angle.h"
#include "exact/named_constant.h"
#include "model/followers.h"
#include "model/private_names.h"

namespace qvgen::emit {

using dag::Angle;
using dag::Op;

std::vector<Angle> angles_of(const dag::Function& function) {
  std::vector<Angle> angles;
  for (const std::uint32_t id : dag::reachable(function)) {
    const dag::Node& node = function.graph.node(id);
    if (node.op != Op::sine && node.op != Op::cosine) continue;
    const Angle& angle = function.graph.angle_of(node);
    if (!exact::radians(angle)) angles.push_back(angle);
  }
  return merged({angles});
}

std::vector<Angle> merged(const std::vector<std::vector<Angle>>& lists) {
  std::map<std::pair<std::size_t, std::string>, Angle> found;
  for (const std::vector<Angle>& list : lists)
    for (const Angle& angle : list) found.emplace(std::pair(angle.terms.size(), to_string(angle)), angle);
  std::vector<Angle> angles;
  for (const auto& [place, angle] : found) angles.push_back(angle);
  return angles;
}

namespace {

std::size_t place_of(const std::vector<Angle>& angles, const Angle& angle) {
  const auto place = std::find(angles.begin(), angles.end(), angle);
  if (place == angles.end()) throw std::logic_error("angle " + to_string(angle) + " has no place");
  return static_cast<std::size_t>(place - angles.begin());
}

/// A term of an angle: its joint's number, or its name and no number.
struct Term {
  std::size_t joint = 0;
  std::string symbol;
  bool negative = false;

  friend bool operator<(const Term& a, const Term& b) {
    return std::tie(a.joint, a.symbol) < std::tie(b.joint, b.symbol);
  }
};

Term term_of(const model::Robot& robot, const std::string& symbol, bool negative) {
  const std::vector<std::string> variables = model::variables(robot);
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (variables[i] == symbol) return {i + 1, "", negative};
  return {variables.size() + 1, symbol, negative};
}

cln::cl_I common_denominator(const Angle& angle) {
  cln::cl_I common = 1;
  for (const auto& [name, coefficient] : angle.terms)
    common = cln::lcm(common, cln::denominator(coefficient));
  return common;
}

std::string scalar(const exact::Number& number, const Spelling& spelling) {
  return spelling.number(literal(number));
}

/// pi * turns, in double.
std::string radians(const cln::cl_RA& turns, const Spelling& spelling) {
  const cln::cl_RA pi = cln::cl_RA(cln::cl_I("3141592653589793238462643383279502884197")) /
                        cln::cl_RA(cln::expt_pos(cln::cl_I(10), 39));
  return scalar(exact::Number(turns * pi), spelling);
}

/// A named constant's value; nothing if it is none.
std::optional<std::string> constant_code(const std::string& name, const Spelling& spelling) {
  if (const auto constant = exact::named_value(name)) return scalar(exact::Number(*constant), spelling);
  if (const auto constant = exact::constant_angle(name))
    return scalar(exact::Number(exact::radians(*constant)), spelling);
  return std::nullopt;
}

using Meaning = std::function<std::string(const std::string&)>;

/// A definition as code, for the few that stand inside of an angle. `meaning`: of a symbol, as code.
std::string code_of(const model::Expression& e, const Meaning& meaning, const Spelling& spelling) {
  using Kind = model::Expression::Kind;
  const auto operand = [&](std::size_t i) { return code_of(e.operands()[i], meaning, spelling); };
  const auto joined = [&](const std::string& by) {
    std::string text = operand(0);
    for (std::size_t i = 1; i < e.operands().size(); ++i) text += by + operand(i);
    return "(" + text + ")";
  };
  switch (e.kind()) {
    case Kind::number:
      return scalar(exact::Number(e.number()), spelling);
    case Kind::pi:
      return radians(1, spelling);
    case Kind::symbol:
      return meaning(e.name());
    case Kind::negate:
      return "(-" + operand(0) + ")";
    case Kind::sum:
      return joined(" + ");
    case Kind::product:
      return joined(" * ");
    case Kind::quotient:
      return joined(" / ");
    case Kind::power: {
      std::string product = operand(0);
      for (long i = 1; i < std::abs(e.exponent()); ++i) product += " * " + operand(0);
      return e.exponent() < 0 ? "(" + scalar(1, spelling) + " / (" + product + "))" : "(" + product + ")";
    }
    case Kind::root:
      return spelling.call("sqrt", operand(0));
    case Kind::sine:
      return spelling.call("sin", operand(0));
    case Kind::cosine:
      return spelling.call("cos", operand(0));
  }
  throw std::logic_error("unknown kind of expression");
}

}  // namespace

std::string angle_name(const model::Robot& robot, const Angle& angle, std::size_t place) {
  const cln::cl_RA size = angle.terms.empty() ? cln::cl_RA(0) : cln::abs(angle.terms.begin()->second);
  const bool half = size == cln::cl_RA(1) / 2;
  bool plain = cln::zerop(angle.pi) && (half || size == 1);
  std::vector<Term> terms;
  for (const auto& [symbol, coefficient] : angle.terms) {
    // Named constants and definitions are no identifiers.
    plain = plain && cln::abs(coefficient) == size && symbol.find('(') == std::string::npos;
    terms.push_back(term_of(robot, symbol, cln::minusp(coefficient)));
  }
  if (!plain) return "_" + std::to_string(place);
  std::sort(terms.begin(), terms.end());
  std::string name = half ? "h" : "";
  for (const Term& term : terms) {
    const bool apart = !term.symbol.empty() || (robot.joints.size() > 9 && &term != &terms.front());
    name += std::string(term.negative ? "m" : "") + (apart ? "_" : "") +
            (term.symbol.empty() ? std::to_string(term.joint) : term.symbol);
  }
  return name;
}

std::set<std::pair<std::size_t, Op>> sines_and_cosines_of(const dag::Function& function,
                                                          const std::vector<Angle>& angles) {
  std::set<std::pair<std::size_t, Op>> used;
  for (const std::uint32_t id : dag::reachable(function)) {
    const dag::Node& node = function.graph.node(id);
    if (node.op != Op::sine && node.op != Op::cosine) continue;
    const Angle& angle = function.graph.angle_of(node);
    if (!exact::radians(angle)) used.emplace(place_of(angles, angle), node.op);
  }
  return used;
}

std::vector<std::string> sine_cosine_declarations(const model::Robot& robot, const dag::Function& function,
                                                  const std::vector<Angle>& angles) {
  std::vector<std::string> lines;
  for (const auto& [place, op] : sines_and_cosines_of(function, angles)) {
    const std::string letter = op == Op::sine ? "s" : "c";
    const std::string name = angle_name(robot, angles[place], place);
    // A name by the place alone says nothing of its angle.
    const std::string note = name.front() == '_' ? "  // of " + to_string(angles[place]) : "";
    lines.push_back("const Scalar& " + letter + name + " = angles." + (op == Op::sine ? "sine" : "cosine") +
                    "[" + std::to_string(place) + "];" + note);
  }
  return lines;
}

SymbolTable symbol_table(const model::Robot& robot, const std::vector<Angle>& angles,
                         const std::function<std::string(const std::string&)>& others,
                         const Spelling& spelling) {
  std::map<std::string, std::string> known{{"pi", radians(1, spelling)}};
  const std::vector<std::string> variables = model::variables(robot);
  for (std::size_t i = 0; i < variables.size(); ++i) known[variables[i]] = "q[" + std::to_string(i) + "]";
  for (const model::Parameter& parameter : robot.geometry)
    known[parameter.name] = "g" + spelling.member + model::described_name(parameter.name);
  // A definition may have others in it, and constants.
  const Meaning defined = [&](const std::string& name) {
    if (const auto constant = constant_code(name, spelling)) return *constant;
    const auto definition = robot.definitions.find(name);
    if (known.count(name) == 0 && definition != robot.definitions.end())
      known[name] = code_of(definition->second, defined, spelling);
    return known.at(name);
  };
  for (const auto& [name, definition] : robot.definitions) defined(name);
  const auto symbol = [known, others, spelling](const std::string& name) {
    if (const auto constant = constant_code(name, spelling)) return *constant;
    const auto place = known.find(name);
    if (place != known.end()) return place->second;
    if (!others) throw std::logic_error("symbol " + name + " has no place in the generated code");
    return others(name);
  };
  std::vector<std::string> names;
  for (std::size_t i = 0; i < angles.size(); ++i) names.push_back(angle_name(robot, angles[i], i));
  return {symbol, [angles, names](const Angle& angle) { return "s" + names[place_of(angles, angle)]; },
          [angles, names](const Angle& angle) { return "c" + names[place_of(angles, angle)]; }, spelling};
}

std::string angle_code(const Angle& angle, const SymbolTable& names) {
  const cln::cl_I common = common_denominator(angle);
  std::string sum;
  for (const auto& [name, coefficient] : angle.terms) {
    const cln::cl_RA factor = coefficient * common;
    const cln::cl_RA size = cln::abs(factor);
    sum += cln::minusp(factor) ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
    sum += (size == 1 ? "" : scalar(exact::Number(size), names.spelling) + " * ") + names.symbol(name);
  }
  const bool compound = angle.terms.size() > 1;
  if (common != 1)
    sum = scalar(exact::Number(cln::recip(cln::cl_RA(common))), names.spelling) + " * " +
          (compound ? "(" + sum + ")" : sum);
  if (cln::zerop(angle.pi)) return sum;
  if (sum.empty()) return radians(angle.pi, names.spelling);
  return sum + (cln::minusp(angle.pi) ? " - " : " + ") + radians(cln::abs(angle.pi), names.spelling);
}

nlohmann::json angle_values(const std::vector<Angle>& angles, const SymbolTable& names) {
  nlohmann::json values = nlohmann::json::array();
  for (std::size_t i = 0; i < angles.size(); ++i)
    values.push_back({{"text", to_string(angles[i])},
                      {"code", angle_code(angles[i], names)},
                      {"index", i},
                      {"last", i + 1 == angles.size()}});
  return values;
}

std::string sines_cosines_code(const std::vector<Angle>& angles, const SymbolTable& names,
                               const std::string& empty) {
  if (angles.empty()) return empty + "<Scalar>{}";
  std::string arguments;
  for (const Angle& angle : angles) arguments += (arguments.empty() ? "" : ", ") + angle_code(angle, names);
  return "sines_and_cosines<Scalar>(" + arguments + ")";
}

}  // namespace qvgen::emit
