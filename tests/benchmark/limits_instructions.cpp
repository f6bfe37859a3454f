// SPDX-License-Identifier: MIT
// Inverse kinematics within joint limits at random poses, beside all solutions without limits:
// `qvgen_limits_instructions` prints nanoseconds a call of every arm and call; `... ARM CALL POSES` runs one
// of them, to be counted by limits_instructions.sh.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <qvgen/robots/irb6640.h>
#include <qvgen/robots/puma560.h>
#include <qvgen/robots/ur5.h>
#ifdef QVGEN_MOTOR_ARMS
#include <qvgen/robots/bevel_arm.h>
#include <qvgen/robots/nested_wrist.h>
#endif

namespace {

using Joints = qvgen::Joints<6>;
using Limits = qvgen::JointLimits<6>;

struct Query {
  qvgen::Pose<double> pose;
  Joints seed;
};

constexpr double degree = 3.14159265358979323846 / 180;

Limits symmetric(double degrees) {
  return {Joints::Constant(-degrees * degree), Joints::Constant(degrees * degree)};
}

struct Sums {
  long rows = 0;
};

/// Counts rows that are wanted, in a register. Not a lambda: callgrind would take its name for that of `run`.
struct Counter {
  long& rows;
  template <class Row>
  void operator()(const Row& row) const {
    rows += 1;
    asm volatile("" : : "r"(row.q.data()) : "memory");
  }
};

template <class Found>
void add(const Found& found, Sums& sums) {
  long rows = 0;
  for (const auto& row : found) Counter{rows}(row);
  sums.rows += rows;
}

constexpr const char* calls[] = {"all",         "seed",   "seed_limits", "seed_wide", "nearest", "near",
                                 "near_limits", "limits", "wide",        "turns",     "visits"};

// The arm of a namespace `arm`, a type that has its functions, with limits of half a turn and a little less,
// as most arms have them, and of a whole turn to either side.
#define QVGEN_ARM_FUNCTIONS(name, narrow_limits, wide_limits)            \
  struct name {                                                          \
    static constexpr const char* text = #name;                           \
    template <class... Arguments>                                        \
    static auto inverse(const Arguments&... arguments) {                 \
      return qvgen::robots::name::inverse_kinematics(arguments...);      \
    }                                                                    \
    template <class... Arguments>                                        \
    static auto near(const Arguments&... arguments) {                    \
      return qvgen::robots::name::inverse_kinematics_near(arguments...); \
    }                                                                    \
    static qvgen::Pose<double> forward(const Joints& q) {                \
      return qvgen::robots::name::forward_kinematics<double>(q);         \
    }                                                                    \
    static Limits narrow() { return narrow_limits; }                     \
    static Limits wide() { return wide_limits; }                         \
  };
QVGEN_ARM_FUNCTIONS(irb6640, symmetric(170), symmetric(360))
QVGEN_ARM_FUNCTIONS(puma560, symmetric(170), symmetric(360))
QVGEN_ARM_FUNCTIONS(ur5, symmetric(170), symmetric(360))
#ifdef QVGEN_MOTOR_ARMS
// Motors have the description's limits, some of which are two turns; `wide` are twice as far.
Limits twice(const Limits& limits) { return {2 * limits.lower, 2 * limits.upper}; }
QVGEN_ARM_FUNCTIONS(bevel_arm, qvgen::robots::bevel_arm::Limits(), twice(narrow()))
QVGEN_ARM_FUNCTIONS(nested_wrist, qvgen::robots::nested_wrist::Limits(), twice(narrow()))
#endif
#undef QVGEN_ARM_FUNCTIONS

template <class Arm>
std::vector<Query> queries(int count) {
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> turn(-3, 3), little(-0.1, 0.1);
  std::vector<Query> result;
  for (int i = 0; i < count; ++i) {
    Joints q;
    for (int k = 0; k < 6; ++k) q[k] = turn(random);
    result.push_back({Arm::forward(q), q});
    for (int k = 0; k < 6; ++k) result.back().seed[k] += little(random);
  }
  return result;
}

template <class Call>
Sums summed(const std::vector<Query>& all, const Call& call) {
  Sums sums;
  for (const Query& query : all) add(call(query), sums);
  return sums;
}

/// One call for each query, all rows read, but for `nearest`, which is `seed_limits` with its first row read:
/// how many rows there are is not guessed by the processor. `seed_wide`: `seed_limits` within the wide
/// limits; `wide`: rows within these, counted; `turns`: every representative visited, `visits`: by
/// `for_each`.
template <class Arm>
Sums run(const std::string& call, const std::vector<Query>& all) {
  const Limits narrow = Arm::narrow(), wide = Arm::wide();
  if (call == "all") return summed(all, [&](const Query& a) { return Arm::inverse(a.pose); });
  if (call == "seed") return summed(all, [&](const Query& a) { return Arm::inverse(a.pose, a.seed); });
  if (call == "seed_limits")
    return summed(all, [&](const Query& a) { return Arm::inverse(a.pose, a.seed, narrow); });
  if (call == "seed_wide")
    return summed(all, [&](const Query& a) { return Arm::inverse(a.pose, a.seed, wide); });
  if (call == "nearest") {
    Sums sums;
    for (const Query& query : all)
      if (const auto found = Arm::inverse(query.pose, query.seed, narrow); !found.empty())
        Counter{sums.rows}(found[0]);
    return sums;
  }
  if (call == "near") return summed(all, [&](const Query& a) { return Arm::near(a.pose, a.seed); });
  if (call == "near_limits")
    return summed(all, [&](const Query& a) { return Arm::near(a.pose, a.seed, narrow); });
  if (call == "limits") return summed(all, [&](const Query& a) { return Arm::inverse(a.pose, narrow); });
  if (call == "wide") {
    Sums sums;
    for (const Query& query : all) sums.rows += static_cast<long>(Arm::inverse(query.pose, wide).size());
    return sums;
  }
  if (call == "turns") return summed(all, [&](const Query& a) { return Arm::inverse(a.pose, wide); });
  Sums sums;
  for (const Query& query : all) {
    long rows = 0;
    Arm::inverse(query.pose, wide).for_each(Counter{rows});
    sums.rows += rows;
  }
  return sums;
}

template <class Arm>
double nanoseconds(const std::string& call, const std::vector<Query>& all) {
  double best = 1e300;
  for (int repeat = 0; repeat < 30; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    if (run<Arm>(call, all).rows < 0) std::abort();
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / static_cast<double>(all.size()));
  }
  return best;
}

