// SPDX-License-Identifier: MIT
#pragma once

// Random arms, written as TOML.
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "axes.h"

namespace qvgen::test {

class RandomWriter {
 public:
  RandomWriter(std::string name, std::uint32_t seed)
      : name_(std::move(name)), random_(seed), place_(static_cast<int>(seed % 4)) {}

  std::string pieper() {
    std::string joints;
    for (int i = 0; i < 6; ++i) joints += i >= place_ && i < place_ + 3 ? wrist_joint(i) : arm_joint(i);
    return description("random Pieper arm", joints);
  }

  std::string parallel_axes() {
    if (below(6) == 0) return link_table();
    const Axis common = axis();
    std::string joints;
    for (int i = 0; i < 6; ++i)
      joints += i >= place_ && i < place_ + 3 ? parallel_joint(i, common) : turning_joint(i, common);
    return description("random arm with three parallel axes", joints);
  }

  /// One of these with one more joint, q7, whose value is given: anywhere but among the three axes.
  std::string seven() {
    const bool meet = below(2) == 0;
    const Axis common = axis();
    int at = below(5);
    if (at > place_) at += 2;
    std::string joints;
    for (int i = 0; i <= 6; ++i) {
      if (i == at) joints += arm_joint(6);
      if (i == 6) break;
      const bool three = i >= place_ && i < place_ + 3;
      if (meet)
        joints += three ? wrist_joint(i) : arm_joint(i);
      else
        joints += three ? parallel_joint(i, common) : turning_joint(i, common);
    }
    return description("random arm of seven joints", joints, "given = \"q7\"\n");
  }

  /// Three slides and three turns in any order, no two turns in a row about parallel axes.
  std::string three_slides() {
    int slides = 3;
    bool turned = false;
    Axis before{};
    std::string joints;
    for (int i = 0; i < 6; ++i) {
      const bool slide = below(6 - i) < slides;
      slides -= slide ? 1 : 0;
      Axis along = axis();
      while (!slide && turned && parallel(along, before)) along = axis();
      if (!slide) before = along;
      turned = turned || !slide;
      const std::string origin = offset();
      joints += joint(i, !slide, along, origin, slide ? "" : offset());
    }
    return description("random arm with three slides", joints);
  }

  /// Four joints that a position and a pitch determine: a turn, then turns about one direction and at most
  /// one slide across it, the last a turn. Every second arm has one joint more, whose value is given: behind
  /// the others, before them, or between the first and the rest.
  std::string pitched() {
    const Axis common = axis();
    constexpr std::array<int, 4> places{4, 4, 0, 1};
    const int given = below(2) == 0 ? places.at(static_cast<std::size_t>(below(4))) : -1;
    const std::string joints = turned_plane(common, given, 4);
    Axis tool = axis();
    while (parallel(tool, common)) tool = axis();
    return description("random arm with a pitch", joints,
                       "task = \"position_and_pitch\"\ntool_axis = " + text(tool) + "\n" + given_key(given));
  }

  /// Such an arm with a roll behind it: five joints that a position and an inclination determine, or six of
  /// which one is given: before the others or behind them, behind the first, or before the roll.
  std::string inclined() {
    const Axis common = axis();
    constexpr std::array<int, 4> places{0, 1, 4, 5};
    const int given = below(2) == 0 ? places.at(static_cast<std::size_t>(below(4))) : -1;
    return description("random arm with an inclination", turned_plane(common, given, 5),
                       "task = \"position_and_inclination\"\n" + given_key(given));
  }

  /// Five joints of any geometry, or six of which one is given, that a position and an inclination determine:
  /// at most one of those that are solved for slides, and no axis is parallel to the next but by chance.
  std::string heading() {
    const int given = below(3) == 0 ? below(6) : -1;
    const int count = given < 0 ? 5 : 6;
    const int slide = below(2) == 0 ? below(count) : -1;
    return description("random arm with a heading", skew_joints(count, slide, -1),
                       "task = \"position_and_inclination\"\n" + given_key(given));
  }

  /// Six joints with a wrist or three parallel axes; the generator chooses the one to give.
  std::string directed(const std::string& keys) {
    const bool meet = below(2) == 0;
    const Axis common = axis();
    return description("random arm with a direction", three_among(6, meet, common), keys);
  }

