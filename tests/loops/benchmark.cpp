// SPDX-License-Identifier: MIT
// Nanoseconds a call of functions of closed loops, and of MuJoCo's constrained forward dynamics for the same
// mechanisms in the same run; agreement at rest is checked first, and an exit status says whether there is.
// `loops_benchmark --instructions` makes one dump of callgrind's for each function, for instructions.sh.
// A platform on six cylinders comes last, unless the build is light: its inverse kinematics, the tip's
// Jacobian, and all of its places.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(name)
#endif

#include "measured.h"
#include "mujoco_loops.h"
#ifdef QVGEN_MEASURES_STEWART
#include <qvgen/robots/stewart/assembly.h>
#endif

namespace {

using Eigen::VectorXd;
using qvgen::test::loops::MujocoLoops;
using Clock = std::chrono::steady_clock;

constexpr int inputs = 64;
double sum = 0;  // so that no call is left out

/// The least mean time of a call, ns, over some rounds.
double nanoseconds(int rounds, std::size_t calls, const std::function<double()>& all) {
  double least = 1e300;
  for (int i = 0; i < rounds; ++i) {
    const auto start = Clock::now();
    for (int k = 0; k < 20; ++k) sum += all();
    const std::chrono::duration<double, std::nano> time = Clock::now() - start;
    least = std::min(least, time.count() / (20 * static_cast<double>(calls)));
  }
  return least;
}

/// Configurations at which the loops close, by the reference.
std::vector<VectorXd> closed(const reference::LoopMechanism& mechanism) {
  std::vector<VectorXd> result;
  const VectorXd none = VectorXd::Zero(static_cast<Eigen::Index>(mechanism.chain.joints.size()));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-0.5, 0.5);
  for (unsigned seed = 1; result.size() < inputs && seed < 100 * inputs; ++seed) {
    VectorXd start = none;
    for (const Eigen::Index joint : mechanism.outputs) start[joint] = place(random);
    for (const VectorXd& q : reference::assemblies(mechanism, start, mechanism.outputs, 1, seed))
      result.push_back(q);
  }
  return result;
}

template <class Values>
Values picked(const VectorXd& q, const std::vector<Eigen::Index>& joints) {
  Values values;
  for (std::size_t i = 0; i < joints.size(); ++i) values[static_cast<Eigen::Index>(i)] = q[joints[i]];
  return values;
}

std::string file(const char* name) { return std::string(QVGEN_LOOP_ROBOTS) + "/" + name + ".toml"; }

/// Largest share by which accelerations of driven joints at rest differ from MuJoCo's.
template <class Of>
double difference(const reference::LoopMechanism& mechanism, MujocoLoops& peer,
                  const std::vector<VectorXd>& at) {
  using Driven = typename Of::Driven;
  double worst = 0;
  for (const VectorXd& q : at) {
    VectorXd all = VectorXd::Zero(q.size());
    for (const Eigen::Index joint : mechanism.driven) all[joint] = 0.7;
    const VectorXd found = peer.forward(q, all);
    const Driven expected = Of::dynamics(typename Of::Joints(q), Driven::Zero(), Driven::Constant(0.7));
    for (std::size_t i = 0; i < mechanism.driven.size(); ++i) {
      const double off = found[mechanism.driven[i]] - expected[static_cast<Eigen::Index>(i)];
      worst = std::max(worst, std::abs(off) / (1 + expected.norm()));
    }
  }
  return worst;
}

/// Nanoseconds a call.
struct Timed {
  double assemble, follow, inverse, rates, dynamics, peer, apart;
};

void print(const char* name, const Timed& t) {
  std::printf("%-22s %9.0f %9.0f", name, t.assemble, t.follow);
  if (t.inverse > 0)
    std::printf(" %9.0f", t.inverse);
  else
    std::printf(" %9s", "");
  std::printf(" %9.0f %9.0f", t.rates, t.dynamics);
  if (t.peer > 0)
    std::printf(" %9.0f %8.1fx\n", t.peer, t.peer / t.dynamics);
  else
    std::printf("\n");
}

/// How a function is measured: by the clock in so many rounds, or, without rounds, by callgrind.
struct Meter {
  int rounds = 0;

  /// Calls `all`, which makes so many calls. Returns nanoseconds a call; 0 if callgrind counts, whose dump
  /// has the name and the number of calls.
  double operator()(const std::string& name, std::size_t calls, const std::function<double()>& all) const {
    if (rounds > 0) return nanoseconds(rounds, calls, all);
    sum += all();  // once before, for what is done at the first call only
    [[maybe_unused]] const std::string label = name + " " + std::to_string(calls);
    CALLGRIND_ZERO_STATS;
    sum += all();
    CALLGRIND_DUMP_STATS_AT(label.c_str());
    return 0;
  }
};

/// How far the driven joints move from one call of `follow` to the next, rad or m.
constexpr double tick = 1e-3;

