// SPDX-License-Identifier: MIT
#include "pipeline/six_rods.h"

#include <algorithm>
#include <stdexcept>

#include "emit/template_values.h"
#include "pipeline/assembly_values.h"
#include "verify/loops/six_rods.h"

namespace qvgen::pipeline {
namespace {

using inverse::six_rods::Complex;
using nlohmann::json;

/// Digits of a point at the start: Newton's steps give the others.
constexpr int kept_digits = 10;

std::string number(double value) { return fmt::format("{}", value); }
std::string number(Complex value) { return fmt::format("{{{}, {}}}", value.re, value.im); }

std::string rounded(Complex value) {
  return fmt::format("{{{:.{}g}, {:.{}g}}}", value.re, kept_digits, value.im, kept_digits);
}

/// A list in braces. Arrays of structures need two pairs.
template <class List, class Text>
std::string braces(const List& list, const Text& text, bool twice) {
  std::string inner;
  for (const auto& each : list) inner += (inner.empty() ? "" : ", ") + text(each);
  return twice ? "{{" + inner + "}}" : "{" + inner + "}";
}

std::string text_of(const std::array<double, 3>& v) {
  return braces(
      v, [](double each) { return number(each); }, false);
}
template <class List>
std::string complexes(const List& list) {
  return braces(
      list, [](Complex each) { return number(each); }, true);
}
template <class List>
std::string vectors(const List& list) {
  return braces(
      list, [](const auto& each) { return text_of(each); }, true);
}

std::string text_of_count(const verify::CountedPlaces& counted) {
  return fmt::format("{} complex places, counted from the 40 of a general platform in two runs",
                     counted.points.size());
}

void check_tip(const json& tips, std::size_t tip) {
  if (tip < tips.size() && tips[tip]["inverse"] != false) return;
  throw std::domain_error("assemblies from its rods need the inverse kinematics of the tip on the platform");
}

std::vector<std::string> flags_of(std::size_t count, const std::vector<std::size_t>& joints) {
  std::vector<std::string> list(count, "false");
  for (const std::size_t joint : joints) list[joint] = "true";
  return list;
}

void add_table(const verify::CountedPlaces& counted, json& values) {
  values["unit"] = number(counted.unit);
  values["base_centre"] = text_of(counted.base_centre);
  values["platform_centre"] = text_of(counted.platform_centre);
  values["base"] = vectors(counted.ends.base);
  values["platform"] = vectors(counted.ends.platform);
  values["squares"] = complexes(counted.squares);
  values["patch"] = complexes(counted.patch);
  values["points"] = json::array();
  for (const auto& point : counted.points)
    values["points"].push_back({{"point", braces(
                                              point, [](Complex each) { return rounded(each); }, true)}});
}

}  // namespace

bool is_on_six_rods(const model::Mechanism& mechanism) { return verify::six_rods_of(mechanism).has_value(); }

std::string text_of_places(const model::Mechanism& mechanism) {
  const auto rods = verify::six_rods_of(mechanism);
  return rods ? text_of_count(verify::count_places(rods->ends)) : "";
}

json six_rods_variant(const model::Mechanism& mechanism, const LoopVariant& variant, const json& tips) {
  const auto rods = verify::six_rods_of(mechanism);
  check_tip(tips, rods->tip);
  const verify::CountedPlaces counted = verify::count_places(rods->ends);
  const model::Frame& tip = mechanism.tips[rods->tip];
  std::vector<std::string> lengths;
  for (const std::size_t joint : rods->lengths) lengths.push_back(fmt::format("q[{}]", joint));
  json values{
      {"function", variant.function},
      {"type", variant.type},
      {"space", variant.space},
      {"doc", fmt::format("All assemblies for values of {}, one for each place of the platform; at most {}.",
                          described_names(mechanism.robot, variant.given), counted.points.size())},
      {"summary",
       emit::lines_of({text_of_count(counted), "a path leads from each to the places for given lengths"})},
      {"certificate",
       "Each call proves its rows and that none is missing, or says incomplete: where places meet."},
      {"capacity", counted.points.size()},
      {"argument", variant.argument},
      {"argument_type", "Driven"},
      {"given", commas(variant.given)},
      {"given_count", variant.given.size()},
      {"given_flags", commas(flags_of(mechanism.robot.joints.size(), variant.given))},
      {"rods", true},
      {"tip", tip.name},
      {"chain", commas(model::path(mechanism.robot, model::base_link, tip.joint))},
      {"lengths", commas(lengths)}};
  add_table(counted, values);
  return values;
}

}  // namespace qvgen::pipeline
