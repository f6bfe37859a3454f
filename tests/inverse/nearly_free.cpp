// SPDX-License-Identifier: MIT
#include "nearly_free.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>

#include "judge.h"

namespace qvgen::test {
namespace {

/// A direction that is not marked is off by half a milliradian at most; joints behind it may be off by ten
/// times that.
constexpr double close = 5e-3;

/// 10^-u, u in [6, 16], either sign.
double little(Case& test) {
  const double size = std::pow(10, -test.uniform(6, 16));
  return test.uniform(-1, 1) < 0 ? -size : size;
}

/// The k-th of the joints that are solved for.
int free_joint(const Case& test, int k) {
  const int given = test.robot().info.given_joint;
  const int joint = k % (given < 0 ? test.dof() : test.dof() - 1);
  return given >= 0 && joint >= given ? joint + 1 : joint;
}

std::optional<Eigen::VectorXd> at_right_angle(Case& test, int joint) {
  Eigen::VectorXd q = test.joints();
  q[joint] = test.revolute(joint) ? pi / 2 * std::round(q[joint] / (pi / 2)) : 0;
  return q;
}

/// Joints of a set that is searched for.
std::optional<Eigen::VectorXd> drawn(Case& test, const char* set, int i) {
  const std::optional<Sample> sample = pose_set(set).draw(test, i);
  if (!sample) return std::nullopt;
  return sample->q;
}

/// Returns the i-th pose next to a singular one; none if the search for it fails.
std::optional<Sample> next_to_singular(Case& test, int i) {
  constexpr std::array searched = {"boundary", "centre on axis 1", "tool on axis 1"};
  const int kind = i % 4, turn = i / 4;
  const int joint = free_joint(test, turn);
  auto q = kind == 3 ? at_right_angle(test, joint) : drawn(test, searched[kind], 2 * turn);
  if (!q) return std::nullopt;
  (*q)[joint] += little(test);
  return sample_at(test, *q);
}

/// True if a row is near the sampled joints, or a marked row stands for them.
bool stands_for(const Case& test, const Found& found, const Sample& sample) {
  const auto is_sampled = [&](const Row& row) { return test.distance(row.q, sample.q) < close; };
  if (std::any_of(found.rows.begin(), found.rows.end(), is_sampled)) return true;
  Found marked{found.status, {}};
  std::copy_if(found.rows.begin(), found.rows.end(), std::back_inserter(marked.rows),
               [](const Row& row) { return row.continuum; });
  return contains(test, marked, sample, close);
}

/// Counts a call whose answer neither says that rows may be missing nor has them.
void count_call(const Case& test, const char* call, bool told, bool has_them, const Sample& sample,
                LostRows& result) {
  ++result.calls;
  result.told += told ? 1 : 0;
  if (told || has_them || ++result.lost > 1) return;
  std::ostringstream text;
  text.precision(17);
  text << test.robot().name << ", " << call << ": " << sample.q.transpose();
  result.first = text.str();
}

}  // namespace

LostRows lost_next_to_singular(Case& test, int poses) {
  LostRows result;
  const InverseUnderTest& robot = test.robot();
  const auto look_at = [&](const char* call, const Found& found, const Sample& sample) {
    const bool told = found.status == Status::incomplete;
    count_call(test, call, told, told || stands_for(test, found, sample), sample, result);
  };
  for (int i = 0; i < poses; ++i) {
    const std::optional<Sample> sample = next_to_singular(test, i);
    if (!sample) continue;
    const double given = test.given(sample->q);
    look_at("all", robot.solve(sample->pose, given, inverse::default_tolerance), *sample);
    look_at("from a seed", robot.solve_from(sample->pose, given, test.joints()), *sample);
    if (robot.functions.solve_within)  // not in C
      look_at("within limits",
              robot.solve_within(sample->pose, given, sample->q.array() - 1, sample->q.array() + 1), *sample);
    if (robot.functions.solve_near)
      look_at("near", robot.solve_near(sample->pose, given, sample->q), *sample);
  }
  return result;
}

LostRows lost_at_two_singularities(Case& test, int poses) {
  LostRows result;
  for (int i = 0; i < poses; ++i) {
    const std::optional<Sample> sample = at_two_singularities(test, i);
    if (!sample) continue;
    const Found found = test.robot().solve(sample->pose, test.given(sample->q), inverse::default_tolerance);
    const bool told = found.status == Status::incomplete;
    count_call(test, "all", told, told || contains(test, found, *sample, close), *sample, result);
  }
  return result;
}

}  // namespace qvgen::test
