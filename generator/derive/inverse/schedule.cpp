// SPDX-License-Identifier: MIT
#include "derive/inverse/schedule.h"

#include <algorithm>
#include <set>

#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

namespace {

void collect(const symbolic::Program& program, std::set<std::string>& names) {
  names.insert(program.reads().begin(), program.reads().end());
  for (const auto& step : program.steps()) names.erase(step.name.get_name());
}

bool moves(const Step& step) { return step.is<kind::Half>(); }

}  // namespace

std::vector<std::string> writes(const Step& step) {
  std::vector<std::string> names;
  for (const auto& output : step.after.outputs()) names.push_back(output.name);
  if (step.wrist() == nullptr) return names;
  for (const std::string& variable : step.wrist()->variables) {
    names.push_back(names::cosine(variable));
    names.push_back(names::sine(variable));
  }
  return names;
}

std::vector<std::string> reads(const Step& step) {
  std::set<std::string> names;
  collect(step.before, names);
  collect(step.after, names);
  for (const std::string& name : writes(step)) names.erase(name);
  return {names.begin(), names.end()};
}

void schedule(Plan& plan) {
  std::vector<Step> ordered;
  for (Step& step : plan.steps) {
    std::size_t place = ordered.size();
    if (moves(step)) {
      const std::vector<std::string> needs = reads(step);
      const auto gives = [&](const Step& earlier) {
        for (const std::string& name : writes(earlier))
          if (std::find(needs.begin(), needs.end(), name) != needs.end()) return true;
        return false;
      };
      while (place > 0 && !gives(ordered[place - 1])) --place;
    }
    ordered.insert(ordered.begin() + static_cast<std::ptrdiff_t>(place), std::move(step));
  }
  plan.steps = std::move(ordered);
}

namespace {

bool any_of(const std::vector<std::string>& names, const std::set<std::string>& wanted) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return wanted.count(name) > 0; });
}

/// True if each of the first steps has to come before step `end`, which reads none of them: all but half
/// angles that wait.
std::vector<bool> needed_before(const Plan& plan, std::size_t end) {
  std::vector<bool> needed(end);
  std::set<std::string> wanted;
  for (std::size_t i = end; i-- > 0;) {
    const Step& step = plan.steps[i];
    needed[i] = !moves(step) || any_of(writes(step), wanted);
    if (!needed[i]) continue;
    for (const std::string& name : reads(step)) wanted.insert(name);
  }
  return needed;
}

std::size_t polish_of(const Plan& plan) {
  std::size_t i = 0;
  while (i < plan.steps.size() && !plan.steps[i].is<kind::Newton>()) ++i;
  return i;
}

}  // namespace

std::vector<const Step*> steps_behind(const Plan& plan, std::size_t index) {
  std::vector<const Step*> found;
  const std::vector<std::string> read = reads(plan.steps[index]);
  std::set<std::string> wanted(read.begin(), read.end());
  for (std::size_t i = index; i-- > 0;) {
    if (!any_of(writes(plan.steps[i]), wanted)) continue;
    found.insert(found.begin(), &plan.steps[i]);
    for (const std::string& name : reads(plan.steps[i])) wanted.insert(name);
  }
  return found;
}

bool reads_halves(const Plan& plan, const Step& step) {
  const std::vector<std::string> read = reads(step);
  const std::set<std::string> wanted(read.begin(), read.end());
  return std::any_of(plan.steps.begin(), plan.steps.end(),
                     [&](const Step& other) { return moves(other) && any_of(writes(other), wanted); });
}

std::vector<std::size_t> order(const Plan& plan, bool careful) {
  const std::size_t polish = polish_of(plan);
  const std::vector<bool> needed = needed_before(plan, polish);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < polish; ++i)
    if (!careful || needed[i]) result.push_back(i);
  if (careful && polish < plan.steps.size()) result.push_back(polish);
  for (std::size_t i = 0; i < polish; ++i)
    if (careful && !needed[i]) result.push_back(i);
  for (std::size_t i = polish + 1; i < plan.steps.size(); ++i) result.push_back(i);
  return result;
}

void prune(Plan& plan) {
  std::set<std::string> wanted = {names::size_square};
  for (const JointValue& joint : plan.joints) {
    wanted.insert(joint.cosine);
    wanted.insert(joint.sine);
  }
  const auto kept = [&](const symbolic::Program& program) {
    std::vector<std::string> names;
    for (const auto& output : program.outputs())
      if (wanted.count(output.name) > 0) names.push_back(output.name);
    return names;
  };
  for (auto step = plan.steps.rbegin(); step != plan.steps.rend(); ++step) {
    step->kept = kept(step->after);
    for (const std::string& name : reads(*step)) wanted.insert(name);
  }
  collect(plan.range_test.values, wanted);
  plan.target_kept = kept(plan.target);
  // Values that steps read of the pose itself pass through the target under its own name.
  for (const std::string& name : wanted) {
    if (name.rfind(names::pose_quaternion, 0) != 0 && name.rfind(names::pose_position, 0) != 0) continue;
    plan.target.output(name, symbolic::symbol(name));
    plan.target_kept.push_back(name);
  }
}

}  // namespace qvgen::derive::inverse
