// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include "tree.h"

namespace qvgen::test::sources {
namespace {

using Kind = Tree::Kind;

/// How tightly what a tree's text shows is bound: a sum, a product, a power, a single thing.
int binding(const Tree& tree) {
  switch (tree.kind) {
    case Kind::sum:
    case Kind::negative:
    case Kind::either:
      return 0;
    case Kind::cross:
    case Kind::dot:
      return 1;
    case Kind::product:
    case Kind::quotient:
      return 2;
    case Kind::power:
      return 3;
    default:
      return 4;
  }
}

bool signed_term(const Tree& tree) { return tree.kind == Kind::negative || tree.kind == Kind::either; }

/// Parts of a writer that its notation decides; the rest is common.
class Writer {
 public:
  explicit Writer(bool latex) : latex_(latex) {}

  [[nodiscard]] std::string text(const Tree& tree) const {
    switch (tree.kind) {
      case Kind::number:
        return fmt::format("{:g}", tree.value);
      case Kind::name:
        return !latex_ ? tree.text : is_screw(tree) ? "e^{" + screw(tree.text) + "}" : framed(tree);
      case Kind::angle:
        return angle(tree);
      case Kind::function:
        return function(tree);
      case Kind::sum:
        return sum(tree);
      case Kind::product:
        return joined(tree, latex_ ? " \\, " : "*", 2);
      case Kind::quotient:
        return quotient(tree);
      case Kind::power:
        return power(tree);
      case Kind::negative:
      case Kind::either:
        return sign(tree) + within(tree.parts[0], 1);
      case Kind::cross:
        return joined(tree, latex_ ? " \\times " : " x ", 2);
      case Kind::dot:
        return joined(tree, latex_ ? " \\cdot " : " . ", 2);
      case Kind::vector:
        return latex_ ? listed(tree, "\\langle ", " \\rangle") : listed(tree, "<", ">");
      case Kind::bracket:
        return listed(tree, "[", "]");
      case Kind::pair:
        return listed(tree, "(", ")");
      case Kind::matrix:
        return matrix(tree);
      case Kind::motion:
        return fmt::format("{}({}, {})", tree.text[0], tree.text.substr(1), text(tree.parts[0]));
    }
    return {};
  }

 private:
  [[nodiscard]] std::string within(const Tree& tree, int least) const {
    return binding(tree) < least ? "(" + text(tree) + ")" : text(tree);
  }

  [[nodiscard]] std::string listed(const Tree& tree, const std::string& begin, const std::string& end) const {
    std::string result;
    for (const Tree& part : tree.parts) result += (result.empty() ? "" : ", ") + text(part);
    return begin + result + end;
  }

  /// Rows apart by semicolons, or as LaTeX has them.
  [[nodiscard]] std::string matrix(const Tree& tree) const {
    std::string result;
    for (std::size_t i = 0; i < tree.parts.size(); ++i) {
      const bool begins_row = i % static_cast<std::size_t>(tree.joints[1]) == 0;
      const std::string row = latex_ ? " \\\\ " : "; ";
      result += (i == 0 ? "" : begins_row ? row : latex_ ? " & " : ", ") + text(tree.parts[i]);
    }
    return latex_ ? "\\begin{bmatrix}" + result + "\\end{bmatrix}" : "[" + result + "]";
  }

  [[nodiscard]] std::string joined(const Tree& tree, const std::string& between, int least) const {
    std::string result;
    for (const Tree& part : tree.parts) result += (result.empty() ? "" : between) + within(part, least);
    return result;
  }

  [[nodiscard]] std::string sign(const Tree& tree) const {
    if (tree.kind == Kind::negative) return "-";
    if (latex_) return tree.value > 0 ? "\\pm " : "\\mp ";
    return tree.value > 0 ? "±" : "∓";
  }

  [[nodiscard]] std::string sum(const Tree& tree) const {
    std::string result = text(tree.parts[0]);
    for (std::size_t i = 1; i < tree.parts.size(); ++i) {
      const Tree& part = tree.parts[i];
      result +=
          signed_term(part) ? " " + sign(part) + " " + within(part.parts[0], 1) : " + " + within(part, 1);
    }
    return result;
  }

  [[nodiscard]] std::string quotient(const Tree& tree) const {
    if (latex_) return "\\frac{" + text(tree.parts[0]) + "}{" + text(tree.parts[1]) + "}";
    return within(tree.parts[0], 2) + "/" + within(tree.parts[1], 3);
  }

  /// The motion of a screw by its joint, "e1".
  static bool is_screw(const Tree& tree) {
    return tree.kind == Kind::name && tree.text.size() == 2 && tree.text[0] == 'e';
  }
  static std::string screw(const std::string& name) {
    return "[s_{" + name.substr(1) + "}]\\theta_{" + name.substr(1) + "}";
  }

