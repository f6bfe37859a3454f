// SPDX-License-Identifier: MIT
#include "dag/counts.h"
#include "passes/pass.h"

namespace qvgen::passes {

const std::vector<Pass>& all_passes() {
  static const std::vector<Pass> passes{
      {"fold", fold}, {"flatten", flatten}, {"trig", trig}, {"factor", factor}, {"share", share}};
  return passes;
}

namespace {

int operations(const dag::Function& function) {
  const dag::OperationCounts counts = dag::count(function);
  return counts.multiplications + counts.additions + counts.divisions + counts.roots;
}

}  // namespace

dag::Function simplify(const dag::Function& function) {
  dag::Function best = fold(function);
  while (true) {
    dag::Function next = best;
    for (const Pass& pass : all_passes()) next = pass.run(next);
    if (operations(next) >= operations(best)) return best;
    best = std::move(next);
  }
}

}  // namespace qvgen::passes
