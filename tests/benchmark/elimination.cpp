// SPDX-License-Identifier: MIT
// All solutions of arms without structure. `qvgen_elimination time [POSES]` prints a table of times;
// `qvgen_elimination names` and `qvgen_elimination count ARM REGISTERS SET POSES` serve
// elimination_instructions.sh, one dump a pose: REGISTERS avx2 or sse2, SET random or singular.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <valgrind/callgrind.h>

#include "elimination/arms.h"

namespace {

using namespace qvgen::test;
using qvgen::InstructionSet;
using qvgen::inverse::elimination::Setup;
using Pose = qvgen::Pose<double>;

/// The tests' named arms, and some with all lengths and twists drawn at random.
std::vector<Arm> all_arms() {
  std::vector<Arm> arms = named_arms();
  for (const int slides : {0, 0, 0, 1, 2}) {
    arms.push_back(random_arm(static_cast<unsigned>(arms.size()), slides));
    if (slides > 0) arms.back().name += slides == 1 ? "_a_slide" : "_two_slides";
  }
  return arms;
}

/// Every second one is off by 10^-u, u uniform in [1, 12], in one of the inner joints.
std::vector<Pose> singular_poses(const Arm& arm, int count) {
  Random random(23);
  std::vector<Pose> poses;
  for (int i = 0; static_cast<int>(poses.size()) < count; ++i) {
    std::optional<Joints6> q = at_a_singularity(arm, random, 1 + i % 4);
    if (!q) continue;
    if (poses.size() % 2 == 1) (*q)[1 + i / 4 % 4] += std::pow(10, -uniform(random, 1, 12));
    poses.push_back(Pose::from_isometry(arm.tool(*q)));
  }
  return poses;
}

std::vector<Pose> poses_of(const Arm& arm, const std::string& set, int count) {
  if (set == "singular") return singular_poses(arm, count);
  Random random(11);
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) poses.push_back(Pose::from_isometry(arm.tool(arm.joints(random))));
  return poses;
}

int rows_of(const Setup& setup, const Pose& pose, InstructionSet registers) {
  return solve(setup, pose, registers).size();
}

struct Times {
  double median, mean, last;  ///< microseconds; the last: which 99 % of the poses do not exceed
  double rows;
};

/// The fastest of some calls of each pose.
Times times_of(const Setup& setup, const std::vector<Pose>& poses, InstructionSet registers) {
  using Clock = std::chrono::steady_clock;
  constexpr int calls = 7;
  std::vector<double> times(poses.size(), 1e9);
  Times result{};
  for (int call = 0; call < calls; ++call)
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const auto start = Clock::now();
      const int rows = rows_of(setup, poses[i], registers);
      const std::chrono::duration<double, std::micro> time = Clock::now() - start;
      times[i] = std::min(times[i], time.count());
      result.rows += static_cast<double>(rows) / static_cast<double>(calls * poses.size());
    }
  std::sort(times.begin(), times.end());
  for (const double time : times) result.mean += time / static_cast<double>(times.size());
  result.median = times[times.size() / 2];
  result.last = times[times.size() * 99 / 100];
  return result;
}

void print_times(int count) {
  std::printf("%-24s%6s |%24s |%16s |%16s |%24s\n", "us a pose, all solutions", "", "random, AVX-512", "AVX2",
              "SSE2", "singular, AVX-512");
  std::printf("%-24s%6s |%8s%8s%8s |%8s%8s |%8s%8s |%8s%8s%8s\n", "", "rows", "median", "mean", "99 %",
              "median", "mean", "median", "mean", "median", "mean", "99 %");
  for (const Arm& arm : all_arms()) {
    const Setup setup = qvgen::inverse::elimination::set_up(arm.description());
    const std::vector<Pose> random = poses_of(arm, "random", count);
    const auto times = [&](InstructionSet registers) { return times_of(setup, random, registers); };
    const Times eight = times(InstructionSet::avx512), four = times(InstructionSet::avx2);
    const Times two = times(InstructionSet::baseline);
    const Times singular = times_of(setup, poses_of(arm, "singular", count / 2), InstructionSet::avx512);
    std::printf("%-24s%6.2f |%8.2f%8.2f%8.1f |%8.2f%8.2f |%8.2f%8.2f |%8.1f%8.1f%8.1f\n", arm.name.c_str(),
                eight.rows, eight.median, eight.mean, eight.last, four.median, four.mean, two.median,
                two.mean, singular.median, singular.mean, singular.last);
    std::fflush(stdout);
  }
}

bool count(const std::string& name, InstructionSet registers, const std::string& set, int poses) {
  for (const Arm& arm : all_arms()) {
    if (arm.name != name) continue;
    const Setup setup = qvgen::inverse::elimination::set_up(arm.description());
    int rows = 0;
    for (const Pose& pose : poses_of(arm, set, poses)) {
      CALLGRIND_ZERO_STATS;
      rows += rows_of(setup, pose, registers);
      CALLGRIND_DUMP_STATS;
    }
    std::printf("%.2f\n", rows / static_cast<double>(poses));
    return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "names") {
    for (const Arm& arm : all_arms()) std::printf("%s\n", arm.name.c_str());
  } else if (what == "count" && argc == 6) {
    const bool avx2 = std::string(argv[3]) == "avx2";
    const InstructionSet registers = avx2 ? InstructionSet::avx2 : InstructionSet::baseline;
    return count(argv[2], registers, argv[4], std::atoi(argv[5])) ? 0 : 2;
  } else if (what == "time") {
    print_times(argc > 2 ? std::atoi(argv[2]) : 1000);
  } else {
    return 2;
  }
  return 0;
}
