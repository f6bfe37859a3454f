// SPDX-License-Identifier: MIT
#include "cli/free_items.h"

#include <numbers>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/path_numbers.h"

namespace qvgen::cli {
namespace {

using path::FreeItem;

constexpr double pi = std::numbers::pi;

bool slides(const FreeItem& item) { return item.is("shift") || item.is("base") || item.is("rail"); }

/// The form of a tolerance, for messages.
std::string form_of(const FreeItem& item) {
  if (item.is("cone")) return item.name + "=15deg";
  return item.name + (slides(item) ? "=-2:2mm" : "=-10:20deg");
}

[[noreturn]] void refuse(const FreeItem& item, const std::string& why) {
  throw UsageError(fmt::format("--free {}: {}", item.name, why));
}

/// A number without a sign is as far to both sides.
std::pair<double, double> ends_of(const FreeItem& item, const std::string& text) {
  const std::string option = "--free " + item.name;
  if (text.find(':') != std::string::npos) return range_of(option, text);
  if (item.is_seventh() || item.is("rail")) refuse(item, "LOWER:UPPER is missing");
  const double half = number_of(option, text);
  if (half < 0) refuse(item, text + " is below zero; a range is LOWER:UPPER");
  return {-half, half};
}

/// A unit that is forgotten makes a tolerance that nobody has.
void check_size(const FreeItem& item) {
  const auto [lower, upper] = *item.range;
  const double most = std::max(-lower, upper);
  if (item.is("cone") && -lower != upper) refuse(item, "a cone has one half angle, " + form_of(item));
  if (item.is("cone") && most >= pi) refuse(item, "the half angle is half a turn or more; degrees are 15deg");
  if (item.is("tool") && most > 2 * pi) refuse(item, "more than a whole turn; degrees are 10deg");
  if ((item.is("shift") || item.is("base")) && most > 1)
    refuse(item, "more than a metre; millimetres are 2mm");
}

void check_unit(const FreeItem& item, const std::string& text) {
  const bool has_angle = text.find("deg") != std::string::npos,
             has_length = text.find("mm") != std::string::npos;
  if (has_angle && slides(item))
    refuse(item, "a length in degrees; lengths are in m, or mm as in " + form_of(item));
  if (has_length && !slides(item) && !item.is_seventh())
    refuse(item, "an angle in millimetres; angles are in rad, or deg as in " + form_of(item));
}

FreeItem item_of(const std::string& word) {
  const std::size_t mark = word.find('=');
  FreeItem item{word.substr(0, mark), std::nullopt};
  if (item.name.empty()) throw UsageError("--free " + word + ": a name is missing");
  if (mark == std::string::npos) return item;
  const std::string text = word.substr(mark + 1);
  check_unit(item, text);
  item.range = ends_of(item, text);
  check_size(item);
  return item;
}

void check_ranges(const std::vector<FreeItem>& items) {
  for (const FreeItem& item : items) {
    const bool needs = item.is("cone") || item.is("shift") || item.is("base");
    if (needs && !item.range) refuse(item, "its tolerance is missing, " + form_of(item));
  }
}

/// Two of them would be the same freedom twice, or make a tolerance larger than it is.
void check_pair(const FreeItem& a, const FreeItem& b) {
  if (a.name == b.name) refuse(a, "is named twice");
  if (a.is_seventh() && b.is_seventh())
    refuse(b, "one joint or the arm angle is free, not " + a.name + ", too");
  if (a.is("cone") && b.is("cone")) refuse(b, "there is one cone, " + a.name);
  if (a.is("cone") && b.is("tool") && a.name.back() != b.name.back())
    refuse(a, "the cone has the turn " + b.name + " in it; leave that out");
}

}  // namespace

std::vector<FreeItem> free_items(const std::vector<std::string>& words, const std::string& range) {
  std::vector<FreeItem> items;
  std::size_t coordinates = 0;
  for (const std::string& word : words) {
    items.push_back(item_of(word));
    coordinates += items.back().is("cone") ? 2 : 1;
  }
  if (!range.empty()) {
    if (items.size() != 1 || items.front().range || items.front().is("cone"))
      throw UsageError("--range is for one free coordinate; others have theirs as in " +
                       form_of(items.front()));
    items.front().range = range_of("--range", range);
    check_size(items.front());
  }
  check_ranges(items);
  for (const FreeItem& a : items)
    for (const FreeItem& b : items)
      if (&a != &b) check_pair(a, b);
  if (coordinates > 8) throw UsageError("--free: there are more than eight coordinates");
  return items;
}

}  // namespace qvgen::cli
