// SPDX-License-Identifier: MIT
#include "emit/blocks/runtime/words.h"

#include <algorithm>
#include <cctype>

namespace qvgen::emit::blocks::runtime {
namespace {

using Kind = Token::Kind;

bool is_capital(const std::string& name) { return std::isupper(static_cast<unsigned char>(name[0])) != 0; }

/// Structs that C hands on by pointers; the others are copied.
bool is_handed_on(const std::string& type) { return type == "Boundary" || type == "Branch"; }

/// Functions of C that C++ calls by other names.
std::string name_in_c(const std::string& name) {
  if (name == "abs" || name == "magnitude") return "fabs";
  return name == "angle" ? "angle_of" : name;
}

class Words {
 public:
  Words(const File& file, const std::function<bool(const std::string&)>& skipped, Known& known)
      : file_(file), skipped_(skipped), known_(known), in_(tokens_of(file)) {}

  Tokens run() {
    while (in_[at_].kind != Kind::end) {
      if (is("namespace"))
        at_ = next("{") + 1;
      else if (is("}"))
        ++at_;
      else
        definition();
    }
    comment_.clear();
    put(in_[at_]);
    return std::move(out_);
  }

 private:
  /// Text of a word, nothing behind the last.
  [[nodiscard]] const std::string& text(std::size_t at) const {
    return in_[std::min(at, in_.size() - 1)].text;
  }
  [[nodiscard]] bool is(const char* wanted, std::size_t ahead = 0) const {
    return text(at_ + ahead) == wanted;
  }
  [[noreturn]] void fail(const std::string& what) const { throw error_at(file_, in_[at_].line, what); }

  /// Place of the next such word.
  [[nodiscard]] std::size_t next(const std::string& wanted) const {
    for (std::size_t i = at_; i < in_.size(); ++i)
      if (text(i) == wanted) return i;
    fail("expected " + wanted);
  }
  /// Place of the bracket that closes the one here.
  [[nodiscard]] std::size_t closing(std::size_t from) const {
    int depth = 0;
    for (std::size_t i = from; i < in_.size(); ++i) {
      const std::string& word = text(i);
      depth += word == "(" || word == "{" || word == "["   ? 1
               : word == ")" || word == "}" || word == "]" ? -1
                                                           : 0;
      if (depth == 0) return i;
    }
    fail("a bracket is not closed");
  }

  void put(const Token& token) {
    out_.push_back(token);
    if (!comment_.empty()) out_.back().comment = std::move(comment_);
    comment_.clear();
  }
  void put(const std::string& word, Kind kind = Kind::sign) { put(Token{kind, word, in_[at_].line}); }
  void leave_out(std::size_t behind) {
    if (!in_[at_].comment.empty()) comment_ = in_[at_].comment;
    at_ = behind;
  }

  /// Place of the first of `(`, `=`, `{` and `;`: the name that is defined stands in front of it, that of a
  /// struct too.
  [[nodiscard]] std::size_t behind_name() const {
    std::size_t at = at_;
    for (; text(at) != "(" && text(at) != "=" && text(at) != "{" && text(at) != ";"; ++at)
      if (in_[at].kind == Kind::end) fail("a definition has no end");
    return at;
  }

  /// Place behind a definition.
  [[nodiscard]] std::size_t behind_definition(std::size_t behind_name) const {
    if (text(behind_name) == ";" || text(behind_name) == "=") return next(";") + 1;
    if (text(behind_name) == "{") return closing(behind_name) + 2;
    std::size_t at = closing(behind_name) + 1;
    while (text(at) != "{" && text(at) != ";" && in_[at].kind != Kind::end) ++at;
    return text(at) == "{" ? closing(at) + 1 : at + 1;
  }

  void definition() {
    comment_ = in_[at_].comment;
    flag_.clear();
    if (is("template")) template_head();
    const std::size_t name = behind_name() - 1, end = behind_definition(name + 1);
    const bool is_operator = text(name) == "operator" || text(name - 1) == "operator";
    if (is("using") || is_operator || skipped_(name_in_c(text(name)))) {
      at_ = end;
      comment_.clear();
    } else if (is("struct")) {
      structure(end);
    } else if (text(name + 1) == "(") {
      function(name, end);
    } else {
      put("static", Kind::name);
      put("const", Kind::name);
      translate(end);
    }
  }

  /// Reads `template <typename Scalar, bool flag = false>`.
  void template_head() {
    const std::size_t end = next(">");
    for (; at_ < end; ++at_)
      if (is("bool")) flag_ = text(at_ + 1);
    ++at_;
  }

  void structure(std::size_t end) {
    ++at_;
    const std::string name = text(at_);
    put("typedef", Kind::name);
    put("struct", Kind::name);
    put(name, Kind::name);
    put("{");
    at_ += 2;
    while (at_ + 2 < end) field(name);
    put("}");
    put(name, Kind::name);
    put(";");
    at_ = end;
  }

