// SPDX-License-Identifier: MIT
#include "emit/blocks/reached.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <vector>

#include "emit/blocks/lexer.h"

namespace qvgen::emit::blocks {
namespace {

using Tokens = std::vector<Token>;
using Names = std::set<std::string>;

bool is(const Token& token, const char* text) { return token.text == text; }

/// A definition, or a declaration: its words, and its lines with the comment in front of it.
struct Definition {
  Tokens tokens = {};
  std::string text = {};

  [[nodiscard]] bool begins_with(const char* word) const { return is(tokens.front(), word); }
  [[nodiscard]] bool is_type() const { return begins_with("typedef") || begins_with("enum"); }
  /// The first of `(`, `=` and `[`: the name that a constant or a function has stands in front of it.
  [[nodiscard]] Tokens::const_iterator behind_name() const {
    return std::find_if(tokens.begin(), tokens.end(), [](const Token& token) {
      return is(token, "(") || is(token, "=") || is(token, "[") || is(token, ";");
    });
  }
  [[nodiscard]] bool is_function() const { return !is_type() && is(*behind_name(), "("); }
  /// Public functions, and constants that other files see.
  [[nodiscard]] bool is_public() const { return !is_type() && !begins_with("static"); }
};

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string text_of(const Tokens& tokens, const std::vector<std::string>& lines) {
  std::string text;
  const Token &first = tokens.front(), &last = tokens.back();
  for (int line = first.line - static_cast<int>(first.comment.size()); line <= last.line; ++line)
    if (const std::string& own = lines[static_cast<std::size_t>(line - 1)]; !own.empty()) text += own + "\n";
  return text;
}

/// Splits behind a semicolon, and behind a function's body.
std::vector<Definition> definitions_of(const File& file) {
  const std::vector<std::string> lines = split_lines(file.text);
  std::vector<Definition> result;
  Definition current;
  int depth = 0;
  bool in_body = false;
  for (const Token& token : tokens_of(file)) {
    if (token.kind == Token::Kind::end) break;
    if (current.tokens.empty() && token.kind != Token::Kind::name)
      throw error_at(file, token.line, "no definition begins so");
    if (depth == 0 && is(token, "{")) in_body = is(current.tokens.back(), ")");
    depth += is(token, "{") ? 1 : is(token, "}") ? -1 : 0;
    current.tokens.push_back(token);
    if (depth > 0 || !(is(token, ";") || (in_body && is(token, "}")))) continue;
    current.text = text_of(current.tokens, lines);
    result.push_back(std::move(current));
    current = {};
    in_body = false;
  }
  if (!current.tokens.empty()) throw error_at(file, current.tokens.front().line, "a definition has no end");
  return result;
}

/// Returns the names in a definition but members'; `calls`: only those in front of a bracket.
Names names_in(const Definition& definition, bool calls) {
  Names names;
  const Tokens& tokens = definition.tokens;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool is_member = i > 0 && (is(tokens[i - 1], ".") || is(tokens[i - 1], "->"));
    const bool is_call = i + 1 < tokens.size() && is(tokens[i + 1], "(");
    if (tokens[i].kind == Token::Kind::name && !is_member && (is_call || !calls))
      names.insert(tokens[i].text);
  }
  return names;
}

/// Returns the names that a definition defines.
Names defined(const Definition& definition) {
  const Tokens& tokens = definition.tokens;
  if (definition.begins_with("enum") || (definition.begins_with("typedef") && is(tokens[1], "enum")))
    return names_in(definition, false);
  if (definition.begins_with("typedef")) return {(tokens.end() - 2)->text};
  return {(definition.behind_name() - 1)->text};
}

/// Names that are needed, and those of them that are called.
struct Wanted {
  Names named, called;

  void add(const Definition& definition) {
    named.merge(names_in(definition, false));
    called.merge(names_in(definition, true));
  }
  [[nodiscard]] bool has(const Definition& definition) const {
    const Names& wanted = definition.is_function() ? called : named;
    const Names names = defined(definition);
    return std::any_of(names.begin(), names.end(), [&](const auto& name) { return wanted.count(name) > 0; });
  }
};

/// Returns the text of the definitions that public ones reach, in their order.
std::string text_of_reached(const std::vector<Definition>& all) {
  std::vector<bool> is_needed(all.size(), false);
  Wanted wanted;
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (is_needed[i] || !(all[i].is_public() || wanted.has(all[i]))) continue;
      is_needed[i] = grows = true;
      wanted.add(all[i]);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (is_needed[i]) text += (text.empty() ? "" : "\n") + all[i].text;
  return text;
}

}  // namespace

std::string reached(const std::string& source) {
  return text_of_reached(definitions_of({"blocks", "", false, source}));
}

std::string reached_by(const std::string& function, const std::string& source) {
  std::vector<Definition> all = definitions_of({"blocks", "", false, source});
  all.erase(std::remove_if(all.begin(), all.end(), [](const Definition& each) { return each.is_public(); }),
            all.end());
  for (Definition& each : definitions_of({"function", "", false, function})) all.push_back(std::move(each));
  return text_of_reached(all);
}

}  // namespace qvgen::emit::blocks