  [[nodiscard]] std::string power(const Tree& tree) const {
    const std::string exponent = text(tree.parts[1]);
    const Tree& base = tree.parts[0];
    if (latex_ && is_screw(base)) return "e^{-" + screw(base.text) + "}";
    const bool bare = binding(base) == 4 && !(latex_ && base.kind == Kind::function);
    return (bare ? text(base) : "(" + text(base) + ")") + (latex_ ? "^{" + exponent + "}" : "^" + exponent);
  }

  static std::string terms(const Tree& angle, const std::string& name) {
    std::string result;
    for (const int joint : angle.joints)
      result += (joint < 0 ? "-" : result.empty() ? "" : "+") + name + std::to_string(std::abs(joint));
    return result;
  }

  [[nodiscard]] std::string angle(const Tree& tree) const {
    const bool half = tree.value == 0.5;
    if (latex_) return (half ? "\\bar{\\theta}_{" : "\\theta_{") + terms(tree, "") + "}";
    const std::string full = terms(tree, "theta");
    if (!half) return tree.joints.size() == 1 ? full : "(" + full + ")";
    return tree.joints.size() == 1 ? full + "/2" : "(" + full + ")/2";
  }

  [[nodiscard]] std::string function(const Tree& tree) const {
    const Tree& first = tree.parts[0];
    if (tree.text == "transpose") return within(first, 4) + (latex_ ? "^{T}" : "^T");
    if (tree.text == "norm" && latex_) return "\\lVert " + text(first) + " \\rVert";
    if (latex_) return latex_function(tree);
    if (first.kind != Kind::angle || (tree.text != "sin" && tree.text != "cos"))
      return listed(tree, tree.text + "(", ")");
    const std::string name = (first.value == 0.5 ? "h" : "") + tree.text.substr(0, 1);
    const std::string joints = terms(first, "");
    return first.joints.size() == 1 && first.joints[0] > 0 ? name + joints : name + "(" + joints + ")";
  }

  [[nodiscard]] std::string latex_function(const Tree& tree) const {
    if (tree.text == "sqrt") return "\\sqrt{" + text(tree.parts[0]) + "}";
    if (tree.text == "atan2") return listed(tree, "\\arctan 2(", ")");
    const std::string name = "\\" + (tree.text[0] == 'a' ? "arc" + tree.text.substr(1) : tree.text);
    return tree.parts[0].kind == Kind::angle ? name + " " + text(tree.parts[0])
                                             : listed(tree, name + "(", ")");
  }

  /// The frames stand in the name after its letters, here before them.
  static std::string framed(const Tree& tree) {
    if (tree.above.empty() && tree.below.empty()) return latex_name(tree.text);
    const std::size_t letters = tree.text.find_first_of("0123456789[");
    std::string bare = tree.text;
    const auto brackets = [](const std::string& frame) { return frame.find('i') == 0 ? 2U : 0U; };
    bare.erase(letters, tree.above.size() + tree.below.size() + brackets(tree.above) + brackets(tree.below));
    const std::string below = tree.below.empty() ? "" : "_{" + tree.below + "}";
    return "{}^{" + tree.above + "}" + below + latex_name(bare);
  }

  static bool greek(const std::string& name) {
    for (const char* letter : {"omega", "tau", "theta", "phi", "alpha", "beta", "gamma", "delta"})
      if (name.rfind(letter, 0) == 0) return true;
    return false;
  }

  /// "N41" is N_{41}, "omega1'" has a dot, "hs2" a bar, "q[i+1]" is q_{i+1}, "a_" is a_{*}, "u3*" has a
  /// prime.
  static std::string latex_name(const std::string& primed) {
    const std::string name = primed.substr(0, primed.find('*'));
    const std::string primes(primed.size() - name.size(), '\'');
    const std::size_t dots = name.find('\'');
    const std::string plain = name.substr(0, dots);
    const bool half = plain.size() > 1 && plain[0] == 'h' && std::strchr("scpq", plain[1]) != nullptr;
    const std::size_t length = greek(plain) ? std::min(plain.find_first_of("0123456789["), plain.size())
                               : half       ? 2
                                            : 1;
    std::string base = (greek(plain) ? "\\" : "") + plain.substr(half ? 1 : 0, half ? 1 : length);
    if (half) base = "\\bar{" + base + "}";
    if (dots != std::string::npos) base = (name.size() - dots == 2 ? "\\ddot{" : "\\dot{") + base + "}";
    std::string subscript = plain.substr(length);
    if (subscript == "_") subscript = "*";
    if (subscript.rfind("omega", 0) == 0) subscript.insert(0, "\\");
    subscript.erase(
        std::remove_if(subscript.begin(), subscript.end(), [](char c) { return c == '[' || c == ']'; }),
        subscript.end());
    return (subscript.empty() ? base : base + "_{" + subscript + "}") + primes;
  }

  bool latex_;
};

}  // namespace

std::string plain_text(const Tree& tree) { return Writer(false).text(tree); }

std::string latex(const Tree& tree) { return Writer(true).text(tree); }

}  // namespace qvgen::test::sources
