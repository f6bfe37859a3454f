// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace qvgen::test {

/// An arm for which nothing was derived, and why.
struct Unsolved {
  std::string name;
  std::string description;  ///< path
  std::string reasons;
};

inline std::vector<Unsolved>& unsolved() {
  static std::vector<Unsolved> all;
  return all;
}

inline bool add_unsolved(Unsolved arm) {
  unsolved().push_back(std::move(arm));
  return true;
}

/// Names of the arms that the test is of, solved or not; defined beside them.
std::vector<std::string> written_arms();

}  // namespace qvgen::test
