// SPDX-License-Identifier: MIT
// own_linkage: both assemblies of a four-bar close its loop, and its point moves.
#include <qvgen/robots/four_bar/assembly.h>

int main() {
  namespace bar = qvgen::robots::four_bar;
  const auto found = bar::assemble(bar::Driven(0.8));
  if (found.size() != 2) return 1;
  for (const auto& row : found)
    if (bar::loop_gaps(row.q).norm() > 1e-14 || !(bar::jacobian_of_point(row.q).norm() > 0.01)) return 2;
  return 0;
}
