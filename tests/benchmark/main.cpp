// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "reference/load.h"
#include "suite.h"
#include "table.h"

namespace comparison {
namespace {

// Filled while static objects are built, so it must not be one that may come later.
std::vector<std::function<void()>>& setups() {
  static std::vector<std::function<void()>> all;
  return all;
}

}  // namespace

std::string description_of(const std::string& robot) {
  return QVGEN_SOURCE_DIR "/generator/robots/" + robot + ".toml";
}

reference::Chain load_robot(const std::string& robot) { return reference::load(description_of(robot)); }

void add_setup(std::function<void()> setup) { setups().push_back(std::move(setup)); }

void add_benchmark(const std::string& name, std::function<void(benchmark::State&)> body) {
  // The fastest of many short repetitions is what the machine does when nobody else uses it.
  benchmark::RegisterBenchmark(name.c_str(), std::move(body))->Repetitions(10)->MinTime(0.02);
}

void require_agreement(const std::string& robot, double difference) {
  std::fprintf(stderr, "%s: implementations agree to %.1e\n", robot.c_str(), difference);
  if (!(difference < 1e-12)) std::exit(1);
}

}  // namespace comparison

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const auto& setup : comparison::setups()) setup();
  comparison::Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  benchmark::Shutdown();
  return 0;
}
