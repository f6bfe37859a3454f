// SPDX-License-Identifier: MIT
// Paths of 1,000 poses: `qvgen_paths [PATHS]` prints how long all motions along random paths take, beside all
// solutions of the same poses alone, the best motion where one coordinate is free, and least times along
// joints. `qvgen_paths way` prints one of these ways for others to time (paths_toppra.py). Processor time.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <qvgen/path/free_program.h>
#include <qvgen/path/time.h>
#include <qvgen/robots/crx10ia.h>
#include <qvgen/robots/iiwa14.h>
#include <qvgen/robots/iiwa14/arm_angle.h>
#include <qvgen/robots/iiwa14/dynamics_definitions.h>
#include <qvgen/robots/irb6640.h>
#include <qvgen/robots/jaco2.h>
#include <qvgen/robots/puma560.h>
#include <qvgen/robots/stanford.h>
#include <qvgen/robots/ur5.h>

namespace {

using namespace qvgen;
using Poses = std::vector<Pose<double>>;

constexpr std::size_t samples = 1000;
const double pi = inverse::whole_turn / 2;

/// Processor time of a call, ms.
template <class Call>
double milliseconds(const Call& call) {
  const std::clock_t start = std::clock();
  call();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The fastest of some calls, ms.
template <class Call>
double fastest(int calls, const Call& call) {
  double least = 1e9;
  for (int i = 0; i < calls; ++i) least = std::min(least, milliseconds(call));
  return least;
}

/// A bent way around a pose, of about that length, the tool turning by about so many radians on it.
Poses bent_path(const Pose<double>& middle, double length, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector3<double>(unit(random), unit(random), unit(random)); };
  const Vector3<double> along = vector().normalized(), bend = vector(), turn = vector();
  Poses poses;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = length * (static_cast<double>(i) / static_cast<double>(samples - 1) - 0.5);
    poses.push_back({from_rotation_vector<double>(t * turn) * middle.orientation,
                     middle.position + t * along + t * t * bend});
  }
  return poses;
}

template <int dof>
Joints<dof> random_joints(const JointKinds<dof>& revolute, std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-3.1, 3.1), slide(0.1, 0.9);
  Joints<dof> q;
  for (int i = 0; i < dof; ++i) q[i] = revolute[static_cast<std::size_t>(i)] ? angle(random) : slide(random);
  return q;
}

/// Limits of every joint, as industrial arms have them.
template <int dof>
JointLimits<dof> usual_limits() {
  return {Joints<dof>::Constant(-2.8), Joints<dof>::Constant(2.8)};
}

struct Times {
  std::vector<double> all, alone;
  double places = 0, motions = 0;
  int failed = 0;
};

