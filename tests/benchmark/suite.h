// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include <benchmark/benchmark.h>

#include "reference/chain.h"

namespace comparison {

/// The file that describes a robot of the project, and what it says.
std::string description_of(const std::string& robot);
reference::Chain load_robot(const std::string& robot);

/// To be run once main has begun, in the order of names.
void add_setup(std::function<void()> setup);

/// A benchmark named "quantity/robot/variant": one row of the table for quantity and robot, one column a
/// variant.
void add_benchmark(const std::string& name, std::function<void(benchmark::State&)> body);

/// Calls of the same variant, `counted_calls` of them, whose instructions can be counted (instructions.sh).
inline constexpr int counted_calls = 256;
void add_counted(const std::string& name, std::function<void()> calls);

/// Ends the program if two implementations differ by more than 1e-12: their times could not be compared.
void require_agreement(const std::string& robot, double difference);

}  // namespace comparison
