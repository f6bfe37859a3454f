// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

#include "tree.h"

namespace qvgen::test::sources {
namespace {

using Kind = Tree::Kind;

/// A command with its backslash, a number, or one character.
std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    const auto extend = [&](auto belongs) {
      while (end < text.size() && belongs(static_cast<unsigned char>(text[end])) != 0) ++end;
    };
    if (text[at] == '\\') extend([](int c) { return std::isalpha(c); });
    if (std::isdigit(static_cast<unsigned char>(text[at])) != 0)
      extend([](int c) { return c == '.' || std::isdigit(c) != 0 ? 1 : 0; });
    const std::string token = text.substr(at, end - at);
    const bool escaped = token == "\\";  // the end of a row, or a space such as "\\,"
    if (escaped && end < text.size() && text[end] == '\\') tokens.emplace_back("\\\\");
    if (std::isspace(static_cast<unsigned char>(text[at])) == 0 && !escaped) tokens.push_back(token);
    at = end + (escaped ? 1 : 0);
  }
  tokens.emplace_back();
  return tokens;
}

Tree make(Kind kind, std::vector<Tree> parts, const std::string& text = {}) {
  Tree tree;
  tree.kind = kind;
  tree.text = text;
  tree.parts = std::move(parts);
  return tree;
}

Tree number(double value) {
  Tree tree;
  tree.value = value;
  return tree;
}

/// The joints of "4+6", "(6-4)", "3"; none if it is something else.
std::vector<int> joints_in(const std::string& subscript) {
  std::vector<int> joints;
  int sign = 1;
  for (const char c : subscript) {
    if (c == '+' || c == '-') {
      sign = c == '+' ? 1 : -1;
    } else if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
      joints.push_back(sign * (c - '0'));
    } else if (c != '(' && c != ')') {
      return {};
    }
  }
  return joints;
}

/// Returns an index of a general equation in brackets, as in omega[i+1].
std::string indexed(const std::string& subscript) {
  const std::size_t letter = subscript.rfind('i');
  const bool index =
      letter != std::string::npos && (letter + 1 == subscript.size() || subscript.substr(letter) == "i+1");
  return index ? subscript.substr(0, letter) + "[" + subscript.substr(letter) + "]" : subscript;
}

/// X and x are printed for one another in p_x, F_X and their like. An asterisk tells a name from another.
std::string name_of(const std::string& base, std::string subscript) {
  if (subscript == "*") return base + "_";
  const auto gone = [](char c) { return c == '(' || c == ')' || c == ',' || c == '\\'; };
  subscript.erase(std::remove_if(subscript.begin(), subscript.end(), gone), subscript.end());
  if (!subscript.empty() && std::string("XYZ").find(subscript[0]) != std::string::npos)
    subscript[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(subscript[0])));
  return base + indexed(subscript);
}

/// With numbers for i and i+1.
std::vector<std::string> with_index(const std::vector<std::string>& tokens, int index) {
  std::vector<std::string> result;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const bool next =
        tokens[at] == "i" && at + 2 < tokens.size() && tokens[at + 1] == "+" && tokens[at + 2] == "1";
    result.push_back(tokens[at] == "i" ? std::to_string(index + (next ? 1 : 0)) : tokens[at]);
    if (next) at += 2;
  }
  return result;
}

class Reader {
 public:
  Reader(std::vector<std::string> tokens, bool frames) : tokens_(std::move(tokens)), frames_(frames) {}

  std::vector<Tree> sides() {
    std::vector<Tree> result{sum()};
    while (take("=")) result.push_back(sum());
    if (!token().empty()) stop("the end");
    return result;
  }

