// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <thread>

#include <qvgen/map/evaluate.h>

// The program that `qvgen map` compiles for an arm and runs. Its arguments are the plan and how many threads;
// on its input stand numbers of blocks, on its output come the blocks, each as it is finished: its number,
// four bytes, then its cells.
namespace qvgen::map {

inline Plan plan_of(char** words) {
  const auto number = [&](int i) { return std::strtod(words[i], nullptr); };
  const auto count = [&](int i) { return static_cast<std::size_t>(std::strtoull(words[i], nullptr, 10)); };
  Plan plan;
  plan.sphere = {{number(0), number(1), number(2)}, number(3), number(4)};
  plan.targets = count(5);
  plan.values = count(6);
  plan.lower = number(7);
  plan.upper = number(8);
  plan.limits = count(9) != 0;
  return plan;
}

inline std::vector<int> blocks_of_input() {
  std::vector<int> blocks;
  for (int block = 0; std::scanf("%d", &block) == 1;) blocks.push_back(block);
  return blocks;
}

/// Writes cells of a block; false if the file could not be written.
inline bool put(std::FILE* to, int block, const std::vector<Cell>& cells) {
  const auto number = static_cast<std::uint32_t>(block);
  return std::fwrite(&number, sizeof number, 1, to) == 1 &&
         std::fwrite(cells.data(), sizeof(Cell), cells.size(), to) == cells.size() && std::fflush(to) == 0;
}

template <class Arm>
int run(int argc, char** argv) {
  if (argc != 12) return 2;
  const Plan plan = plan_of(argv + 1);
  const Grid grid(plan.sphere);
  const std::vector<int> blocks = blocks_of_input();
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex writing;
  const auto work = [&] {
    const auto evaluation = std::make_unique<Evaluation<Arm>>(grid, plan);
    for (std::size_t i = next++; i < blocks.size() && !failed; i = next++) {
      const std::vector<Cell>& cells = evaluation->block(blocks[i]);
      const std::lock_guard<std::mutex> lock(writing);
      if (!failed && !put(stdout, blocks[i], cells)) failed = true;
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < std::atoi(argv[11]); ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  return failed ? 1 : 0;
}

}  // namespace qvgen::map
