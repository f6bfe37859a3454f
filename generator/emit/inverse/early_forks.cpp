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

template <class Value>
bool contains(const std::vector<Value>& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// Goes through the steps in their order. A level is the number of forks up to a step, itself among them:
/// what it leaves is known in that many loops.
class Search {
 public:
  Search(const Plan& plan, bool all) : plan_(plan), all_(all) {}

  std::vector<EarlyFork> run() {
    for (std::size_t i = 0; i < plan_.steps.size(); ++i) {
      plan_.steps[i].branches > 1 ? add_fork(i) : follow(i);
      for (const std::string& name : derive::inverse::writes(plan_.steps[i])) writer_[name] = i;
      levels_.push_back(forks_);
    }
    for (EarlyFork& fork : found_) connect(fork);
    if (all_)
      for (EarlyFork& fork : found_) go_over(fork);
    return found_;
  }

 private:
  /// The step that leaves a value; nothing for the target's.
  [[nodiscard]] const std::size_t* writer_of(const std::string& name) const {
    const auto writer = writer_.find(name);
    return writer == writer_.end() ? nullptr : &writer->second;
  }
  /// How many loops have to be around a step, with those of a fork that it goes with left out.
  [[nodiscard]] int depth_of(std::size_t index, const EarlyFork* with = nullptr) const {
    int depth = 0;
    for (const std::string& name : derive::inverse::reads(plan_.steps[index]))
      if (const std::size_t* writer = writer_of(name); writer != nullptr)
        if (with == nullptr || !with->has(*writer)) depth = std::max(depth, levels_[*writer]);
    return depth;
  }
  [[nodiscard]] bool reads_from(std::size_t index, const EarlyFork& fork) const {
    const std::vector<std::string> names = derive::inverse::reads(plan_.steps[index]);
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      const std::size_t* writer = writer_of(name);
      return writer != nullptr && fork.has(*writer);
    });
  }

  void add_fork(std::size_t index) {
    const Step& step = plan_.steps[index];
    const int depth = depth_of(index);
    if ((all_ || depth < forks_) && !step.is_quartic() && !step.keeps_length())
      found_.push_back({index, {}, forks_, depth, {}, {}});
    ++forks_;
  }

  /// Lets a step of one value go with the last early fork of which it reads anything, if it can.
  void follow(std::size_t index) {
    const Step& step = plan_.steps[index];
    if (step.is<kind::Require>() || step.keeps_length()) return;
    const auto fork = std::find_if(found_.rbegin(), found_.rend(),
                                   [&](const EarlyFork& each) { return reads_from(index, each); });
    if (fork != found_.rend() && depth_of(index, &*fork) <= fork->depth) fork->behind.push_back(index);
  }

  /// Lists the values that go into a fork and out of it.
  void connect(EarlyFork& fork) const {
    for (std::size_t i = fork.step; i < plan_.steps.size(); ++i)
      for (const std::string& name : derive::inverse::reads(plan_.steps[i])) {
        const std::size_t* writer = writer_of(name);
        if (writer == nullptr || fork.has(i) == fork.has(*writer)) continue;
        std::vector<std::string>& list = fork.has(i) ? fork.taken : fork.handed;
        if (!contains(list, name)) list.push_back(name);
      }
  }

  /// Lets a fork go over the values of the last fork that it reads from, if these are stored: then it needs
  /// that one's loop no more.
  void go_over(EarlyFork& fork) const {
    const int last = fork.depth - 1;
    const auto parent = std::find_if(found_.begin(), found_.end(),
                                     [&](const EarlyFork& each) { return each.number == last; });
    if (parent == found_.end()) return;
    int depth = std::max(parent->depth, parent->over + 1);
    for (const std::string& name : fork.taken)
      if (const std::size_t writer = writer_.at(name); !parent->has(writer))
        depth = std::max(depth, levels_[writer]);
    if (depth > last) return;
    fork.over = last;
    fork.depth = depth;
  }

  const Plan& plan_;
  bool all_;
  int forks_ = 0;
  std::vector<int> levels_;                    ///< by step
  std::map<std::string, std::size_t> writer_;  ///< by the value's name
  std::vector<EarlyFork> found_;
};

}  // namespace

bool EarlyFork::has(std::size_t index) const { return index == step || contains(behind, index); }

std::vector<EarlyFork> early_forks(const Plan& plan, bool all) { return Search(plan, all).run(); }

}  // namespace qvgen::emit
