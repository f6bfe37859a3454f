// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "symbolic/program.h"

/// Inverse kinematics derived from a model: what is solved, in which order, by which equation.
namespace qvgen::derive::inverse {

/// The canonical equation that a step solves; each is one building block of the runtime.
enum class Kind {
  circle,       ///< cos φ = (high-low)/(high+low): ±φ from a direction that is a constant of the arm
  free_circle,  ///< the same from a direction (x, y) of the pose, which vanishes where the angle is free
  factored,     ///< cos φ = rhs/|(x, y)| and sin² φ |(x, y)|² = low*high, which rounding does not touch
  opposite,     ///< ±(x, y): a·x = 0 on a circle
  pair,         ///< the direction (x, y): the angle that turns one known vector into another
  root,         ///< ±sqrt(square)
  slides,       ///< a s - b t = k, s² + 2 g s - t² - 2 f t + gap = 0: gives result_1 (the step's joint) and
                ///< result_2
  linear,       ///< one value
  line,  ///< t divisor = rhs, or t (x, y) = (rhs_x, rhs_y): the slide is free where what the pose gives there
         ///< vanishes
  conic,       ///< a conic on the unit circle: a quartic in the half-angle tangent
  slide_turn,  ///< divisor t = l(u), t² + 2 h t + m(u) = 0 for a slide t and a unit vector u, l and m linear:
               ///< a quartic
  require,      ///< no unknown: an equation that the pose must satisfy
  half,         ///< cosine and sine of half an angle already known
  reach,        ///< no unknown: the value that a free angle takes so that the joints after it are in reach
  polish,       ///< Newton steps, after a quartic and wherever a pose is near a singular one
  right_wrist,  ///< three axes at right angles through a point
  oblique_wrist
};

/// One step: inputs from `before`, the building block, then named values from `after`.
///
/// Programs are in terms of the target's values, the geometry, and of names that earlier steps gave. The
/// block's results enter `after` as the symbols cos_result, sin_result (angles), result (lengths; of a
/// direction that is left as long as it is, with the branch's sign) or result_1, result_2 (two lengths).
struct Step {
  Kind kind = Kind::linear;
  int joint = -1;       ///< index of the joint that it determines, -1 if none
  std::string unknown;  ///< that joint's variable, or a name for what else it computes
  int slide = -1;       ///< slide_turn: the other joint's index
  int branches = 1;
  int degree =
      1;  ///< a direction's units: 0 none, 1 a length, 2 a length squared, 4 the square of a short length
  symbolic::Program before;        ///< the block's inputs, by the block's names
  symbolic::Program after;         ///< names that stay
  std::vector<std::string> turns;  ///< wrist, polish: the joints whose values it leaves, in order
  int points = 0;                  ///< polish: how many points the joints carry to their goals
  struct Seed {
    int joint;
    int sense;
  };
  std::vector<Seed> seeds;  ///< reach: the joints whose angles, with their senses, add up to the free one
  bool unit = true;         ///< pair, opposite: the direction is brought to length one
  GiNaC::ex length;         ///< pair: the direction's length, zero if it is not known without a root
  bool length_known =
      false;  ///< the same as an input of the block, of a direction that is left as long as it is
  std::vector<std::string> lengths;  ///< half: the unknowns among its angle's terms that are not
  std::vector<std::string> kept;     ///< those of `after` that a later step or the result reads
  std::string equation;              ///< in words and symbols, for people
  std::string degenerate;            ///< where it loses a branch or an angle becomes free

  /// A block that gives all of its solutions at once, as many as there happen to be.
  [[nodiscard]] bool is_quartic() const { return kind == Kind::conic || kind == Kind::slide_turn; }
  /// An input of the block, written out; 0 if it has none of that name.
  [[nodiscard]] GiNaC::ex input(const std::string& name) const {
    for (const auto& output : before.expanded())
      if (output.name == name) return output.value;
    return 0;
  }
  [[nodiscard]] bool has_input(const std::string& name) const {
    for (const auto& output : before.outputs())
      if (output.name == name) return true;
    return false;
  }
  [[nodiscard]] bool is_wrist() const { return kind == Kind::right_wrist || kind == Kind::oblique_wrist; }
};

/// Value of a joint, as a step leaves it behind.
struct JointValue {
  bool revolute = true;
  std::string cosine;  ///< name of the cosine, or of the length
  std::string sine;
};

/// Constants of a wrist that has oblique axes; the target program computes those that are not numbers.
struct WristPlan {
  std::vector<int> joints;  ///< first, middle, last
  bool right = true;
  bool middle_swapped = false;  ///< right: middle = 2 atan2(|u|, |v|) instead of 2 atan2(|v|, |u|)
  bool ends_the_plan = true;    ///< angles are the output; otherwise cosines and sines for further steps
};

/// Tells without a root, before any branch is followed, that none reaches a pose: `is_out_of_range` of the
/// runtime.
struct RangeTest {
  symbolic::Program values;  ///< middle and swing, from the target; nothing if there is no such test
  std::string unknown;       ///< of the step whose equation has no solution then
  std::string equation;

  [[nodiscard]] bool exists() const { return !values.outputs().empty(); }
  [[nodiscard]] bool is_of(const Step& step) const {
    return exists() && step.kind == Kind::circle && step.unknown == unknown;
  }
};

struct Plan {
  std::string structure;                 ///< "joints 4, 5, 6 meet in a point", ...
  symbolic::Program target;              ///< from the pose to what the steps need
  std::vector<std::string> target_kept;  ///< names of `target` that a step reads
  RangeTest range_test;
  std::vector<Step> steps;
  std::vector<JointValue> joints;  ///< by joint
  WristPlan wrist;
  bool candidates = false;  ///< some rows may miss the pose: not every pose is one of the arm's
  std::vector<int> places;  ///< by joint: where in a row of solutions its value stands
  int row_size = 0;
  int given = -1;  ///< place of what the caller gives
  int capacity = 1;
  /// Whether the joints behind a free one may be out of reach of what has been chosen for it: where they have
  /// to follow the orientation too.
  [[nodiscard]] bool chooses_for_others(const Step& step) const {
    bool follows = false;
    for (const Step& other : steps) follows = follows || other.kind == Kind::reach;
    return follows && step.kind == Kind::opposite && !step.unit;
  }
  [[nodiscard]] bool quartic() const {
    for (const Step& step : steps)
      if (step.is_quartic()) return true;
    return false;
  }
  /// Whether near singular poses branches are looked for as for a quartic: also where a pose may leave a
  /// slide free that the joints behind it have to follow.
  [[nodiscard]] bool searches_nearby() const {
    for (const Step& step : steps)
      if (step.kind == Kind::slides || (step.kind == Kind::line && step.has_input("inner"))) return true;
    return quartic();
  }
};

/// The steps in the order of a first pass, which leaves out Newton steps, or of a careful one: what may wait
/// until the joints are polished then does. An arm with a quartic has no first pass.
std::vector<std::size_t> order(const Plan& plan, bool careful);

}  // namespace qvgen::derive::inverse
