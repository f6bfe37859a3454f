// SPDX-License-Identifier: MIT
#include "emit/blocks/lexer.h"

#include <array>
#include <cctype>
#include <sstream>

namespace qvgen::emit::blocks {
namespace {

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

class Lexer {
 public:
  explicit Lexer(const File& file) : file_(file) {}

  std::vector<Token> run() {
    std::istringstream stream(file_.text);
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      if (!skips(trimmed(line))) read(line);
    }
    add(Token::Kind::end, "");
    return std::move(tokens_);
  }

 private:
  /// True for a line of the preprocessor, or one between `#ifdef __cplusplus` and its end.
  bool skips(const std::string& line) {
    if (line.rfind("#ifdef __cplusplus", 0) == 0) for_cplusplus_ = true;
    const bool ends = for_cplusplus_ && line.rfind("#endif", 0) == 0;
    const bool skipped = for_cplusplus_ || (!line.empty() && line[0] == '#');
    if (ends) for_cplusplus_ = false;
    return skipped;
  }

  void read(const std::string& line) {
    bool is_first = true;
    if (trimmed(line).empty()) comment_.clear();
    for (std::size_t at = 0; at < line.size();) {
      if (std::isspace(static_cast<unsigned char>(line[at])) != 0) {
        ++at;
      } else if (line.compare(at, 2, "//") == 0) {
        take_comment(line.substr(at), is_first);
        return;
      } else if (line.compare(at, 2, "/*") == 0) {
        at = line.find("*/", at);
        if (at == std::string::npos) throw error_at(file_, line_, "a comment in /* */ goes on over lines");
        at += 2;
      } else {
        at = read_token(line, at);
        is_first = false;
      }
    }
  }

  void take_comment(std::string text, bool is_first) {
    text.erase(0, text.find_first_not_of('/'));
    if (text.find_first_not_of('/') == std::string::npos) text.clear();
    if (!text.empty() && text[0] == ' ') text.erase(0, 1);
    const bool goes_on = is_first && text.rfind("< ", 0) == 0 && !tokens_.empty();
    if (goes_on)
      tokens_.back().behind += text.substr(1);
    else if (is_first)
      comment_.push_back(text);
    else
      tokens_.back().behind = text;
  }

  std::size_t read_token(const std::string& line, std::size_t at) {
    if (is_digit(line[at]) || (line[at] == '.' && at + 1 < line.size() && is_digit(line[at + 1])))
      return read_number(line, at);
    if (in_name(line[at])) return read_name(line, at);
    if (line[at] == '"') return read_text(line, at);
    return read_sign(line, at);
  }

  std::size_t read_number(const std::string& line, std::size_t at) {
    const bool hexadecimal = line.compare(at, 2, "0x") == 0;
    std::size_t end = at;
    const auto is_exponent = [&](char c) { return hexadecimal ? c == 'p' : c == 'e' || c == 'E'; };
    while (end < line.size() && (in_name(line[end]) || line[end] == '.' ||
                                 ((line[end] == '-' || line[end] == '+') && is_exponent(line[end - 1]))))
      ++end;
    add(Token::Kind::number, line.substr(at, end - at));
    return end;
  }

  std::size_t read_name(const std::string& line, std::size_t at) {
    std::size_t end = at;
    while (end < line.size() && in_name(line[end])) ++end;
    add(Token::Kind::name, line.substr(at, end - at));
    return end;
  }

  std::size_t read_text(const std::string& line, std::size_t at) {
    const std::size_t end = line.find('"', at + 1);
    if (end == std::string::npos) throw error_at(file_, line_, "a string goes on over lines");
    add(Token::Kind::text, line.substr(at, end + 1 - at));
    return end + 1;
  }

  std::size_t read_sign(const std::string& line, std::size_t at) {
    static constexpr std::array<const char*, 19> pairs{"->", "++", "--", "+=", "-=", "*=", "/=",
                                                       "|=", "&=", "==", "!=", "<=", ">=", "&&",
                                                       "||", "<<", ">>", "%=", "^="};
    for (const char* pair : pairs)
      if (line.compare(at, 2, pair) == 0) {
        add(Token::Kind::sign, pair);
        return at + 2;
      }
    if (std::string("+-*/%=<>!~&|^?:;,.()[]{}").find(line[at]) == std::string::npos)
      throw error_at(file_, line_, std::string("the character ") + line[at] + " has no place in C blocks");
    add(Token::Kind::sign, std::string(1, line[at]));
    return at + 1;
  }

  void add(Token::Kind kind, const std::string& text) {
    tokens_.push_back({kind, text, line_, std::move(comment_)});
    comment_.clear();
  }

  const File& file_;
  int line_ = 0;
  bool for_cplusplus_ = false;
  std::vector<std::string> comment_;
  std::vector<Token> tokens_;
};

}  // namespace

NotInSubset error_at(const File& file, int line, const std::string& what) {
  std::istringstream stream(file.text);
  std::string text;
  for (int i = 0; i < line; ++i) std::getline(stream, text);
  return NotInSubset(file.name + ":" + std::to_string(line) + ": " + what + ": " + trimmed(text));
}

std::vector<Token> tokens_of(const File& file) { return Lexer(file).run(); }

}  // namespace qvgen::emit::blocks
