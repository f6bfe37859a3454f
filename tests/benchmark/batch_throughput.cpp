// SPDX-License-Identifier: MIT
// Batches against single calls in a loop: time a configuration by size, scalar, instruction set and threads,
// and what the memory would allow. ./qvgen benchmark batches [LARGEST], 1000000 if not given.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <oneapi/tbb/global_control.h>
#include <qvgen/batch/threads.h>
#include <qvgen/robots/iiwa14/batch.h>
#include <qvgen/robots/puma560/batch.h>

#include "peaks.h"
#include "throughput.h"

namespace {

using qvgen::Batch;
using qvgen::InstructionSet;
using throughput::shortest;

/// Rows of numbers, the inputs of one function or its results.
template <class T>
struct Rows {
  std::size_t rows;
  std::vector<T> numbers;

  Rows(std::size_t rows_, std::size_t count) : rows(rows_), numbers(rows_ * count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-3, 3);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = i < 4096 ? static_cast<T>(number(random)) : numbers[i % 4096];
  }
  Batch<T> view() { return {numbers.data(), numbers.size() / rows}; }
};

/// One function: its rows, the batch form of a part, and single calls one after the other, from and to arrays
/// of structures.
template <class T>
struct Function {
  std::string name;
  std::size_t in, out;
  std::function<void(const Batch<const T>&, const Batch<T>&, InstructionSet)> form;
  std::function<T(const T*, std::size_t)>
      singles;  ///< the sum of a result's component: what nothing reads is left out
};

/// Row `first` and those behind it.
template <class T>
Batch<T> from_row(const Batch<T>& batch, std::size_t first) {
  return {batch.data + first * batch.stride, batch.count, batch.stride};
}

template <class T>
std::vector<Function<T>> functions() {
  namespace puma = qvgen::robots::puma560;
  namespace iiwa = qvgen::robots::iiwa14;
  const auto singles = [](auto dof, std::size_t rows, auto call) {
    return [rows, call](const T* numbers, std::size_t count) {
      constexpr int n = decltype(dof)::value;
      T sum = 0;
      for (std::size_t k = 0; k < count; ++k, numbers += rows) {
        using Vector = Eigen::Matrix<T, n, 1>;
        const auto column = [&](std::size_t i) { return Vector(Eigen::Map<const Vector>(numbers + i * n)); };
        sum += call(column);
      }
      return sum;
    };
  };
  using Six = std::integral_constant<int, 6>;
  using Seven = std::integral_constant<int, 7>;
  return {
      {"puma560 forward_kinematics", 6, 7,
       [](const auto& q, const auto& result, InstructionSet set) {
         puma::forward_kinematics(q, result, {}, set);
       },
       singles(Six{}, 6, [](auto in) { return puma::forward_kinematics<T>(in(0)).position.x(); })},
      {"puma560 jacobian", 6, 36,
       [](const auto& q, const auto& result, InstructionSet set) { puma::jacobian(q, result, {}, set); },
       singles(Six{}, 6, [](auto in) { return puma::jacobian<T>(in(0))(0, 0); })},
      {"puma560 inverse_dynamics", 18, 6,
       [](const auto& in, const auto& result, InstructionSet set) {
         puma::inverse_dynamics(in, from_row(in, 6), from_row(in, 12), result, {}, {}, T(9.81), set);
       },
       singles(Six{}, 18, [](auto in) { return puma::inverse_dynamics<T>(in(0), in(1), in(2))[0]; })},
      {"puma560 forward_dynamics", 18, 6,
       [](const auto& in, const auto& result, InstructionSet set) {
         puma::forward_dynamics(in, from_row(in, 6), from_row(in, 12), result, {}, {}, T(9.81), set);
       },
       singles(Six{}, 18, [](auto in) { return puma::forward_dynamics<T>(in(0), in(1), in(2))[0]; })},
      {"puma560 mass_matrix", 6, 36,
       [](const auto& q, const auto& result, InstructionSet set) {
         puma::mass_matrix(q, result, {}, {}, set);
       },
       singles(Six{}, 6, [](auto in) { return puma::mass_matrix<T>(in(0))(0, 0); })},
      {"iiwa14 forward_kinematics", 7, 7,
       [](const auto& q, const auto& result, InstructionSet set) {
         iiwa::forward_kinematics(q, result, {}, set);
       },
       singles(Seven{}, 7, [](auto in) { return iiwa::forward_kinematics<T>(in(0)).position.x(); })},
      {"iiwa14 inverse_dynamics", 21, 7,
       [](const auto& in, const auto& result, InstructionSet set) {
         iiwa::inverse_dynamics(in, from_row(in, 7), from_row(in, 14), result, {}, {}, T(9.81), set);
       },
       singles(Seven{}, 21, [](auto in) { return iiwa::inverse_dynamics<T>(in(0), in(1), in(2))[0]; })},
  };
}

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