double part(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

/// Room for all that is found, made once.
template <int capacity>
struct Room {
  std::vector<double> q = std::vector<double>(samples * capacity * 6);
  std::vector<int> rows = std::vector<int>(samples * capacity);
  std::vector<path::Track> tracks = std::vector<path::Track>(4000);
  std::vector<path::Event> events = std::vector<path::Event>(20000);
  [[nodiscard]] path::Buffers<capacity> buffers() {
    return {q.data(), rows.data(), tracks.data(), tracks.size(), events.data(), events.size()};
  }
};

template <class Arm>
void follow_one(const Arm& arm, const Poses& poses, Room<Arm::capacity>& room, Times& times) {
  const path::Curve curve(poses.data(), poses.size());
  const JointLimits<6> limits = usual_limits<6>();
  long places = 0, motions = 0;
  bool is_whole = true;
  times.all.push_back(fastest(3, [&] {
    path::Record<Arm::capacity> record(room.buffers());
    path::Follower<Arm> follower(arm, curve, limits, record);
    follower.run();
    motions = 0;
    const auto take = [&](const path::Motion&) { ++motions; };
    const bool fits =
        path::MotionsOf<Arm::capacity, decltype(take)>(record, limits, arm.revolute, take).run();
    places = follower.places();
    is_whole = fits && !record.is_full && !record.is_doubtful;
  }));
  times.alone.push_back(fastest(3, [&] {
    for (const Pose<double>& pose : poses) {
      const auto found = arm.solve(pose);
      asm volatile("" : : "r"(&found) : "memory");
    }
  }));
  times.places += static_cast<double>(places);
  times.motions += static_cast<double>(motions);
  times.failed += static_cast<int>(!is_whole);
}

template <class Arm>
void follow_all(const char* name, const Arm& arm, double length, int paths) {
  std::mt19937 random(5);
  Room<Arm::capacity> room;
  Times times;
  for (int i = 0; i < paths; ++i)
    follow_one(arm, bent_path(arm.forward(random_joints<6>(arm.revolute, random)), length, random), room,
               times);
  std::printf("%-12s%10.2f%10.2f%10.2f%14.2f%12.0f%10.1f%10d\n", name, part(times.all, 0.5),
              part(times.all, 0.9), part(times.all, 1), part(times.alone, 0.5), times.places / paths,
              times.motions / paths, times.failed);
  std::fflush(stdout);
}

/// A path with what is free on it, by name and half width.
using Free = std::vector<std::pair<const char*, double>>;

template <int dof>
path::FreeRequest<dof> request_of(const Poses& poses, const Free& free) {
  path::FreeRequest<dof> request;
  request.path.samples = poses;
  request.limits = usual_limits<dof>();
  for (const auto& [name, half] : free) {
    path::FreeRange range;
    range.lower = -half;
    range.upper = half;
    range.is_circle = half >= pi;
    add_named(request.freedoms, name, range);
  }
  return request;
}

template <int dof, int capacity, class Solve, class Forward>
void follow_free(const char* name, const Free& free, const Solve& solve, const Forward& forward,
                 const JointKinds<dof>& revolute, int paths) {
  std::mt19937 random(5);
  std::vector<double> all;
  for (int i = 0; i < paths; ++i) {
    const Poses poses =
        bent_path(forward(Joints<dof>(0.8 * random_joints<dof>(revolute, random))), 0.5, random);
    const auto request = request_of<dof>(poses, free);
    double followed = -1;
    const double time = milliseconds(
        [&] { followed = path::FreeResult<dof, capacity, Solve>(solve, request, revolute).followed; });
    if (followed >= static_cast<double>(samples - 1)) all.push_back(time);
  }
  std::printf("%-28s%10.1f%10.1f%10.1f%16zu of %d\n", name, part(all, 0.5), part(all, 0.9), part(all, 1),
              all.size(), paths);
  std::fflush(stdout);
}

// The arm of a namespace.
#define QVGEN_FOLLOW(robot)                                                                                \
  follow_all(#robot,                                                                                       \
             path::Arm{[](const Pose<double>& pose) { return robots::robot::inverse_kinematics(pose); },   \
                       [](const path::Values& q) { return robots::robot::forward_kinematics<double>(q); }, \
                       [](const path::Values& q) { return robots::robot::jacobian<double>(q); },           \
                       robots::robot::is_revolute, robots::robot::inverse_info.stable_branches},           \
             length, paths)

void follow_all(double length, int paths) {
  std::printf("%.1f m, ms a path\n%-12s%10s%10s%10s%14s%12s%10s%10s\n", length, "", "median", "90 %",
              "slowest", "poses alone", "places", "motions", "doubtful");
  QVGEN_FOLLOW(irb6640);
  QVGEN_FOLLOW(puma560);
  QVGEN_FOLLOW(stanford);
  QVGEN_FOLLOW(ur5);
  QVGEN_FOLLOW(jaco2);
  QVGEN_FOLLOW(crx10ia);
  std::printf("\n");
}

void follow_free(int paths) {
  std::printf("%-28s%10s%10s%10s%18s\n", "free, ms", "median", "90 %", "slowest", "all the way");
  const auto ur5 = [](const Pose<double>& pose, double) { return robots::ur5::inverse_kinematics(pose); };
  const auto ur5_pose = [](const auto& q) { return robots::ur5::forward_kinematics<double>(q); };
  const auto irb = [](const Pose<double>& pose, double) { return robots::irb6640::inverse_kinematics(pose); };
  const auto irb_pose = [](const auto& q) { return robots::irb6640::forward_kinematics<double>(q); };
  const auto iiwa = [](const Pose<double>& pose, double value) {
    return robots::iiwa14::inverse_kinematics_arm_angle(pose, value);
  };
  const auto iiwa_pose = [](const auto& q) { return robots::iiwa14::forward_kinematics<double>(q); };
  const Free turn{{"tool_z", pi}}, cone{{"cone_z", 0.2}}, both{{"cone_z", 0.2}, {"tool_z", pi}};
  const Free box{{"shift_x", 0.005}, {"shift_y", 0.005}, {"shift_z", 0.005},
                 {"tool_x", 0.05},   {"tool_y", 0.05},   {"tool_z", 0.05}};
  const auto& ur5_kinds = robots::ur5::is_revolute;
  const auto& iiwa_kinds = robots::iiwa14::is_revolute;
  follow_free<6, 8>("ur5, turn", turn, ur5, ur5_pose, ur5_kinds, paths);
  follow_free<6, 8>("ur5, cone", cone, ur5, ur5_pose, ur5_kinds, paths);
  follow_free<6, 8>("ur5, cone and turn", both, ur5, ur5_pose, ur5_kinds, paths);
  follow_free<6, 8>("ur5, box of six", box, ur5, ur5_pose, ur5_kinds, paths);
  follow_free<6, 8>("irb6640, turn", turn, irb, irb_pose, robots::irb6640::is_revolute, paths);
  follow_free<6, 8>("irb6640, cone and turn", both, irb, irb_pose, robots::irb6640::is_revolute, paths);
  follow_free<7, 8>("iiwa14, arm angle", {{"arm_angle", pi}}, iiwa, iiwa_pose, iiwa_kinds, paths);
  follow_free<7, 8>("iiwa14, arm angle and turn", {{"joint", pi}, {"tool_z", pi}}, iiwa, iiwa_pose,
                    iiwa_kinds, paths);
}

/// The forces of an iiwa14.
struct Forces {
  static constexpr int forces = 7;
  path::HeldValue held = {};
  template <class Scalar>
  [[nodiscard]] path::ForceParts<Scalar, 7> parts(const robots::iiwa14::JointVector<Scalar>& q,
                                                  const robots::iiwa14::JointVector<Scalar>& slope) const {
    return {robots::iiwa14::mass_matrix<Scalar>(q), robots::iiwa14::coriolis_torque<Scalar>(q, slope),
            robots::iiwa14::gravity_torque<Scalar>(q)};
  }
};

std::vector<Joints<7>> bent_way(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Joints<7>(Joints<7>::NullaryExpr([&] { return normal(random); })); };
  const Joints<7> a = vector(), b = vector(), c = vector(), middle = 0.3 * vector();
  std::vector<Joints<7>> way;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = 3.0 * static_cast<double>(i) / static_cast<double>(samples - 1);
    way.push_back(middle + 0.5 * a * std::sin(t) + 0.3 * b * std::cos(1.7 * t) + 0.1 * c * std::sin(2.9 * t));
  }
  return way;
}

