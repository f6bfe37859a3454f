// SPDX-License-Identifier: MIT
// One library in the benchmark of trees: five functions of a robot at states that are made before. A call
// leaves its results where the library puts them; they are copied out only to be compared.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace qvgen::benchmark::trees {

inline constexpr std::size_t functions = 5;
inline constexpr std::array<const char*, functions> function_names{"ID", "M", "FD", "dID", "dFD"};
/// Matrices (or vectors, of one column) that each function returns; the columns of M are one matrix.
inline constexpr std::array<std::size_t, functions> matrices{0, 1, 0, 2, 3};

/// A state in Pinocchio's order: position and quaternion x y z w of the base where it floats, then joints.
struct State {
  std::vector<double> q, v, a;  ///< a: accelerations, or forces where a function takes those
};

struct Robot {
  std::size_t size;  ///< of velocities
  bool floating;
  std::vector<std::string> joints;  ///< of one coordinate each, in Pinocchio's order
  std::vector<State> states;
};

using Call = void (*)(std::size_t state);
/// Copies the results of the function's last call: n forces or accelerations, or the columns of n x n
/// matrices.
using Copy = void (*)(double* result);

struct Implementation {
  std::string name;
  std::array<Call, functions> calls;
  std::array<Copy, functions> copies;
  std::vector<std::size_t> place;  ///< among its velocities, of each of Pinocchio's
};

Implementation of_qvgen(const Robot& robot);
Implementation of_casadi(const Robot& robot);
/// Reads the model's numbers from the file.
Implementation of_pinocchio(const Robot& robot, const std::string& model);

}  // namespace qvgen::benchmark::trees
