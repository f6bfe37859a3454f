// SPDX-License-Identifier: MIT
#include "description/names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <optional>

namespace qvgen::description {
namespace {

constexpr auto keywords = std::to_array<std::string_view>(
    {"alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
     "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
     "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
     "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
     "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
     "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
     "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
     "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
     "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
     "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
     "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
     "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
     "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
     "xor_eq"});

/// Names that generated code, or a header that it includes, gives a meaning of its own; words of C and of
/// compilers' dialects, and the macros of the standard headers that are not in capitals.
constexpr auto taken = std::to_array<std::string_view>({"BasicGeometry",
                                                        "BasicInertia",
                                                        "Eigen",
                                                        "Geometry",
                                                        "I",
                                                        "Inertia",
                                                        "JointVector",
                                                        "L_ctermid",
                                                        "P_tmpdir",
                                                        "L_cuserid",
                                                        "L_tmpnam",
                                                        "Pose",
                                                        "Scalar",
                                                        "Solutions",
                                                        "acos",
                                                        "asin",
                                                        "assert",
                                                        "atan",
                                                        "atan2",
                                                        "cos",
                                                        "deg",
                                                        "dof",
                                                        "e",
                                                        "errno",
                                                        "fmt",
                                                        "free",
                                                        "g",
                                                        "geometry",
                                                        "gravity",
                                                        "inertia",
                                                        "linux",
                                                        "links",
                                                        "math_errhandling",
                                                        "pi",
                                                        "q",
                                                        "qd",
                                                        "qdd",
                                                        "qvgen",
                                                        "rad",
                                                        "restrict",
                                                        "robots",
                                                        "sched_priority",
                                                        "sin",
                                                        "sincos",
                                                        "size_t",
                                                        "sqrt",
                                                        "std",
                                                        "stderr",
                                                        "stdin",
                                                        "stdout",
                                                        "tan",
                                                        "tau",
                                                        "typeof",
                                                        "typeof_unqual",
                                                        "unix"});

/// Robots' names are namespaces beside these.
constexpr auto taken_for_robots = std::to_array<std::string_view>({"detail", "inverse"});

/// Capitals are left to macros, but for a few with a number: L1, RL4. M_PIl and its like are not all
/// capitals.
bool looks_like_macro(std::string_view name) {
  const auto is_capital = [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; };
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  if (name.substr(0, 2) == "M_" || name.substr(0, 6) == "EIGEN_") return true;
  if (std::any_of(name.begin(), name.end(),
                  [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }))
    return false;
  const auto number = std::find_if_not(name.begin(), name.end(), is_capital);
  const bool has_number = std::all_of(number, name.end(), is_digit) && number != name.end();
  return name.size() > 1 && !(has_number && number - name.begin() <= 3);
}

bool is_word(std::string_view name) {
  const auto letter = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
         std::all_of(name.begin(), name.end(), letter);
}

std::string in_quotes(std::string_view name) { return "'" + std::string(name) + "'"; }

std::string lower_case(std::string_view name) {
  std::string result(name);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Levenshtein's distance, row by row; a change of case costs nothing but is no equality either.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string wanted = lower_case(name);
  std::string best;
  std::size_t best_distance = 2 * std::max<std::size_t>(1, wanted.size() / 2) + 1;
  for (const std::string& candidate : candidates) {
    const std::string known = lower_case(candidate);
    // The beginning of a name is as near as can be.
    const bool begins = wanted.size() > 1 && known.compare(0, wanted.size(), wanted) == 0;
    const std::size_t distance = begins && known != wanted ? 1 : 2 * edit_distance(wanted, known);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

NameProblem check_identifier(std::string_view name) {
  if (!is_word(name)) {
    return {in_quotes(name) + " is not a C++ name", "use letters, digits and '_', and begin with a letter"};
  }
  if (name.front() == '_' || name.find("__") != std::string_view::npos) {
    return {in_quotes(name) + " is reserved by C++", "do not begin with '_' and do not use '__'"};
  }
  if (name.size() > longest_name) {
    return {"the name " + in_quotes(std::string(name.substr(0, 16)) + "...") + " has " +
                std::to_string(name.size()) + " letters",
            "names have at most " + std::to_string(longest_name)};
  }
  if (looks_like_macro(name)) {
    return {in_quotes(name) + " may be a macro of C or C++",
            "names in capitals are theirs; write '" + lower_case(name) + "'"};
  }
  const auto is_name = [&](std::string_view other) { return name == other; };
  if (std::any_of(keywords.begin(), keywords.end(), is_name)) {
    return {in_quotes(name) + " is a C++ keyword", "choose another name, e.g. '" + std::string(name) + "1'"};
  }
  if (std::any_of(taken.begin(), taken.end(), is_name)) {
    return {in_quotes(name) + " has a meaning in the generated code",
            "choose another name, e.g. '" + std::string(name) + "1'"};
  }
  return {};
}

NameProblem check_robot_name(std::string_view name) {
  NameProblem problem = check_identifier(name);
  if (problem.message.empty() && lower_case(name) != name) {
    problem = {in_quotes(name) + " has capital letters", "write '" + lower_case(name) + "'"};
  }
  if (std::find(taken_for_robots.begin(), taken_for_robots.end(), name) != taken_for_robots.end()) {
    problem = {in_quotes(name) + " has a meaning in the generated code",
               "choose another name, e.g. '" + std::string(name) + "1'"};
  }
  return problem;
}

}  // namespace qvgen::description
