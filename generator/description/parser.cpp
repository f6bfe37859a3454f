// SPDX-License-Identifier: MIT
#include "description/parser.h"

#include <charconv>
#include <cmath>
#include <utility>

#include <cln/integer.h>

#include "description/names.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

using model::Expression;
using Kind = Token::Kind;

constexpr long max_power = 64;
constexpr double max_value_size = 1e5;
constexpr int max_operands = 250;
constexpr int max_depth = 200;  // of parentheses and signs: recursion must not reach the end of the stack

/// Counts the recursion while it lasts.
class Depth {
 public:
  Depth(int& depth, std::size_t offset) : depth_(depth) {
    if (++depth_ > max_depth) {
      throw ExpressionError{offset, "the expression is nested too deeply", "at most 200 levels"};
    }
  }
  Depth(const Depth&) = delete;
  Depth& operator=(const Depth&) = delete;
  ~Depth() { --depth_; }

 private:
  int& depth_;
};

class Parser {
 public:
  explicit Parser(std::string_view text) : lexer_(text) {}
  ParsedExpression run();

 private:
  Expression expression();
  Expression term();
  Expression factor();
  Expression primary();
  Expression named();
  Expression call(const std::string& function, std::size_t offset);
  Expression parenthesised();
  Expression divide_by_factor(const Expression& numerator);
  Expression raised(const Expression& base, std::size_t base_offset);
  long exponent();
  [[nodiscard]] bool at_unit() const;

  bool accept(Kind kind) {
    if (lexer_.current().kind != kind) return false;
    lexer_.advance();
    return true;
  }
  [[noreturn]] void unexpected(const std::string& wanted) const;

  Lexer lexer_;
  ParsedExpression result_;
  int depth_ = 0;
  int operands_ = 0;
};

void Parser::unexpected(const std::string& wanted) const {
  const Token& token = lexer_.current();
  if (token.kind == Kind::end) throw ExpressionError{token.offset, "the expression ends too early", wanted};
  throw ExpressionError{token.offset, "unexpected '" + std::string(token.text) + "'", wanted};
}

/// Roughly the bits of an expression's exact value, for powers of powers that would fill the memory.
double value_size(const Expression& e) {
  if (e.kind() == Expression::Kind::number) {
    return static_cast<double>(cln::integer_length(cln::numerator(e.number())) +
                               cln::integer_length(cln::denominator(e.number())));
  }
  double size = e.operands().empty() ? 32 : 0;
  for (const Expression& operand : e.operands()) size += value_size(operand);
  return e.kind() == Expression::Kind::power ? size * std::abs(static_cast<double>(e.exponent())) : size;
}

/// Looks at a fixed irregular point: what is zero there is zero everywhere, for all a description may hold.
bool is_zero_everywhere(const Expression& e) {
  model::Bindings bindings;
  long seed = 7919;
  for (const std::string& name : symbols(e)) {
    seed = (seed * 16807) % 2147483647;
    bindings[name] = cln::cl_RA(seed) / 65537;
  }
  try {
    return model::vanishes(model::evaluate(e, bindings));
  } catch (const model::EvaluationError&) {
    return false;  // no real value at this point; that says nothing about others
  }
}

void require_nonzero(const Expression& e, std::size_t offset) {
  if (is_zero_everywhere(e)) {
    const std::string which = e.is_literal_zero() ? "" : ": '" + to_string(e) + "' is 0";
    throw ExpressionError{offset, "division by zero" + which, "the denominator must differ from 0"};
  }
}

bool Parser::at_unit() const {
  const Token& token = lexer_.current();
  return token.kind == Kind::name && (token.text == "deg" || token.text == "rad");
}

ParsedExpression Parser::run() {
  if (lexer_.current().kind == Kind::end)
    throw ExpressionError{0, "an empty expression", "write a number or a name"};
  result_.value = expression();
  if (lexer_.current().kind != Kind::end) unexpected("an operator or the end of the expression was due");
  return std::move(result_);
}

Expression Parser::expression() {
  Expression sum = term();
  for (;;) {
    if (accept(Kind::plus)) {
      sum = model::add(sum, term());
    } else if (accept(Kind::minus)) {
      sum = model::subtract(sum, term());
    } else {
      return sum;
    }
  }
}

Expression Parser::term() {
  Expression product = factor();
  bool has_unit = false;
  for (;;) {
    if (accept(Kind::times)) {
      product = model::multiply(product, factor());
    } else if (accept(Kind::divide)) {
      product = divide_by_factor(product);
    } else if (at_unit()) {
      if (std::exchange(has_unit, true)) unexpected("one unit per term; set parentheses");
      result_.has_unit = true;
      const bool degrees = lexer_.current().text == "deg";
      lexer_.advance();
      if (degrees) product = model::multiply(model::multiply(product, cln::cl_RA(1) / 180), Expression::pi());
    } else {
      return product;
    }
  }
}

Expression Parser::divide_by_factor(const Expression& numerator) {
  const std::size_t offset = lexer_.current().offset;
  const Expression denominator = factor();
  require_nonzero(denominator, offset);
  return model::divide(numerator, denominator);
}

