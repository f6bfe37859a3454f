// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

#include "configurations.h"
#include "transcription.h"

namespace qvgen::test::sources {

/// Judgement of an equation in which every name has its true value.
struct Judgement {
  enum class Kind {
    right,
    wrong,
    meaningless,  ///< such as the product of two vectors that is added to a number
    local,        ///< gives a name to what later equations use
    definition,
    excluded,
    words,   ///< words or numbers in print that are wrong; the transcription has the evidence
    inverse  ///< a joint's equation: judged at all solutions of a pose, elsewhere
  };
  Kind kind = Kind::right;
  std::vector<Tree> sides;
  std::vector<Tree> right;      ///< the sides as they should be; empty if right as printed
  std::string trouble;          ///< of one without meaning
  double error = 0;             ///< the largest difference of two sides
  double brackets_alone = 0;    ///< largest difference once the brackets are right and all else is as printed
  bool corrected = false;       ///< whether the right form is right
  std::set<std::string> slips;  ///< what tells the printed from the right form: "sign", "index", ...
  std::string counterexample;   ///< the first configuration's values, of numbers
};

/// In the order of the section's equations. Throws std::runtime_error for LaTeX that cannot be read, with the
/// equation's number.
std::vector<Judgement> judge(const Section& section);

/// Returns what tells two expressions apart: "sign", "index", "prime", "name", "half angle", "function",
/// "axis", "value", "bracket", "form".
std::set<std::string> differences(const std::vector<Tree>& printed, const std::vector<Tree>& right);

}  // namespace qvgen::test::sources
