// SPDX-License-Identifier: MIT
#include "emit/blocks/runtime/translation.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "emit/blocks/runtime/brackets.h"

namespace qvgen::emit::blocks::runtime {
namespace {

using Kind = Token::Kind;

bool is_capital(const std::string& name) { return std::isupper(static_cast<unsigned char>(name[0])) != 0; }

}  // namespace

std::string name_in_c(const std::string& name) {
  static const std::map<std::string, std::string> all{{"abs", "fabs"},
                                                      {"magnitude", "fabs"},
                                                      {"angle", "angle_of"},
                                                      {"pass", "may_pass"},
                                                      {"step", "may_step"}};
  const auto known = all.find(name);
  return known != all.end() ? known->second : name;
}

const std::string& Translation::text(std::size_t at) const { return in_[std::min(at, in_.size() - 1)].text; }

bool Translation::is(const char* wanted, std::size_t ahead) const { return text(at_ + ahead) == wanted; }

void Translation::fail(const std::string& what) const { throw error_at(file_, in_[at_].line, what); }

std::size_t Translation::next(const std::string& wanted) const {
  for (std::size_t i = at_; i < in_.size(); ++i)
    if (text(i) == wanted) return i;
  fail("expected " + wanted);
}

std::size_t Translation::closing(std::size_t from) const { return runtime::closing(file_, in_, from); }

void Translation::put(const Token& token) {
  out_.push_back(token);
  if (!comment_.empty()) out_.back().comment = std::move(comment_);
  comment_.clear();
}

void Translation::put(const std::string& word, Kind kind) { put(Token{kind, word, in_[at_].line}); }

void Translation::leave_out(std::size_t behind) {
  if (!in_[at_].comment.empty()) comment_ = in_[at_].comment;
  at_ = behind;
}

void Translation::translate(std::size_t end) {
  while (at_ < end) word();
}

void Translation::word() {
  const Token& token = in_[at_];
  if (token.kind != Kind::name) {
    if (is("[") && is("[", 1)) return leave_out(closing(at_) + 1);
    if (is("0x1p-1022")) return put_smallest();
    put(token);
    ++at_;
    return;
  }
  if (is("using")) return leave_out(next(";") + 1);
  if (is("if") && is("constexpr", 1)) return known_condition();
  if (is("static_cast") || is("std") || is("inline") || is("constexpr")) return qualifier();
  if (is(":", 1) && is(":", 2)) return leave_out(at_ + 3);
  if (is("Scalar") || (is_capital(token.text) && is("<", 1) && is("Scalar", 2))) return type();
  if (is("Boundary") || is("Patience") || is_sized()) return type();
  named();
}

/// Puts the name of the least normal number, which float has as well.
void Translation::put_smallest() {
  put("DBL_MIN", Kind::name);
  ++at_;
}

/// Words that C has no need of, and arrays.
void Translation::qualifier() {
  if (is("static_cast")) return leave_out(next(">") + 1);
  if (is("inline") || is("constexpr")) return leave_out(at_ + 1);
  leave_out(at_ + 3);
  if (is("size_t")) {
    put("int", Kind::name);
    ++at_;
  } else if (is("array")) {
    Tokens sizes;
    array(sizes);
    put(in_[at_++]);
    put_sizes(sizes);
  }
}

void Translation::put_sizes(const Tokens& sizes) {
  for (const Token& size : sizes) {
    put("[");
    put(size);
    put("]");
  }
}

/// Room in C for a size: a number, or a constant of the robot's C for one of the template.
Token Translation::room(const Token& size) const {
  Token result = size;
  if (std::find(sizes_.begin(), sizes_.end(), size.text) != sizes_.end()) result.text = "most_" + size.text;
  return result;
}

void Translation::array(Tokens& sizes) {
  at_ += 2;
  Tokens inner;
  if (is("std")) {
    at_ += 3;
    array(inner);
  } else {
    type();
  }
  sizes.push_back(room(in_[at_ + 1]));
  sizes.insert(sizes.end(), inner.begin(), inner.end());
  at_ += 3;
}

/// `if constexpr`: singular poses are never left, and flags are arguments.
void Translation::known_condition() {
  const bool leaves = is("leaves_singular_poses", 3), stays = is("!", 3) && is("leaves_singular_poses", 4);
  if (!leaves && !stays) {
    put(in_[at_]);
    at_ += 2;
    return;
  }
  const std::size_t statement = closing(at_ + 2) + 1;
  const bool is_block = text(statement) == "{";
  leave_out(statement);
  if (leaves) {
    at_ = is_block ? closing(at_) + 1 : next(";") + 1;
  } else {
    const std::size_t end = closing(at_);
    ++at_;
    translate(end);
    ++at_;
  }
}

/// True at a struct with sizes among its arguments.
bool Translation::is_sized() const { return is("<", 1) && known_.sized.count(text(at_)) > 0; }

/// Structs that C hands on by pointers; the others are copied.
bool Translation::is_handed_on(const std::string& type) const {
  const auto sized = known_.sized.find(type);
  return type == "Boundary" || type == "Branch" || (sized != known_.sized.end() && !sized->second.empty());
}

/// Place behind a type and its arguments.
std::size_t Translation::behind_arguments() const {
  std::size_t at = at_ + 1;
  if (text(at) != "<") return at;
  for (int depth = 0; at < in_.size(); ++at) {
    depth += text(at) == "<" ? 1 : text(at) == ">" ? -1 : 0;
    if (depth == 0) return at + 1;
  }
  fail("the arguments of a template have no end");
}

/// Puts the sizes among a type's arguments, which end in front of a place.
void Translation::put_arguments(std::size_t behind) {
  std::size_t at = at_ + 2;
  if (text(at) == "Scalar") at += 2;
  if (!is("<", 1) || at >= behind) return;
  put("<");
  for (; at < behind; ++at) put(in_[at]);
}

void Translation::type() {
  const std::string cpp = text(at_);
  const std::string c = cpp == "Scalar" ? "double" : cpp == "Mask" ? "bool" : cpp;
  const bool is_number = c == "double" || c == "bool",
             is_constant = !out_.empty() && out_.back().text == "const";
  const std::size_t behind = behind_arguments();
  const std::string after = text(behind);
  if (after == "(" && is_number) {
    leave_out(behind);
    return whole_number();
  }
  if (!in_[at_].comment.empty()) comment_ = in_[at_].comment;
  if (after == "{") {
    put("(");
    put(c, Kind::name);
    put(")");
    at_ = behind;
    return;
  }
  put(c, Kind::name);
  put_arguments(behind);
  at_ = behind;
  if (after == "&" && is_constant && !is_handed_on(c)) ++at_;
  if (is("&") || !in_body_ || in_[at_].kind != Kind::name) return;
  if (!is("(", 1) && !is("{", 1)) return;
  put(in_[at_++]);
  put("=");
}

/// Puts 2.0 for the brackets of `Scalar(2)`.
void Translation::whole_number() {
  const std::size_t sign = is("-", 1) ? 1 : 0;
  const Token& number = in_[at_ + 1 + sign];
  const bool is_whole =
      number.kind == Kind::number && number.text.find_first_not_of("0123456789") == std::string::npos;
  if (!is_whole || !is(")", 2 + sign)) return;
  put("(");
  if (sign != 0) put("-");
  put(number.text + ".0", Kind::number);
  put(")");
  at_ += 3 + sign;
}

void Translation::named() {
  const std::string name = text(at_);
  if (name == "auto") {
    put("int", Kind::name);
    ++at_;
  } else if ((name == "digits" || name == "range") && in_[at_ + 2].kind == Kind::number) {
    put(name + "(" + text(at_ + 2) + ")", Kind::number);
    at_ += 4;
  } else if ((name == "epsilon" || name == "not_a_number") && is("<", 1)) {
    put(name == "epsilon" ? "DBL_EPSILON" : "NAN", Kind::name);
    at_ += 6;
  } else if (name == "any" && is("(", 1)) {
    leave_out(at_ + 1);
  } else if (is("<", 1) && is("Scalar", 2) && (is(">", 3) || is(",", 3))) {
    with_arguments(name);
  } else {
    Token token = in_[at_++];
    if (is("(")) token.text = name_in_c(name);
    put(token);
    if (is("(") && known_.flagged.count(name) > 0) put_flag("false");
  }
}

void Translation::put_flag(const std::string& value) {
  put(in_[at_++]);
  put(value, Kind::name);
  put(",");
}

/// `name<Scalar, flag>(`, or pi<Scalar>(), which is a constant.
void Translation::with_arguments(const std::string& name) {
  put(name_in_c(name), Kind::name);
  at_ += 3;
  if (name == "pi") {
    at_ += 3;
    return;
  }
  std::string flag = known_.flagged.count(name) > 0 ? "false" : "";
  if (is(",")) {
    flag = text(at_ + 1);
    at_ += 2;
  }
  ++at_;
  if (!flag.empty()) put_flag(flag);
}

}  // namespace qvgen::emit::blocks::runtime
