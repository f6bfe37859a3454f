// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <numbers>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/commands.h"
#include "cli/origin.h"
#include "cli/progress_line.h"
#include "cli/suggestion.h"
#include "map/arm_program.h"
#include "map/sphere.h"
#include "map/write.h"
#include "pipeline/files.h"
#include "pipeline/folder_state.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;
using map::Grid;

/// Values of a joint that is given, tried for every orientation.
constexpr std::size_t given_values = 16;

void check_outputs(const MapArguments& arguments) {
  for (const fs::path& output : arguments.outputs) {
    const std::string suffix = output.extension().string();
    if (!map::is_suffix(suffix))
      throw UsageError(
          fmt::format("'{}' has no suffix that says what to write: {}", output.string(), map::suffixes));
    if (!arguments.blocks.empty() && suffix != ".part")
      throw UsageError("--blocks makes a part of a map: call it .part, and put parts together with --merge");
  }
}

/// 0 ... 999, as FIRST:LAST or one number.
std::vector<int> blocks_of(const std::string& text) {
  int first = 0, last = Grid::blocks - 1;
  char rest = 0;
  const auto refuse = [&] {
    throw UsageError(fmt::format("--blocks {}: the blocks of a map are 0 to {}; name FIRST:LAST of them",
                                 text, Grid::blocks - 1));
  };
  if (!text.empty()) {
    const int read = std::sscanf(text.c_str(), "%d:%d%c", &first, &last, &rest);
    const bool one = read == 1 && text.find_first_not_of("0123456789") == std::string::npos;
    if (one) last = first;
    if (!one && read != 2) refuse();
  }
  if (first < 0 || last >= Grid::blocks || first > last) refuse();
  std::vector<int> blocks;
  for (int block = first; block <= last; ++block) blocks.push_back(block);
  return blocks;
}

/// A map that does not fit is refused before anything is computed.
void check_size(const map::Sphere& sphere, const MapArguments& arguments) {
  // Beyond a bound that no machine has room for, so that what is said of it stays a number.
  const double ratio = std::min(sphere.radius / sphere.resolution, 1e7);
  const double edge = 2 * std::floor(ratio) + 1;
  const double cells = 4 * std::numbers::pi / 3 * ratio * ratio * ratio;
  const double blocks = static_cast<double>(blocks_of(arguments.blocks).size()) / Grid::blocks;
  const bool whole = arguments.blocks.empty();  // files of whole maps are made in memory
  const double bytes = blocks * cells * sizeof(map::Cell) + edge * edge * (whole ? edge * 40 : 8);
  const double memory =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE));
  if (bytes <= memory) return;
  throw std::runtime_error(fmt::format(
      "cells of {:g} m in a sphere of {:.3g} m are {:.2g} positions or more, whose map takes {:.2g} GB of "
      "memory; this machine has {:.3g} GB: --resolution {:.2g} would fit",
      sphere.resolution, sphere.radius, cells, bytes / 1e9, memory / 1e9,
      sphere.radius / ratio * std::cbrt(bytes / memory) * 1.05));
}

/// A round number of metres, two digits long, about a twentieth of the reach.
double default_resolution(double reach) {
  const double unit = std::pow(10, std::floor(std::log10(reach / 20)) - 1);
  return std::round(reach / 20 / unit) * unit;
}

/// All of a map that its program need not be known for.
map::About about_of(const MapArguments& arguments, const model::Robot& robot, const report::Chain& chain) {
  map::About about;
  about.robot = robot.name;
  about.title = robot.title;
  about.own_reach = arguments.reach == 0;
  about.limits_known = std::any_of(chain.joints.begin(), chain.joints.end(),
                                   [](const report::ChainJoint& joint) { return joint.limits.has_value(); });
  if (arguments.limits && !about.limits_known)
    throw std::runtime_error("--limits: the description of " + robot.name + " has no joint limits");
  if (!chain.assumed.empty())
    throw std::runtime_error(chain.assumed.front() +
                             " has no value: a map is of numbers; write one under [defaults]");
  map::Sphere& sphere = about.plan.sphere;
  sphere = map::sphere_of(chain, arguments.reach > 0 ? std::optional<double>(arguments.reach) : std::nullopt);
  sphere.resolution = arguments.resolution > 0 ? arguments.resolution : default_resolution(sphere.radius);
  check_size(sphere, arguments);
  about.plan.limits = arguments.limits;
  return about;
}

void add_program(const MapArguments& arguments, const report::Chain& chain, const map::ArmProgram& program,
                 map::About& about) {
  about.program = program.fingerprint;
  about.task = program.task;
  about.given = program.given;
  about.plan.targets = program.task == "position" ? 1 : arguments.orientations;
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    if (chain.joints[i].variable == program.given) {
      about.plan.values = given_values;
      std::tie(about.plan.lower, about.plan.upper) = report::range_of(chain, i);
    }
}