  /// Six joints, five, or seven of which one is given; no two axes meet or are parallel but by chance.
  std::string unstructured() {
    const int count = 5 + static_cast<int>(random_() % 3);
    const int slide = below(3) == 0 ? below(count) : -1;
    const int other = slide >= 0 && below(2) == 0 ? (slide + 1 + below(count - 1)) % count : -1;
    return description("random arm without structure", skew_joints(count, slide, other),
                       count == 7 ? "given = \"q4\"\n" : "");
  }

 protected:
  /// Joints of which three have axes that meet or are parallel.
  std::string three_among(int count, bool meet, const Axis& common) {
    std::string joints;
    for (int i = 0; i < count; ++i) {
      const bool three = i >= place_ && i < place_ + 3;
      if (meet)
        joints += three ? wrist_joint(i) : arm_joint(i);
      else
        joints += three ? parallel_joint(i, common) : turning_joint(i, common);
    }
    return joints;
  }

  /// Joints of which two may slide; no two axes meet or are parallel but by chance.
  std::string skew_joints(int count, int slide, int other) {
    std::string joints;
    for (int i = 0; i < count; ++i) {
      Axis along = axis();
      while (i > 0 && parallel(along, before_)) along = axis();
      before_ = along;
      const std::string origin = i > 0 ? offset_of_any_length() : offset();
      const bool slides = i == slide || i == other;
      const bool has_tool = i + 1 == count && !slides;
      joints += joint(i, !slides, along, origin, has_tool ? offset() : "[0, 0, 0]");
    }
    return joints;
  }

  /// A turn, then turns about `common` and at most one slide across it, the last of the three a turn; with
  /// `count` 5 a roll. One joint more stands at `given`, if that is not negative.
  std::string turned_plane(const Axis& common, int given, int count) {
    Axis first = axis();
    while (parallel(first, common)) first = axis();
    Axis roll = common;
    while (count > 4 && parallel(roll, common)) roll = axis();
    std::vector<Axis> across;
    std::copy_if(unit_axes.begin(), unit_axes.end(), std::back_inserter(across),
                 [&](const Axis& each) { return is_across(each, common); });
    const int slide = across.empty() ? 0 : below(3);  // 1 or 2, 0 for none
    std::string joints;
    int number = 0;
    for (int i = 0; i <= count; ++i) {
      if (i == given) joints += arm_joint(number++);
      if (i == count) break;
      const bool slides = i > 0 && i == slide;
      const std::string origin = link();
      joints += joint(number++, !slides,
                      i == 0   ? first
                      : i == 4 ? roll
                      : slides ? across[static_cast<std::size_t>(below(static_cast<int>(across.size())))]
                               : common,
                      origin, link());
    }
    return joints;
  }

  static std::string given_key(int given) {
    return given < 0 ? "" : "given = \"q" + std::to_string(given + 1) + "\"\n";
  }

  std::string description(const std::string& title, const std::string& joints,
                          const std::string& keys = "") const {
    std::string text = "name = \"" + name_ + "\"\ntitle = \"" + title + "\"\n" + keys;
    if (symbols_ > 0) text += "[defaults]\n";
    for (int i = 0; i < symbols_; ++i)
      text += "l" + std::to_string(i) + " = \"" + std::to_string(2 + 3 * i % 7) + "/11\"\n";
    return text + joints;
  }

  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }

  Axis axis() {
    const bool oblique = below(3) == 0;
    return unit_axes[static_cast<std::size_t>(oblique ? along_coordinates + below(8)
                                                      : below(along_coordinates))];
  }

  static std::string vector(const std::array<std::string, 3>& v) {
    return "[" + v[0] + ", " + v[1] + ", " + v[2] + "]";
  }
  static std::string quotient(int number, int by) {
    return number == 0 ? "0" : "\"" + std::to_string(number) + "/" + std::to_string(by) + "\"";
  }
  static std::string text(const Axis& a) {
    return vector({quotient(a[0], a[3]), quotient(a[1], a[3]), quotient(a[2], a[3])});
  }

  std::string length() {
    switch (below(6)) {
      case 0:
        return "\"l" + std::to_string(symbols_++) + "\"";
      case 1:
        return "\"-" + std::to_string(1 + below(6)) + "/9\"";
      case 2:
        return "\"" + std::to_string(1 + below(6)) + "/7\"";
      default:
        return "0";
    }
  }
  std::string offset() {
    const std::string x = length();
    const std::string y = length();
    return vector({x, y, length()});
  }

