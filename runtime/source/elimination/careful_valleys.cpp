// SPDX-License-Identifier: MIT
// Valleys of the miss next to continua: from whatever leads into one it is followed along its floor, so that
// all its solutions are found.
#include <algorithm>

#include "careful.h"
#include "valley.h"

namespace qvgen::inverse::elimination {
namespace {

/// Places this near, squared, are the same for a walk.
constexpr double same_place = 0.12 * 0.12;
/// A walk goes on so far, rad or share of the size: few valleys need more than two turns of two joints.
constexpr double longest_in_valley = 25;
/// Part of a closed walk that is left to be walked, on the other side of its beginning.
constexpr double beside_start = 0.2;
/// Largest distance between two solutions that nearly meet.
constexpr double beside_row = 0.05;

/// With more rows than these, away from continua, all strays that were remembered have sufficed.
constexpr int few_rows = 6;

/// Joints that add no more than this share are nearly idle.
constexpr double nearly_idle = 1e-3;

/// Places that walks have come by.
struct Explored {
  static constexpr int most_places = 800;
  int places = 0;
  Values place[most_places];

  [[nodiscard]] bool has(const Values& values) const {
    return std::any_of(place, place + places,
                       [&](const Values& each) { return distance_square(each, values) < same_place; });
  }
  void add(const Values& values) {
    if (places < most_places) place[places++] = values;
  }
};

}  // namespace

/// Walks along the valleys in which rows and strays are, if there is any; what is found on the way becomes a
/// row.
void Careful::search_valleys() {
  const ValleyWalk walk(task_, valleys_);
  Explored explored;
  const bool is_stray_alone = has_lonely_stray();
  const auto passes = [&](const ValleyWalk::Floor& floor) { explored.add(floor.values); };
  const auto leads = [&](const Values& values) { settle(pairs_of(values)); };
  const auto search = [&](const Values& start, double far) {
    ValleyWalk::Floor floor;
    if (!walk.begin(start, floor) || explored.has(floor.values)) return;
    passes(floor);
    const bool closes = walk.follow(floor, 1, far, passes, leads);
    walk.follow(floor, -1, closes ? beside_start : far, passes, leads);
  };
  const int rows = size_, strays = stray_count_;
  for (int k = 0; k < rows; ++k) {
    const double far = rows_[k].continuum ? 0 : is_stray_alone ? longest_in_valley : way_to_search(rows_[k]);
    if (far > 0) search(Values(rows_[k].values), far);
  }
  for (int k = 0; k < strays && is_stray_alone; ++k) search(Values(stray_[k]), longest_in_valley);
  for (int k = 0; k < stray_count_; ++k) is_searched_[k] = explored.has(stray_[k]);
  merge();
  // There may be more valleys than strays are remembered.
  lacks_strays_ =
      is_stray_alone && stray_count_ == most_strays && size_ <= few_rows && !any_is_on_continuum();
}

/// Returns how far to search from a row if no stray is alone: along all of a valley that it is in, if the
/// rows are odd in number, since solutions come in pairs; a little where a joint is nearly idle, since
/// another solution may nearly meet it; else nowhere.
double Careful::way_to_search(const Row& row) {
  auto at = polishing::Newton<double, joints, 3>(task_).reached(row.values);
  if (polishing::idle_joints(at).least < joints)
    return size_ % 2 != 0 && is_next_to_continuum(row.values) ? longest_in_valley : 0;
  return polishing::dependent(at.jacobian, nearly_idle).least < joints ? beside_row : 0;
}

/// True if several joints are nearly idle at a row. What is next to it is no valley but a plain, of which a
/// walk sees a line.
bool Careful::any_is_on_plain() const {
  return std::any_of(rows_, rows_ + size_, [this](const Row& row) {
    auto at = polishing::Newton<double, joints, 3>(task_).reached(row.values);
    const auto idle = polishing::dependent(at.jacobian, nearly_idle);
    return !row.continuum && std::count(idle.is.begin(), idle.is.end(), true) > 1;
  });
}

}  // namespace qvgen::inverse::elimination