const path::RateLimits<7> rates{Joints<7>::Constant(2), Joints<7>::Constant(10)};

/// Prints how many milliseconds planning one way takes, and the motion seconds; then the way.
void print_way() {
  std::mt19937 random(5);
  const std::vector<Joints<7>> way = bent_way(random);
  std::vector<path::Timing<7>::Point> points(samples);
  path::Timing<7> timing(way.data(), samples, rates, points.data());
  double seconds = 0;
  const double least = fastest(5, [&] { seconds = timing.run(); });
  std::printf("%.9g %.9g\n", least, seconds);
  for (const Joints<7>& q : way)
    for (int k = 0; k < 7; ++k) std::printf("%.17g%s", q[k], k < 6 ? "," : "\n");
}

/// Least times along joints of 1,000 points, without and with limits of torque (the maker's).
void plan_times(int paths) {
  std::mt19937 random(5);
  path::ForceLimits<7> limits;
  limits.most << 320, 320, 176, 176, 110, 40, 40;
  std::vector<double> plain, bounds_alone, with_forces;
  int failed = 0;
  for (int i = 0; i < paths; ++i) {
    const std::vector<Joints<7>> way = bent_way(random);
    std::vector<path::Timing<7>::Point> points(samples);
    path::Timing<7> timing(way.data(), samples, rates, points.data());
    double seconds = 0, longer = 0;
    plain.push_back(fastest(5, [&] { seconds = timing.run(); }));
    std::vector<path::ForceBounds<7>> bounds(samples);
    std::vector<path::Timing<7, 7>::Point> loaded_points(samples);
    path::Timing<7, 7> loaded(way.data(), samples, rates, loaded_points.data());
    loaded.lay();
    bounds_alone.push_back(fastest(3, [&] {
      for (std::size_t k = 0; k + 1 < samples; ++k)
        bounds[k] = path::force_bounds(Forces(), loaded.spline(k));
    }));
    loaded.limit_forces(limits, bounds.data());
    with_forces.push_back(bounds_alone.back() + fastest(3, [&] { longer = loaded.plan(); }));
    failed += static_cast<int>(!(seconds > 0 && longer >= seconds * (1 - 1e-9)));
  }
  std::printf("\n%-24s%10s%10s%10s%10s\n", "least time, 7 joints, ms", "median", "90 %", "slowest", "failed");
  const auto row = [&](const char* name, const std::vector<double>& all) {
    std::printf("%-24s%10.2f%10.2f%10.2f%10d\n", name, part(all, 0.5), part(all, 0.9), part(all, 1), failed);
  };
  row("speed, acceleration", plain);
  row("torque too", with_forces);
  row("  bounds of torques", bounds_alone);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "way") {
    print_way();
    return 0;
  }
  const int paths = argc > 1 ? std::atoi(argv[1]) : 20;
  if (paths < 1) return 2;
  for (const double length : {0.5, 1.5}) follow_all(length, paths);
  follow_free(paths);
  plan_times(paths);
  return 0;
}
