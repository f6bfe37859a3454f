// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>

#include "brackets.h"
#include "verdict.h"

namespace qvgen::test::sources {
namespace {

using Kind = Tree::Kind;
using Names = std::set<std::string>;

void compare(const Tree& a, const Tree& b, Names& found);

void compare_parts(const Tree& a, const Tree& b, Names& found) {
  if (a.parts.size() != b.parts.size()) {
    found.insert("form");
    return;
  }
  for (std::size_t i = 0; i < a.parts.size(); ++i) compare(a.parts[i], b.parts[i], found);
}

bool same_up_to_signs(const std::vector<int>& a, const std::vector<int>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](int x, int y) { return std::abs(x) == std::abs(y); });
}

void compare_angles(const Tree& a, const Tree& b, Names& found) {
  if (a.value != b.value) found.insert("half angle");
  if (a.joints != b.joints) found.insert(same_up_to_signs(a.joints, b.joints) ? "sign" : "index");
}

std::string without_primes(const std::string& name) { return name.substr(0, name.find('*')); }

void compare_names(const std::string& a, const std::string& b, Names& found) {
  if (a == b) return;
  const bool primed = without_primes(a) == without_primes(b);
  found.insert(primed ? "prime" : a[0] == b[0] ? "index" : "name");
}

/// The three numbers of a direction.
bool direction(const Tree& tree) {
  return tree.kind == Kind::vector && std::all_of(tree.parts.begin(), tree.parts.end(), [](const Tree& part) {
           return (part.kind == Kind::negative ? part.parts[0] : part).kind == Kind::number;
         });
}

void compare(const Tree& a, const Tree& b, Names& found) {
  if ((a.kind == Kind::negative) != (b.kind == Kind::negative)) {
    found.insert("sign");
    return compare(a.kind == Kind::negative ? a.parts[0] : a, b.kind == Kind::negative ? b.parts[0] : b,
                   found);
  }
  if (direction(a) && direction(b)) {
    if (plain_text(a) != plain_text(b)) found.insert("axis");
    return;
  }
  if (a.kind != b.kind) {
    found.insert("form");
    return;
  }
  if (a.kind == Kind::angle) compare_angles(a, b, found);
  if (a.kind == Kind::number && a.value != b.value) found.insert("value");
  if (a.kind == Kind::name) compare_names(a.text, b.text, found);
  if (a.kind == Kind::function && a.text != b.text) found.insert("function");
  if (a.kind == Kind::motion && a.text != b.text) found.insert("axis");
  compare_parts(a, b, found);
}

/// Two expressions that differ in their brackets: "bracket", and what else tells them apart.
Names beside_brackets(const Tree& printed, const Tree& right) {
  Names found{"bracket"};
  const std::vector<Token> a = tokens_of(printed), b = tokens_of(right);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].leaf != nullptr) compare(*a[i].leaf, *b[i].leaf, found);
    if (a[i].sign != b[i].sign) found.insert("sign");
  }
  return found;
}

Names differences_of_sides(const Tree& printed, const Tree& right) {
  Names found;
  compare(printed, right, found);
  if (found.count("form") == 0 || !same_without_brackets(printed, right)) return found;
  Names beside = beside_brackets(printed, right);
  return beside.count("form") > 0 ? found : beside;
}

}  // namespace

std::set<std::string> differences(const std::vector<Tree>& printed, const std::vector<Tree>& right) {
  Names found;
  if (printed.size() != right.size()) found.insert("form");
  for (std::size_t i = 0; i < std::min(printed.size(), right.size()); ++i)
    found.merge(differences_of_sides(printed[i], right[i]));
  return found;
}

}  // namespace qvgen::test::sources
