// SPDX-License-Identifier: MIT
// The fewest motions that cover a path, and where to change: against all chains that there are.
#include <gtest/gtest.h>
#include <qvgen/path/cover.h>

#include "arms.h"

namespace path_test {
namespace {

struct Invented {
  static constexpr std::size_t samples = 9;
  std::vector<double> q;
  std::vector<int> rows;
  std::vector<Track> tracks;
  std::vector<Motion> motions;
  Record<16> record;

  explicit Invented(std::mt19937& random)
      : q(samples * 16 * 6),
        rows(samples * 16, -1),
        tracks(16),
        record({q.data(), rows.data(), tracks.data(), 16, nullptr, 0}) {
    std::uniform_int_distribution<int> place(-2, static_cast<int>(samples) + 1);
    std::uniform_real_distribution<double> joint(-3, 3);
    const double end = samples - 1;
    for (int i = 0; i < 7; ++i) {
      int from = std::max(0, place(random)), to = std::min(static_cast<int>(end), place(random));
      if (from >= to) continue;
      Motion motion;
      motion.track = record.begin_track();
      motion.begin.s = from;
      motion.end.s = to;
      motions.push_back(motion);
      for (int s = from; s <= to; ++s) {
        Values values;
        for (int k = 0; k < 6; ++k) values[k] = joint(random);
        record.keep(static_cast<std::size_t>(s), static_cast<std::size_t>(motion.track), motion.track,
                    values);
      }
    }
  }

  [[nodiscard]] double way(std::size_t a, std::size_t b, std::size_t s) const {
    Values one, two;
    if (!record.at(s, motions[a].track, one) || !record.at(s, motions[b].track, two)) return 1e9;
    return (one - two).cwiseAbs().maxCoeff();
  }
};

struct Best {
  int count = 99;
  double way = 1e9;
};

/// Tries every change at every sample.
void search(const Invented& all, std::size_t motion, std::size_t s, int count, double way, Best& best) {
  if (count > best.count) return;
  if (all.motions[motion].end.s == Invented::samples - 1) {
    if (count < best.count || way < best.way) best = {count, way};
  }
  for (std::size_t next = 0; next < all.motions.size(); ++next)
    // In a chain of the fewest motions each ends later than the one before, which else could go on in its
    // place.
    for (std::size_t at = s; all.motions[next].end.s > all.motions[motion].end.s &&
                             static_cast<double>(at) <= all.motions[motion].end.s;
         ++at) {
      const double step = all.way(motion, next, at);
      if (step < 1e8) search(all, next, at, count + 1, way + step, best);
    }
}

TEST(PathCover, TheFewestMotionsAndTheShortestChanges) {
  std::mt19937 random(3);
  int covered = 0, changed = 0;
  for (int i = 0; i < 400; ++i) {
    const Invented all(random);
    Best best;
    for (std::size_t k = 0; k < all.motions.size(); ++k)
      if (all.motions[k].begin.s == 0) search(all, k, 0, 1, 0, best);
    std::vector<int> first(all.motions.size()), last(first);
    std::vector<Chain> one(first.size()), two(first.size());
    Cover<16> cover(all.record, all.motions.data(), all.motions.size(), Invented::samples,
                    {first.data(), last.data(), one.data(), two.data()});
    const Chain chain = cover.fewest();
    ASSERT_EQ(chain.count, best.count == 99 ? 0 : best.count);
    if (chain.count == 0) continue;
    ++covered;
    changed += static_cast<int>(chain.count > 1);
    EXPECT_NEAR(chain.way, best.way, 1e-12);
  }
  EXPECT_GT(covered, 50);
  EXPECT_GT(changed, 20);
}

}  // namespace
}  // namespace path_test
