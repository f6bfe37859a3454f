// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/kinds/kinds.h"
#include "symbolic/program.h"

/// Inverse kinematics derived from a model: what is solved, in which order, by which equation.
namespace qvgen::derive::inverse {

/// Elements of the pairs M_i = N_i (thesis, (1.22) and (1.23)) that an equation compares: 1 to 4 are the
/// quaternion's, 5 to 7 the vector's, which is that of the point that the step places.
struct Elements {
  int joint = -1;  ///< index of joint i
  std::vector<int> indices = {};

  [[nodiscard]] bool of_vector() const { return !indices.empty() && indices.back() > 4; }
};

/// One step: inputs from `before`, the building block of its kind, then named values from `after`.
///
/// Programs are in terms of the target's values, the geometry, and of names that earlier steps gave. The
/// block's results enter `after` as the symbols cos_result, sin_result (angles), result (lengths; of a
/// direction that is left as long as it is, with the branch's sign) or result_1, result_2 (two lengths).
struct Step : Unknown {
  Kind kind;
  symbolic::Program before;       ///< the block's inputs, by the block's names
  symbolic::Program after;        ///< names that stay
  std::vector<std::string> kept;  ///< those of `after` that a later step or the result reads
  std::string equation;           ///< in words and symbols, for people
  Elements elements;              ///< that it compares; none where these are not elements of M_i = N_i
  std::string degenerate;         ///< where it loses a branch or an angle becomes free

  template <class K>
  [[nodiscard]] bool is() const {
    return std::holds_alternative<K>(kind);
  }
  template <class K>
  [[nodiscard]] const K* as() const {
    return std::get_if<K>(&kind);
  }

  /// A block that gives all of its solutions at once, as many as there happen to be.
  [[nodiscard]] bool is_quartic() const {
    return is<kind::Conic>() || is<kind::SlideTurn>() || is<kind::TwoTurns>();
  }
  /// The wrist, nothing if the step is none.
  [[nodiscard]] const kind::Wrist* wrist() const {
    if (const auto* right = as<kind::RightWrist>()) return right;
    return as<kind::ObliqueWrist>();
  }
  /// True if it is the wrist behind which nothing comes: it gives angles, not cosines and sines.
  [[nodiscard]] bool ends_plan() const { return wrist() != nullptr && wrist()->ends_the_plan; }
  /// The direction that a joint follows, nothing if the step has none.
  [[nodiscard]] const kind::Direction* direction() const {
    if (const auto* opposite = as<kind::Opposite>()) return opposite;
    return as<kind::Pair>();
  }
  /// True if the direction is left as long as it is, and its length kept.
  [[nodiscard]] bool keeps_length() const { return direction() != nullptr && !direction()->unit; }
  /// Indices of the joints whose values it leaves. A sum of angles is none, and so is a joint that is held.
  [[nodiscard]] std::vector<int> joints() const {
    std::vector<int> left = wrist() != nullptr ? wrist()->joints : std::vector<int>{joint};
    std::erase(left, -1);
    return left;
  }

  /// An input of the block, written out; 0 if it has none of that name.
  [[nodiscard]] GiNaC::ex input(const std::string& name) const {
    for (const auto& output : before.expanded())
      if (output.name == name) return output.value;
    return 0;
  }
};

/// Value of a joint, as a step leaves it behind.
struct JointValue {
  bool revolute = true;
  std::string cosine;  ///< name of the cosine, or of the length
  std::string sine;
};

/// Tells without a root, before any branch is followed, that none reaches a pose: `is_out_of_range` of the
/// runtime.
struct RangeTest {
  symbolic::Program values;  ///< middle and swing, from the target; nothing if there is no such test
  std::string unknown;       ///< of the step whose equation has no solution then
  std::string equation;

  [[nodiscard]] bool exists() const { return !values.outputs().empty(); }
  [[nodiscard]] bool is_of(const Step& step) const {
    return exists() && step.is<kind::Circle>() && step.unknown == unknown;
  }
};

struct Plan {
  std::string structure;                 ///< "joints 4, 5, 6 meet in a point", ...
  symbolic::Program target;              ///< from the pose to what the steps need
  std::vector<std::string> target_kept;  ///< names of `target` that a step reads
  RangeTest range_test;
  std::vector<Step> steps;
  std::vector<JointValue> joints;  ///< by joint
  bool candidates = false;         ///< some rows may miss the pose: not every pose is one of the arm's
  std::vector<int> places;         ///< by joint: where in a row of solutions its value stands
  int row_size = 0;
  int given = -1;  ///< place of what the caller gives
  int capacity = 1;
  [[nodiscard]] bool has_oblique_wrist() const {
    for (const Step& step : steps)
      if (step.is<kind::ObliqueWrist>()) return true;
    return false;
  }
  [[nodiscard]] bool quartic() const {
    for (const Step& step : steps)
      if (step.is_quartic()) return true;
    return false;
  }
  /// True if a pose may leave a joint free while the others can follow for few of its angles: one about whose
  /// axis the arm turns when it is stretched, or a first one whose axis the tool's point is on, if the others
  /// have to follow the orientation too.
  [[nodiscard]] bool follows_for_few_angles() const {
    bool reaches = false, is_opposite = false;
    for (const Step& step : steps) {
      if (const auto* pair = step.as<kind::Pair>(); pair != nullptr && pair->at_double_root) return true;
      reaches = reaches || step.is<kind::Reach>();
      is_opposite = is_opposite || step.is<kind::Opposite>();
    }
    return reaches && is_opposite;
  }
  /// True if near singular poses branches are looked for as for a quartic: also where a pose may leave a
  /// slide free that the joints behind it have to follow.
  [[nodiscard]] bool searches_nearby() const {
    for (const Step& step : steps) {
      const auto* line = step.as<kind::Line>();
      if (step.is<kind::Slides>() || (line != nullptr && line->reach != kind::Line::Reach::any)) return true;
    }
    return quartic();
  }
};

/// The steps in the order of a first pass, which leaves out Newton steps, or of a careful one: what may wait
/// until the joints are polished then does. An arm with a quartic has no first pass.
std::vector<std::size_t> order(const Plan& plan, bool careful);

}  // namespace qvgen::derive::inverse
