// SPDX-License-Identifier: MIT
#include "emit/inverse/early_forks.h"

#include <algorithm>
#include <map>

#include "derive/inverse/schedule.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::Plan;
using derive::inverse::Step;

/// Goes through the steps in their order. A level is the number of forks up to a step, itself among them:
/// what it leaves is known in that many loops.
class Search {
 public:
  explicit Search(const Plan& plan) : plan_(plan) {}

  std::vector<EarlyFork> run() {
    for (std::size_t i = 0; i < plan_.steps.size(); ++i) {
      plan_.steps[i].branches > 1 ? add_fork(i) : follow(i);
      for (const std::string& name : derive::inverse::writes(plan_.steps[i])) writer_[name] = i;
      levels_.push_back(forks_);
    }
    for (EarlyFork& fork : found_) hand_on(fork);
    return found_;
  }

 private:
  /// Steps before this one of which it reads values.
  [[nodiscard]] std::vector<std::size_t> read_by(std::size_t index) const {
    std::vector<std::size_t> steps;
    for (const std::string& name : derive::inverse::reads(plan_.steps[index]))
      if (const auto writer = writer_.find(name); writer != writer_.end()) steps.push_back(writer->second);
    return steps;
  }
  /// How many loops have to be around a step, with those of a fork that it goes with left out.
  [[nodiscard]] int depth_of(std::size_t index, const EarlyFork* with = nullptr) const {
    int depth = 0;
    for (const std::size_t other : read_by(index))
      if (with == nullptr || !with->has(other)) depth = std::max(depth, levels_[other]);
    return depth;
  }

  void add_fork(std::size_t index) {
    const Step& step = plan_.steps[index];
    const int depth = depth_of(index);
    if (depth < forks_ && !step.is_quartic() && !step.keeps_length())
      found_.push_back({index, {}, forks_, depth, {}});
    ++forks_;
  }

  /// Lets a step of one value go with the last early fork of which it reads anything, if it can.
  void follow(std::size_t index) {
    const Step& step = plan_.steps[index];
    if (step.is<kind::Require>() || step.keeps_length()) return;
    const auto read = read_by(index);
    const auto fork = std::find_if(found_.rbegin(), found_.rend(), [&](const EarlyFork& each) {
      return std::any_of(read.begin(), read.end(), [&](std::size_t other) { return each.has(other); });
    });
    if (fork != found_.rend() && depth_of(index, &*fork) <= fork->depth) fork->behind.push_back(index);
  }

  void hand_on(EarlyFork& fork) const {
    for (std::size_t i = fork.step + 1; i < plan_.steps.size(); ++i) {
      if (fork.has(i)) continue;
      for (const std::string& name : derive::inverse::reads(plan_.steps[i])) {
        const auto writer = writer_.find(name);
        const bool is_its = writer != writer_.end() && fork.has(writer->second);
        if (is_its && std::find(fork.handed.begin(), fork.handed.end(), name) == fork.handed.end())
          fork.handed.push_back(name);
      }
    }
  }

  const Plan& plan_;
  int forks_ = 0;
  std::vector<int> levels_;                    ///< by step
  std::map<std::string, std::size_t> writer_;  ///< by the value's name
  std::vector<EarlyFork> found_;
};

}  // namespace

bool EarlyFork::has(std::size_t index) const {
  return index == step || std::find(behind.begin(), behind.end(), index) != behind.end();
}

std::vector<EarlyFork> early_forks(const Plan& plan) { return Search(plan).run(); }

}  // namespace qvgen::emit