/// What one core of the machine does in a second at most.
struct Machine {
  double bytes;
  double numbers[2];  ///< operations on doubles, on floats
};

Machine measure_machine() {
  const InstructionSet set = qvgen::widest_instruction_set();
  return {throughput::bandwidth(), {throughput::arithmetic<double>(set), throughput::arithmetic<float>(set)}};
}

/// What bounds a function whose numbers come from memory: the longer of the times that they and the
/// arithmetic take at the least.
std::string roof(double bytes, double work, double moved, double computed) {
  const double memory = 1e9 * bytes / moved, arithmetic = 1e9 * work / computed;
  return fmt::format(
      "{:.0f} operations, {:.1f} a byte; at least {:.2f} ns in memory, {:.2f} ns in arithmetic: {} bound",
      work, work / bytes, memory, arithmetic, memory > arithmetic ? "bandwidth" : "compute");
}

template <class T>
void measure(const char* scalar, std::size_t largest, const Machine& machine) {
  const double copied = machine.bytes, computed = machine.numbers[std::is_same_v<T, float> ? 1 : 0];
  for (const Function<T>& function : functions<T>()) {
    Rows<T> some(function.in, 1000);
    volatile T sink = 0;
    const double single = shortest([&] { sink = function.singles(some.numbers.data(), 1000); }) / 1000;
    const double bytes = static_cast<double>((function.in + function.out) * sizeof(T));
    fmt::print("{} {}: {} bytes a configuration, single calls {:.1f} ns; {}\n", function.name, scalar, bytes,
               single * 1e9, roof(bytes, operations(function.name), copied, computed));
    for (std::size_t count = 1; count <= largest; count *= 10) {
      Rows<T> in(function.in, count), out(function.out, count);
      const Batch<const T> given = in.view();
      const Batch<T> result = out.view();
      const auto time = [&](InstructionSet set) {
        return shortest([&] { function.form(given, result, set); }) / static_cast<double>(count);
      };
      const double avx2 = time(InstructionSet::avx2), widest = time(qvgen::widest_instruction_set());
      const double threads = shortest([&] {
                               qvgen::in_threads(count, [&](std::size_t first, std::size_t part) {
                                 function.form(given.part(first, part), result.part(first, part),
                                               qvgen::widest_instruction_set());
                               });
                             }) /
                             static_cast<double>(count);
      fmt::print(
          "{:>10}  AVX2 {:8.2f} ns ({:4.1f} x)   widest {:8.2f} ns ({:4.1f} x)   threads {:8.2f} ns ({:4.1f} "
          "x)"
          "   {:3.0f} % of a copy's bandwidth, {:3.0f} % of the arithmetic\n",
          count, avx2 * 1e9, single / avx2, widest * 1e9, single / widest, threads * 1e9, single / threads,
          100 * bytes / widest / copied, 100 * operations(function.name) / widest / computed);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t largest = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
  const Machine machine = measure_machine();
  fmt::print(
      "one core: a copy in memory moves {:.1f} GB/s, {:.1f} G operations a second on doubles, {:.1f} on "
      "floats; "
      "{} threads\n",
      machine.bytes / 1e9, machine.numbers[0] / 1e9, machine.numbers[1] / 1e9,
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  for (const std::size_t poses : {1000U, 10000U, 1000000U}) {
    if (poses > largest) continue;
    fmt::print("all solutions of {} poses: share at the boundary of reach, ns a pose singly and in batches\n",
               poses);
    for (const auto measure_arm : throughput::inverse_of_arms()) measure_arm(poses);
  }
  measure<double>("double", largest, machine);
  measure<float>("float", largest, machine);
  return 0;
}