  /// Away from all coordinate axes; one length in five is a symbol.
  std::string offset_of_any_length() {
    const auto any = [&] {
      return below(5) == 0 ? "\"l" + std::to_string(symbols_++) + "\""
                           : "\"" + std::to_string(1 + below(9)) + "/" + std::to_string(11 + below(7)) + "\"";
    };
    const std::string x = any();
    const std::string y = any();
    return vector({x, y, any()});
  }

  std::string joint(int i, bool revolute, const Axis& along, const std::string& origin,
                    const std::string& link) {
    std::string result = "[[joint]]\ntype = \"" + std::string(revolute ? "revolute" : "prismatic") +
                         "\"\naxis = " + text(along) + "\nvariable = \"q" + std::to_string(i + 1) +
                         "\"\norigin = " + origin + "\n";
    if (revolute) result += "link = " + link + "\n";
    return result;
  }

  std::string arm_joint(int i) {
    const bool revolute = below(5) < 3;
    const Axis along = axis();
    const std::string origin = offset();
    return joint(i, revolute, along, origin, revolute ? offset() : "");
  }

  /// Offsets before the first and after the last of the three only: their axes meet where the second stands.
  std::string wrist_joint(int i) {
    Axis along = axis();
    while (i > place_ && parallel(along, before_)) along = axis();
    before_ = along;
    const std::string none = "[0, 0, 0]";
    const std::string origin = i == place_ ? offset() : none;
    return joint(i, true, along, origin, i == place_ + 2 ? offset() : none);
  }

  /// Offsets across the axes: none of the three coincides with another one but by chance.
  std::string parallel_joint(int i, const Axis& common) {
    Axis along = common;
    if (below(4) == 0)
      for (int k = 0; k < 3; ++k) along[static_cast<std::size_t>(k)] *= -1;
    const std::string origin = i == place_ ? offset() : "[0, 0, 0]";
    return joint(i, true, along, origin, i == place_ + 2 ? offset() : link());
  }

  std::string link() {
    const auto quotient = [&] { return "\"" + std::to_string(1 + below(8)) + "/11\""; };
    const std::string x = quotient();
    const std::string y = quotient();
    return vector({x, y, quotient()});
  }

  /// One of the other joints, not parallel to the three beside it; without an offset it meets the joint
  /// before.
  std::string turning_joint(int i, const Axis& common) {
    Axis along = axis();
    const bool same = below(6) == 0 && i > 0 && i != place_ + 3;
    if (same) along = before_;
    const bool beside = i == place_ - 1 || i == place_ + 3;
    while (beside && parallel(along, common)) along = axis();
    before_ = along;
    const std::string origin = i == 0 || !(same || below(3) > 0) ? "[0, 0, 0]" : link();
    return joint(i, true, along, origin, i == 5 ? offset() : "[0, 0, 0]");
  }

  /// As a table of Denavit and Hartenberg, whose twists may be symbols.
  std::string link_table() {
    std::string joints;
    for (int i = 0; i < 6; ++i) {
      const bool parallel_to_next = i == place_ || i == place_ + 1;
      const std::string number = "\"" + std::to_string(1 + below(8)) + "/11\"";
      joints += "[[dh]]\ntype = \"revolute\"\nvariable = \"q" + std::to_string(i + 1) +
                "\"\nd = " + length() + "\na = " + (parallel_to_next ? number : length()) +
                "\nalpha = " + (parallel_to_next ? "0" : twist()) + "\n";
    }
    return description("random arm with three parallel axes", joints, "convention = \"standard\"\n");
  }

  std::string twist() {
    constexpr std::array<const char*, 4> twists{"90 deg", "-90 deg", "-90 deg", "60 deg"};
    const int which = below(5);
    return "\"" +
           (which == 4 ? "l" + std::to_string(symbols_++)
                       : std::string(twists[static_cast<std::size_t>(which)])) +
           "\"";
  }

  std::string name_;
  std::mt19937 random_;
  int place_;  ///< of the first of the three joints whose axes meet or are parallel
  int symbols_ = 0;
  Axis before_{};
};

}  // namespace qvgen::test
