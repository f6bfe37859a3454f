// SPDX-License-Identifier: MIT
// Batches against single calls and other libraries in a loop: time a configuration by size, scalar,
// instruction set and threads, and what the memory would allow. ./qvgen benchmark batches [LARGEST], 10000000
// if not given.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for_each.h>
#include <qvgen/batch/threads.h>

#include "batch_functions.h"
#include "batch_peers.h"
#include "peaks.h"
#include "throughput.h"

namespace {

using namespace throughput;

/// Most that one core of the machine does in a second.
struct Machine {
  double bytes;
  double numbers[2];  ///< operations on doubles, on floats
};

struct PeerTime {
  std::string name;
  double one_thread, threads;
};

/// Measurements of a function in one scalar.
struct Measured {
  std::string name;
  double bytes, operations;              ///< a configuration
  std::map<std::size_t, Times> batches;  ///< by their size
  std::vector<PeerTime> peers;
};

/// Products, sums, quotients and roots a configuration; a sine and cosine in a lane
/// takes 22, in double; what is fused counts once, as in time.
double operations(const std::string& robot_and_function) {
  static const nlohmann::json counts =
      nlohmann::json::parse(std::ifstream(QVGEN_SOURCE_DIR "/generated/operation_counts.json"));
  const std::size_t space = robot_and_function.find(' ');
  const auto& emitted =
      counts.at(robot_and_function.substr(0, space)).at(robot_and_function.substr(space + 1)).at("emitted");
  constexpr double of_angle = 22;
  double sum = of_angle * emitted.at("sincos").get<double>();
  for (const char* kind : {"mul", "add", "div", "sqrt"}) sum += emitted.at(kind).get<double>();
  return sum;
}

Machine measure_machine() {
  const InstructionSet set = qvgen::widest_instruction_set();
  return {bandwidth(), {arithmetic<double>(set), arithmetic<float>(set)}};
}

/// A batch of 1000 by the form.
std::vector<double> results_of(const Function<double>& function, Rows<double>& in) {
  Rows<double> out(function.out, 1000);
  function.form(Batch<const double>(in.view()), out.view(), qvgen::widest_instruction_set());
  return out.numbers;
}

/// Ends the program if a library differs in what both write down alike: times could not be compared.
void require_agreement(const Function<double>& function, const Peer& peer, const PeerCall& call) {
  Rows<double> in(function.in, 1000);
  const std::vector<double> results = results_of(function, in);
  // Libraries have the position of a pose first, the batch behind the quaternion.
  const bool is_pose = function.name.find("kinematics") != std::string::npos;
  const std::size_t first = is_pose ? 4 : 0, rows = is_pose ? 3 : function.out;
  double worst = 0;
  std::vector<double> column(function.in);
  for (std::size_t k = 0; k < 1000; ++k) {
    for (std::size_t i = 0; i < function.in; ++i) column[i] = in.numbers[i * 1000 + k];
    const double* theirs = call(column.data());
    double largest = 1;
    for (std::size_t i = 0; i < rows; ++i) largest = std::max(largest, std::abs(theirs[i]));
    for (std::size_t i = 0; i < rows; ++i)
      worst = std::max(worst, std::abs(theirs[i] - results[(first + i) * 1000 + k]) / largest);
  }
  if (worst < 1e-9) return;
  fmt::print("{}: {} differs by {}\n", function.name, peer.name, worst);
  std::exit(1);
}

/// A library in a loop over arrays of structures, on one thread and on all, each with an arm of its own.
PeerTime measure_peer(const Function<double>& function, const Peer& peer) {
  constexpr std::size_t count = 1000, repeats = 20;
  const int threads =
      static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  Rows<double> some(function.in, count);
  std::vector<PeerCall> calls;
  for (int i = 0; i < threads; ++i) calls.push_back(peer.make());
  require_agreement(function, peer, calls[0]);
  const auto loop = [&](const PeerCall& call) {
    volatile double sink = 0;  // what nothing reads is left out
    for (std::size_t r = 0; r < repeats; ++r)
      for (std::size_t k = 0; k < count; ++k) sink = sink + *call(some.numbers.data() + k * function.in);
  };
  const double one = shortest([&] { loop(calls[0]); });
  const double all = shortest([&] { tbb::parallel_for_each(calls, loop); });
  return {peer.name, one / (count * repeats), all / (count * repeats * static_cast<double>(threads))};
}

/// How many configurations: powers of ten, and one of two, with which rows share sets of the cache.
std::vector<std::size_t> sizes(std::size_t largest) {
  std::vector<std::size_t> list;
  for (std::size_t count = 1; count <= largest; count *= 10) {
    list.push_back(count);
    if (count == 1000) list.push_back(1024);
  }
  return list;
}

/// One batch of that size. What is larger than 1 GB comes in blocks of that, the same memory again and again.
template <class T>
Times measure_batch(const Function<T>& function, std::size_t count, double single) {
  const std::size_t bytes = (function.in + function.out) * sizeof(T);
  const std::size_t held = std::min(count, std::size_t(1000000000) / bytes);
  Rows<T> in(function.in, held), out(function.out, held);
  const Batch<const T> given = in.view();
  const Batch<T> result = out.view();
  const auto blocks = [&](const auto& work) {
    const auto all = [&] {
      for (std::size_t first = 0; first < count; first += held) work(std::min(held, count - first));
    };
    return shortest(all) / static_cast<double>(count);
  };
  Times times{single, {}, 0};
  for (const Lanes& lanes : lanes_of_machine())
    times.batch.push_back(blocks(
        [&](std::size_t part) { function.form(given.part(0, part), result.part(0, part), lanes.set); }));
  times.threads = blocks([&](std::size_t block) {
    qvgen::in_threads(block, [&](std::size_t first, std::size_t part) {
      function.form(given.part(first, part), result.part(first, part), qvgen::widest_instruction_set());
    });
  });
  return times;
}

template <class T>
Measured measure(const Function<T>& function, std::size_t largest) {
  Rows<T> some(function.in, 1000);
  volatile T sink = 0;
  Measured result{function.name,
                  static_cast<double>((function.in + function.out) * sizeof(T)),
                  operations(function.name),
                  {},
                  {}};
  const double single = shortest([&] { sink = function.singles(some.numbers.data(), 1000); }) / 1000;
  if constexpr (std::is_same_v<T, double>)
    for (const Peer& peer : peers_of(function.name)) result.peers.push_back(measure_peer(function, peer));
  for (const std::size_t count : sizes(largest))
    result.batches[count] = measure_batch(function, count, single);
  return result;
}

/// A column for each size.
template <class Time>
void print_line(const std::string& head, const std::map<std::size_t, Times>& batches, const Time& time) {
  fmt::print("{:<51}", head);
  for (const auto& [count, times] : batches) fmt::print("{:9.2f}", 1e9 * time(times));
  fmt::print("\n");
}

/// A line for each instruction set, the first with the time of a single call, and one for all threads.
void print_sizes(const std::string& name, const std::map<std::size_t, Times>& batches) {
  const std::vector<Lanes> sets = lanes_of_machine();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::string what = fmt::format("{:<36}{:<8}", i == 0 ? name : "", sets[i].name);
    const std::string single = i == 0 ? fmt::format("{:7.1f}", 1e9 * batches.at(1000).single) : "";
    print_line(what + single, batches, [i](const Times& times) { return times.batch[i]; });
  }
  print_line(fmt::format("{:<36}threads", ""), batches, [](const Times& times) { return times.threads; });
}

