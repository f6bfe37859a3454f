// SPDX-License-Identifier: MIT
#include "report/html.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "emit/builtin_templates.h"
#include "emit/math/mathml.h"
#include "emit/render.h"

namespace qvgen::report {

using nlohmann::json;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else if (letter == '>')
      result += "&gt;";
    else if (letter == '"')
      result += "&quot;";
    else
      result += letter;
  }
  return result;
}

std::string with_formulas(const std::string& sentence) {
  std::string result;
  std::size_t start = 0;
  bool formula = false;
  while (start <= sentence.size()) {
    const std::size_t end = std::min(sentence.find('$', start), sentence.size());
    std::string piece = sentence.substr(start, end - start);
    if (!formula)
      for (std::size_t at = piece.find("\\_"); at != std::string::npos; at = piece.find("\\_", at + 1))
        piece.erase(at, 1);
    result += formula ? emit::inline_mathml(piece) : escaped(piece);
    formula = !formula;
    start = end + 1;
  }
  return result;
}

std::string formulas_html(const std::vector<std::string>& lines) {
  return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Formulas\">" +
         emit::aligned_mathml(lines) + "</div>\n";
}

const std::string& asset(const std::string& name) {
  const auto& all = emit::builtin_templates();
  const auto place = all.find("report/" + name);
  if (place == all.end()) throw std::invalid_argument("no template report/" + name);
  return place->second;
}

Cell text_cell(const std::string& text) { return {escaped(text), false}; }

Cell number_cell(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (text == "-0") text = "0";
  if (text.front() == '-') text = "−" + text.substr(1);
  return {text, true};
}

Cell count_cell(int value) { return {std::to_string(value), true}; }

namespace {

json cells_of(const std::vector<Cell>& list) {
  json result = json::array();
  for (const Cell& cell : list)
    result.push_back({{"html", cell.html}, {"number", cell.number}, {"first", result.empty()}});
  return result;
}

}  // namespace

std::string html(const HtmlTable& table) {
  json rows = json::array();
  for (const auto& row : table.rows) rows.push_back({{"cells", cells_of(row)}});
  return emit::render("report/table.html", {{"caption", table.caption},
                                            {"sortable", !table.key.empty()},
                                            {"key", table.key},
                                            {"head", cells_of(table.head)},
                                            {"rows", rows}});
}

std::string typeset(const std::string& name) {
  static const std::map<std::string, std::string> greek{{"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"},
                                                        {"theta", "θ"}, {"phi", "φ"},  {"psi", "ψ"}};
  static constexpr std::array<const char*, 10> low{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  const std::size_t end = std::min(name.find_first_of("0123456789"), name.size());
  const std::string index = name.substr(end);
  if (index.find_first_not_of("0123456789") != std::string::npos) return name;
  const auto letter = greek.find(name.substr(0, end));
  std::string result = letter == greek.end() ? name.substr(0, end) : letter->second;
  for (const char digit : index) result += low.at(static_cast<std::size_t>(digit - '0'));
  return result;
}

std::size_t letters_in(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

std::string coordinate(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace qvgen::report
