// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <qvgen/inverse/general/setup.h>
#include <qvgen/inverse/scalar.h>

#include "gathered.h"

namespace qvgen::inverse::general {
namespace {

constexpr int trials = 64;

/// Joint values spread over the circle, slides over the arm's size: fractional parts of multiples of square
/// roots.
JointPairs sampled_joints(const Chain& chain, int number) {
  constexpr double roots[joints] = {1.4142135623730951, 1.7320508075688772, 2.23606797749979,
                                    2.6457513110645906, 3.3166247903554,    3.605551275463989};
  JointPairs q;
  for (int j = 0; j < joints; ++j) {
    const double multiple = (number + 1) * roots[j];
    const double share = 2 * (multiple - std::floor(multiple)) - 1;
    constexpr double half_turn = 3.14159265358979323846;
    q.cosine[j] = chain.slides[j] ? share * chain.size : std::cos(half_turn * share);
    q.sine[j] = chain.slides[j] ? 0 : std::sin(half_turn * share);
  }
  return q;
}

/// The pose, in the first axis's frame, that joint values lead to.
Goal reached(const Chain& chain, const JointPairs& q) {
  Goal goal{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
  for (int j = 0; j < joints; ++j)
    for (int i = 0; i < 3; ++i) {
      double* row = goal.rotation + 3 * i;
      double& p = goal.translation[i];
      const Motion& link = chain.links[j];
      if (chain.slides[j]) {
        p += q.cosine[j] * row[2];
      } else {
        const double x = row[0] * q.cosine[j] + row[1] * q.sine[j];
        row[1] = row[1] * q.cosine[j] - row[0] * q.sine[j];
        row[0] = x;
      }
      const double x = row[0], y = row[1], z = row[2];
      p += x * link.translation[0] + y * link.translation[1] + z * link.translation[2];
      for (int k = 0; k < 3; ++k)
        row[k] = x * link.rotation[k] + y * link.rotation[3 + k] + z * link.rotation[6 + k];
    }
  return goal;
}

bool has_row(const Gathered& found, const JointPairs& q) {
  for (int i = 0; i < found.rows; ++i) {
    double distance = 0;
    for (int j = 0; j < joints; ++j)
      distance += std::abs(found.row[i].cosine[j] - q.cosine[j]) + std::abs(found.row[i].sine[j] - q.sine[j]);
    if (distance < 1e-6) return true;
  }
  return false;
}

/// How often an elimination misses the joints that a pose comes from, and how often it has doubts.
struct Trial {
  int missing = 0;
  int doubtful = 0;
  [[nodiscard]] int score() const { return 8 * missing + doubtful; }
};

Trial tried(const Chain& chain, const Elimination& e) {
  Trial trial;
  for (int i = 0; i < trials; ++i) {
    const JointPairs q = sampled_joints(chain, i);
    Gathered found;
    pass_for_all(chain, e, reached(chain, q), default_tolerance, found);
    trial.missing += has_row(found, q) ? 0 : 1;
    trial.doubtful += found.doubtful ? 1 : 0;
  }
  return trial;
}

}  // namespace

Setup set_up(const Description& arm) {
  Setup setup;
  setup.description = arm;
  setup.chain = chain_of(arm);
  const auto& slides = setup.chain.slides;
  if (!(setup.chain.size > 0) || std::count(slides, slides + joints, true) > 1) return setup;
  struct Choice {
    Elimination elimination;
    int score;
  };
  Choice choices[6];
  int count = 0;
  for (const bool backwards : {false, true})
    for (int shift = 0; shift < 3; ++shift) {
      Choice& choice = choices[count];
      if (!eliminate(setup.chain, backwards, shift, choice.elimination)) continue;
      const Trial trial = tried(setup.chain, choice.elimination);
      choice.score = trial.score() + (choice.elimination.pair == Pair::skew ? 0 : trials / 4);
      if (trial.missing <= trials / 8) ++count;
    }
  std::stable_sort(choices, choices + count,
                   [](const Choice& a, const Choice& b) { return a.score < b.score; });
  setup.count = std::min(count, most_eliminations);
  for (int i = 0; i < setup.count; ++i) setup.eliminations[i] = choices[i].elimination;
  return setup;
}

}  // namespace qvgen::inverse::general
