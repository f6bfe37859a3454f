// SPDX-License-Identifier: MIT
#include "paths.h"

#include <sstream>

namespace qvgen::test {
namespace {

/// A joint may go so many times as far as the path's own joints do, which may come to a singular pose on one
/// of two branches that meet there and leave on the other.
constexpr double factor = 30;
/// Distance within which no other solution is asked for, rad or m: rounding may have moved a row along a
/// nearly free direction.
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

namespace {

/// Follows a path from seed to seed.
class Follower {
 public:
  Follower(const Case& test, const Nearest& nearest, Eigen::VectorXd seed)
      : test_(test), nearest_(nearest), seed_(std::move(seed)) {}

  /// One step, to where the path's own joints are so. Whether it was short enough, and the pose held.
  bool go_to(const Eigen::VectorXd& own, double step) {
    const Pose<double> pose = Pose<double>::from_isometry(test_.tool(own));
    const auto found = nearest_(pose, test_.given(own), seed_);
    text_.str("");
    text_.precision(17);
    text_ << "the path's " << own.transpose() << "; seed " << seed_.transpose() << "; ";
    if (!found) {
      text_ << "no solution";
      return false;
    }
    const double way = test_.distance(seed_, *found);
    const double miss = test_.miss(*found, pose.isometry()).largest() / (1e-12 * (1 + pose.position.norm()));
    text_ << "found " << found->transpose() << "; step " << step << ", way " << way << ", miss " << miss;
    if (!(miss < 1 && way <= factor * step + slack)) return false;
    seed_ = *found;
    return true;
  }

  /// Goes in halves as long as a step is too long: a branch beside the path's may be faster than it.
  bool go_in_halves(const Eigen::VectorXd& from, const Eigen::VectorXd& to, int times) {
    if (go_to(to, test_.distance(from, to))) return true;
    if (times == 0) return false;
    const Eigen::VectorXd middle = (from + to) / 2;
    return go_in_halves(from, middle, times - 1) && go_in_halves(middle, to, times - 1);
  }

  [[nodiscard]] std::string text() const { return test_.robot().name + ": " + text_.str(); }

 private:
  const Case& test_;
  const Nearest& nearest_;
  Eigen::VectorXd seed_;
  std::ostringstream text_;
};

}  // namespace

std::string fault_along(const Case& test, const Path& path, const Nearest& nearest) {
  Follower follower(test, nearest, path.joints.front());
  for (std::size_t i = 0; i < path.joints.size(); ++i) {
    const Eigen::VectorXd& own = path.joints[i];
    const Eigen::VectorXd& before = path.joints[i == 0 ? 0 : i - 1];
    if (follower.go_in_halves(before, own, 12)) continue;
    return "place " + std::to_string(i) + ", " + follower.text();
  }
  return "";
}

}  // namespace qvgen::test
