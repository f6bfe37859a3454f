// SPDX-License-Identifier: MIT
#include "description/xml/decimals.h"

#include <algorithm>
#include <cctype>

#include "description/lexer.h"
#include "description/names.h"

namespace qvgen::description::xml {
namespace {

// Numbers of machines and people: nothing outside describes a robot.
constexpr int largest_exponent = 30;

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// 10^exponent times an integer of digits: how many of them stand behind the point.
int places_of(std::string_view literal) {
  const std::size_t e = literal.find_first_of("eE");
  const std::size_t point = literal.find('.');
  const int behind = point == std::string_view::npos
                         ? 0
                         : static_cast<int>((e == std::string_view::npos ? literal.size() : e) - point - 1);
  return e == std::string_view::npos ? behind : behind - std::stoi(std::string(literal.substr(e + 1)));
}

void report(Context& context, Place place, const std::string& word) {
  const std::string low = lower_case(word);
  const std::string bare =
      low.substr(low.find_first_not_of("+-") == std::string::npos ? 0 : low.find_first_not_of("+-"));
  if (bare.substr(0, 3) == "nan" || bare.substr(0, 3) == "inf")
    return context.error(place, "'" + word + "' is not finite", "write a finite number");
  if (word.find('$') != std::string::npos)
    return context.error(place, "'" + word + "' is to be filled in by xacro",
                         "install xacro, which is run then: pip install xacro");
  context.error(place, "'" + word + "' is no number", "write a decimal number such as 0.1 or 1e-3");
}

/// Removes the digits at the front and returns how many there were.
std::size_t skip_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(count);
  return count;
}

/// Removes the first character if it is one of these, and returns true if it was.
bool skip_one(std::string_view& text, std::string_view of) {
  if (text.empty() || of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// True if commas part thousands: in two places at least, or in front of a decimal point.
bool has_parted_thousands(std::string_view text) {
  skip_one(text, "-+");
  if (text.substr(0, 1) == "0") return false;
  const std::size_t first = skip_digits(text);
  std::size_t commas = 0;
  for (; skip_one(text, ","); ++commas)
    if (skip_digits(text) != 3) return false;
  if (first < 1 || first > 3 || commas == 0) return false;
  if (text.empty()) return commas > 1;
  if (!skip_one(text, ".")) return false;
  skip_digits(text);
  if (text.empty()) return true;
  if (!skip_one(text, "eE")) return false;
  skip_one(text, "-+");
  return skip_digits(text) > 0 && text.empty();
}

/// Returns a number without its commas where they can only part thousands (1,234.5 or 1,234,567) or numbers
/// (0.5,). A single comma between digits may be a decimal point as well.
std::optional<std::string> without_commas(const std::string& word) {
  constexpr std::size_t longest = 60;
  if (word.size() > longest || word.find(',') == std::string::npos) return std::nullopt;
  std::string bare = word;
  std::erase(bare, ',');
  const bool at_end = word.find(',') == word.size() - 1;
  return (at_end && !bare.empty()) || has_parted_thousands(word) ? std::optional(bare) : std::nullopt;
}

std::optional<Decimal> decimal(Context& context, const std::string& written, Place place) {
  const std::optional<std::string> bare = without_commas(written);
  if (bare) context.warning(place, "'" + written + "' is read as " + *bare, "write it without ','");
  const std::string word = bare.value_or(written);
  const bool negative = word.front() == '-';
  std::string digits = word.substr(negative || word.front() == '+' ? 1 : 0);
  if (!digits.empty() && digits.back() == '.') digits += '0';
  const std::size_t point = digits.find(".e");
  if (point != std::string::npos) digits.insert(point + 1, "0");
  try {
    const Lexer lexer(digits);
    const Token token = lexer.current();
    if (token.kind != Token::Kind::number || token.text.size() != digits.size()) {
      report(context, place, word);
      return std::nullopt;
    }
    const cln::cl_RA size = decimal_value(token);
    if (size > cln::expt(cln::cl_RA(10), largest_exponent)) {
      context.error(place, "'" + word + "' is beyond every robot",
                    "lengths are in metres, angles in radians");
      return std::nullopt;
    }
    return Decimal{negative ? -size : size, places_of(digits), 1, place, word};
  } catch (const ExpressionError& error) {
    if (error.message.find("exponent") == std::string::npos &&
        error.message.find("digits") == std::string::npos)
      report(context, place, word);
    else
      context.error(place, error.message, error.hint);
    return std::nullopt;
  }
}

}  // namespace

std::optional<std::vector<Decimal>> read_decimals(Context& context, const Attribute& attribute) {
  std::vector<Decimal> numbers;
  bool good = true;
  const std::string& text = attribute.value;
  for (std::size_t i = 0; i < text.size();) {
    if (is_blank(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && !is_blank(text[end])) ++end;
    Place place = attribute.place;
    place.column += static_cast<int>(i);
    if (const auto number = decimal(context, text.substr(i, end - i), place))
      numbers.push_back(*number);
    else
      good = false;
    i = end;
  }
  if (!good) return std::nullopt;
  return numbers;
}

std::optional<std::vector<Decimal>> read_decimals(Context& context, const Element& element,
                                                  const std::string& key, std::size_t count) {
  const Attribute* attribute = element.attribute(key);
  if (attribute == nullptr) return std::nullopt;
  auto numbers = read_decimals(context, *attribute);
  if (!numbers || numbers->size() == count) return numbers;
  context.error(attribute->place,
                "'" + key + "' of <" + element.name + "> has " + std::to_string(numbers->size()) +
                    (numbers->size() == 1 ? " number" : " numbers"),
                "write " + std::to_string(count) + (count == 1 ? " number" : " numbers apart by blanks"));
  return std::nullopt;
}

Decimal read_decimal(Context& context, const Element& element, const std::string& key,
                     const cln::cl_RA& otherwise) {
  const auto numbers = read_decimals(context, element, key, 1);
  return numbers ? numbers->front() : Decimal{otherwise, 0, 1, element.place, ""};
}

void warn_of_others(Context& context, const Element& element, const std::vector<std::string>& known) {
  for (const Attribute& attribute : element.attributes) {
    if (std::find(known.begin(), known.end(), attribute.name) != known.end()) continue;
    const std::string near = nearest(attribute.name, known);
    if (near.empty()) continue;  // of another program, with a name of its own
    context.warning(attribute.place, "nobody reads '" + attribute.name + "' of <" + element.name + ">",
                    "did you mean '" + near + "'?");
  }
}

}  // namespace qvgen::description::xml
