// SPDX-License-Identifier: MIT
#include "emit/math/mathml.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>

namespace qvgen::emit {
namespace {

std::string element(const char* name, const std::string& content) {
  return std::string("<") + name + ">" + content + "</" + name + ">";
}

std::string fence(const char* bracket) { return std::string("<mo stretchy=\"false\">") + bracket + "</mo>"; }

/// An upright word; several letters are one name.
std::string name(const std::string& letters) { return element("mi", letters); }

/// numerator/denominator as a decimal number where that is short; nothing for others, and for 1/2 and the
/// like.
std::string short_decimal(const std::string& numerator, const std::string& denominator) {
  constexpr std::size_t most_digits = 12;
  if (denominator.size() < 2 || denominator.size() > most_digits || numerator.size() > most_digits) return "";
  if ((numerator + denominator).find_first_not_of("0123456789") != std::string::npos) return "";
  const long long rest = std::stoll(denominator);
  long long value = std::stoll(numerator);
  std::size_t decimals = 0;
  for (; value % rest != 0 && decimals < 6; ++decimals) value *= 10;
  if (value % rest != 0) return "";
  std::string digits = std::to_string(value / rest);
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  return digits.insert(digits.size() - decimals, ".");
}

/// Spaces at the ends of an element are dropped where it is shown, unless they do not break.
std::string with_lasting_spaces(std::string text) {
  if (!text.empty() && text.back() == ' ') text.replace(text.size() - 1, 1, "&#xA0;");
  if (!text.empty() && text.front() == ' ') text.replace(0, 1, "&#xA0;");
  return text;
}

/// A piece of a row, and what decides on the space around it.
struct Atom {
  enum class Kind { value, function, sign } kind = Kind::value;
  std::string text;
};

class Parser {
 public:
  explicit Parser(const std::string& latex) : latex_(latex) {}

  std::string row() {
    std::string result;
    Atom::Kind before = Atom::Kind::sign;
    while (true) {
      const bool spaced = skip_spaces();
      if (at_end() || peek() == '}') return result;
      const Atom atom = with_scripts(next_atom());
      const bool product = before == Atom::Kind::value && atom.kind != Atom::Kind::sign;
      if (spaced && product) result += "<mspace width=\"0.2em\"></mspace>";
      if (before == Atom::Kind::function && atom.kind != Atom::Kind::sign)
        result += "<mo>&#x2061;</mo><mspace width=\"0.15em\"></mspace>";
      result += atom.text;
      before = atom.kind;
    }
  }

  [[nodiscard]] bool at_end() const { return place_ >= latex_.size(); }

 private:
  [[nodiscard]] char peek() const { return latex_[place_]; }
  char take() { return latex_[place_++]; }

  bool skip_spaces() {
    const std::size_t start = place_;
    while (!at_end() && peek() == ' ') ++place_;
    return place_ > start;
  }

  /// Reads the text between braces, unchanged.
  std::string braced() {
    if (at_end() || take() != '{') throw std::invalid_argument("LaTeX without a brace: " + latex_);
    const std::size_t end = latex_.find('}', place_);
    if (end == std::string::npos) throw std::invalid_argument("LaTeX with an open brace: " + latex_);
    const std::string inside = latex_.substr(place_, end - place_);
    place_ = end + 1;
    return inside;
  }

  /// The next group or single sign as one element.
  std::string argument() {
    skip_spaces();
    if (at_end()) throw std::invalid_argument("LaTeX that ends too early: " + latex_);
    if (peek() != '{') {
      // \tfrac12: a digit is an argument of its own.
      if (std::isdigit(static_cast<unsigned char>(peek())) != 0) return element("mn", std::string(1, take()));
      return next_atom().text;
    }
    ++place_;
    const std::string inside = row();
    if (at_end()) throw std::invalid_argument("LaTeX with an open brace: " + latex_);
    ++place_;
    return element("mrow", inside);
  }

  Atom with_scripts(Atom atom) {
    std::string low;
    std::string high;
    while (!at_end() && (peek() == '_' || peek() == '^')) {
      const char kind = take();
      (kind == '_' ? low : high) = argument();
    }
    if (!low.empty() && !high.empty())
      atom.text = element("msubsup", atom.text + low + high);
    else if (!low.empty())
      atom.text = element("msub", atom.text + low);
    else if (!high.empty())
      atom.text = element("msup", atom.text + high);
    return atom;
  }

