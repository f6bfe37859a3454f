// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include <qvgen/robots/iiwa14/batch.h>
#include <qvgen/robots/puma560/batch.h>

/// Functions whose throughput is measured.
namespace throughput {

using qvgen::Batch;
using qvgen::InstructionSet;

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
      {"iiwa14 forward_dynamics", 21, 7,
       [](const auto& in, const auto& result, InstructionSet set) {
         iiwa::forward_dynamics(in, from_row(in, 7), from_row(in, 14), result, {}, {}, T(9.81), set);
       },
       singles(Seven{}, 21, [](auto in) { return iiwa::forward_dynamics<T>(in(0), in(1), in(2))[0]; })},
      {"iiwa14 inverse_dynamics_derivatives", 21, 105,
       [](const auto& in, const auto& result, InstructionSet set) {
         iiwa::inverse_dynamics_derivatives(in, from_row(in, 7), from_row(in, 14), result, {}, {}, T(9.81),
                                            set);
       },
       singles(
           Seven{}, 21,
           [](auto in) { return iiwa::inverse_dynamics_derivatives<T>(in(0), in(1), in(2)).by_rate(0, 0); })},
  };
}

}  // namespace throughput
