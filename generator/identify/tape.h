// SPDX-License-Identifier: MIT
// A function of the graph as a straight list of instructions over columns: each works on a block of samples
// at once, so that looking up the next instruction costs little, and no compiler is needed. A value that has
// been read for the last time leaves its slot to the next one, so that a block stays in the processor's
// cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "dag/graph.h"

namespace qvgen::identify {

/// Values of symbols that do not change along a log.
using Known = std::map<std::string, double>;

/// Returns the value of a symbol from `known` or from its name, if it is a named constant. Throws
/// std::runtime_error if it has none.
double value_of_symbol(const std::string& name, const Known& known);

/// Returns the outputs of a function all of whose symbols are known or named constants.
std::vector<double> values_of(const dag::Function& function, const Known& known);

class Tape {
 public:
  /// Samples that an instruction works on at once.
  static constexpr std::size_t block = 64;

  /// `inputs` are the symbols that change along a log, in the order of their columns.
  Tape(const dag::Function& function, const std::vector<std::string>& inputs, const Known& known);

  /// Memory of one thread: a block for each slot, constants filled in.
  [[nodiscard]] std::vector<double> workspace() const;
  /// Computes all outputs. The first blocks of the workspace are the inputs, to be filled before.
  void run(std::vector<double>& workspace) const;
  /// Copies `count` values of an output.
  void copy(const std::vector<double>& workspace, std::size_t output, std::size_t count, double* to) const;
  /// True if the output is zero for every input.
  [[nodiscard]] bool vanishes(std::size_t output) const { return outputs_[output].zero; }
  [[nodiscard]] std::size_t size() const { return instructions_.size(); }

 private:
  enum class Kind : std::uint8_t {
    add,
    subtract,
    minus_sum,
    multiply,
    divide,
    negate,
    root,
    arctangent,
    sine,
    cosine
  };
  struct Instruction {
    Kind kind;
    std::uint32_t to, a, b;  ///< slots; of sine and cosine `a` is the number of the angle
  };
  /// A constant plus inputs times factors, in radians.
  struct Angle {
    double constant = 0;
    std::vector<std::pair<std::uint32_t, double>> terms;
  };
  struct Output {
    std::uint32_t slot = 0;
    bool negative = false, zero = false;
  };
  class Compiler;

  void run(const Instruction& instruction, double* values) const;
  void turn(const Angle& angle, bool sine, const double* values, double* to) const;

  std::size_t slots_ = 0;
  std::vector<std::pair<std::uint32_t, double>> constants_;  ///< slot and value
  std::vector<Angle> angles_;
  std::vector<Instruction> instructions_;
  std::vector<Output> outputs_;
};

}  // namespace qvgen::identify