Expression Parser::factor() {
  const std::size_t offset = lexer_.current().offset;
  if (lexer_.current().kind == Kind::plus || lexer_.current().kind == Kind::minus) {
    const bool negative = lexer_.current().kind == Kind::minus;
    lexer_.advance();
    const Depth guard(depth_, offset);
    const Expression operand = factor();
    return negative ? model::negate(operand) : operand;
  }
  const Expression base = primary();
  return accept(Kind::power) ? raised(base, offset) : base;
}

Expression Parser::raised(const Expression& base, std::size_t base_offset) {
  const long power = exponent();
  if (lexer_.current().kind == Kind::power) unexpected("powers of powers need parentheses");
  if (value_size(base) * std::abs(static_cast<double>(power)) > max_value_size) {
    throw ExpressionError{base_offset, "the power is too large", "its exact value has more than 100000 bits"};
  }
  if (power < 0) require_nonzero(base, base_offset);
  return model::raise(base, power);
}

long Parser::exponent() {
  const bool enclosed = accept(Kind::open);
  const bool negative = accept(Kind::minus);
  const Token token = lexer_.current();
  long value = 0;
  const char* const end = token.text.data() + token.text.size();
  const auto parsed = std::from_chars(token.text.data(), end, value);
  if (token.kind != Kind::number || parsed.ptr != end || parsed.ec != std::errc() || value > max_power) {
    unexpected("exponents are integers from -64 to 64");
  }
  lexer_.advance();
  if (enclosed && !accept(Kind::close)) unexpected("a ')' was due");
  return negative ? -value : value;
}

Expression Parser::parenthesised() {
  const std::size_t offset = lexer_.current().offset;
  if (!accept(Kind::open)) unexpected("a '(' was due");
  const Depth guard(depth_, offset);
  Expression inner = expression();
  if (!accept(Kind::close)) unexpected("a ')' was due");
  return inner;
}

Expression Parser::primary() {
  const Token token = lexer_.current();
  if (++operands_ > max_operands) {
    throw ExpressionError{token.offset, "the expression is too long",
                          "at most " + std::to_string(max_operands) + " numbers and names"};
  }
  if (token.kind == Kind::number) {
    lexer_.advance();
    return decimal_value(token);
  }
  if (token.kind == Kind::name && !at_unit()) return named();
  if (token.kind == Kind::open) return parenthesised();
  unexpected("a number, a name or a '(' was due");
}

Expression Parser::named() {
  const Token token = lexer_.current();
  const std::string name(token.text);
  lexer_.advance();
  if (lexer_.current().kind == Kind::open) return call(name, token.offset);
  if (name == "pi") return Expression::pi();
  if (const NameProblem problem = check_identifier(name); !problem.message.empty()) {
    throw ExpressionError{token.offset, problem.message, problem.hint};
  }
  result_.symbols.push_back({name, token.offset});
  return Expression::symbol(name);
}

Expression Parser::call(const std::string& function, std::size_t offset) {
  const std::size_t argument_offset = lexer_.current().offset + 1;
  if (function != "sqrt" && function != "sin" && function != "cos") {
    const std::string near = nearest(function, {"sqrt", "sin", "cos"});
    throw ExpressionError{offset, "unknown function '" + function + "'",
                          near.empty() ? "the functions are sqrt, sin and cos; a product needs its '*'"
                                       : "did you mean '" + near + "'?"};
  }
  const bool had_unit = result_.has_unit;
  const Expression argument = parenthesised();
  if (function != "sqrt") result_.has_unit = had_unit;  // a sine is no angle
  if (function == "sqrt") {
    if (symbols(argument).empty() && cln::minusp(model::evaluate(argument))) {
      throw ExpressionError{argument_offset, "the root of " + to_string(argument) + " is not real",
                            "roots are taken of numbers from 0 on"};
    }
    return argument.is_literal_zero() ? argument : Expression::make(Expression::Kind::root, {argument});
  }
  if (!symbols(argument).empty()) {
    throw ExpressionError{argument_offset,
                          "the " + std::string(function == "sin" ? "sine" : "cosine") + " of '" +
                              to_string(argument) + "' is no constant",
                          "sin and cos take constants; give the symbol's value in [defaults] instead"};
  }
  return function == "sin" ? model::sine(argument) : model::cosine(argument);
}

/// Offsets in bytes become offsets in characters, as editors count columns.
std::size_t characters(std::string_view text, std::size_t bytes) {
  std::size_t count = 0;
  for (const char c : text.substr(0, bytes))
    count += (static_cast<unsigned char>(c) & 0xC0U) == 0x80U ? 0 : 1;
  return count;
}

}  // namespace

ParsedExpression parse_expression(std::string_view text) {
  try {
    return Parser(text).run();
  } catch (ExpressionError error) {
    error.offset = characters(text, error.offset);
    throw error;
  } catch (const model::EvaluationError& error) {
    throw ExpressionError{0, error.what(), "roots are real and denominators differ from 0"};
  }
}

}  // namespace qvgen::description
