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

const char* const example = "write a sum of joints and motors, e.g. \"1/2 ml - 1/2 mr + 10 deg\"";

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The word that begins at a place of the text.
std::string word_at(const std::string& text, std::size_t place) {
  const auto begin = text.begin() + static_cast<std::ptrdiff_t>(place);
  const auto is_in_word = [](char c) { return begins_name(c) || is_digit(c); };
  return {begin, std::find_if_not(begin, text.end(), is_in_word)};
}

/// Puts products in place of blanks between a number or a bracket and a name; the text keeps its length.
std::string with_products(std::string text) {
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const char before = text[i - 1], behind = text[i + 1];
    if (text[i] != ' ' || !(is_digit(before) || before == ')' || before == '.') || !begins_name(behind))
      continue;
    const std::string word = word_at(text, i + 1);
    if (word != "deg" && word != "rad") text[i] = '*';
  }
  return text;
}

/// A sum of multiples of names, and a constant.
struct Linear {
  std::map<std::string, Expression> factors;
  Expression constant;
};

Linear scaled(Linear linear, const Expression& by, bool divides) {
  const auto scale = [&](const Expression& e) {
    return divides ? model::divide(e, by) : model::multiply(e, by);
  };
  for (auto& [name, factor] : linear.factors) factor = scale(factor);
  linear.constant = scale(linear.constant);
  return linear;
}

Linear sum(Linear a, const Linear& b) {
  for (const auto& [name, factor] : b.factors) a.factors[name] = model::add(a.factors[name], factor);
  a.constant = model::add(a.constant, b.constant);
  return a;
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
    if (!parsed || !names_differ(*parsed)) return std::nullopt;
    const auto form = linear_form(parsed->value);
    if (!form) return failed(place_, "'follows' is not a sum of multiples of joints and motors", example);
    if (parsed->symbols.empty()) return failed(place_, "'follows' names no joint and no motor", example);
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