  /// A field, whose value in structs that say none is kept.
  void field(const std::string& structure) {
    const std::size_t end = next(";");
    std::size_t stop = at_;
    while (stop < end && text(stop) != "=" && text(stop) != "{") ++stop;
    if (text(stop) == "=") known_.defaults[structure].push_back({text(stop - 1), text(stop + 1)});
    translate(stop);
    at_ = end;
    put(in_[at_++]);
  }

  void function(std::size_t name, std::size_t end) {
    put("static", Kind::name);
    if (!flag_.empty()) known_.flagged.insert(text(name));
    translate(name);
    put(in_[at_++]);
    parameters();
    in_body_ = true;
    translate(end);
    in_body_ = false;
  }

  /// Parameters without their usual values; pi is a constant.
  void parameters() {
    const std::size_t end = closing(at_);
    put(in_[at_++]);
    const std::size_t before = out_.size();
    if (!flag_.empty()) {
      put("bool", Kind::name);
      put(flag_, Kind::name);
    }
    while (at_ < end) {
      std::size_t stop = at_, comma = at_;
      for (int depth = 0; comma < end && !(depth == 0 && text(comma) == ","); ++comma)
        depth += text(comma) == "<" ? 1 : text(comma) == ">" ? -1 : 0;
      while (stop < comma && text(stop) != "=") ++stop;
      if (text(stop - 1) != "pi") {
        if (out_.size() > before) put(",");
        translate(stop);
      }
      at_ = comma + (comma < end ? 1 : 0);
    }
    if (out_.size() == before) put("void", Kind::name);
    at_ = end;
    put(in_[at_++]);
  }

  void translate(std::size_t end) {
    while (at_ < end) word();
  }

  void word() {
    const Token& token = in_[at_];
    if (token.kind != Kind::name) {
      if (is("[") && is("[", 1)) return leave_out(closing(at_) + 1);
      put(token);
      ++at_;
      return;
    }
    if (is("using")) return leave_out(next(";") + 1);
    if (is("if") && is("constexpr", 1)) return known_condition();
    if (is("static_cast") || is("std") || is("inline") || is("constexpr")) return qualifier();
    if (is("Scalar") || (is_capital(token.text) && is("<", 1) && is("Scalar", 2))) return type();
    if (is("Boundary")) return type();
    named();
  }

  /// Words that C has no need of, and arrays.
  void qualifier() {
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
      for (const Token& size : sizes) {
        put("[");
        put(size);
        put("]");
      }
    }
  }

  /// Reads `array<T, size>`: puts T and gives the sizes, outer ones first.
  void array(Tokens& sizes) {
    at_ += 2;
    Tokens inner;
    if (is("std")) {
      at_ += 3;
      array(inner);
    } else {
      type();
    }
    sizes.push_back(in_[at_ + 1]);
    sizes.insert(sizes.end(), inner.begin(), inner.end());
    at_ += 3;
  }

  /// `if constexpr`: singular poses are never left, and flags are arguments.
  void known_condition() {
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

  void type() {
    const std::string cpp = text(at_);
    const std::string c = cpp == "Scalar" ? "double" : cpp == "Mask" ? "bool" : cpp;
    const bool is_number = c == "double" || c == "bool",
               is_constant = !out_.empty() && out_.back().text == "const";
    const std::size_t behind = at_ + (is("<", 1) ? 4 : 1);
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
    at_ = behind;
    if (after == "&" && is_constant && !is_handed_on(c)) ++at_;
    if (is("&") || !in_body_ || in_[at_].kind != Kind::name) return;
    if (!is("(", 1) && !is("{", 1)) return;
    put(in_[at_++]);
    put("=");
  }

  /// Puts 2.0 for the brackets of `Scalar(2)`.
  void whole_number() {
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

  void named() {
    const std::string name = text(at_);
    if (name == "auto") {
      put("int", Kind::name);
      ++at_;
    } else if ((name == "digits" || name == "range") && in_[at_ + 2].kind == Kind::number) {
      put(name + "(" + text(at_ + 2) + ")", Kind::number);
      at_ += 4;
    } else if (name == "epsilon" && is("<", 1)) {
      put("DBL_EPSILON", Kind::name);
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

  void put_flag(const std::string& value) {
    put(in_[at_++]);
    put(value, Kind::name);
    put(",");
  }

  /// `name<Scalar, flag>(`.
  void with_arguments(const std::string& name) {
    put(name_in_c(name), Kind::name);
    at_ += 3;
    std::string flag = known_.flagged.count(name) > 0 ? "false" : "";
    if (is(",")) {
      flag = text(at_ + 1);
      at_ += 2;
    }
    ++at_;
    if (!flag.empty()) put_flag(flag);
  }

  const File& file_;
  const std::function<bool(const std::string&)>& skipped_;
  Known& known_;
  Tokens in_, out_;
  std::size_t at_ = 0;
  std::vector<std::string> comment_;
  std::string flag_;
  bool in_body_ = false;
};

}  // namespace

Tokens words_of(const File& header, const std::function<bool(const std::string&)>& skipped, Known& known) {
  return Words(header, skipped, known).run();
}

}  // namespace qvgen::emit::blocks::runtime