void print_head(const std::string& what, std::size_t largest) {
  fmt::print("\n{:<44}{:>7}", what + ", ns", "single");
  for (const std::size_t count : sizes(largest)) fmt::print("{:>9}", count);
  fmt::print("\n");
}

void print_ratio(const Measured& one, const std::string& library, double PeerTime::*time, double ours) {
  const auto is_it = [&](const PeerTime& peer) { return peer.name == library; };
  const auto peer = std::find_if(one.peers.begin(), one.peers.end(), is_it);
  fmt::print("{:>13}", peer == one.peers.end() ? "-" : fmt::format("{:.0f}", (*peer).*time / ours));
}

/// Against single calls, and against libraries on as many threads.
void print_ratios(const std::vector<Measured>& all, std::size_t largest) {
  const std::size_t many = std::min<std::size_t>(100000, largest);
  fmt::print("\n1000 configurations on one thread, {} on all: times as fast as\n{:<36}{:>13}", many, "",
             "single calls");
  for (const char* library : {"KDL", "MuJoCo", "KDL, all", "MuJoCo, all"}) fmt::print("{:>13}", library);
  fmt::print("\n");
  for (const Measured& one : all) {
    const Times &some = one.batches.at(1000), &most = one.batches.at(many);
    fmt::print("{:<36}{:13.1f}", one.name, some.single / some.widest());
    for (const char* library : {"KDL", "MuJoCo"})
      print_ratio(one, library, &PeerTime::one_thread, some.widest());
    for (const char* library : {"KDL", "MuJoCo"}) print_ratio(one, library, &PeerTime::threads, most.threads);
    fmt::print("\n");
  }
}

