// SPDX-License-Identifier: MIT
#include "description/relation.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "description/characters.h"
#include "description/parser.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

using model::Expression;

/// The greatest power in a relation.
constexpr long most_power = 8;

const char* const example = "write a sum of joints and motors, e.g. \"1/2 ml - 1/2 mr + 10 deg\"";

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The word that begins at a place of the text.
std::string word_at(const std::string& text, std::size_t place) {
  const auto begin = text.begin() + static_cast<std::ptrdiff_t>(place);
  const auto is_in_word = [](char c) { return begins_name(c) || is_digit(c); };
  return {begin, std::find_if_not(begin, text.end(), is_in_word)};
}

/// Puts products in place of blanks between a number or a bracket and a name or a bracket; the text keeps its
/// length.
std::string with_products(std::string text) {
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const char before = text[i - 1], behind = text[i + 1];
    if (text[i] != ' ' || !(is_digit(before) || before == ')' || before == '.')) continue;
    if (behind == '(') text[i] = '*';
    if (!begins_name(behind)) continue;
    const std::string word = word_at(text, i + 1);
    if (word != "deg" && word != "rad") text[i] = '*';
  }
  return text;
}

/// factor (name - from)^exponent.
struct Power {
  std::string name;
  Expression factor, from;
  long exponent;
};

/// A sum of multiples of names, and a constant; powers beside them.
struct Linear {
  std::map<std::string, Expression> factors;
  Expression constant;
  std::vector<Power> powers = {};
};

Linear scaled(Linear linear, const Expression& by, bool divides) {
  const auto scale = [&](const Expression& e) {
    return divides ? model::divide(e, by) : model::multiply(e, by);
  };
  for (auto& [name, factor] : linear.factors) factor = scale(factor);
  for (Power& power : linear.powers) power.factor = scale(power.factor);
  linear.constant = scale(linear.constant);
  return linear;
}

Linear sum(Linear a, const Linear& b) {
  for (const auto& [name, factor] : b.factors) a.factors[name] = model::add(a.factors[name], factor);
  a.powers.insert(a.powers.end(), b.powers.begin(), b.powers.end());
  a.constant = model::add(a.constant, b.constant);
  return a;
}

/// The power of a multiple of one name and a constant: (f x + d)^n is f^n (x + d / f)^n.
std::optional<Linear> power_form(const Linear& base, long exponent) {
  if (exponent < 2 || base.factors.size() != 1 || !base.powers.empty()) return std::nullopt;
  const auto& [name, factor] = *base.factors.begin();
  Linear form{{{name, Expression()}}, {}};
  form.powers.push_back(
      {name, model::raise(factor, exponent), model::negate(model::divide(base.constant, factor)), exponent});
  return form;
}

std::optional<Linear> linear_form(const Expression& e);

std::optional<Linear> product_form(const Expression& e) {
  std::optional<Linear> result = Linear{{}, Expression(cln::cl_RA(1))};
  for (const Expression& operand : e.operands()) {
    if (symbols(operand).empty()) {
      result = scaled(std::move(*result), operand, false);
      continue;
    }
    const std::optional<Linear> other = linear_form(operand);
    if (!other || !result->factors.empty()) return std::nullopt;
    result = scaled(*other, result->constant, false);
  }
  return result;
}

/// Nothing if the expression is not linear in its names.
std::optional<Linear> linear_form(const Expression& e) {
  using Kind = Expression::Kind;
  if (symbols(e).empty()) return Linear{{}, e};
  switch (e.kind()) {
    case Kind::symbol:
      return Linear{{{e.name(), Expression(cln::cl_RA(1))}}, {}};
    case Kind::negate:
      if (const auto form = linear_form(e.operands()[0]))
        return scaled(*form, Expression(cln::cl_RA(-1)), false);
      return std::nullopt;
    case Kind::sum: {
      Linear total;
      for (const Expression& operand : e.operands()) {
        const auto form = linear_form(operand);
        if (!form) return std::nullopt;
        total = sum(std::move(total), *form);
      }
      return total;
    }
    case Kind::product:
      return product_form(e);
    case Kind::power: {
      const auto base = linear_form(e.operands()[0]);
      return base ? power_form(*base, e.exponent()) : std::nullopt;
    }
    case Kind::quotient: {
      const auto form = linear_form(e.operands()[0]);
      if (!form || !symbols(e.operands()[1]).empty()) return std::nullopt;
      return scaled(*form, e.operands()[1], true);
    }
    default:
      return std::nullopt;
  }
}

class RelationReader {
 public:
  RelationReader(Context& context, Place place) : context_(context), place_(place) {}