  std::string number() {
    const std::size_t start = place_;
    while (!at_end() && (std::isdigit(static_cast<unsigned char>(peek())) != 0 || peek() == '.')) ++place_;
    // 1e-07 as printf writes it
    if (place_ + 2 < latex_.size() && peek() == 'e' &&
        (latex_[place_ + 1] == '-' || latex_[place_ + 1] == '+')) {
      place_ += 2;
      while (!at_end() && std::isdigit(static_cast<unsigned char>(peek())) != 0) ++place_;
    }
    const std::string over = latex_.substr(start, place_ - start);
    if (at_end() || peek() != '/') return element("mn", over);
    // 1/2*\sqrt{3}: the coefficient as a fraction of its own
    const std::size_t end = std::min(latex_.find_first_not_of("0123456789", place_ + 1), latex_.size());
    if (end == place_ + 1) return element("mn", over);
    const std::string under = latex_.substr(place_ + 1, end - place_ - 1);
    place_ = end;
    const std::string decimal = short_decimal(over, under);
    return decimal.empty() ? element("mfrac", element("mn", over) + element("mn", under))
                           : element("mn", decimal);
  }

  Atom next_atom() {
    using Kind = Atom::Kind;
    const char letter = peek();
    if (letter == '\\') return command();
    if (letter == '{') return {Kind::value, argument()};
    if (std::isdigit(static_cast<unsigned char>(letter)) != 0) return {Kind::value, number()};
    ++place_;
    if (std::isalpha(static_cast<unsigned char>(letter)) != 0)
      return {Kind::value, name(std::string(1, letter))};
    static const std::map<char, std::string> signs{
        {'(', fence("(")},          {')', fence(")")},          {'[', fence("[")},
        {']', fence("]")},          {'-', "<mo>&#x2212;</mo>"}, {'\'', "<mo>&#x2032;</mo>"},
        {'*', "<mo>&#x22C5;</mo>"}, {'<', "<mo>&lt;</mo>"},     {'>', "<mo>&gt;</mo>"},
        {'|', fence("|")},          {':', "<mo>:</mo>"},        {'+', "<mo>+</mo>"},
        {'=', "<mo>=</mo>"},        {'/', "<mo>/</mo>"},        {',', "<mo>,</mo>"}};
    const auto known = signs.find(letter);
    if (known == signs.end())
      throw std::invalid_argument(std::string("no MathML for '") + letter + "' in " + latex_);
    const bool closes_or_opens = letter == '(' || letter == ')' || letter == '\'';
    return {closes_or_opens ? Kind::value : Kind::sign, known->second};
  }

  std::string command_name() {
    ++place_;
    std::string word;
    while (!at_end() && std::isalpha(static_cast<unsigned char>(peek())) != 0) word += take();
    return word.empty() ? std::string(1, take()) : word;
  }

  Atom command() {
    using Kind = Atom::Kind;
    const std::string word = command_name();
    static const std::map<std::string, std::string> letters{
        {"alpha", "&#x3B1;"},  {"beta", "&#x3B2;"}, {"gamma", "&#x3B3;"}, {"delta", "&#x3B4;"},
        {"theta", "&#x3B8;"},  {"phi", "&#x3D5;"},  {"psi", "&#x3C8;"},   {"omega", "&#x3C9;"},
        {"tau", "&#x3C4;"},    {"mu", "&#x3BC;"},   {"rho", "&#x3C1;"},   {"lambda", "&#x3BB;"},
        {"varphi", "&#x3C6;"}, {"pi", "&#x3C0;"}};
    static const std::map<std::string, std::string> signs{{"pm", "<mo>&#xB1;</mo>"},
                                                          {"le", "<mo>&#x2264;</mo>"},
                                                          {"cdot", "<mo>&#x22C5;</mo>"},
                                                          {"dots", "<mo>&#x2026;</mo>"},
                                                          {"langle", fence("&#x27E8;")},
                                                          {"rangle", fence("&#x27E9;")},
                                                          {",", "<mspace width=\"0.17em\"></mspace>"},
                                                          {" ", "<mspace width=\"0.4em\"></mspace>"}};
    if (const auto letter = letters.find(word); letter != letters.end())
      return {Kind::value, name(letter->second)};
    if (const auto sign = signs.find(word); sign != signs.end()) return {Kind::sign, sign->second};
    if (word == "sin" || word == "cos" || word == "arg") return {Kind::function, name(word)};
    if (word == "mathrm") return {Kind::value, name(braced())};
    if (word == "text") return {Kind::sign, element("mtext", with_lasting_spaces(braced()))};
    if (word == "bar")
      return {Kind::value, "<mover accent=\"true\">" + argument() + "<mo>&#xAF;</mo></mover>"};
    if (word == "dot")
      return {Kind::value, "<mover accent=\"true\">" + argument() + "<mo>&#x2D9;</mo></mover>"};
    if (word == "ddot")
      return {Kind::value, "<mover accent=\"true\">" + argument() + "<mo>&#xA8;</mo></mover>"};
    if (word == "sqrt") return {Kind::value, element("msqrt", argument())};
    if (word == "left" || word == "right") return next_atom();
    if (word == "frac" || word == "tfrac") {
      const std::size_t start = place_;
      if (peek() == '{') {
        const std::string over = braced();
        const std::string decimal = peek() == '{' ? short_decimal(over, braced()) : "";
        if (!decimal.empty()) return {Kind::value, element("mn", decimal)};
        place_ = start;
      }
      const std::string numerator = argument();
      return {Kind::value, element("mfrac", numerator + argument())};
    }
    throw std::invalid_argument("no MathML for \\" + word + " in " + latex_);
  }