/// Prints the bound of functions whose numbers come from memory: the longer of the times that they and the
/// arithmetic take at the least.
void print_roofline(const std::vector<Measured>& all, double moved, double computed,
                    const std::string& scalar) {
  fmt::print("\n{:<37}{:>6}{:>12}{:>8}{:>9}{:>12}{:>9}{:>12}   bound from memory by\n", scalar, "bytes",
             "operations", "a byte", "memory", "arithmetic", "is, ns", "of peak, %");
  for (const Measured& one : all) {
    const double memory = one.bytes / moved, work = one.operations / computed,
                 is = one.batches.at(1000).widest();
    fmt::print("{:<37}{:6.0f}{:12.0f}{:8.1f}{:9.2f}{:12.2f}{:9.2f}{:12.0f}   {}\n", one.name, one.bytes,
               one.operations, one.operations / one.bytes, 1e9 * memory, 1e9 * work, 1e9 * is,
               100 * work / is, memory > work ? "bandwidth" : "computing");
  }
}

/// All solutions of 1000 poses by the share of doubtful ones: a column for single calls, one for each
/// instruction set.
void measure_doubtful() {
  const double shares[] = {0, 0.01, 0.1, 1};
  const std::vector<Lanes> sets = lanes_of_machine();
  fmt::print("\nns of single calls, and times as fast as they are, 1000 poses\n{:<10}", "in doubt");
  for (const double share : shares) fmt::print("{:>{}.0f} %", 100 * share, 6 + 8 * sets.size());
  fmt::print("\n{:<10}", "");
  for ([[maybe_unused]] const double share : shares) {
    fmt::print("{:>8}", "single");
    for (const Lanes& lanes : sets) fmt::print("{:>8}", lanes.name);
  }
  fmt::print("\n");
  for (const InverseOfArm& arm : inverse_of_arms()) {
    fmt::print("{:<10}", arm.name);
    for (const double share : shares) {
      const Times times = arm.measure(1000, share);
      fmt::print("{:8.0f}", 1e9 * times.single);
      for (const double batch : times.batch) fmt::print("{:8.1f}", times.single / batch);
    }
    fmt::print("\n");
  }
}

/// All solutions of poses, by the number of poses, and by the share of doubtful ones.
void measure_inverse(std::size_t largest) {
  print_head("all solutions of poses", largest);
  for (const InverseOfArm& arm : inverse_of_arms()) {
    std::map<std::size_t, Times> batches;
    for (const std::size_t count : sizes(largest)) batches[count] = arm.measure(count, 0);
    print_sizes(arm.name, batches);
  }
  measure_doubtful();
}

template <class T>
void measure_all(const std::string& scalar, std::size_t largest, const Machine& machine) {
  std::vector<Measured> all;
  for (const Function<T>& function : functions<T>()) all.push_back(measure(function, largest));
  print_head(scalar, largest);
  for (const Measured& one : all) print_sizes(one.name, one.batches);
  if (!all.front().peers.empty()) print_ratios(all, largest);
  print_roofline(all, machine.bytes, machine.numbers[std::is_same_v<T, float> ? 1 : 0], scalar);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t largest =
      std::max<std::size_t>(1000, argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000000);
  const Machine machine = measure_machine();
  fmt::print(
      "one core: a copy in memory moves {:.1f} GB/s, {:.1f} G operations a second on doubles, {:.1f} on "
      "floats; "
      "{} threads\n",
      machine.bytes / 1e9, machine.numbers[0] / 1e9, machine.numbers[1] / 1e9,
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  measure_inverse(largest);
  measure_all<double>("double", largest, machine);
  measure_all<float>("float", largest, machine);
  return 0;
}