/// Measures one mechanism, apart from dead centres, where accelerations grow without bound. Returns how far
/// its accelerations are from the peer's.
template <class Of>
double measure(const Meter& meter, bool with_peer) {
  using Driven = typename Of::Driven;
  using Joints = typename Of::Joints;
  const auto mechanism = reference::load_loops(file(Of::name));
  // The measure is a product of as many sines as there are equations.
  constexpr double least = Joints::RowsAtCompileTime > 8 ? 1e-3 : 0.05;
  std::vector<Joints> q;
  std::vector<Driven> a;
  std::vector<VectorXd> at;
  for (const VectorXd& each : closed(mechanism)) {
    if (!(Of::drive_measure(Joints(each)) > least)) continue;
    at.push_back(each);
    q.emplace_back(each);
    a.push_back(picked<Driven>(each, mechanism.driven));
  }
  Timed t{};
  const auto timed = [&](const char* name, const auto& call) {
    const auto all = [&] {
      double total = 0;
      for (std::size_t i = 0; i < at.size(); ++i) total += call(i);
      return total;
    };
    return meter(std::string(Of::name) + " " + name, at.size(), all);
  };
  t.assemble = timed("assemble", [&](std::size_t i) { return Of::assemble(a[i])[0].q[0]; });
  t.follow =
      timed("follow", [&](std::size_t i) { return Of::follow(a[i] + Driven::Constant(tick), q[i]).q[0]; });
  if constexpr (Of::has_inverse)
    t.inverse = timed("inverse", [&](std::size_t i) { return Of::inverse(q[i])[0].q[0]; });
  t.rates = timed("rates", [&](std::size_t i) { return Of::rates(q[i])(0, 0); });
  const Driven force = Driven::Constant(0.7), still = Driven::Zero();
  t.dynamics = timed("dynamics", [&](std::size_t i) { return Of::dynamics(q[i], still, force)[0]; });
  if (meter.rounds == 0) return 0;
  if (with_peer) {
    MujocoLoops peer(mechanism);
    t.apart = difference<Of>(mechanism, peer, at);
    VectorXd all = VectorXd::Zero(at[0].size());
    for (const Eigen::Index joint : mechanism.driven) all[joint] = 0.7;
    t.peer = timed("MuJoCo", [&](std::size_t i) { return peer.forward(at[i], all)[0]; });
  }
  print(Of::name, t);
  return t.apart;
}

#ifdef QVGEN_MEASURES_STEWART
/// Measures a platform on six cylinders at random places. Paths to all of its places are longer for some
/// lengths than for others, so each input is timed by itself.
void measure_stewart(const Meter& meter) {
  namespace arm = qvgen::robots::stewart;
  constexpr std::size_t count = 48;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> slide(-0.15, 0.15), turn(-0.4, 0.4);
  std::vector<arm::Driven> places(count), legs(count);
  std::vector<arm::JointVector<double>> q(count);
  for (std::size_t i = 0; i < count; ++i) {
    places[i] << slide(random), slide(random), 0.5 + slide(random), turn(random), turn(random), turn(random);
    q[i] = arm::assemble_from_outputs(places[i])[0].q;
    legs[i] = q[i](arm::driven_joints);
  }
  const auto timed = [&](const char* name, const auto& call) {
    return meter(std::string("stewart ") + name, count, [&] {
      double total = 0;
      for (std::size_t i = 0; i < count; ++i) total += call(i);
      return total;
    });
  };
  const double inverse =
      timed("inverse", [&](std::size_t i) { return arm::assemble_from_outputs(places[i])[0].q[0]; });
  const double rates = timed("rates", [&](std::size_t i) { return arm::rates(q[i])(0, 0); });
  const double jacobian = timed("jacobian", [&](std::size_t i) { return arm::jacobian_of_top(q[i])(0, 0); });
  if (meter.rounds == 0) {
    timed("assemble", [&](std::size_t i) { return arm::assemble(legs[i])[0].q[0]; });
    return;
  }
  std::vector<double> each(count, 1e300);
  int rows = 0;
  for (int k = 0; k < std::min(meter.rounds, 10); ++k)
    for (std::size_t i = 0; i < count; ++i) {
      const auto start = Clock::now();
      const int found = arm::assemble(legs[i]).size();
      const std::chrono::duration<double, std::milli> time = Clock::now() - start;
      each[i] = std::min(each[i], time.count());
      rows += k == 0 ? found : 0;
    }
  std::sort(each.begin(), each.end());
  double mean = 0;
  for (const double time : each) mean += time / count;
  std::printf("stewart, ns a call: inverse %.0f, rates %.0f, Jacobian of the tip %.0f\n", inverse, rates,
              jacobian);
  std::printf("stewart, all places, ms a call: median %.1f, mean %.1f, slowest %.1f; %.1f real ones of 40\n",
              each[count / 2], mean, each.back(), static_cast<double>(rows) / count);
}
#endif

}  // namespace

int main(int count, char** arguments) {
  const bool counts = count > 1 && std::string(arguments[1]) == "--instructions";
  const Meter meter{counts ? 0 : count > 1 ? std::atoi(arguments[1]) : 200};
  if (!counts)
    std::printf("%-22s %9s %9s %9s %9s %9s %9s %9s\n", "ns a call", "assemble", "follow", "inverse", "rates",
                "dynamics", "MuJoCo", "ratio");
  double worst = 0;
#define QVGEN_MEASURE(Mechanism, has_peer) worst = std::max(worst, measure<Mechanism>(meter, has_peer));
  QVGEN_MEASURED(QVGEN_MEASURE)
#undef QVGEN_MEASURE
#ifdef QVGEN_MEASURES_STEWART
  measure_stewart(meter);
#endif
  if (!counts) std::printf("farthest from MuJoCo's accelerations: %.1e of them (sum %g)\n", worst, sum);
  return worst < 2e-3 && std::isfinite(sum) ? 0 : 1;
}