map::ArmProgram program_of(const MapArguments& arguments, const description::ReadResult& description) {
  const toolchain::Runtime runtime =
      arguments.source_tree
          ? toolchain::runtime_of(*arguments.source_tree)
          : toolchain::runtime_in(arguments.known_robots.parent_path().parent_path().parent_path());
  const std::string key = pipeline::fingerprint(
      fmt::format("{}\n{}\n{}\n{}\n{}", arguments.tool, fmt::join(toolchain::cxx_compiler(), " "),
                  origin_options(arguments.read), snap_text(arguments.read), description.text));
  const ProgressLine progress(0);
  return map::arm_program(*description.robot, key, runtime,
                          [&](const std::string& what) { progress.say(what); });
}

volatile std::sig_atomic_t stop_wanted = 0;

/// For as long as it lives a request to stop is noted, and not obeyed at once.
class StopRequests {
 public:
  StopRequests() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stop_wanted = 1; });
  }
  StopRequests(const StopRequests&) = delete;
  StopRequests& operator=(const StopRequests&) = delete;
  ~StopRequests() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  }
};

/// Computes what the journal lacks.
void fill(map::Journal& journal, const map::ArmProgram& program, const std::vector<int>& blocks,
          int threads) {
  std::vector<int> open;
  std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(open),
               [&](int block) { return journal.blocks().count(block) == 0; });
  if (open.size() < blocks.size())
    fmt::print(stderr, "going on: {} of {} blocks are there\n", blocks.size() - open.size(), blocks.size());
  const ProgressLine progress(0);
  const auto start = std::chrono::steady_clock::now();
  double poses = 0;
  std::size_t done = 0;
  map::compute(
      program, journal.part().about.plan, open, threads, [&](int block, std::vector<map::Cell> cells) {
        poses += static_cast<double>(cells.size() * journal.part().about.plan.targets);
        journal.add(block, std::move(cells));
        if (stop_wanted != 0) throw std::runtime_error("stopped");
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        ++done;
        progress.say(fmt::format(
            "[{}/{}] {:.1f} million poses/s, {:.0f} s left", done, open.size(), poses / seconds / 1e6,
            seconds * static_cast<double>(open.size() - done) / static_cast<double>(done)));
      });
}

/// Returns a summary of a part in one line.
std::string summary(const map::Part& part) {
  std::uint64_t positions = 0, reached = 0, some = 0;
  for (const auto& [block, cells] : part.blocks)
    for (const map::Cell& cell : cells) {
      ++positions;
      reached += cell.reached;
      if (cell.reached > 0) ++some;
    }
  const double all = static_cast<double>(positions * part.about.plan.targets);
  const std::string places = fmt::format("{}: {} of {} places {:.4g} m apart are reached", part.about.robot,
                                         some, positions, part.about.plan.sphere.resolution);
  if (part.about.task == "position") return places;
  return fmt::format("{}; of {} at each {:.1f} %", places, map::targets_text(part.about),
                     all > 0 ? 100 * static_cast<double>(reached) / all : 0.0);
}

void write_all(const map::Part& part, const std::vector<fs::path>& outputs) {
  for (const fs::path& output : outputs) {
    map::write_map(part, output);
    fmt::print("{}\n", output.string());
  }
  fmt::print(stderr, "{}\n", summary(part));
}

}  // namespace

int run_map(const MapArguments& arguments) {
  check_outputs(arguments);
  const std::vector<int> blocks = blocks_of(arguments.blocks);
  if (!arguments.merged.empty()) {
    write_all(map::merged(arguments.merged), arguments.outputs);
    return success;
  }
  const auto descriptions = read_chains({arguments.description}, arguments.read);
  if (!descriptions) return bad_description;
  const model::Robot& robot = *descriptions->front().robot;
  const report::Chain chain = report::chain_of(robot);
  map::About about = about_of(arguments, robot, chain);
  const map::ArmProgram program = program_of(arguments, descriptions->front());
  add_program(arguments, chain, program, about);
  const int threads = arguments.threads > 0
                          ? arguments.threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  map::Journal journal(arguments.outputs.front().string() + ".unfinished", about);
  try {
    const StopRequests requests;
    fill(journal, program, blocks, threads);
  } catch (const std::runtime_error&) {
    if (stop_wanted == 0) throw;
    throw std::runtime_error(fmt::format("stopped: {} blocks are in {}, the same command goes on from there",
                                         journal.blocks().size(), journal.path().string()));
  }
  write_all(journal.part(), arguments.outputs);
  journal.remove();
  return success;
}

}  // namespace qvgen::cli
