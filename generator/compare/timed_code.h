// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "dag/counts.h"
#include "dag/graph.h"

namespace qvgen::compare {

/// A function as plain C++ to be timed: its body, with arguments and the robot's numbers in x, results in y,
/// a statement an operation. What is free (numbers of the robot alone) is one of the numbers in x.
struct TimedCode {
  std::string body;
  std::vector<std::string> inputs = {};  ///< what stands in x: symbols, and "number ..." for what is free
  int outputs = 0;
};
TimedCode timed_code(const dag::Function& function, const dag::IsFree& is_free);

/// Returns the code as a C++ function of a name.
std::string cpp_function(const TimedCode& code, const std::string& name);

/// A program that calls each body in turn, `rounds` times over, and prints a line for each: the median and
/// the quartiles of the nanoseconds of a call.
std::string timing_program(const std::vector<TimedCode>& codes, int rounds);

}  // namespace qvgen::compare
