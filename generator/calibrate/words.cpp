// SPDX-License-Identifier: MIT
#include "calibrate/words.h"

#include <algorithm>

namespace qvgen::calibrate {
namespace {

/// Returns the name under which a frame or a surface as a whole is spoken of; an error of the arm has its
/// own.
std::string name_of(const Parameter& each) {
  if (each.kind == Kind::tracker_shift || each.kind == Kind::tracker_turn) return "the tracker's frame";
  if (each.kind == Kind::target_shift) return "the target's place on the tool";
  if (each.kind == Kind::target_turn) return "the target's turn on the tool";
  return each.kind == Kind::surface ? "what stands still (its place and size)" : each.name;
}

std::vector<std::string> names_of(const std::vector<Parameter>& parameters,
                                  const std::vector<std::size_t>& indices) {
  std::vector<std::string> names;
  for (const std::size_t index : indices) {
    const std::string name = name_of(parameters[index]);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::string ending(const std::vector<std::string>& on) {
  constexpr std::size_t most = 5;
  if (on.empty()) return " without effect on what is measured";
  std::vector<std::string> named(on.begin(),
                                 on.begin() + static_cast<std::ptrdiff_t>(std::min(most, on.size())));
  if (on.size() > most) named.push_back(std::to_string(on.size() - most) + " more");
  return " only together with " + listed(named);
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

std::vector<std::string> sentences(const std::vector<Parameter>& parameters,
                                   const std::vector<Dependence>& dependent) {
  std::vector<std::string> endings;
  std::vector<std::vector<std::string>> subjects;
  for (const Dependence& each : dependent) {
    const std::string text = ending(names_of(parameters, each.on));
    const auto found = std::find(endings.begin(), endings.end(), text);
    const auto place = static_cast<std::size_t>(found - endings.begin());
    if (found == endings.end()) {
      endings.push_back(text);
      subjects.emplace_back();
    }
    subjects[place].push_back(parameters[each.parameter].name);
  }
  std::vector<std::string> result;
  for (std::size_t i = 0; i < endings.size(); ++i) result.push_back(listed(subjects[i]) + endings[i]);
  return result;
}

}  // namespace qvgen::calibrate
