// SPDX-License-Identifier: MIT
#include "emit/math/notation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "exact/constant_angle.h"
#include "exact/named_constant.h"

namespace qvgen::emit {
namespace {

using dag::Edge;
using dag::Op;

bool is_greek(const std::string& word) {
  static constexpr std::array<const char*, 12> greek{"alpha", "beta",  "gamma", "delta",  "theta", "phi",
                                                     "psi",   "omega", "tau",   "lambda", "mu",    "rho"};
  return std::find(greek.begin(), greek.end(), word) != greek.end();
}

std::string latex_name(const std::string& name) {
  const std::size_t end = name.find_first_of("0123456789_");
  const std::string word = name.substr(0, end);
  std::string index = end == std::string::npos ? "" : name.substr(end);
  // link_1_2 is not link_12
  if (!index.empty() && index.front() == '_') index.erase(0, 1);
  std::replace(index.begin(), index.end(), '_', ',');
  if (word.empty()) return index;
  const std::string letters =
      is_greek(word) ? "\\" + word : (word.size() > 1 ? "\\mathrm{" + word + "}" : word);
  return index.empty() ? letters : letters + "_{" + index + "}";
}

/// A linear form whose coefficients are all +-1/2: the thesis writes the halves as bars over the angles.
bool all_halves(const dag::Angle& angle) {
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  return cln::zerop(angle.pi) && std::all_of(angle.terms.begin(), angle.terms.end(),
                                             [&](const auto& term) { return cln::abs(term.second) == half; });
}

std::string barred(const dag::Angle& angle) {
  std::string text;
  for (const auto& [name, coefficient] : angle.terms) {
    const bool negative = cln::minusp(coefficient);
    text += negative ? "-" : (text.empty() ? "" : "+");
    text += "\\bar{" + latex_name(name) + "}";
  }
  return text;
}

std::string latex_number(const exact::Number& number) {
  if (number.is_rational()) {
    const cln::cl_RA value = number.rational();
    const auto text = [](const cln::cl_RA& part) { return exact::to_string(exact::Number(part)); };
    if (cln::denominator(value) == 1) return text(value);
    return "\\tfrac{" + text(cln::numerator(value)) + "}{" + text(cln::denominator(value)) + "}";
  }
  std::string text = exact::to_string(number);
  for (std::size_t at = text.find("sqrt("); at != std::string::npos; at = text.find("sqrt(", at + 5)) {
    text[text.find(')', at)] = '}';
    text.replace(at, 5, "\\sqrt{");
  }
  return text;
}

/// A fraction that ends within twelve decimals and is not halves; else nothing.
std::string decimal(const cln::cl_RA& value) {
  if (cln::denominator(value) <= 2) return {};
  cln::cl_RA scaled = cln::abs(value);
  std::size_t places = 0;
  for (; cln::denominator(scaled) != 1; ++places) {
    if (places == 12) return {};
    scaled = scaled * 10;
  }
  std::string digits = exact::to_string(exact::Number(scaled));
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  digits.insert(digits.size() - places, ".");
  return (cln::minusp(value) ? "-" : "") + digits;
}

/// Roots and fractions that nobody reads: 4318/18686333*sqrt(18686333).
bool is_long(const exact::Number& value) {
  constexpr unsigned long most = 10000;
  for (const auto& [radicand, coefficient] : value.terms())
    if (radicand > most || cln::denominator(coefficient) > most * most) return true;
  return false;
}

class Formula {
 public:
  Formula(const dag::Graph& graph, Notation notation,
          const std::function<std::string(const std::string&)>& name)
      : graph_(graph),
        latex_(notation.typeset),
        notation_(notation),
        name_(name),
        numbers_(notation.numbers) {}

  std::string signed_text(Edge edge) const {
    if (!edge.negative) return text(edge.node);
    return graph_.node(edge).op == Op::sum ? sum(graph_.node(edge), true) : "-" + factor(edge.node);
  }

