// SPDX-License-Identifier: MIT
// What poses cost beyond closed forms: how many evaluations of the Jacobian, over many random poses and as
// many near singular ones. Counted, so that it is the same on every machine.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "case.h"
#include "pose_sets.h"

namespace {

using namespace qvgen::test;

constexpr const char* help =
    "qvgen_inverse_histogram [--poses N] [ROBOT...]\n"
    "Percent of poses by the evaluations of the Jacobian that they take, of N random poses (100000 unless\n"
    "told) and of N near singular ones: joints at 0, pi and 10^-u, theta5 at these, 45 degree lattice, in\n"
    "turn. `most`: of one pose. `incomplete`: poses of which more was wanted than is allowed.\n";

constexpr std::array<int, 7> bounds = {0, 1, 4, 8, 16, 32, 64};

struct Histogram {
  std::array<long, bounds.size() + 1> poses = {};
  long all = 0;
  long incomplete = 0;
  int most = 0;

  void add(const qvgen::inverse::Effort& effort, bool is_incomplete) {
    const auto* place = std::lower_bound(bounds.begin(), bounds.end(), effort.steps);
    ++poses[static_cast<std::size_t>(place - bounds.begin())];
    ++all;
    most = std::max(most, effort.steps);
    incomplete += is_incomplete ? 1 : 0;
  }
};

std::vector<PoseSet> near_singular_sets(const Case& test) {
  std::vector<PoseSet> sets;
  for (const char* name : {"theta5 = 0", "theta5 = pi", "theta5 = 10^-u", "45° lattice", "a joint at 0",
                           "a joint at pi", "a joint at 10^-u"})
    if (pose_set(name).is_for(test)) sets.push_back(pose_set(name));
  return sets;
}

Histogram measure(Case& test, const std::vector<PoseSet>& sets, int poses) {
  Histogram histogram;
  for (int i = 0; i < poses; ++i) {
    const auto count = static_cast<int>(sets.size());
    const std::optional<Sample> sample = sets[static_cast<std::size_t>(i % count)].draw(test, i / count);
    if (!sample) continue;
    const Found found =
        test.robot().solve(sample->pose, test.given(sample->q), qvgen::inverse::default_tolerance);
    histogram.add(found.effort, found.status == qvgen::Status::incomplete);
  }
  return histogram;
}

void print_head() {
  std::printf("%-28s", "evaluations");
  std::printf("%9d", bounds[0]);
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    const std::string range = bounds[i] == bounds[i - 1] + 1
                                  ? std::to_string(bounds[i])
                                  : std::to_string(bounds[i - 1] + 1) + "-" + std::to_string(bounds[i]);
    std::printf("%9s", range.c_str());
  }
  std::printf("%9s%7s%12s\n", ("> " + std::to_string(bounds.back())).c_str(), "most", "incomplete");
}

void print(const std::string& what, const Histogram& histogram) {
  std::printf("%-28s", what.c_str());
  for (const long poses : histogram.poses) {
    const double percent =
        100.0 * static_cast<double>(poses) / static_cast<double>(std::max(1L, histogram.all));
    if (poses == 0)
      std::printf("%9s", "-");
    else
      std::printf("%9.4f", percent);
  }
  std::printf("%7d%12ld\n", histogram.most, histogram.incomplete);
}

}  // namespace

int main(int argc, char** argv) {
  int poses = 100000;
  std::vector<std::string> wanted;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--help") return std::fputs(help, stdout), 0;
    if (argument == "--poses" && i + 1 < argc)
      poses = std::atoi(argv[++i]);
    else
      wanted.push_back(argument);
  }
  print_head();
  for (const InverseUnderTest& robot : inverses()) {
    if (robot.info.by_elimination) continue;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), robot.name) == wanted.end()) continue;
    Case test(robot);
    test.seed(5);
    print(robot.name + ", random", measure(test, {pose_set("random")}, poses));
    print(robot.name + ", near singular", measure(test, near_singular_sets(test), poses));
  }
  return 0;
}
