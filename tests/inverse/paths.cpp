// SPDX-License-Identifier: MIT
#include "paths.h"

#include <sstream>

namespace qvgen::test {
namespace {

/// A joint may go so many times as far as the path's own joints do, which may come to a singular pose on one
/// of two branches that meet there and leave on the other.
constexpr double factor = 30;
/// Of what is nearer than this no other solution is asked for; rounding may have moved it along a direction
/// that is next to free. rad or m.
constexpr double slack = 1e-2;

std::vector<double> even_places(Case& test) {
  const double step = 0.2 / 50;
  const double start = test.uniform(0, 1) < 0.5 ? 0 : test.uniform(0, step);
  std::vector<double> places;
  for (int i = -25; i <= 25; ++i) places.push_back(start + step * i);
  return places;
}

std::vector<double> halved_places() {
  std::vector<double> places;
  for (double s = 0.1; s > 1e-16; s /= 2) places.push_back(-s);
  std::vector<double> back(places.rbegin(), places.rend());
  places.push_back(0);
  for (const double s : back) places.push_back(-s);
  return places;
}

}  // namespace

Path Path::through(Case& test, const Eigen::VectorXd& singular) {
  Eigen::VectorXd along(test.dof()), bend(test.dof());
  for (int i = 0; i < test.dof(); ++i) {
    along[i] = test.uniform(-1, 1);
    bend[i] = test.uniform(-1, 1);
  }
  Path path;
  for (const double s : test.uniform(0, 1) < 0.5 ? even_places(test) : halved_places())
    path.joints.emplace_back(singular + s * along + s * s * bend);
  return path;
}

Followed follow(const Case& test, const Path& path, const Nearest& nearest) {
  Followed result;
  std::ostringstream text;
  text.precision(17);
  Eigen::VectorXd seed = path.joints.front();
  for (std::size_t i = 0; i < path.joints.size(); ++i) {
    const Eigen::VectorXd& own = path.joints[i];
    const Pose<double> pose = Pose<double>::from_isometry(test.tool(own));
    const auto found = nearest(pose, test.given(own), seed);
    if (!found) {
      text << test.robot().name << ": no solution at place " << i << "; the path's " << own.transpose()
           << "; seed " << seed.transpose();
      result.fault = text.str();
      return result;
    }
    const double step = i == 0 ? 0 : test.distance(path.joints[i - 1], own);
    const double way = test.distance(seed, *found);
    const double miss = test.miss(*found, pose.isometry()).largest() / (1e-12 * (1 + pose.position.norm()));
    result.miss = std::max(result.miss, miss);
    result.jump = std::max(result.jump, way - factor * step - slack);
    if (result.fault.empty() && !(way <= factor * step + slack && miss < 1)) {
      text << test.robot().name << ": place " << i << " of " << path.joints.size() << ", step " << step
           << ", way " << way << ", miss " << miss << "; the path's " << own.transpose() << "; seed "
           << seed.transpose() << "; found " << found->transpose();
      result.fault = text.str();
    }
    seed = *found;
  }
  return result;
}

}  // namespace qvgen::test