 private:
  std::string text(std::uint32_t id) const {
    const dag::Node& node = graph_.node(id);
    switch (node.op) {
      case Op::constant:
        return number(graph_.constant_of(node));
      case Op::symbol:
        return name_(graph_.symbol_of(node));
      case Op::sine:
        return call("sin", graph_.angle_of(node));
      case Op::cosine:
        return call("cos", graph_.angle_of(node));
      case Op::sum:
        return sum(node);
      case Op::product:
        return product(node);
      case Op::quotient:
        return quotient(node);
      case Op::root:
        return latex_ ? "\\sqrt{" + signed_text(node.operands[0]) + "}"
                      : "sqrt(" + signed_text(node.operands[0]) + ")";
      case Op::arctangent:
        return "atan2(" + signed_text(node.operands[0]) + ", " + signed_text(node.operands[1]) + ")";
    }
    return {};
  }

  std::string number(const exact::Number& value) const {
    if (numbers_ == Numbers::decimal) {
      if (value.is_rational())
        if (const std::string text = decimal(value.rational()); !text.empty()) return text;
      if (is_long(value)) return rounded(value.to_double());
    }
    return latex_ ? latex_number(value) : exact::to_string(value);
  }

  [[nodiscard]] std::string rounded(double value) const {
    std::string text = fmt::format("{:.10g}", value);
    const std::size_t exponent = text.find('e');
    if (!latex_ || exponent == std::string::npos) return text;
    return fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, exponent), std::stoi(text.substr(exponent + 1)));
  }

  std::string call(const char* name, const dag::Angle& angle) const {
    if (latex_) return fmt::format("\\{}({})", name, formula(angle, notation_));
    return fmt::format("{}({})", name, formula(angle, notation_));
  }

  std::string factor(std::uint32_t id) const {
    const dag::Node& node = graph_.node(id);
    const bool has_terms = node.op == Op::constant && graph_.constant_of(node).terms().size() > 1;
    return node.op == Op::sum || (has_terms && text(id).find('(') != std::string::npos) ? "(" + text(id) + ")"
                                                                                        : text(id);
  }

  std::string raised(std::uint32_t id, bool square) const {
    if (!square) return factor(id);
    // sin(x) in LaTeX stands without parentheses of its own.
    const bool plain = graph_.node(id).op == Op::sum || !latex_;
    return (plain ? factor(id) : "{" + factor(id) + "}") + "^2";
  }

  /// The sum or its negative, written term by term with a positive one first.
  std::string sum(const dag::Node& node, bool negative = false) const {
    std::vector<Edge> terms = node.operands;
    for (Edge& term : terms) term.negative = term.negative != negative;
    const auto positive = std::find_if(terms.begin(), terms.end(), [](Edge e) { return !e.negative; });
    if (positive != terms.end()) std::rotate(terms.begin(), positive, positive + 1);
    std::string result = (terms.front().negative ? "-" : "") + factor(terms.front().node);
    for (std::size_t i = 1; i < terms.size(); ++i)
      result += (terms[i].negative ? " - " : " + ") + factor(terms[i].node);
    return result;
  }

  /// Numbers, symbols, functions, sums.
  int place(Edge edge) const {
    switch (graph_.node(edge).op) {
      case Op::constant:
        return factor(edge.node).front() == '(' ? 3 : 0;
      case Op::symbol:
        return 1;
      case Op::sum:
        return 3;
      default:
        return 2;
    }
  }

  /// Returns a factor as a decimal number: a named constant or a number beside one.
  [[nodiscard]] std::optional<double> decimal_value(Edge edge) const {
    const dag::Node& node = graph_.node(edge);
    std::optional<double> value;
    if (node.op == Op::constant) value = graph_.constant_of(node).to_double();
    if (node.op == Op::symbol)
      if (const auto named = exact::named_value(graph_.symbol_of(node))) value = cln::double_approx(*named);
    return value && edge.negative ? -*value : value;
  }

  [[nodiscard]] bool is_named_constant(Edge edge) const {
    const dag::Node& node = graph_.node(edge);
    return node.op == Op::symbol && exact::named_value(graph_.symbol_of(node)).has_value();
  }

