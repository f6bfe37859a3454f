// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

namespace qvgen {

/// Lets oneTBB's threads share a batch: calls `body(first, count)` for parts that together are 0 ... count -
/// 1, several at a time. Link TBB::tbb; who does not include this header needs no such library.
///
///     qvgen::in_threads(q.count, [&](std::size_t first, std::size_t count) {
///       arm::forward_kinematics(q.part(first, count), poses.part(first, count));
///     });
///
/// Parts begin at multiples of `grain`: no cache line of an aligned batch is written by two threads. How many
/// threads there are is the caller's to say, with a tbb::task_arena or tbb::global_control.
template <class Body>
void in_threads(std::size_t count, const Body& body, std::size_t grain = 1024) {
  const std::size_t blocks = (count + grain - 1) / grain;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      const std::size_t first = range.begin() * grain;
                      body(first, std::min(range.end() * grain, count) - first);
                    });
}

}  // namespace qvgen
