// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace qvgen::pipeline {

/// work(0) ... work(count - 1) on all cores, results in order.
///
/// In processes, not threads: neither GiNaC nor CLN may be used by two threads at once. An exception in
/// `work` becomes a std::runtime_error with its text here; `progress` is told each finished index as it
/// comes.
std::vector<std::string> in_processes(std::size_t count, const std::function<std::string(std::size_t)>& work,
                                      const std::function<void(std::size_t)>& progress = {});

}  // namespace qvgen::pipeline
