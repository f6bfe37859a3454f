// SPDX-License-Identifier: MIT
#include "derive/loops/hoist.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "derive/inverse/names.h"
#include "derive/inverse/schedule.h"

namespace qvgen::derive::loops {
namespace {

using inverse::Plan;
using inverse::Step;
using symbolic::Program;
namespace names = inverse::names;

bool is_output(const Program& program, const std::string& name) {
  return std::any_of(program.outputs().begin(), program.outputs().end(),
                     [&](const Program::Output& output) { return output.name == name; });
}

/// True for the value of a joint, which its own step leaves.
bool is_joint(const Plan& plan, const std::string& name) {
  return std::any_of(plan.joints.begin(), plan.joints.end(), [&](const inverse::JointValue& joint) {
    return joint.cosine == name || joint.sine == name;
  });
}

/// Names that the results of a step have within it alone.
constexpr std::array<const char*, 5> results{names::cosine_result, names::sine_result, names::result,
                                             names::result_1, names::result_2};

class Hoist {
 public:
  explicit Hoist(Plan& plan) : plan_(plan) {}

  void run() {
    for (std::size_t i = 0; i < plan_.steps.size(); ++i) move_from(i);
  }

 private:
  /// Places are steps, counted from 1; 0 is the target.
  [[nodiscard]] std::size_t place_of(const GiNaC::ex& value) const {
    if (GiNaC::is_a<GiNaC::symbol>(value)) {
      const auto known = places_.find(GiNaC::ex_to<GiNaC::symbol>(value).get_name());
      return known == places_.end() ? 0 : known->second;
    }
    std::size_t place = 0;
    for (std::size_t i = 0; i < value.nops(); ++i) place = std::max(place, place_of(value.op(i)));
    return place;
  }
  Program& program(std::size_t place) { return place == 0 ? plan_.target : plan_.steps[place - 1].after; }

  void move_from(std::size_t index) {
    const std::size_t own = index + 1;
    for (const char* result : results) places_[result] = own;
    const Program before = plan_.steps[index].after;
    Program rest;
    for (const Program::Step& each : before.steps()) {
      const std::string& name = each.name.get_name();
      const bool may_move = is_output(before, name) && !is_joint(plan_, name);
      const std::size_t place = may_move ? place_of(each.value) : own;
      places_[name] = place;
      place < own ? program(place).output(each.name, each.value) : rest.append(each);
    }
    for (const Program::Output& output : before.outputs()) {
      const auto known = places_.find(output.name);
      if (known == places_.end() || known->second == own) rest.output(output.name, output.value);
    }
    plan_.steps[index].after = rest;
  }

  Plan& plan_;
  std::map<std::string, std::size_t> places_;
};

bool is_in(const Program::Step& value, const std::set<std::string>& names) {
  return names.count(value.name.get_name()) > 0;
}

std::set<std::string> reads_of(const Program::Step& value) {
  Program alone;
  alone.output("value", value.value);
  return alone.reads();
}

bool reads_a_result(const Program::Step& value) {
  const std::set<std::string> read = reads_of(value);
  return std::any_of(results.begin(), results.end(), [&](const char* name) { return read.count(name) > 0; });
}

/// The part of a program that computes some of its values.
Program of_values(const std::vector<Program::Step>& values, const Program& program) {
  Program result;
  std::set<std::string> left;
  for (const Program::Step& value : program.steps()) left.insert(value.name.get_name());
  for (const Program::Step& value : values) {
    left.erase(value.name.get_name());
    result.append(value);
  }
  for (const Program::Output& output : program.outputs())
    if (left.count(output.name) == 0) result.output(output.name, output.value);
  return result;
}

/// Drops values of steps that nothing reads: what they read themselves keeps nothing from its place.
void drop_unread(Plan& plan) {
  inverse::prune(plan);
  for (Step& step : plan.steps) {
    std::set<std::string> read(step.kept.begin(), step.kept.end());
    for (const Program::Output& output : step.after.outputs())
      if (!GiNaC::is_a<GiNaC::symbol>(output.value)) read.merge(reads_of({{}, output.value}));
    std::vector<Program::Step> values = step.after.steps();
    for (std::size_t k = values.size(); k-- > 0;) {
      if (is_in(values[k], read))
        read.merge(reads_of(values[k]));
      else
        values.erase(values.begin() + static_cast<std::ptrdiff_t>(k));
    }
    step.after = of_values(values, step.after);
  }
}

/// A program in which a value comes first.
Program with_first(const Program::Step& value, const Program& program) {
  Program result;
  result.append(value);
  for (const Program::Step& step : program.steps()) result.append(step);
  for (const Program::Output& output : program.outputs()) result.output(output.name, output.value);
  return result;
}

/// Lets values wait for the fork that reads them where they keep another one from being solved early.
class Wait {
 public:
  explicit Wait(Plan& plan) : plan_(plan) {
    int forks = 0;
    for (const Step& step : plan.steps) {
      forks += step.branches > 1 ? 1 : 0;
      for (const Program::Output& output : step.after.outputs()) forks_[output.name] = forks;
    }
  }

  void run() {
    for (std::size_t i = plan_.steps.size(); i-- > 0;)
      if (plan_.steps[i].branches > 1) wait(i);
  }

 private:
  /// How many forks are up to the last step whose values are read.
  [[nodiscard]] int forks_in(const std::set<std::string>& names) const {
    int forks = 0;
    for (const std::string& name : names)
      if (const auto known = forks_.find(name); known != forks_.end()) forks = std::max(forks, known->second);
    return forks;
  }

  /// The fork behind a step whose inputs read a value; nothing if others read it, too.
  Step* only_reader(const Program::Step& value, std::size_t index) {
    Step* reader = nullptr;
    for (std::size_t i = index + 1; i < plan_.steps.size(); ++i) {
      Step& step = plan_.steps[i];
      if (is_in(value, step.after.reads())) return nullptr;
      if (!is_in(value, step.before.reads())) continue;
      if (reader != nullptr || step.branches == 1) return nullptr;
      reader = &step;
    }
    return reader;
  }

  void wait(std::size_t index) {
    Step& step = plan_.steps[index];
    const int forks = forks_in(step.before.reads());
    std::vector<Program::Step> values = step.after.steps();
    for (const Program::Step& value : values) forks_[value.name.get_name()] = 0;
    for (const Program::Step& value : values) forks_[value.name.get_name()] = forks_in(reads_of(value));
    for (std::size_t k = values.size(); k-- > 0;) {
      const Program::Step value = values[k];
      if (is_joint(plan_, value.name.get_name()) || forks_in({value.name.get_name()}) <= forks) continue;
      if (reads_a_result(value)) continue;
      if (std::any_of(values.begin(), values.end(),
                      [&](const Program::Step& other) { return is_in(value, reads_of(other)); }))
        continue;
      Step* reader = only_reader(value, index);
      if (reader == nullptr) continue;
      reader->before = with_first(value, reader->before);
      values.erase(values.begin() + static_cast<std::ptrdiff_t>(k));
    }
    if (values.size() < step.after.steps().size()) step.after = of_values(values, step.after);
  }

  Plan& plan_;
  /// By the value's name: how many are up to the step that leaves it; of values of a step that is looked at,
  /// and of those behind it, without the step's own.
  std::map<std::string, int> forks_;
};

}  // namespace

void hoist(Plan& plan) {
  Hoist(plan).run();
  drop_unread(plan);
  Wait(plan).run();
}

}  // namespace qvgen::derive::loops
