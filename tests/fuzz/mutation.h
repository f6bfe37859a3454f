// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <vector>

namespace qvgen::test {

/// A text of the corpus with a few slips: characters or lines deleted, doubled or exchanged, lines of another
/// text put in, numbers and words replaced by others that a description may have.
std::string mutated(const std::vector<std::string>& corpus, std::mt19937& random);

}  // namespace qvgen::test
