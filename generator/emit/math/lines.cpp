// SPDX-License-Identifier: MIT
#include "emit/math/lines.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace qvgen::emit {
namespace {

constexpr std::size_t text_width = 112;
/// A line of LaTeX's article has 345 pt, a letter of a formula some 5.5.
constexpr std::size_t latex_width = 58;

/// Half characters.
std::size_t width_of_command(const std::string& name) {
  if (name == "cos" || name == "sin") return 7;
  if (name == "quad" || name == "qquad" || name == "sqrt") return 4;
  if (name == "bar" || name == "ddot" || name == "dot" || name == "mathrm" || name == "tfrac" ||
      name == "left" || name == "right" || name == "text" || name == "frac")
    return 0;
  return 2;
}

/// One piece of LaTeX, and how wide it is in half characters.
struct Piece {
  std::size_t length;
  std::size_t width;
};

Piece latex_piece(const std::string& text, std::size_t at, bool small) {
  const char letter = text[at];
  if (letter == '\\') {
    std::size_t end = at + 1;
    while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
    if (end == at + 1) return {2, 1};
    return {end - at, width_of_command(text.substr(at + 1, end - at - 1))};
  }
  if (letter == '{' || letter == '}' || letter == ' ' || letter == '_' || letter == '^' || letter == '&')
    return {1, 0};
  if (letter == '+' || letter == '-' || letter == '=') return {1, small ? 2U : 5U};
  if (letter == '(' || letter == ')' || letter == ',' || letter == '.') return {1, 1};
  return {1, small ? 1U : 2U};
}

/// A place where a line may end: before a term.
struct Break {
  std::size_t at;
  int depth;
  std::size_t width;  ///< before it
};

/// All of a formula's, and behind them its end.
std::vector<Break> breaks(const std::string& text, bool latex) {
  std::vector<Break> all;
  int depth = 0;
  int braces = 0;
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char letter = text[i];
    if (letter == '(' || letter == '[') ++depth;
    if (letter == ')' || letter == ']') --depth;
    if (letter == '{') ++braces;
    if (letter == '}') --braces;
    const bool term = i > 0 && (text.compare(i, 3, " + ") == 0 || text.compare(i, 3, " - ") == 0);
    if (term && braces == 0) all.push_back({i, depth, latex ? width / 2 : width});
    const Piece piece = latex ? latex_piece(text, i, braces > 0) : Piece{1, 1};
    i += piece.length;
    width += piece.width;
  }
  all.push_back({text.size(), 0, latex ? width / 2 : width});
  return all;
}

/// The best place within a line: the last one of the outermost sum that does not leave most of it empty.
std::optional<std::size_t> best_break(const std::vector<Break>& all, std::size_t limit) {
  for (const std::size_t least : {limit / 3, std::size_t(1)})
    for (int depth = -8; depth < 8; ++depth)  // below 0: parentheses that an earlier line opened
      for (auto place = all.rbegin(); place != all.rend(); ++place)
        if (place->depth == depth && place->width <= limit && place->width >= least) return place->at;
  return std::nullopt;
}

}  // namespace

std::size_t width(const std::string& formula, Notation notation) {
  return breaks(formula, notation.typeset).back().width;
}

std::vector<std::string> broken(const std::string& formula, Notation notation, std::size_t used) {
  const bool latex = notation.typeset;
  const std::size_t whole = latex ? latex_width : text_width;
  std::vector<std::string> lines;
  std::string rest = formula;
  for (;;) {
    const std::size_t limit = whole - std::min(used, whole / 2);
    std::vector<Break> all = breaks(rest, latex);
    if (all.back().width <= limit) break;
    all.pop_back();
    auto at = best_break(all, limit);
    if (!at && !all.empty()) at = all.front().at;
    if (!at) break;
    lines.push_back(rest.substr(0, *at));
    rest = rest.substr(*at + 1);
    used = 4;
  }
  lines.push_back(rest);
  return lines;
}

std::vector<std::string> equation_lines(const std::string& left, const std::string& right,
                                        Notation notation) {
  const bool latex = notation.typeset;
  std::vector<std::string> lines = broken(right, notation, width(left, notation) + 3);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (latex)
      lines[i] = (i == 0 ? left + " &= "
                         : "&\\quad " + std::string(lines[i][0] == '-' || lines[i][0] == '+' ? "{}" : "")) +
                 lines[i] + " \\\\";
    else
      lines[i] = (i == 0 ? left + " = " : "    ") + lines[i];
  }
  return lines;
}

std::vector<std::string> formula_lines(const std::string& formula, Notation notation) {
  const std::size_t equals = formula.find(" = ");
  if (equals != std::string::npos)
    return equation_lines(formula.substr(0, equals), formula.substr(equals + 3), notation);
  return {notation.typeset ? "& " + formula + " \\\\" : formula};
}

std::string latex_words(const std::string& words) {
  std::string result;
  for (const char letter : words) {
    if (letter == '_' || letter == '&' || letter == '%' || letter == '#') result += '\\';
    result += letter == '^' ? std::string("\\^{}") : std::string(1, letter);
  }
  return result;
}

}  // namespace qvgen::emit
