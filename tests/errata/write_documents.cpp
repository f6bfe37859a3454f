// SPDX-License-Identifier: MIT
// Writes printed_equations.md and printed_equations.tex into a folder.
#include <cstdio>
#include <fstream>
#include <string>

#include "document.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: qvgen_judge_sources FOLDER\n", stderr);
    return 2;
  }
  const std::vector<qvgen::test::sources::Part> parts = qvgen::test::sources::parts();
  const std::string folder = arguments[1];
  std::ofstream(folder + "/printed_equations.md") << markdown(parts);
  std::ofstream(folder + "/printed_equations.tex") << latex_document(parts);
  return 0;
}
