// SPDX-License-Identifier: MIT
#include "description/lexer.h"

#include <cctype>
#include <charconv>

#include <cln/integer.h>

#include "description/characters.h"

namespace qvgen::description {
namespace {

// Far beyond any physical quantity, and small enough that a slip of the keyboard cannot exhaust the memory.
constexpr std::size_t max_digits = 1000;
constexpr int max_exponent = 300;

bool is_letter(char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Length in bytes of the UTF-8 character that begins here, so that a message can show it whole.
std::size_t character_length(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) ++length;
  return length;
}

std::string hint_for(std::string_view character) {
  if (character == ",") return "write a decimal point, and one expression per entry";
  if (character == "°") return "write degrees as in '90 deg'";
  if (character == "π") return "write 'pi'";
  return "expressions have numbers, names, + - * / ^, parentheses, sqrt, sin, cos, pi, deg";
}

int exponent_value(const Token& literal, std::string_view digits) {
  int value = 0;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end.ec != std::errc() || value > max_exponent || value < -max_exponent) {
    throw ExpressionError{literal.offset,
                          "the exponent of '" + std::string(literal.text) + "' is out of range",
                          "exponents go from -300 to 300"};
  }
  return value;
}

}  // namespace

std::size_t Lexer::skip_number(std::size_t position) const {
  const auto at = [&](std::size_t i) { return i < text_.size() ? text_[i] : '\0'; };
  while (is_digit(at(position))) ++position;
  if (at(position) == '.') {
    ++position;
    while (is_digit(at(position))) ++position;
  }
  if (at(position) == 'e' || at(position) == 'E') {
    const std::size_t sign = at(position + 1) == '+' || at(position + 1) == '-' ? 1 : 0;
    if (is_digit(at(position + 1 + sign))) {
      position += 1 + sign;
      while (is_digit(at(position))) ++position;
    }
  }
  return position;
}

std::size_t Lexer::skip_name(std::size_t position) const {
  while (position < text_.size() && (is_letter(text_[position]) || is_digit(text_[position]))) ++position;
  return position;
}

void Lexer::set(Token::Kind kind, std::size_t length) {
  current_ = {kind, position_, text_.substr(position_, length)};
  position_ += length;
}

void Lexer::advance() {
  while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_])) != 0)
    ++position_;
  if (position_ == text_.size()) return set(Token::Kind::end, 0);
  const std::string_view rest = text_.substr(position_);
  const char c = rest.front();
  if (is_digit(c) || (c == '.' && rest.size() > 1 && is_digit(rest[1]))) {
    return set(Token::Kind::number, skip_number(position_) - position_);
  }
  if (is_letter(c)) return set(Token::Kind::name, skip_name(position_) - position_);
  switch (c) {
    case '+':
      return set(Token::Kind::plus, 1);
    case '-':
      return set(Token::Kind::minus, 1);
    case '*':
      if (rest.size() > 1 && rest[1] == '*') return set(Token::Kind::power, 2);
      return set(Token::Kind::times, 1);
    case '/':
      return set(Token::Kind::divide, 1);
    case '^':
      return set(Token::Kind::power, 1);
    case '(':
      return set(Token::Kind::open, 1);
    case ')':
      return set(Token::Kind::close, 1);
    default:
      break;
  }
  const std::string_view character = rest.substr(0, character_length(rest));
  throw ExpressionError{position_, "'" + std::string(character) + "' cannot stand in an expression",
                        hint_for(character)};
}

cln::cl_RA decimal_value(const Token& literal) {
  std::string digits;
  int exponent = 0;
  bool fraction = false;
  for (std::size_t i = 0; i < literal.text.size(); ++i) {
    const char c = literal.text[i];
    if (c == 'e' || c == 'E') {
      exponent += exponent_value(literal, literal.text.substr(i + 1));
      break;
    }
    if (c == '.') {
      fraction = true;
    } else {
      digits += c;
      if (fraction) --exponent;
    }
  }
  if (digits.size() > max_digits) {
    throw ExpressionError{literal.offset, "a number of " + std::to_string(digits.size()) + " digits",
                          "numbers have at most 1000 digits"};
  }
  return cln::cl_I(digits.c_str()) * cln::expt(cln::cl_RA(10), exponent);
}

}  // namespace qvgen::description
