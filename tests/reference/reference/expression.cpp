// SPDX-License-Identifier: MIT
#include "reference/expression.h"

#include <cctype>
#include <cmath>
#include <stdexcept>

namespace reference {
namespace {

constexpr double pi = 3.14159265358979323846;

class Parser {
 public:
  Parser(const std::string& text, const Values& values, const Functions& functions)
      : text_(text), values_(values), functions_(functions) {}

  double whole() {
    const double value = sum();
    if (peek() != '\0') fail("unexpected rest");
    return value;
  }

 private:
  double sum() {
    double value = term();
    while (true) {
      if (take("+")) {
        value += term();
      } else if (take("-")) {
        value -= term();
      } else {
        return value;
      }
    }
  }

  double term() {
    double value = signed_factor();
    while (true) {
      if (peek() == '*' && !starts("**")) {
        take("*");
        value *= signed_factor();
      } else if (take("/")) {
        value /= signed_factor();
      } else if (take_word("deg")) {
        value *= pi / 180;
      } else if (!take_word("rad")) {
        return value;
      }
    }
  }

  double signed_factor() {
    if (take("-")) return -signed_factor();
    if (take("+")) return signed_factor();
    return power();
  }

  double power() {
    const double base = atom();
    if (take("**") || take("^")) return std::pow(base, signed_factor());
    return base;
  }

  double atom() {
    if (take("(")) return closed();
    const char c = peek();
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return number();
    const std::string name = word();
    if (name.empty()) fail("number or name expected");
    at_ += name.size();
    if (name == "pi") return pi;
    if (const auto function = functions_.find(name); function != functions_.end()) {
      if (!take("(")) fail("parenthesis expected");
      std::vector<double> arguments{sum()};
      while (take(",")) arguments.push_back(sum());
      if (!take(")")) fail("closing parenthesis expected");
      return function->second(arguments);
    }
    const auto found = values_.find(name);
    if (found == values_.end()) fail("no value for '" + name + "'");
    return found->second;
  }

  double closed() {
    const double value = sum();
    if (!take(")")) fail("closing parenthesis expected");
    return value;
  }

  double number() {
    std::size_t length = 0;
    const double value = std::stod(text_.substr(at_), &length);
    at_ += length;
    return value;
  }

  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool starts(const std::string& token) {
    peek();
    return text_.compare(at_, token.size(), token) == 0;
  }
  bool take(const std::string& token) {
    if (!starts(token)) return false;
    at_ += token.size();
    return true;
  }
  std::string word() {
    peek();
    std::size_t end = at_;
    while (end < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '_')) {
      ++end;
    }
    return text_.substr(at_, end - at_);
  }
  bool take_word(const std::string& name) {
    if (word() != name) return false;
    at_ += name.size();
    return true;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("'" + text_ + "' at " + std::to_string(at_) + ": " + what);
  }

  const std::string& text_;
  const Values& values_;
  const Functions& functions_;
  std::size_t at_ = 0;
};

}  // namespace

double evaluate(const std::string& text, const Values& values) {
  static const Functions functions{{"sqrt", [](const auto& x) { return std::sqrt(x[0]); }},
                                   {"sin", [](const auto& x) { return std::sin(x[0]); }},
                                   {"cos", [](const auto& x) { return std::cos(x[0]); }}};
  return evaluate(text, values, functions);
}

double evaluate(const std::string& text, const Values& values, const Functions& functions) {
  return Parser(text, values, functions).whole();
}

}  // namespace reference
