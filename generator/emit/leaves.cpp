// SPDX-License-Identifier: MIT
#include "emit/leaves.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "dag/rebuild.h"
#include "emit/ast/angle.h"
#include "emit/ast/literal.h"
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

ast::Expression scalar(const exact::Number& number) { return ast::real(literal(number)); }

/// A named constant's value; nothing if it is none.
std::optional<ast::Expression> constant_value(const std::string& name) {
  if (const auto constant = exact::named_value(name)) return scalar(exact::Number(*constant));
  if (const auto constant = exact::constant_angle(name))
    return scalar(exact::Number(exact::radians(*constant)));
  return std::nullopt;
}

using Meaning = std::function<ast::Expression(const std::string&)>;

/// x^n of a whole n.
ast::Expression power(const ast::Expression& base, long exponent) {
  const ast::Expression product =
      ast::grouped(ast::product(ast::Expressions(static_cast<std::size_t>(std::abs(exponent)), base)));
  return exponent < 0 ? ast::grouped(ast::quotient(scalar(1), product)) : product;
}

/// A definition as an expression, for the few that stand inside of an angle. `meaning`: of a symbol.
ast::Expression value_of(const model::Expression& e, const Meaning& meaning) {
  using Kind = model::Expression::Kind;
  ast::Expressions operands;
  for (const model::Expression& operand : e.operands()) operands.push_back(value_of(operand, meaning));
  const auto called = [&](const char* function) {
    return ast::call(ast::Expression::Kind::function, function, operands);
  };
  switch (e.kind()) {
    case Kind::number:
      return scalar(exact::Number(e.number()));
    case Kind::pi:
      return ast::radians(1);
    case Kind::symbol:
      return meaning(e.name());
    case Kind::negate:
      return ast::grouped(ast::negative(operands[0]));
    case Kind::sum:
      return ast::grouped(ast::sum(operands));
    case Kind::product:
      return ast::grouped(ast::product(operands));
    case Kind::quotient:
      return ast::grouped(ast::quotient(operands[0], operands[1]));
    case Kind::power:
      return power(operands[0], e.exponent());
    case Kind::root:
      return called("sqrt");
    case Kind::sine:
      return called("sin");
    case Kind::cosine:
      return called("cos");
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

ast::Leaves robot_leaves(const model::Robot& robot, const std::vector<Angle>& angles, const Meaning& others) {
  std::map<std::string, ast::Expression> known{{"pi", ast::radians(1)}};
  const std::vector<std::string> variables = model::variables(robot);
  for (std::size_t i = 0; i < variables.size(); ++i) known[variables[i]] = ast::entry("q", i);
  const ast::Expression g = ast::name("g", {"Geometry"}, ast::Reach::reference);
  for (const model::Parameter& parameter : robot.geometry)
    known[parameter.name] = ast::member(g, model::described_name(parameter.name));
  // A definition may have others in it, and constants.
  const Meaning defined = [&](const std::string& name) {
    if (const auto constant = constant_value(name)) return *constant;
    const auto definition = robot.definitions.find(name);
    if (known.count(name) == 0 && definition != robot.definitions.end())
      known[name] = value_of(definition->second, defined);
    return known.at(name);
  };
  for (const auto& [name, definition] : robot.definitions) defined(name);
  const auto symbol = [known, others](const std::string& name) {
    if (const auto constant = constant_value(name)) return *constant;
    const auto place = known.find(name);
    if (place != known.end()) return place->second;
    if (!others) throw std::logic_error("symbol " + name + " has no place in the generated code");
    return others(name);
  };
  std::vector<std::string> names;
  for (std::size_t i = 0; i < angles.size(); ++i) names.push_back(angle_name(robot, angles[i], i));
  const auto named = [angles, names](const std::string& letter) {
    return [angles, names, letter](const Angle& angle) {
      return ast::name(letter + names[place_of(angles, angle)]);
    };
  };
  return {symbol, named("s"), named("c")};
}

std::string angle_code(const Angle& angle, const ast::Leaves& leaves, const ast::Printer& language) {
  return language.text(ast::angle_value(angle, leaves.symbol));
}

}  // namespace qvgen::emit
