// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace qvgen::description {

/// The candidate nearest to the name by edit distance, or empty if none is near enough to be meant.
std::string nearest(std::string_view name, const std::vector<std::string>& candidates);

/// Problem that keeps a name from becoming an identifier of the generated code; empty message: none.
struct NameProblem {
  std::string message;
  std::string hint;
};
/// The most letters that a name may have.
inline constexpr std::size_t longest_name = 64;
NameProblem check_identifier(std::string_view name);
/// Robots' names are namespaces and file names: identifiers in lower case.
NameProblem check_robot_name(std::string_view name);

}  // namespace qvgen::description