  /// Takes named constants out of the factors, and numbers with them; their product as text, empty if there
  /// is no named constant. Side by side they would read as one number.
  std::string take_numbers(std::vector<Edge>& factors) const {
    const auto is_named = [this](Edge edge) { return is_named_constant(edge); };
    if (std::none_of(factors.begin(), factors.end(), is_named)) return "";
    double value = 1;
    for (const Edge& factor : factors) value *= decimal_value(factor).value_or(1);
    std::erase_if(factors, [this](Edge edge) { return decimal_value(edge).has_value(); });
    return fmt::format("{:.6g}", value);
  }

  /// Adds the factors of a product, and of products within it.
  void add_factors(const dag::Node& node, std::vector<Edge>& factors) const {
    for (const Edge& operand : node.operands)
      if (graph_.node(operand).op == Op::product && !operand.negative)
        add_factors(graph_.node(operand), factors);
      else
        factors.push_back(operand);
  }

  std::string product(const dag::Node& node) const {
    std::vector<Edge> operands;
    add_factors(node, operands);
    std::stable_sort(operands.begin(), operands.end(),
                     [this](Edge a, Edge b) { return place(a) < place(b); });
    std::string result = take_numbers(operands);
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const Edge& operand = operands[i];
      const bool square = i + 1 < operands.size() && operands[i + 1] == operand;
      if (!result.empty()) result += latex_ ? " " : "*";
      result += (operand.negative ? "-" : "") + raised(operand.node, square);
      if (square) ++i;
    }
    return result;
  }

  std::string quotient(const dag::Node& node) const {
    if (latex_) return "\\frac{" + signed_text(node.operands[0]) + "}{" + signed_text(node.operands[1]) + "}";
    const Op below = graph_.node(node.operands[1]).op;
    const bool alone = below == Op::symbol || below == Op::sine || below == Op::cosine || below == Op::root;
    const std::string denominator = signed_text(node.operands[1]);
    return factor(node.operands[0].node) + (alone ? "/" + denominator : "/(" + denominator + ")");
  }

  const dag::Graph& graph_;
  bool latex_;
  Notation notation_;
  const std::function<std::string(const std::string&)>& name_;
  Numbers numbers_;
};

/// Named constants and multiples of pi gathered in one decimal number of radians.
std::string with_decimals(const dag::Angle& angle, Notation notation) {
  dag::Angle variables;
  dag::Angle constants{{}, angle.pi};
  for (const auto& [name, coefficient] : angle.terms)
    (exact::named_value(name) ? constants : variables).terms.emplace(name, coefficient);
  const double radians = cln::double_approx(*exact::radians(constants));
  if (variables.terms.empty()) return fmt::format("{:.6g}", radians);
  return formula(variables, notation) + fmt::format(" {} {:.6g}", radians < 0 ? "-" : "+", std::abs(radians));
}

}  // namespace

std::string formula(const std::string& name, Notation notation) {
  if (const auto value = exact::named_value(name)) return fmt::format("{:.6g}", cln::double_approx(*value));
  return notation.typeset ? latex_name(name) : name;
}

std::string formula(const dag::Angle& angle, Notation notation) {
  const auto is_named = [](const auto& term) { return exact::named_value(term.first).has_value(); };
  if (std::any_of(angle.terms.begin(), angle.terms.end(), is_named)) return with_decimals(angle, notation);
  if (!notation.typeset) return exact::to_string(angle);
  if (all_halves(angle)) return barred(angle);
  std::string text = exact::to_string(angle);
  for (const auto& [name, coefficient] : angle.terms) {
    const std::size_t at = text.find(name);
    if (at != std::string::npos) text.replace(at, name.size(), latex_name(name));
  }
  text.erase(std::remove(text.begin(), text.end(), '*'), text.end());
  const std::size_t pi = text.find("pi");
  if (pi != std::string::npos) text.replace(pi, 2, "\\pi");
  return text;
}

std::string formula(const dag::Graph& graph, Edge value, Notation notation) {
  return formula(graph, value, notation,
                 [notation](const std::string& name) { return formula(name, notation); });
}

std::string formula(const dag::Graph& graph, Edge value, Notation notation,
                    const std::function<std::string(const std::string&)>& name) {
  return Formula(graph, notation, name).signed_text(value);
}

}  // namespace qvgen::emit