 private:
  [[nodiscard]] const std::string& token(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
  bool take(const std::string& wanted) {
    if (token() != wanted) return false;
    ++at_;
    return true;
  }
  void expect(const std::string& wanted) {
    if (!take(wanted)) stop(wanted);
  }
  [[noreturn]] void stop(const std::string& wanted) const {
    std::string rest;
    for (std::size_t i = at_; i < std::min(at_ + 8, tokens_.size()); ++i) rest += tokens_[i] + " ";
    throw std::runtime_error("expected " + wanted + " before: " + rest);
  }

  Tree sum() {
    std::vector<Tree> terms;
    do {
      const std::string sign = token();
      const bool signed_term = sign == "+" || sign == "-" || sign == "\\pm" || sign == "\\mp";
      if (signed_term) ++at_;
      terms.push_back(term());
      if (sign == "-") terms.back() = make(Kind::negative, {terms.back()});
      if (sign != "\\pm" && sign != "\\mp") continue;
      terms.back() = make(Kind::either, {terms.back()});
      terms.back().value = sign == "\\pm" ? 1 : -1;
    } while (token() == "+" || token() == "-" || token() == "\\pm" || token() == "\\mp");
    return terms.size() == 1 ? terms[0] : make(Kind::sum, std::move(terms));
  }

  Tree term() {
    Tree left = inner_product();
    while (take("\\times")) left = make(Kind::cross, {left, inner_product()});
    return left;
  }

  Tree inner_product() {
    Tree left = product();
    while (take("\\cdot")) left = make(Kind::dot, {left, product()});
    return left;
  }

  Tree product() {
    std::vector<Tree> factors{factor()};
    while (true) {
      if (take("/")) {
        const Tree above = factors.back();
        factors.back() = make(Kind::quotient, {above, factor()});
      } else if (take("*") || starts_factor()) {
        factors.push_back(factor());
      } else {
        return factors.size() == 1 ? factors[0] : make(Kind::product, std::move(factors));
      }
    }
  }

  [[nodiscard]] bool starts_factor() const {
    static const std::array<const char*, 20> no{
        "",  "+", "-", "=",    ")",    "]",       ",",      "}",    "/",     "_",
        "*", "&", "|", "\\pm", "\\mp", "\\times", "\\cdot", "\\\\", "\\end", "\\rVert"};
    return token() != "\\rangle" && std::find(no.begin(), no.end(), token()) == no.end();
  }

  Tree factor() {
    Tree base = primary();
    while (take("^")) {
      const std::string exponent = raw();
      base = exponent == "T" ? make(Kind::function, {base}, "transpose")
                             : make(Kind::power, {base, number(std::stod(exponent))});
    }
    return base;
  }

  /// One token or what stands between braces, without spaces.
  std::string raw() {
    if (!take("{")) return tokens_[at_++];
    std::string text;
    for (int depth = 1; !token().empty(); ++at_) {
      depth += token() == "{" ? 1 : token() == "}" ? -1 : 0;
      if (depth == 0) break;
      if (token() != "{" && token() != "}" && token() != "_") text += token();
    }
    expect("}");
    return text;
  }

  std::vector<Tree> list(const std::string& end) {
    std::vector<Tree> items;
    do items.push_back(sum());
    while (take(","));
    expect(end);
    return items;
  }

  Tree braces() {
    expect("{");
    Tree inner = sum();
    expect("}");
    return inner;
  }

  Tree primary() {
    const Frames frames = leading_frames();
    const std::string first = token();
    if (first.empty()) stop("an expression");
    if (std::isdigit(static_cast<unsigned char>(first[0])) != 0) return number(std::stod(tokens_[at_++]));
    if (take("(")) return parentheses();
    if (take("[")) return make(Kind::bracket, list("]"));
    if (take("\\langle")) return make(Kind::vector, list("\\rangle"));
    if (take("\\frac")) return fraction();
    if (take("\\begin")) return matrix();
    if (take("\\sqrt")) return make(Kind::function, {braces()}, "sqrt");
    if (take("\\lVert")) return norm();
    if (first == "e" && token(1) == "^") return exponential();
    if (first == "{") return braces();
    if ((first == "R" || first == "T") && motion_follows()) return motion();
    if (first == "\\sin" || first == "\\cos" || first == "\\tan" || first == "\\det" ||
        first.rfind("\\arc", 0) == 0)
      return function();
    return named(frames);
  }

  /// The frames before a letter; neither if they are passed over.
  struct Frames {
    std::string above;
    std::string below;
  };
  Frames leading_frames() {
    Frames frames;
    if (token() == "{" && token(1) == "}") at_ += 2;
    while (token() == "^" || token() == "_") {
      std::string& place = token() == "^" ? frames.above : frames.below;
      ++at_;
      place = raw();
    }
    return frames_ ? frames : Frames();
  }

  Tree parentheses() {
    std::vector<Tree> items = list(")");
    if (items.size() > 2) stop("one or two between parentheses");
    return items.size() == 1 ? items[0] : make(Kind::pair, std::move(items));
  }

  Tree norm() {
    Tree inner = sum();
    expect("\\rVert");
    return make(Kind::function, {std::move(inner)}, "norm");
  }

  /// e^{[s_1]\theta_1}, the motion of screw 1 by its joint, or its inverse with a sign.
  Tree exponential() {
    at_ += 2;
    std::string text = raw();
    const bool inverted = text[0] == '-';
    if (inverted) text.erase(0, 1);
    const std::string number = text.substr(std::min<std::size_t>(2, text.size()), 1);
    if (text != "[s" + number + "]\\theta" + number) stop("an exponential such as e^{[s_1]\\theta_1}");
    const Tree motion = make(Kind::name, {}, "e" + number);
    return inverted ? make(Kind::power, {motion, sources::number(-1)}) : motion;
  }

  Tree fraction() {
    Tree above = braces();
    return make(Kind::quotient, {std::move(above), braces()});
  }

  Tree matrix() {
    const std::string kind = raw();
    Tree result = make(Kind::matrix, {});
    int rows = 0;
    do {
      do result.parts.push_back(sum());
      while (take("&"));
      ++rows;
    } while (take("\\\\"));
    expect("\\end");
    if (raw() != kind) stop("the end of " + kind);
    result.joints = {rows, static_cast<int>(result.parts.size()) / rows};
    return result;
  }

  /// R(z, ...) or T(-y, ...).
  [[nodiscard]] bool motion_follows() const {
    const std::size_t axis = token(2) == "-" ? 3 : 2;
    return token(1) == "(" && (token(axis) == "x" || token(axis) == "y" || token(axis) == "z") &&
           token(axis + 1) == ",";
  }

  Tree motion() {
    std::string text = tokens_[at_];
    at_ += 2;
    while (token() != "," && !token().empty()) text += tokens_[at_++];
    expect(",");
    return make(Kind::motion, list(")"), text);
  }

  Tree function() {
    std::string name = tokens_[at_++].substr(1);
    if (name.rfind("arc", 0) == 0) name = "a" + name.substr(3);
    if (name == "atan" && token() == "2" && token(1) == "(") {
      ++at_;
      name = "atan2";
    }
    return applied(name);
  }

  Tree applied(const std::string& name) {
    const bool squared = take("^");
    if (squared) expect("2");
    Tree result = take("(") ? make(Kind::function, list(")"), name) : make(Kind::function, {angle()}, name);
    for (Tree& part : result.parts) part = halved(part);
    return squared ? make(Kind::power, {std::move(result), number(2)}) : result;
  }

  /// Reads the angle of a sine without parentheses: a name, or a fraction of it.
  Tree angle() {
    Tree first = primary();
    if (first.kind != Kind::quotient) return first;
    return make(Kind::product, {std::move(first), primary()});
  }

  /// Half of an angle, however it is written.
  static Tree halved(const Tree& tree) {
    const bool half = tree.kind == Kind::product && plain_text(tree.parts[0]) == "1/2";
    const bool over_two = tree.kind == Kind::quotient && plain_text(tree.parts[1]) == "2";
    if (tree.parts.size() != 2 || !(half || over_two)) return tree;
    Tree angle = tree.parts[half ? 1 : 0];
    if (angle.kind != Kind::angle || angle.value != 1) return tree;
    angle.value = 0.5;
    return angle;
  }

  Tree named(const Frames& frames) {
    std::string accents;
    bool half = false;
    int braces = 0;
    while (token() == "\\bar" || token() == "\\dot" || token() == "\\ddot" || token() == "\\hat") {
      half = half || token() == "\\bar";
      accents += token() == "\\dot" ? "'" : token() == "\\ddot" ? "''" : "";
      ++at_;
      braces += take("{") ? 1 : 0;
    }
    std::string base = tokens_[at_++];
    if (base[0] == '\\') base.erase(0, 1);
    if (base.empty() || std::isalpha(static_cast<unsigned char>(base[0])) == 0) {
      --at_;
      stop("a name");
    }
    if (!half && (base == "s" || base == "c") && sine_follows()) return applied(base == "s" ? "sin" : "cos");
    std::string subscript = take("_") ? raw() : std::string();
    for (; braces > 0; --braces) expect("}");
    if (subscript.empty() && take("_")) subscript = raw();
    Tree tree = with_subscript(base, subscript, accents, half);
    while (take("'")) tree.text += "*";
    tree.text.insert(tree.kind == Kind::name ? base.size() : 0,
                     indexed(frames.above) + indexed(frames.below));
    tree.above = frames.above;
    tree.below = frames.below;
    return tree;
  }

  /// As in "s theta_2" and "c^2 theta_2".
  [[nodiscard]] bool sine_follows() const {
    const std::size_t ahead = token() == "^" && token(1) == "2" ? 2 : 0;
    return token(ahead) == "\\theta" || (token(ahead) == "\\bar" && token(ahead + 2) == "\\theta");
  }

  static Tree with_subscript(const std::string& base, const std::string& subscript,
                             const std::string& accents, bool half) {
    Tree tree;
    tree.joints = base == "theta" && accents.empty() ? joints_in(subscript) : std::vector<int>();
    tree.kind = tree.joints.empty() ? Kind::name : Kind::angle;
    tree.value = half ? 0.5 : 1;
    if (tree.kind == Kind::name) tree.text = name_of((half ? "h" : "") + base, subscript) + accents;
    return tree;
  }

  std::vector<std::string> tokens_;
  bool frames_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Tree> read_latex(const std::string& text, const Notation& notation) {
  const std::vector<std::string> tokens = tokens_of(text);
  return Reader(notation.index ? with_index(tokens, *notation.index) : tokens, notation.frames).sides();
}

}  // namespace qvgen::test::sources
