// SPDX-License-Identifier: MIT
#include "pipeline/language.h"

#include <algorithm>

namespace qvgen::pipeline {
namespace {

const std::vector<Lack>& lacks_of_c() {
  static const std::vector<Lack> lacks{
      {{"arm_angle"}, "its solver is a part of the C++ runtime"},
      {{"batch", "from_ideal", "certified", "given_joint", "nearest_pose", "moveit_plugin"},
       "it is written in C++"},
      {{"c_inverse"}, "it is a C header for the C++ solver: --only c_inverse without --language"},
      {{"inverse by elimination"}, "its solver is a part of the C++ runtime"}};
  return lacks;
}

/// Languages that are printed from C lack what C lacks, and what is outside the subset that is read.
std::vector<Lack> lacks_of_translations() {
  std::vector<Lack> lacks = lacks_of_c();
  lacks.push_back(
      {{"metrics"}, "its C calls functions by pointers, which is outside the subset that is translated"});
  return lacks;
}

}  // namespace

const std::vector<LanguageRow>& languages() {
  static const std::vector<LanguageRow> table{
      {Language::cxx, "cxx", "headers in include/, sources in source/", "float, double and more", {}},
      {Language::c, "c", "C99 in c/, which needs libm alone",
       "double, the bits of C++ with libm's sines; or float (--scalar float)", lacks_of_c()},
      {Language::rust, "rust", "a crate in rust/, no_std with the feature libm, without unsafe",
       "f64, the bits of C", lacks_of_translations()},
      {Language::javascript, "javascript", "an ES module in javascript/, with types for TypeScript",
       "number, the bits of C but for the sines of the engine", lacks_of_translations()}};
  return table;
}

const LanguageRow& row_of(Language language) {
  const Language own = language == Language::c_in_float ? Language::c : language;
  const auto& rows = languages();
  return *std::find_if(rows.begin(), rows.end(), [&](const LanguageRow& row) { return row.language == own; });
}

std::string lack_of(const LanguageRow& row, const std::string& part) {
  for (const Lack& lack : row.lacks)
    if (std::find(lack.parts.begin(), lack.parts.end(), part) != lack.parts.end()) return lack.reason;
  return "";
}

}  // namespace qvgen::pipeline