template <class Arm>
void print_times() {
  const auto all = queries<Arm>(2000);
  std::printf("%-13s", Arm::text);
  const double unlimited = nanoseconds<Arm>("all", all);
  for (const char* call : calls) {
    const double time = nanoseconds<Arm>(call, all);
    std::printf("%14.1f%6.2fx", time, time / unlimited);
  }
  std::printf("\n");
}

template <class Arm>
bool count(const char* arm, const char* call, int poses) {
  if (std::string(arm) != Arm::text) return false;
  const Sums sums = run<Arm>(call, queries<Arm>(poses));
  std::printf("%.4f\n", static_cast<double>(sums.rows) / poses);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4) {
    const int poses = std::atoi(argv[3]);
    const bool is_known = count<irb6640>(argv[1], argv[2], poses) ||
                          count<puma560>(argv[1], argv[2], poses) || count<ur5>(argv[1], argv[2], poses);
#ifdef QVGEN_MOTOR_ARMS
    if (count<bevel_arm>(argv[1], argv[2], poses) || count<nested_wrist>(argv[1], argv[2], poses)) return 0;
#endif
    return is_known ? 0 : 2;
  }
  std::printf("%-13s", "ns a call");
  for (const char* call : calls) std::printf("%14s%7s", call, "");
  std::printf("\n");
  print_times<irb6640>();
  print_times<puma560>();
  print_times<ur5>();
#ifdef QVGEN_MOTOR_ARMS
  print_times<bevel_arm>();
  print_times<nested_wrist>();
#endif
  return 0;
}
