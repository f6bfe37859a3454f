// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace qvgen::pipeline {

/// Most that one piece of work may use. A last resort: what is derived bounds its own work first. A build
/// with sanitizers has more of both.
struct Budget {
  std::uint64_t seconds = 20;      ///< of processor time
  std::uint64_t megabytes = 1024;  ///< of address space
};

/// Runs the work in a child process with a budget and returns its exit code; the child goes on as this
/// program would, so that its output and its exceptions are the program's own. Throws std::runtime_error with
/// `what` and the reason if the budget ends it. To be called once, before anything is printed.
int bounded(const std::string& what, const Budget& budget, const std::function<int()>& work);

/// The budget that a worker itself has, for workers of its own.
Budget own_budget();

/// Outcome of a piece of work.
struct Outcome {
  bool done = false;
  std::string text;  ///< what it returned, or why it has not
};

/// work(0) ... work(count - 1) on all cores, outcomes in order.
///
/// Each in a process of its own, not in threads: neither GiNaC nor CLN may be used by two threads at once,
/// and one that dies or exceeds its budget takes no other with it. `progress` is told each finished index.
std::vector<Outcome> in_processes(std::size_t count, const std::function<std::string(std::size_t)>& work,
                                  const Budget& budget = {},
                                  const std::function<void(std::size_t)>& progress = {});

}  // namespace qvgen::pipeline
