// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <qvgen/inverse/branch.h>
#include <qvgen/inverse/elimination/setup.h>

#include "gathered.h"

namespace qvgen::inverse::elimination {
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

/// How often an elimination misses the joints that a pose comes from, how often it has doubts, and how many
/// stretches of the circle it magnifies: doubts take ten times as long.
struct Trial {
  int missing = 0;
  int doubtful = 0;
  int magnified = 0;
  [[nodiscard]] int score() const { return 80 * missing + 10 * doubtful + magnified; }
};

void try_at(const Chain& chain, const Elimination& e, const JointPairs& q, Trial& trial) {
  Gathered found;
  pass_for_all->eliminate(chain, e, reached(chain, q), default_tolerance, found);
  trial.missing += has_row(found, q) ? 0 : 1;
  trial.doubtful += found.doubtful || found.has_twins ? 1 : 0;
  trial.magnified += found.magnified;
}

Trial tried(const Chain& chain, const Elimination& e) {
  Trial trial;
  for (int i = 0; i < trials; ++i) try_at(chain, e, sampled_joints(chain, i), trial);
  return trial;
}

bool needs_derivatives(Pair pair) { return pair == Pair::repeats || pair == Pair::confuses; }

/// Neither without size nor with three slides.
bool is_eligible(const Chain& chain) {
  return chain.size > 0 && std::count(chain.slides, chain.slides + joints, true) <= 2;
}

}  // namespace

namespace {

/// An elimination of several arms: how often it misses joints, and its score.
struct Tried {
  Choice choice;
  int missing, score;
};

/// The eliminations that miss few joints, the best first. `serves(choice, i, one)`: adds what the i-th
/// arm says, false if it does not admit the choice. `poses`: how many are tried.
template <class Serves>
Choices best_of(int count, int poses, const Serves& serves) {
  Tried tried[Choices::most];
  int found = 0;
  for (const bool backwards : {false, true})
    for (int shift = 0; shift < 3; ++shift) {
      Tried& one = tried[found] = {{backwards, shift}, 0, 0};
      bool all = count > 0;
      for (int i = 0; i < count && all; ++i) all = serves(i, one);
      if (all && one.missing <= poses / 8) ++found;
    }
  std::stable_sort(tried, tried + found, [](const Tried& a, const Tried& b) { return a.score < b.score; });
  Choices choices;
  choices.count = found;
  choices.score = found > 0 ? tried[0].score : 0;
  for (int i = 0; i < found; ++i) choices.choice[i] = tried[i].choice;
  return choices;
}

bool is_set_up(const Chain& chain, const Choice& choice, Elimination& result) {
  return is_eligible(chain) && eliminate(chain, choice.backwards, choice.shift, result);
}

JointPairs pairs_at(const Chain& chain, const double* joint_values) {
  JointPairs q;
  for (int j = 0; j < joints; ++j) {
    q.cosine[j] = chain.slides[j] ? joint_values[j] : std::cos(joint_values[j]);
    q.sine[j] = chain.slides[j] ? 0 : std::sin(joint_values[j]);
  }
  return q;
}

}  // namespace

Choices choose(const Description* arms, int count) {
  return best_of(count, count * trials, [&](int i, Tried& one) {
    const Chain chain = chain_of(arms[i]);
    Elimination elimination;
    if (!is_set_up(chain, one.choice, elimination)) return false;
    const Trial trial = tried(chain, elimination);
    one.missing += trial.missing;
    one.score += trial.score() + (needs_derivatives(elimination.pair) ? 10 * trials / 4 : 0);
    return true;
  });
}

Choices choose(const Sample* samples, int count) {
  return best_of(count, count, [&](int i, Tried& one) {
    const Chain chain = chain_of(samples[i].arm);
    Elimination elimination;
    if (!is_set_up(chain, one.choice, elimination)) return false;
    Trial trial;
    try_at(chain, elimination, pairs_at(chain, samples[i].joints), trial);
    one.missing += trial.missing;
    one.score += trial.score() + (needs_derivatives(elimination.pair) ? 10 / 4 : 0);
    return true;
  });
}

namespace {

/// As many eliminations as are asked for.
Setup set_up(const Description& arm, const Choices& choices, int count) {
  Setup setup;
  setup.description = arm;
  setup.chain = chain_of(arm);
  if (!is_eligible(setup.chain)) return setup;
  int next = 0;
  for (; next < choices.count && setup.count < count; ++next) {
    const Choice& choice = choices.choice[next];
    if (eliminate(setup.chain, choice.backwards, choice.shift, setup.eliminations[setup.count]))
      ++setup.count;
  }
  for (; next < choices.count; ++next) setup.further.choice[setup.further.count++] = choices.choice[next];
  return setup;
}

}  // namespace

Setup set_up(const Description& arm) {
  Setup setup = set_up(arm, choose(&arm, 1), most_eliminations);
  setup.further.count = 0;
  return setup;
}

Setup set_up(const Description& arm, const Choices& choices) {
  return set_up(arm, choices, most_eliminations);
}

Setup set_up_first(const Description& arm, const Choices& choices) { return set_up(arm, choices, 1); }

}  // namespace qvgen::inverse::elimination
