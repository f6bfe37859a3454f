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
      {{"c_assembly"}, "it is a C header for the C++ of assembly.h: --only c_assembly without --language"},
      {{"c_inverse"}, "it is a C header for the C++ solver: --only c_inverse without --language"},
      {{"inverse by elimination"}, "its solver is a part of the C++ runtime"}};
  return lacks;
}

/// Lacked by all but C.
const Lack made_of_c{{"linuxcnc"}, "it is made of C in double: --language c"};

/// Languages that are printed from C lack what C lacks, and what is made of C itself.
std::vector<Lack> lacks_of_translations() {
  std::vector<Lack> lacks = lacks_of_c();
  lacks.push_back(made_of_c);
  lacks.push_back({{"assembly"}, "assemblies are in C++, and in C (double): --language c"});
  return lacks;
}

}  // namespace

const std::vector<LanguageRow>& languages() {
  static const std::vector<LanguageRow> table{
      {Language::cxx,
       "cxx",
       "headers in include/, sources in source/",
       "float, double and more",
       {made_of_c}},
      {Language::c, "c", "C99 in c/, which needs libm alone",
       "double, the bits of C++ with libm's sines; or float (--scalar float)", lacks_of_c()},
      {Language::rust, "rust", "a crate in rust/, no_std with the feature libm, without unsafe",
       "f64, the bits of C; f32 (feature f32), those of C in float", lacks_of_translations()},
      {Language::javascript, "javascript",
       "an ES module in javascript/, with types for TypeScript; batches in WebAssembly",
       "number, the bits of C but for the sines of the engine", lacks_of_translations()},
      {Language::octave, "octave",
       "functions of Octave and MATLAB in octave/, over columns; all of them compiled (MEX)",
       "double, the bits of C", lacks_of_translations()},
      {Language::opencl, "opencl", "kernels in opencl/, a configuration a thread",
       "double, C's but for the device's sines; or float (--scalar float)", lacks_of_translations()},
      {Language::cuda, "cuda", "kernels in cuda/, a configuration a thread",
       "double, C's but for the device's sines; or float (--scalar float)", lacks_of_translations()}};
  return table;
}

const LanguageRow& row_of(Language language) {
  const auto& rows = languages();
  return *std::find_if(rows.begin(), rows.end(), [&](const LanguageRow& row) {
    return row.language == language || in_float(row.language) == language;
  });
}

std::string lack_of(const LanguageRow& row, const std::string& part) {
  for (const Lack& lack : row.lacks)
    if (std::find(lack.parts.begin(), lack.parts.end(), part) != lack.parts.end()) return lack.reason;
  return "";
}

}  // namespace qvgen::pipeline
