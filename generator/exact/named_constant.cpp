// SPDX-License-Identifier: MIT
#include "exact/named_constant.h"

#include <sstream>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational_io.h>
#include <cln/real.h>

namespace qvgen::exact {
namespace {

constexpr unsigned long digits = 60;
const std::string number_prefix = "number(";
const std::string turn_prefix = "turn(";
const std::string angle_prefix = "angle(";

std::string text_of(const cln::cl_RA& value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Rounded to 60 decimals behind the first digit of the whole: a rational with a power of ten below.
cln::cl_RA rounded(const cln::cl_R& value) {
  const cln::cl_I unit = cln::expt_pos(cln::cl_I(10), digits);
  return cln::cl_RA(cln::round1(cln::rational(value) * unit)) / unit;
}

/// "0.8660254..." of a rational whose denominator divides 10^60.
std::string decimal(const cln::cl_RA& value) {
  const cln::cl_I unit = cln::expt_pos(cln::cl_I(10), digits);
  const cln::cl_I all = cln::numerator(cln::abs(value) * unit);
  std::string text = text_of(all);
  if (text.size() <= digits) text.insert(0, digits + 1 - text.size(), '0');
  text.insert(text.size() - digits, ".");
  return (cln::minusp(value) ? "-" : "") + text;
}

cln::cl_RA from_text(const std::string& text) {
  const bool negative = !text.empty() && text.front() == '-';
  const std::string size = negative ? text.substr(1) : text;
  cln::cl_RA value;
  if (const auto point = size.find('.'); point != std::string::npos) {
    const std::string all = size.substr(0, point) + size.substr(point + 1);
    value = cln::cl_RA(cln::cl_I(all.c_str())) /
            cln::expt_pos(cln::cl_I(10), static_cast<unsigned int>(size.size() - point - 1));
  } else if (const auto bar = size.find('/'); bar != std::string::npos) {
    value = cln::cl_RA(cln::cl_I(size.substr(0, bar).c_str())) / cln::cl_I(size.substr(bar + 1).c_str());
  } else {
    value = cln::cl_I(size.c_str());
  }
  return negative ? -value : value;
}

std::optional<std::string> inside(const std::string& name, const std::string& prefix) {
  if (name.compare(0, prefix.size(), prefix) != 0) return std::nullopt;
  const std::string text = name.substr(prefix.size(), name.size() - prefix.size() - 1);
  if (text.find_first_not_of("-0123456789./") != std::string::npos) return std::nullopt;
  return text;
}

cln::cl_R pi() { return cln::pi(cln::float_format(digits + 20)); }

}  // namespace

std::optional<cln::cl_RA> rational_near(const cln::cl_R& value) {
  static const cln::cl_I longest = cln::expt_pos(cln::cl_I(10), 24);
  const cln::cl_RA simplest = cln::rationalize(cln::cl_float(value, cln::float_format(digits + 15)));
  if (cln::abs(cln::numerator(simplest)) > longest || cln::denominator(simplest) > longest)
    return std::nullopt;
  return simplest;
}

std::string name_of_number(const cln::cl_R& value) { return number_prefix + decimal(rounded(value)) + ")"; }

std::string name_of_angle(const cln::cl_R& radians) {
  if (const auto turns = rational_near(radians / pi())) return turn_prefix + text_of(*turns) + ")";
  if (const auto whole = rational_near(radians)) return angle_prefix + text_of(*whole) + ")";
  return angle_prefix + decimal(rounded(radians)) + ")";
}

std::optional<cln::cl_RA> named_value(const std::string& name) {
  if (const auto number = inside(name, number_prefix)) return from_text(*number);
  if (const auto angle = inside(name, angle_prefix)) return from_text(*angle);
  if (const auto turns = inside(name, turn_prefix)) return rounded(from_text(*turns) * pi());
  return std::nullopt;
}

}  // namespace qvgen::exact