  const std::string& latex_;
  std::size_t place_ = 0;
};

/// Signs that a reader sees, about.
std::size_t visible_length(const std::string& latex) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    if (latex[i] == '\\') {
      while (i + 1 < latex.size() && std::isalpha(static_cast<unsigned char>(latex[i + 1])) != 0) ++i;
      length += 2;
    } else if (std::string("{}_^ ").find(latex[i]) == std::string::npos) {
      ++length;
    }
  }
  return length;
}

constexpr std::size_t longest_line = 64;

/// A sum cut before signs that stand in no brackets.
std::vector<std::string> lines_of_sum(const std::string& latex) {
  std::vector<std::string> lines(1);
  int depth = 0;
  std::size_t start = 0;
  const auto add = [&](std::size_t end) {
    const std::string term = latex.substr(start, end - start);
    if (!lines.back().empty() && visible_length(lines.back() + term) > longest_line) lines.emplace_back();
    lines.back() += term;
    start = end;
  };
  for (std::size_t i = 0; i < latex.size(); ++i) {
    if (latex[i] == '(' || latex[i] == '{') ++depth;
    if (latex[i] == ')' || latex[i] == '}') --depth;
    const bool is_sign = latex.compare(i, 3, " + ") == 0 || latex.compare(i, 3, " - ") == 0;
    if (depth == 0 && i > 0 && is_sign) add(i);
  }
  add(latex.size());
  return lines;
}

std::string cell(const std::string& content) { return element("mtd", content); }

std::string table_row(const std::string& left, const std::string& sign, const std::string& right) {
  return element("mtr", cell(left) + cell(sign) + cell(right)) + "\n";
}

std::string in_math(const std::string& attributes, const std::string& content) {
  return "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"" + attributes + ">" + content + "</math>";
}

}  // namespace

std::string mathml(const std::string& latex) {
  Parser parser(latex);
  const std::string result = parser.row();
  if (!parser.at_end()) throw std::invalid_argument("LaTeX with a brace too many: " + latex);
  return result;
}

std::string inline_mathml(const std::string& latex) { return in_math("", mathml(latex)); }

std::string aligned_mathml(const std::vector<std::string>& formulas) {
  std::string rows;
  for (const std::string& formula : formulas) {
    const std::size_t equals = formula.find(" = ");
    const bool has_sides = equals != std::string::npos && equals > 0;
    const std::string right = has_sides ? formula.substr(equals + 3) : formula;
    std::string left = has_sides ? mathml(formula.substr(0, equals)) : "";
    std::string sign = has_sides ? "<mo>=</mo>" : "";
    for (const std::string& line : lines_of_sum(right)) {
      rows += table_row(left, sign, mathml(line));
      left.clear();
      sign.clear();
    }
  }
  return in_math(" display=\"block\"", "\n<mtable displaystyle=\"true\">\n" + rows + "</mtable>\n");
}

}  // namespace qvgen::emit
