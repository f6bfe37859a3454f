// SPDX-License-Identifier: MIT
#include "emit/ast/c_like.h"

namespace qvgen::emit::ast {

std::string indented(int depth, const std::string& line) {
  return line.empty() ? line : std::string(static_cast<std::size_t>(2 * depth), ' ') + line;
}

std::string CLikePrinter::text(const Expression& e) const {
  using Kind = Expression::Kind;
  switch (e.kind) {
    case Kind::literal:
    case Kind::name:
      return e.text;
    case Kind::member:
      return text(e.operands[0]) + arrow(e.operands[0]) + e.text;
    case Kind::negative:
      return "-" + factor(e.operands[0]);
    case Kind::sum:
      return sum(e.operands);
    case Kind::product:
      return product(e.operands);
    case Kind::quotient:
      return factor(e.operands[0]) + " / " + divisor(e.operands[1]);
    case Kind::grouped:
      return "(" + text(e.operands[0]) + ")";
    case Kind::compare:
      return text(e.operands[0]) + " " + e.text + " " + text(e.operands[1]);
    case Kind::condition:
      return text(e.operands[0]) + " ? " + text(e.operands[1]) + " : " + text(e.operands[2]);
    case Kind::pair:
      return "{" + list(e.operands) + "}";
    default:
      return spelled(e);
  }
}

std::string CLikePrinter::list(const Expressions& expressions, std::size_t first) const {
  std::string result;
  for (std::size_t i = first; i < expressions.size(); ++i) {
    const std::string each = text(expressions[i]);
    if (!each.empty()) result += (result.empty() ? "" : ", ") + each;
  }
  return result;
}

/// Sums get brackets, behind a sign too.
std::string CLikePrinter::factor(const Expression& e) const {
  return e.kind == Expression::Kind::sum ? "(" + text(e) + ")" : text(e);
}

/// So do products and quotients where they divide.
std::string CLikePrinter::divisor(const Expression& e) const {
  using Kind = Expression::Kind;
  if (e.kind == Kind::negative) return "-" + divisor(e.operands[0]);
  const bool is_compound = e.kind == Kind::product || e.kind == Kind::quotient;
  return is_compound ? "(" + text(e) + ")" : factor(e);
}

std::string CLikePrinter::sum(const Expressions& terms) const {
  std::string result = factor(terms.front());
  for (std::size_t i = 1; i < terms.size(); ++i) {
    const bool subtracts = terms[i].kind == Expression::Kind::negative;
    result += subtracts ? " - " + factor(terms[i].operands[0]) : " + " + factor(terms[i]);
  }
  return result;
}

std::string CLikePrinter::product(const Expressions& factors) const {
  std::string result = factor(factors.front());
  for (std::size_t i = 1; i < factors.size(); ++i) result += " * " + factor(factors[i]);
  return result;
}

Lines CLikePrinter::lines(const Statements& statements, int depth) const {
  Lines result;
  for (const Statement& statement : statements) add(statement, depth, result);
  return result;
}

Lines CLikePrinter::body(const std::vector<std::string>& /*parameters*/, const Statements& statements) const {
  return lines(statements);
}

void CLikePrinter::add_block(const std::string& head, const Statements& body, int depth,
                             Lines& result) const {
  result.push_back(indented(depth, head + "{"));
  for (const Statement& statement : body) add(statement, depth + 1, result);
  result.push_back(indented(depth, "}"));
}

void CLikePrinter::add(const Statement& s, int depth, Lines& result) const {
  using Kind = Statement::Kind;
  const auto line = [&](const std::string& text) { result.push_back(indented(depth, text)); };
  switch (s.kind) {
    case Kind::evaluate:
      return line(text(s.values[0]) + ";");
    case Kind::guard: {
      Lines then = lines(s.body);
      then.front().insert(0, "if (" + text(s.values[0]) + ") ");
      for (const std::string& each : then) line(each);
      return;
    }
    case Kind::choose:
      return add_block("if (" + text(s.values[0]) + ") ", s.body, depth, result);
    case Kind::loop: {
      if (s.unrolled && !unroll().empty()) line(unroll());
      const std::string head =
          "for (int " + s.name + " = 0; " + s.name + " < " + text(s.values[0]) + "; ++" + s.name + ") ";
      return add_block(head, s.body, depth, result);
    }
    case Kind::leave_loop:
      return line("break;");
    case Kind::next_round:
      return line("continue;");
    case Kind::give:
      return line(s.values[0].kind == Expression::Kind::nothing ? "return;"
                                                                : "return " + text(s.values[0]) + ";");
    case Kind::scope:
      return add_block("", s.body, depth, result);
    default:
      for (const std::string& each : spelled(s)) line(each);
  }
}

}  // namespace qvgen::emit::ast