  std::optional<Relation> read(const std::string& text) {
    const auto parsed = parse(text);
    if (!parsed) return std::nullopt;
    const auto form = linear_form(parsed->value);
    if (!form) return failed(place_, "'follows' is not a sum of multiples of joints and motors", example);
    if (parsed->symbols.empty()) return failed(place_, "'follows' names no joint and no motor", example);
    if (!form->powers.empty()) return polynomial(*form);
    if (!names_differ(*parsed)) return std::nullopt;
    Relation relation;
    for (const ParsedExpression::SymbolUse& use : parsed->symbols) {
      const auto factor = factor_of(*form, use);
      if (!factor) return std::nullopt;
      relation.leaders.push_back({use.name, *factor});
    }
    relation.constant = {form->constant, place_, parsed->has_unit};
    return relation;
  }

 private:
  std::nullopt_t failed(Place place, const std::string& message, const std::string& hint) {
    context_.error(place, message, hint);
    return std::nullopt;
  }

  /// A relation with powers, all of one name less one constant.
  std::optional<Relation> polynomial(const Linear& form) {
    try {
      return checked_polynomial(form);
    } catch (const model::EvaluationError& error) {
      return failed(place_, std::string("'follows' has a number without a value: ") + error.what(), example);
    }
  }
  std::optional<Relation> checked_polynomial(const Linear& form) {
    if (form.factors.size() != 1)
      return failed(place_, "'follows' has powers and names several",
                    "powers are those of one joint or motor");
    const auto& [name, factor] = *form.factors.begin();
    const auto linear = rational(factor, name);
    if (!linear) return std::nullopt;
    Relation relation{{{name, *linear}}, {form.constant, place_}};  // in radians or metres
    const Expression& from = form.powers.front().from;
    std::vector<cln::cl_RA>& factors = relation.powers.factors;
    for (const Power& power : form.powers) {
      if (power.exponent > most_power)
        return failed(place_, "'follows' has a power above " + std::to_string(most_power), example);
      if (!cln::zerop(model::evaluate(model::subtract(power.from, from))))
        return failed(place_, "the powers in 'follows' are those of different sums",
                      "write powers of one difference, e.g. \"1/2 ml + 1/5 (ml - 1/10)^2 - (ml - 1/10)^3\"");
      const auto value = rational(power.factor, name);
      if (!value) return std::nullopt;
      const auto place = static_cast<std::size_t>(power.exponent) - 2;
      factors.resize(std::max(factors.size(), place + 1), 0);
      factors[place] = factors[place] + *value;
    }
    while (!factors.empty() && cln::zerop(factors.back())) factors.pop_back();
    relation.powers.from = from;
    if (factors.empty() && cln::zerop(*linear))
      return failed(place_, "the factor of '" + name + "' is 0", example);
    return relation;
  }

  /// A factor of a name; reported if it is not rational.
  std::optional<cln::cl_RA> rational(const Expression& factor, const std::string& name) {
    const auto value = model::rational_value(model::evaluate(factor));
    if (value) return *value;
    return failed(place_, "a factor of '" + name + "' is not rational", "write a number or a quotient");
  }

  /// The place of a character of the text, which stands in quotes.
  [[nodiscard]] Place at(std::size_t offset) const {
    Place place = place_;
    place.column += 1 + static_cast<int>(offset);
    return place;
  }

  std::optional<ParsedExpression> parse(const std::string& text) {
    try {
      return parse_expression(with_products(text));
    } catch (const ExpressionError& error) {
      return failed(at(error.offset), error.message, error.hint);
    }
  }

  bool names_differ(const ParsedExpression& parsed) {
    for (std::size_t i = 0; i < parsed.symbols.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (parsed.symbols[i].name == parsed.symbols[k].name) {
          context_.error(at(parsed.symbols[i].offset),
                         "'follows' names '" + parsed.symbols[i].name + "' twice",
                         "write it once, with the sum of its factors");
          return false;
        }
    return true;
  }

  std::optional<cln::cl_RA> factor_of(const Linear& form, const ParsedExpression::SymbolUse& use) {
    const auto place = form.factors.find(use.name);
    const Expression factor = place == form.factors.end() ? Expression() : place->second;
    try {
      const auto value = model::rational_value(model::evaluate(factor));
      if (value && !cln::zerop(*value)) return *value;
      return failed(at(use.offset), "the factor of '" + use.name + (value ? "' is 0" : "' is not rational"),
                    value ? "leave it out" : "write a number or a quotient, e.g. \"3/2 " + use.name + "\"");
    } catch (const model::EvaluationError& error) {
      return failed(at(use.offset), "the factor of '" + use.name + "' has no value: " + error.what(),
                    example);
    }
  }

  Context& context_;
  Place place_;
};

}  // namespace

std::optional<Relation> read_relation(Context& context, const std::string& text, Place place) {
  return RelationReader(context, place).read(text);
}

}  // namespace qvgen::description
