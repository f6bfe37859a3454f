// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include <valgrind/callgrind.h>

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

std::vector<std::pair<std::string, std::function<void()>>>& counted() {
  static std::vector<std::pair<std::string, std::function<void()>>> all;
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

void add_counted(const std::string& name, std::function<void()> calls) {
  counted().emplace_back(name, std::move(calls));
}

/// One dump of callgrind's for each variant whose name contains the text.
int count_instructions(const std::string& text) {
  for (const auto& setup : setups()) setup();
  for (const auto& [name, calls] : counted()) {
    if (name.find(text) == std::string::npos) continue;
    calls();  // once before, for what is done at the first call only
    CALLGRIND_ZERO_STATS;
    calls();
    CALLGRIND_DUMP_STATS_AT(name.c_str());
  }
  return 0;
}

void require_agreement(const std::string& robot, double difference) {
  std::fprintf(stderr, "%s: implementations agree to %.1e\n", robot.c_str(), difference);
  if (!(difference < 1e-12)) std::exit(1);
}

}  // namespace comparison

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "--instructions")
    return comparison::count_instructions(argc > 2 ? argv[2] : "");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const auto& setup : comparison::setups()) setup();
  comparison::Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  benchmark::Shutdown();
  return 0;
}
