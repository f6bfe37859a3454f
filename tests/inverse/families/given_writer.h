// SPDX-License-Identifier: MIT
#pragma once

// Random arms with joints given anywhere, beside a pose, a direction, an inclination, a pitch or a position.
#include <cstddef>

#include "random_writer.h"

namespace qvgen::test {

/// Writes an arm whose joints are determined by what is asked for, and among them one or two more, turns or
/// slides, whose values are given. Given joints between axes that are parallel turn about these or slide,
/// those between axes that meet turn about an axis through the same point. Some arms have axes that neither
/// meet nor are parallel.
class GivenWriter : private RandomWriter {
 public:
  enum class Asked { pitch, inclination, direction, position, pose };

  GivenWriter(std::string name, std::uint32_t seed, Asked asked)
      : RandomWriter(std::move(name), seed),
        asked_(asked),
        in_a_plane_(asked != Asked::direction && asked != Asked::pose),
        common_(axis()),
        meet_(!in_a_plane_ && below(2) == 0),
        skew_(asked != Asked::pitch && asked != Asked::position && below(4) == 0) {
    if (!in_a_plane_) place_ = below(solved() - 2);
  }

  [[nodiscard]] std::string task() const {
    constexpr std::array<const char*, 5> tasks{"position_and_pitch", "position_and_inclination",
                                               "position_and_direction", "position", "pose"};
    return tasks.at(static_cast<std::size_t>(asked_));
  }

  std::string write() {
    std::vector<Joint> joints = split(determined());
    for (int more = 1 + below(2); more > 0; --more) insert_given(joints);
    return description("random arm with joints given anywhere", numbered(joints),
                       "task = \"" + task() + "\"\n" + axis_of_tool() + given_line(joints));
  }

 private:
  struct Joint {
    std::string text;
    bool given = false;
  };

  /// How many joints what is asked for determines.
  [[nodiscard]] int solved() const {
    constexpr std::array<int, 5> counts{4, 5, 5, 3, 6};
    return counts.at(static_cast<std::size_t>(asked_));
  }

  std::string determined() {
    if (skew_) return skew_joints(solved(), below(2 * solved()), -1);
    return in_a_plane_ ? turned_plane(common_, -1, solved()) : three_among(solved(), meet_, common_);
  }

  void insert_given(std::vector<Joint>& joints) {
    const auto at = joints.begin() + below(static_cast<int>(joints.size()) + 1);
    const auto before = std::count_if(joints.begin(), at, [](const Joint& joint) { return !joint.given; });
    const int first = in_a_plane_ ? 1 : place_, last = in_a_plane_ ? std::min(solved(), 4) : place_ + 3;
    const bool is_within = !skew_ && before > first && before < last;
    const std::string text = !is_within ? arm_joint(0) : meet_ ? turn_through_the_point() : joint_along();
    joints.insert(at, {text, true});
  }

  /// A turn about an axis that is parallel to others, or a slide in any direction.
  std::string joint_along() {
    const bool revolute = below(2) == 0;
    const Axis along = revolute ? common_ : axis();
    const std::string origin = offset();
    return joint(0, revolute, along, origin, revolute ? offset() : "");
  }
  std::string turn_through_the_point() { return joint(0, true, axis(), "[0, 0, 0]", "[0, 0, 0]"); }

  static std::vector<Joint> split(const std::string& joints) {
    std::vector<Joint> all;
    for (std::size_t at = 0; at != std::string::npos;) {
      const std::size_t next = joints.find("[[joint]]", at + 1);
      all.push_back({joints.substr(at, next - at)});
      at = next;
    }
    return all;
  }

  static std::string variable(std::size_t joint) { return "q" + std::to_string(joint + 1); }

  /// The joints with their variables in a row.
  static std::string numbered(const std::vector<Joint>& joints) {
    const std::string key = "variable = \"";
    std::string all;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const std::string& text = joints[i].text;
      const std::size_t at = text.find(key) + key.size();
      all += text.substr(0, at) + variable(i) + text.substr(text.find('"', at));
    }
    return all;
  }

  static std::string given_line(const std::vector<Joint>& joints) {
    std::string names;
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (joints[i].given) names += (names.empty() ? "" : ", ") + variable(i);
    return "given = \"" + names + "\"\n";
  }

  /// The axis of a pitch is not along those that the pitch is about.
  std::string axis_of_tool() {
    if (asked_ != Asked::pitch && asked_ != Asked::direction) return "";
    Axis tool = axis();
    while (asked_ == Asked::pitch && parallel(tool, common_)) tool = axis();
    return "tool_axis = " + RandomWriter::text(tool) + "\n";
  }

  Asked asked_;
  bool in_a_plane_;  ///< all joints but the first, and a roll, move in one plane
  Axis common_;      ///< of the joints whose axes are parallel
  bool meet_;        ///< three axes meet; else three are parallel
  bool skew_;        ///< neither: axes lie anyhow
};

}  // namespace qvgen::test
