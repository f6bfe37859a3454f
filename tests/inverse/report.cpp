// SPDX-License-Identifier: MIT
// Tables of solutions, errors and faults of the generated inverse kinematics: one line per set of poses, or
// one per robot over all sets.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "judge.h"

namespace {

using namespace qvgen::test;

constexpr const char* help =
    "qvgen_inverse_report [--poses N] [--sets] [--faults] [ROBOT...]\n"
    "One line per robot over all sets of poses; with --sets one per set. N poses a set, 1000 unless told;\n"
    "--faults names every fault.\n"
    "  solutions  rows a pose (of the random set in the short table)\n"
    "  error      largest position (m, a share of the distance beyond 1 m) and orientation (rad) error of a "
    "row\n"
    "  missing    poses whose sampled joints are not among the solutions; \"told\" are those of which the\n"
    "             status says that solutions may be missing (arms without a closed form)\n"
    "  lost       poses of reachable joints that were given no solution at all\n"
    "  repeated   rows that equal another one\n"
    "  bad        rows off the pose by more than 1e-12 of 1 m plus the distance, wrong status or mark\n";

struct Line {
  int poses = 0;
  long rows = 0;
  Case::Miss miss;
  int missing = 0;
  int told = 0;
  int lost = 0;
  int repeated = 0;
  int bad = 0;

  void add(const Sample& sample, const Verdict& verdict) {
    ++poses;
    rows += verdict.rows;
    // Far outside, at a kilometre and more, rounding alone is 1e-13 m.
    const double size = std::max(1.0, sample.target.translation().norm());
    miss.position = std::max(miss.position, verdict.miss.position / size);
    miss.orientation = std::max(miss.orientation, verdict.miss.orientation);
    missing += verdict.missing ? 1 : 0;
    told += verdict.told ? 1 : 0;
    lost += sample.expect == Expect::joints && verdict.rows == 0 ? 1 : 0;
    repeated += verdict.repeated;
    const bool otherwise =
        !verdict.fault.empty() && verdict.bad == 0 && verdict.repeated == 0 && !verdict.missing;
    bad += verdict.bad + (otherwise ? 1 : 0);
  }
  void add(const Line& other) {
    poses += other.poses;
    rows += other.rows;
    miss.position = std::max(miss.position, other.miss.position);
    miss.orientation = std::max(miss.orientation, other.miss.orientation);
    missing += other.missing;
    told += other.told;
    lost += other.lost;
    repeated += other.repeated;
    bad += other.bad;
  }
};

Line measure(Case& test, const PoseSet& set, int count, bool faults) {
  Line line;
  int tried = 0;
  for (int i = 0; i < count; ++i) {
    // An arm without such poses is not asked for all of them.
    if (line.poses == 0 && tried++ > 100) break;
    const std::optional<Sample> sample = set.draw(test, i);
    if (!sample) continue;
    const Verdict verdict =
        judge(test, *sample,
              test.robot().solve(sample->pose, test.given(sample->q), qvgen::inverse::default_tolerance));
    if (faults && !verdict.fault.empty())
      std::fprintf(stderr, "%s, pose %d: %s\n", set.name.c_str(), i, verdict.fault.c_str());
    line.add(*sample, verdict);
  }
  return line;
}

void print(const std::string& name, const Line& line, double solutions) {
  const std::string told = line.told > 0 ? " + " + std::to_string(line.told) + " told" : "";
  std::printf("| %s | %d | %.4f | %.1e / %.1e | %d%s | %d | %d | %d |\n", name.c_str(), line.poses, solutions,
              line.miss.position, line.miss.orientation, line.missing, told.c_str(), line.lost, line.repeated,
              line.bad);
}

double a_pose(const Line& line) { return line.poses == 0 ? 0 : static_cast<double>(line.rows) / line.poses; }

void heading(const char* first) {
  std::printf(
      "| %s | poses | solutions a pose | largest error (m / rad) | missing | lost | repeated | bad |\n",
      first);
  std::printf("|---|---|---|---|---|---|---|---|\n");
}

struct Options {
  int count = 1000;
  bool by_set = false;
  bool faults = false;
};

void report(const InverseUnderTest& robot, const Options& options) {
  Case test(robot);
  Line sum;
  double random = 0;
  if (options.by_set) {
    std::printf("\n%s\n\n", robot.name.c_str());
    heading("set");
  }
  for (const PoseSet& set : pose_sets()) {
    const Line line = measure(test, set, options.count, options.faults);
    if (options.by_set && line.poses > 0) print(set.name, line, a_pose(line));
    if (set.name == "random") random = a_pose(line);
    sum.add(line);
  }
  if (!options.by_set) print(robot.name, sum, random);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--help") {
      std::fputs(help, stdout);
      return 0;
    }
    if (argument == "--sets")
      options.by_set = true;
    else if (argument == "--faults")
      options.faults = true;
    else if (argument == "--poses" && i + 1 < argc)
      options.count = std::atoi(argv[++i]);
    else
      names.push_back(argument);
  }
  if (!options.by_set) heading("robot");
  for (const InverseUnderTest& robot : inverses())
    if (names.empty() || std::find(names.begin(), names.end(), robot.name) != names.end())
      report(robot, options);
  return 0;
}
