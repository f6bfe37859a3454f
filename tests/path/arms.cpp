// SPDX-License-Identifier: MIT
#include "arms.h"

#include <cstdlib>

#include <qvgen/robots/crx10ia.h>
#include <qvgen/robots/cuspidal.h>
#include <qvgen/robots/irb6640.h>
#include <qvgen/robots/jaco2.h>
#include <qvgen/robots/stanford.h>
#include <qvgen/robots/ur5.h>
#ifdef QVGEN_ALL_ARMS
#include <qvgen/robots/cs.h>
#include <qvgen/robots/general_6r.h>
#include <qvgen/robots/nn.h>
#include <qvgen/robots/offset_wrist.h>
#include <qvgen/robots/poe_6r.h>
#include <qvgen/robots/puma560.h>
#include <qvgen/robots/rr.h>
#include <qvgen/robots/rx90.h>
#include <qvgen/robots/xarm6.h>
#endif

namespace path_test {
namespace {

template <class Found>
Solutions<6, 16> in_sixteen(const Found& found) {
  Solutions<6, 16> result;
  result.status = found.status;
  for (const auto& row : found) inverse::append(result, row.q, row.branch, row.continuum);
  return result;
}

/// An arm of the library under test, by its namespace.
#define QVGEN_PATH_ARM(robot)                                                                             \
  NamedArm {                                                                                              \
#robot, AnyArm {                                                                                      \
      [](const Pose<double>& pose) { return in_sixteen(robots::robot::inverse_kinematics(pose)); },       \
          [](const Values& q) { return robots::robot::forward_kinematics<double>(q); },                   \
          [](const Values& q) { return robots::robot::jacobian<double>(q); }, robots::robot::is_revolute, \
          robots::robot::inverse_info.stable_branches                                                     \
    }                                                                                                     \
  }

}  // namespace

const std::vector<NamedArm>& arms() {
  static const std::vector<NamedArm> all{
      QVGEN_PATH_ARM(irb6640),  QVGEN_PATH_ARM(ur5),        QVGEN_PATH_ARM(stanford),
      QVGEN_PATH_ARM(cuspidal), QVGEN_PATH_ARM(jaco2),      QVGEN_PATH_ARM(crx10ia),
#ifdef QVGEN_ALL_ARMS
      QVGEN_PATH_ARM(puma560),  QVGEN_PATH_ARM(rx90),       QVGEN_PATH_ARM(xarm6),
      QVGEN_PATH_ARM(poe_6r),   QVGEN_PATH_ARM(nn),         QVGEN_PATH_ARM(rr),
      QVGEN_PATH_ARM(cs),       QVGEN_PATH_ARM(general_6r), QVGEN_PATH_ARM(offset_wrist),
#endif
  };
  return all;
}

std::vector<std::string> names_of_arms() {
  std::vector<std::string> names;
  for (const NamedArm& each : arms()) names.push_back(each.name);
  return names;
}

const NamedArm& arm_called(const std::string& name) {
  for (const NamedArm& each : arms())
    if (each.name == name) return each;
  throw std::invalid_argument(name);
}

Whole::Whole(const AnyArm& arm, std::vector<Pose<double>> poses, const JointLimits<6>& joint_limits,
             Between between, const Options& options, double radius)
    : samples(std::move(poses)),
      curve(samples.data(), samples.size(), between, radius),
      limits(joint_limits),
      q(samples.size() * capacity * 6),
      rows(samples.size() * capacity),
      tracks(4000),
      events(20000),
      record({q.data(), rows.data(), tracks.data(), tracks.size(), events.data(), events.size()}) {
  follow(arm, options);
}

void Whole::follow(const AnyArm& arm, const Options& options) {
  record =
      Record<capacity>({q.data(), rows.data(), tracks.data(), tracks.size(), events.data(), events.size()});
  Follower<AnyArm> follower(arm, curve, limits, record, options);
  follower.run();
  places = follower.places();
}

Values random_joints(const AnyArm& arm, std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-3.1, 3.1), slide(0.1, 0.9);
  Values q;
  for (int i = 0; i < 6; ++i)
    q[i] = arm.revolute[static_cast<std::size_t>(i)] ? angle(random) : slide(random);
  return q;
}

std::vector<Pose<double>> random_path(const AnyArm& arm, std::mt19937& random, std::size_t count,
                                      double length) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector3<double>(unit(random), unit(random), unit(random)); };
  const Pose<double> middle = arm.forward(random_joints(arm, random));
  const Vector3<double> along = vector(), bend = vector(), turn = vector();
  std::vector<Pose<double>> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = length * (static_cast<double>(i) / static_cast<double>(count - 1) - 0.5);
    poses.push_back({from_rotation_vector<double>(2 * t * turn) * middle.orientation,
                     middle.position + t * along + t * t * bend});
  }
  return poses;
}

std::vector<Pose<double>> path_of_joints(const AnyArm& arm, const Values& from, const Values& to,
                                         std::size_t count) {
  std::vector<Pose<double>> poses;
  for (std::size_t i = 0; i < count; ++i)
    poses.push_back(
        arm.forward(from + static_cast<double>(i) / static_cast<double>(count - 1) * (to - from)));
  return poses;
}

int path_count(int usual) {
  const char* text = std::getenv("QVGEN_PATHS");
  return text == nullptr ? usual : std::atoi(text);
}

}  // namespace path_test
