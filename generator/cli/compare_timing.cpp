// SPDX-License-Identifier: MIT
#include "cli/compare_timing.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/progress_line.h"
#include "toolchain/build.h"
#include "toolchain/workshop.h"

namespace qvgen::cli {
namespace {

const std::vector<std::string> options{"-O2", "-DNDEBUG", "-w"};

/// Median and quartiles of each function, as the program printed them.
std::vector<compare::Time> times_of(const std::vector<compare::TimedCode>& codes, int rounds) {
  const toolchain::Workshop workshop;
  workshop.write("timed.cpp", compare::timing_program(codes, rounds));
  const auto file = workshop.folder() / "timed.cpp";
  const auto program = workshop.folder() / "timed";
  const auto built = toolchain::build({toolchain::cxx_compiler(), options, {{file}}}, program);
  if (!built.done) throw std::runtime_error("the benchmark does not compile: " + built.said);
  const auto ran = toolchain::run({program.string()});
  if (!ran.done) throw std::runtime_error("the benchmark does not run: " + ran.said);
  std::vector<compare::Time> times;
  std::istringstream lines(ran.said);
  for (compare::Time time; lines >> time.median >> time.lower >> time.upper;) times.push_back(time);
  if (times.size() != codes.size()) throw std::runtime_error("the benchmark has said: " + ran.said);
  return times;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(": ") + 2);
  return "processor unknown";
}

}  // namespace

void take_times(std::vector<compare::Row>& rows, int rounds) {
  if (const std::string missing = toolchain::missing(toolchain::cxx_compiler()); !missing.empty())
    throw std::runtime_error("--time: " + missing);
  std::vector<std::vector<compare::TimedCode>> robots;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].robot != rows[i - 1].robot) robots.emplace_back();
    robots.back().push_back(rows[i].code.value());
  }
  ProgressLine progress(robots.size());
  std::vector<compare::Time> times;
  for (const auto& codes : robots) {
    const auto more = times_of(codes, rounds);
    times.insert(times.end(), more.begin(), more.end());
    progress.finished(rows[times.size() - 1].robot);
  }
  compare::set_times(rows, times);
}

std::string machine_text() {
  const auto compiler = toolchain::cxx_compiler();
  const auto version = toolchain::run({compiler.back(), "-dumpfullversion", "-dumpversion"});
  std::string number = version.done ? version.said : "";
  while (!number.empty() && number.back() == '\n') number.pop_back();
  return fmt::format("{}; {} {} -O2", processor(), fmt::join(compiler, " "), number);
}

}  // namespace qvgen::cli
