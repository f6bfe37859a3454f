// SPDX-License-Identifier: MIT
#include <qvgen/inverse/elimination/solve.h>

#include "careful.h"
#include "goal.h"

namespace qvgen::inverse::elimination {
namespace {

const Pass& pass_for(InstructionSet wanted) {
  const auto serves = [wanted](const Pass* pass, InstructionSet set) {
    return wanted >= set && pass != nullptr && simd::machine_has(set);
  };
  if (serves(pass_for_avx512, InstructionSet::avx512)) return *pass_for_avx512;
  return serves(pass_for_avx2, InstructionSet::avx2) ? *pass_for_avx2 : *pass_for_all;
}

void append(const Pass& pass, const Chain& chain, int rows, const JointPairs* pairs, Found& found) {
  double q[Gathered::most_rows][joints];
  pass.put_out(chain, rows, pairs, q);
  for (int i = 0; i < rows; ++i) {
    Solution<joints>& row = found.append();
    row.q = Eigen::Map<const Eigen::Matrix<double, joints, 1>>(q[i]);
    row.branch = 0;
    row.continuum = false;
  }
}

void append(const Pass& pass, const Chain& chain, const Careful& careful, Found& found) {
  JointPairs pairs[most_solutions];
  for (int i = 0; i < careful.size(); ++i) pairs[i] = pairs_of(careful.row(i).values);
  append(pass, chain, careful.size(), pairs, found);
  for (int i = 0; i < careful.size(); ++i) found[i].continuum = careful.row(i).continuum;
}

/// In the order of their joints, which is the same at every call.
void number_rows(Found& found) {
  std::sort(found.begin(), found.end(), [](const Solution<joints>& a, const Solution<joints>& b) {
    return std::lexicographical_compare(a.q.data(), a.q.data() + joints, b.q.data(), b.q.data() + joints);
  });
  for (int i = 0; i < found.size(); ++i) found[i].branch = i;
}

}  // namespace

void solve(const Setup& setup, const Pose<double>& pose, double tolerance,
           const Preference<joints>& preference, Form form, Found& found) {
  const auto set = form == Form::scalar ? InstructionSet::baseline : InstructionSet::avx512;
  solve(setup, pose, tolerance, preference, set, found);
}

void solve(const Setup& setup, const Pose<double>& pose, double tolerance,
           const Preference<joints>& preference, InstructionSet set, Found& found) {
  found.clear();
  found.effort = {};
  if (!std::isfinite(setup.chain.size)) {
    found.status = Status::invalid;
    return;
  }
  if (reach_test(pose, setup.chain.reach, tolerance) != ReachTest::open) {
    found.status = status_beyond(pose);
    return;
  }
  if (setup.count == 0) {
    found.status = Status::incomplete;
    return;
  }
  const Pass& pass = pass_for(set);
  Gathered gathered;
  bool unsure = false;
  pass.eliminate(setup.chain, setup.eliminations[0], goal_of(setup.chain, pose), tolerance, gathered);
  if (is_settled(setup, pose, gathered)) {
    append(pass, setup.chain, gathered.rows, gathered.row, found);
  } else {
    Careful careful(setup, pose, tolerance, preference, pass);
    careful.run(gathered);
    append(pass, setup.chain, careful, found);
    found.effort = careful.effort();
    unsure = careful.is_unsure();
  }
  number_rows(found);
  found.conclude();
  if (!unsure) return;
  found.status = Status::incomplete;
  if (found.empty()) found.effort.used_up = true;
}

}  // namespace qvgen::inverse::elimination
