// SPDX-License-Identifier: MIT
// Work on the samples of a log, chunk by chunk on all cores. Chunks are the same for any number of threads,
// and so are the results.
#pragma once

#include <algorithm>
#include <future>
#include <thread>
#include <vector>

#include <Eigen/Core>

namespace qvgen::identify {

/// Samples of a chunk, which one thread goes through.
inline constexpr Eigen::Index chunk = 8192;

/// Returns work(first, last) of all chunks of samples, in the order of the chunks; none for less than one
/// sample.
template <class Work>
auto in_chunks(Eigen::Index samples, const Work& work) {
  using Eigen::Index;
  using Result = decltype(work(Index(0), Index(0)));
  const Index chunks = (std::max<Index>(0, samples) + chunk - 1) / chunk;
  std::vector<Result> results(static_cast<std::size_t>(chunks));
  const auto work_at = [&](Index k) {
    results[static_cast<std::size_t>(k)] = work(k * chunk, std::min(samples, (k + 1) * chunk));
  };
  if (chunks == 1) work_at(0);  // a thread for each piece of a log with many gaps would cost more
  if (chunks <= 1) return results;
  const auto threads = std::clamp<Index>(std::thread::hardware_concurrency(), 1, chunks);
  std::vector<std::future<void>> running;
  for (Index thread = 0; thread < threads; ++thread)
    running.push_back(std::async(std::launch::async, [&, thread] {
      for (Index k = thread; k < chunks; k += threads) work_at(k);
    }));
  for (auto& each : running) each.get();
  return results;
}

}  // namespace qvgen::identify
