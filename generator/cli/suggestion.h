// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace qvgen::cli {

/// Wrong arguments that CLI11 cannot see.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The message with the known name that may be meant, or all of them.
std::string with_suggestion(const std::string& message, const std::string& name,
                            const std::vector<std::string>& known);

/// Throws a UsageError for the first of the names that is not known: "MESSAGE 'name'; did you mean ...".
void check_names(const std::string& message, const std::vector<std::string>& names,
                 const std::vector<std::string>& known);

}  // namespace qvgen::cli
