// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <cln/rational.h>

namespace qvgen::description {

/// A mistake inside an expression; the offset counts characters from its beginning.
struct ExpressionError {
  std::size_t offset = 0;
  std::string message;
  std::string hint;
};

struct Token {
  enum class Kind { end, number, name, plus, minus, times, divide, power, open, close };
  Kind kind = Kind::end;
  std::size_t offset = 0;
  std::string_view text;
};

/// Cuts an expression into tokens; throws ExpressionError at a character that belongs to none.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) { advance(); }
  [[nodiscard]] const Token& current() const { return current_; }
  void advance();

 private:
  [[nodiscard]] std::size_t skip_number(std::size_t position) const;
  [[nodiscard]] std::size_t skip_name(std::size_t position) const;
  void set(Token::Kind kind, std::size_t length);

  std::string_view text_;
  std::size_t position_ = 0;
  Token current_;
};

/// The exact value of a decimal literal such as 0.4318 or 1e-3; throws ExpressionError if it is absurdly
/// long.
cln::cl_RA decimal_value(const Token& literal);

}  // namespace qvgen::description
