// SPDX-License-Identifier: MIT
// A bracket that closes too early is one slip; a wrong sign beside it is another. To tell them apart the
// printed signs and factors are put into the brackets of the right form.
#include "brackets.h"

#include <stdexcept>

namespace qvgen::test::sources {
namespace {

using Kind = Tree::Kind;

bool has_sign(const Tree& tree) { return tree.kind == Kind::negative || tree.kind == Kind::either; }

char sign_of(const Tree& tree) {
  if (tree.kind == Kind::negative) return '-';
  return tree.value > 0 ? 'p' : 'm';
}

void add_tokens(const Tree& tree, std::vector<Token>& tokens) {
  if (has_sign(tree)) {
    tokens.push_back({sign_of(tree), nullptr});
    return add_tokens(tree.parts[0], tokens);
  }
  if (tree.kind != Kind::sum && tree.kind != Kind::product) {
    tokens.push_back({' ', &tree});
    return;
  }
  for (std::size_t i = 0; i < tree.parts.size(); ++i) {
    if (tree.kind == Kind::sum && i > 0 && !has_sign(tree.parts[i])) tokens.push_back({'+', nullptr});
    add_tokens(tree.parts[i], tokens);
  }
}

/// Takes the printed tokens one by one while it walks through the right form.
class Regrouping {
 public:
  explicit Regrouping(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  Tree tree(const Tree& right) {
    if (has_sign(right)) return with_sign(right.parts[0]);
    if (right.kind != Kind::sum && right.kind != Kind::product) return *next().leaf;
    Tree result = right;
    for (std::size_t i = 0; i < right.parts.size(); ++i) {
      const Tree& part = right.parts[i];
      const bool plus = right.kind == Kind::sum && i > 0 && !has_sign(part);
      result.parts[i] = plus ? with_sign(part) : tree(part);
    }
    return result;
  }

 private:
  Token next() {
    if (place_ >= tokens_.size()) throw std::logic_error("expressions that differ in more than brackets");
    return tokens_[place_++];
  }

  Tree with_sign(const Tree& term) {
    const char sign = next().sign;
    Tree inner = tree(term);
    if (sign == '+') return inner;
    Tree result;
    result.kind = sign == '-' ? Kind::negative : Kind::either;
    result.value = sign == 'm' ? -1 : 1;
    result.parts.push_back(std::move(inner));
    return result;
  }

  std::vector<Token> tokens_;
  std::size_t place_ = 0;
};

}  // namespace

std::vector<Token> tokens_of(const Tree& tree) {
  std::vector<Token> tokens;
  add_tokens(tree, tokens);
  return tokens;
}

bool same_without_brackets(const Tree& a, const Tree& b) {
  const std::vector<Token> first = tokens_of(a), second = tokens_of(b);
  if (first.size() != second.size()) return false;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if ((first[i].leaf == nullptr) != (second[i].leaf == nullptr)) return false;
    if (first[i].leaf != nullptr && first[i].leaf->kind != second[i].leaf->kind) return false;
  }
  return true;
}

Tree rebracketed(const Tree& printed, const Tree& right) {
  return Regrouping(tokens_of(printed)).tree(right);
}

}  // namespace qvgen::test::sources
