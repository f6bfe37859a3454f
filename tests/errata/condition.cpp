// SPDX-License-Identifier: MIT
#include "condition.h"

#include <algorithm>
#include <functional>

namespace qvgen::test::sources {
namespace {

/// By solution: whether something holds.
using Truth = std::vector<bool>;

/// A value whose sign differs from solution to solution.
struct Signed {
  std::string name;
  Truth positive;
};

/// An expression that the transcription proposes.
bool is_expression(const std::string& name) { return name.find(' ') != std::string::npos; }

/// Ranks names by what people would look at first: a proposal, joints, the position, cosines, sines and the
/// rest.
int rank(const std::string& name) {
  if (is_expression(name)) return -1;
  if (name.rfind("theta", 0) == 0) return 0;
  if (name == "px" || name == "py" || name == "pz") return 1;
  return name.size() == 2 && (name[0] == 'c' || name[0] == 's') ? 2 : 3;
}

/// A quaternion and its opposite are one rotation: the sign of one component says nothing.
bool is_of_a_quaternion(const std::string& name) {
  return name == "w" || name == "a" || name == "b" || name == "c" || name.rfind("N4", 0) == 0;
}

std::vector<Signed> signs_of(const std::vector<Outcome>& outcomes) {
  std::vector<Signed> result;
  for (const auto& entry : *outcomes.front().values) {
    if (is_of_a_quaternion(entry.first)) continue;
    Signed one{entry.first, {}};
    for (const Outcome& outcome : outcomes) one.positive.push_back(outcome.values->at(entry.first) > 0);
    const bool always = std::count(one.positive.begin(), one.positive.end(), false) == 0;
    const bool never = std::count(one.positive.begin(), one.positive.end(), true) == 0;
    if (!always && !never) result.push_back(std::move(one));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Signed& a, const Signed& b) { return rank(a.name) < rank(b.name); });
  return result;
}

Truth combined(const Truth& a, const Truth& b, const std::function<bool(bool, bool)>& rule) {
  Truth result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = rule(a[i], b[i]);
  return result;
}

std::string by_one_sign(const std::string& text, const Truth& positive, const Truth& wanted) {
  if (positive == wanted) return text + " > 0";
  return combined(positive, wanted, std::equal_to<>()) == Truth(wanted.size(), false) ? text + " < 0" : "";
}

std::string by_two_signs(const Signed& a, const Signed& b, const Truth& wanted) {
  for (const bool first : {true, false})
    for (const bool second : {true, false}) {
      const auto both = [&](bool x, bool y) { return x == first && y == second; };
      if (combined(a.positive, b.positive, both) == wanted)
        return a.name + (first ? " > 0 and " : " < 0 and ") + b.name + (second ? " > 0" : " < 0");
    }
  return "";
}

/// The first text that is not empty, of all pairs.
std::string first_of_pairs(const std::vector<Signed>& all,
                           const std::function<std::string(const Signed&, const Signed&)>& text) {
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = i + 1; k < all.size(); ++k)
      if (const std::string found = text(all[i], all[k]); !found.empty()) return found;
  return "";
}

}  // namespace

bool is_of_joint(const std::string& name, const std::string& joint) {
  if (name == joint) return true;
  if (joint.rfind("theta", 0) != 0) return false;
  const std::string digit = joint.substr(5);
  for (const char* shorthand : {"c", "s", "hc", "hs"})
    if (name == shorthand + digit) return true;
  return false;
}

namespace {

std::string factor(const std::string& name) { return is_expression(name) ? "(" + name + ")" : name; }

std::string condition_by(const std::vector<Signed>& all, const Truth& wanted) {
  for (const Signed& one : all)
    if (const std::string found = by_one_sign(one.name, one.positive, wanted); !found.empty()) return found;
  const std::string product = first_of_pairs(all, [&](const Signed& a, const Signed& b) {
    return by_one_sign(factor(a.name) + "*" + factor(b.name),
                       combined(a.positive, b.positive, std::equal_to<>()), wanted);
  });
  if (!product.empty()) return product;
  return first_of_pairs(all, [&](const Signed& a, const Signed& b) { return by_two_signs(a, b, wanted); });
}

}  // namespace

std::string condition_of(const std::vector<Outcome>& outcomes, const std::string& own) {
  Truth wanted;
  for (const Outcome& outcome : outcomes) wanted.push_back(outcome.reached);
  const std::vector<Signed> all = signs_of(outcomes);
  std::vector<Signed> others;
  for (const Signed& one : all)
    if (!is_of_joint(one.name, own)) others.push_back(one);
  const std::string found = condition_by(others, wanted);
  return found.empty() ? condition_by(all, wanted) : found;
}

}  // namespace qvgen::test::sources
