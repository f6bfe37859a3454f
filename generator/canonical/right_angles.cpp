// SPDX-License-Identifier: MIT
#include "canonical/right_angles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include <cln/integer.h>

#include "canonical/mass_key.h"
#include "canonical/right_matrix.h"
#include "exact/named_constant.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"
#include "model/mechanism.h"

namespace qvgen::canonical {
namespace {

/// 4^8 zero poses are looked at in a fraction of a second.
constexpr std::size_t most_turns = 8;

/// The frame in which a link is described, from the place on its joint's axis where the joint's frame is.
struct LinkFrame {
  std::optional<Right> rotation;  ///< in the world; none if it is not by right angles
  LengthVector offset;
};

/// The arm at its described zero pose, seen in the world: offset, then axis of each joint.
struct AtZero {
  std::vector<bool> turns;
  std::vector<IntVector> axes;
  std::vector<LengthVector> offsets;  ///< one more than joints: to the tool
  std::vector<LinkFrame> links;
  Right home;  ///< the tool's rotation
};

bool has_numbers(const model::Displacement& displacement) {
  return std::all_of(displacement.turns.begin(), displacement.turns.end(),
                     [](const model::Turn& turn) { return is_known(turn.angle); });
}

std::optional<AtZero> at_zero(const model::Robot& robot) {
  AtZero arm;
  Definitions definitions;
  Placement walk{identity(), {}};
  const auto go = [&](const model::Displacement& displacement) {
    if (!has_numbers(displacement)) return false;
    walk = walk * to_placement(displacement, definitions);
    return definitions.empty();
  };
  if (!go(robot.base)) return std::nullopt;
  for (const model::Joint& joint : robot.joints) {
    if (!go(joint.before)) return std::nullopt;
    const auto frame = to_right(walk.rotation * from_z_to(joint.axis));
    if (!frame) return std::nullopt;
    arm.turns.push_back(joint.type == model::JointType::revolute);
    arm.axes.push_back(applied(*frame, {0, 0, 1}));
    arm.offsets.push_back(walk.translation);
    walk.translation = {};
    if (!go(joint.after)) return std::nullopt;
    arm.links.push_back({to_right(walk.rotation), walk.translation});
  }
  if (!go(robot.tool)) return std::nullopt;
  arm.offsets.push_back(walk.translation);
  const auto home = to_right(walk.rotation);
  if (!home) return std::nullopt;
  arm.home = *home;
  return arm;
}

/// Puts offsets that a joint does not move behind it: all of an offset before a slide, and the part along the
/// axis before a turn.
AtZero with_offsets_behind(AtZero arm) {
  for (std::size_t i = 0; i < arm.axes.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (arm.turns[i] && k != direction_of(arm.axes[i])) continue;
      arm.offsets[i + 1][k] = arm.offsets[i + 1][k] + arm.offsets[i][k];
      arm.links[i].offset[k] = arm.links[i].offset[k] + arm.offsets[i][k];
      arm.offsets[i][k].clear();
    }
  }
  return arm;
}

/// Puts the offsets of an arm, which are behind its joints, as far in front as they can be; that to the tool
/// comes from behind a slide.
AtZero with_offsets_in_front(AtZero arm) {
  for (std::size_t i = arm.turns.size() - (arm.turns.back() ? 1 : 0); i-- > 0;) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (arm.turns[i] && k != direction_of(arm.axes[i])) continue;
      arm.offsets[i][k] = arm.offsets[i + 1][k];
      arm.offsets[i + 1][k].clear();
      arm.links[i].offset[k] = arm.links[i].offset[k] + cln::cl_R(-1) * arm.offsets[i][k];
    }
  }
  return arm;
}

/// Places of the lengths and their opposites in an order that does not depend on who wrote them: nothing
/// first, what begins with a minus last.
class Ranks {
 public:
  explicit Ranks(const std::vector<LengthVector>& offsets) {
    std::map<std::pair<int, std::string>, int> order;
    for (const LengthVector& offset : offsets)
      for (const Length& length : offset)
        for (const int sign : {1, -1}) order[key(length, sign)];
    int next = 0;
    for (auto& [unused, rank] : order) rank = next++;
    for (const LengthVector& offset : offsets)
      for (const Length& length : offset)
        ranks_.push_back({order.at(key(length, 1)), order.at(key(length, -1))});
  }

  [[nodiscard]] int of(std::size_t offset, std::size_t component, int sign) const {
    return ranks_[3 * offset + component][sign > 0 ? 0 : 1];
  }

 private:
  static std::pair<int, std::string> key(const Length& length, int sign) {
    const std::string text = model::to_string(to_expression(cln::cl_R(sign) * length));
    return {length.empty() ? 1 : text.front() == '-' ? 2 : 0, text};
  }

  std::vector<std::array<int, 2>> ranks_;
};

/// Counts the components of the unit quaternion that a zero pose leaves behind the last joint: one component
/// is a half turn or nothing, two are a right angle or a half turn about a diagonal, four a third of a turn.
int components(const Right& home) {
  const int trace = home[0][0] + home[1][1] + home[2][2];
  if (trace == 3) return 1;
  if (trace == 1) return 2;
  if (trace == 0) return 4;
  return home[0][0] * home[0][0] + home[1][1] * home[1][1] + home[2][2] * home[2][2] == 3 ? 1 : 2;
}

struct ZeroPose {
  std::vector<int> quarters;     ///< by which each joint is turned
  std::vector<IntVector> axes;   ///< there, in the world
  std::vector<Right> rotations;  ///< of the offsets
  Right home;
};

ZeroPose at(const AtZero& arm, std::size_t index) {
  ZeroPose pose;
  Right walk = unturned;
  for (std::size_t i = 0; i < arm.axes.size(); ++i) {
    pose.rotations.push_back(walk);
    pose.axes.push_back(applied(walk, arm.axes[i]));
    pose.quarters.push_back(arm.turns[i] ? static_cast<int>(index % 4) : 0);
    if (!arm.turns[i]) continue;
    walk = product(walk, turned(arm.axes[i], pose.quarters.back()));
    index /= 4;
  }
  pose.rotations.push_back(walk);
  pose.home = product(walk, arm.home);
  return pose;
}

/// The directions that the joints' axes have at a zero pose, numbered in the order in which they come: which
/// of them is called x changes no cost.
using Pattern = std::vector<std::size_t>;

Pattern pattern_of(const ZeroPose& pose) {
  Pattern pattern;
  std::array<std::optional<std::size_t>, 3> numbers;
  std::size_t next = 0;
  for (const IntVector& axis : pose.axes) {
    std::optional<std::size_t>& number = numbers[direction_of(axis)];
    if (!number) number = next++;
    pattern.push_back(*number);
  }
  return pattern;
}

/// Turns that are perpendicular to the direction which has fewest of them, neighbours in one direction being
/// one turn.
std::size_t turns_across(const AtZero& arm, const Pattern& pattern) {
  Pattern turns;
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (arm.turns[i] && (turns.empty() || turns.back() != pattern[i])) turns.push_back(pattern[i]);
  std::size_t most_along = 0;
  for (std::size_t k = 0; k < 3; ++k)
    most_along = std::max(most_along, static_cast<std::size_t>(std::count(turns.begin(), turns.end(), k)));
  return turns.size() - most_along;
}

/// All that the derivations see of a pose, as numbers.
std::vector<int> description_of(const ZeroPose& pose, const Ranks& ranks) {
  std::vector<int> result;
  for (std::size_t i = 0; i < pose.rotations.size(); ++i) {
    for (const IntVector& row : pose.rotations[i]) {
      const std::size_t from = direction_of(row);
      result.push_back(ranks.of(i, from, row[from]));
    }
  }
  for (const IntVector& row : pose.home)
    for (const int entry : row) result.push_back(-entry);
  return result;
}

model::Vector3 to_vector(const LengthVector& v) {
  return {to_expression(v[0]), to_expression(v[1]), to_expression(v[2])};
}

/// At a zero pose at which the link is turned so far.
model::Displacement frame_of(const LinkFrame& link, const Right& turned) {
  if (!link.rotation) return {};
  return {to_turns(euler(to_rotation(product(turned, *link.rotation)))),
          to_vector(to_rotation(turned) * link.offset)};
}

bool has_right_links(const AtZero& arm) {
  return std::all_of(arm.links.begin(), arm.links.end(),
                     [](const LinkFrame& link) { return link.rotation.has_value(); });
}

/// In frames and axes, constants that have a name because they are not rational.
bool has_named_constants(const model::Robot& robot) {
  const std::vector<std::string> symbols = model::symbols(robot);
  return std::any_of(symbols.begin(), symbols.end(),
                     [](const std::string& name) { return exact::named_value(name).has_value(); });
}

Arm to_arm(const model::Robot& robot, const AtZero& zero, const ZeroPose& pose) {
  Arm arm{robot, std::vector<exact::Angle>(robot.joints.size()), std::vector<bool>(robot.joints.size())};
  const auto moved = [&](std::size_t i) {
    return to_vector(to_rotation(pose.rotations[i]) * zero.offsets[i]);
  };
  arm.robot.base = {};
  for (std::size_t i = 0; i < zero.axes.size(); ++i) {
    model::Joint& joint = arm.robot.joints[i];
    joint.before = {{}, moved(i)};
    joint.axis = model::unit_vector(direction_of(pose.axes[i]));
    joint.after = {};
    joint.inertia.frame = frame_of(zero.links[i], pose.rotations[i + 1]);
    arm.reversed[i] = sense_of(pose.axes[i]) < 0;
    // The described angle is the one here plus the quarters, about the described axis.
    const int sense = arm.reversed[i] ? 1 : -1;
    const int quarters = pose.quarters[i] == 3 ? -1 : pose.quarters[i];
    arm.phases[i].pi = cln::cl_RA(sense * quarters) / 2;
  }
  arm.robot.tool = {to_turns(euler(to_rotation(pose.home))), moved(zero.axes.size())};
  return arm;
}

/// The described arm with its offsets behind the joints, if all its angles are right.
std::optional<AtZero> right_angled(const model::Robot& robot) {
  const bool follow = std::any_of(robot.joints.begin(), robot.joints.end(),
                                  [](const model::Joint& joint) { return !joint.follows.empty(); });
  if (robot.joints.empty() || follow || model::branches(robot) || robot.floating_base) return std::nullopt;
  std::optional<AtZero> arm = at_zero(robot);
  if (!arm) return std::nullopt;
  const auto turns = static_cast<std::size_t>(std::count(arm->turns.begin(), arm->turns.end(), true));
  if (turns > most_turns) return std::nullopt;
  return with_offsets_behind(std::move(*arm));
}

/// For each way of the axes, the best first, the zero poses at which the arm looks the same but for its mass.
std::vector<std::vector<std::size_t>> zero_poses(const AtZero& arm) {
  const Ranks ranks(arm.offsets);
  const auto turns = static_cast<std::size_t>(std::count(arm.turns.begin(), arm.turns.end(), true));

  using Key = std::tuple<int, std::size_t, Pattern>;
  struct Best {
    std::vector<int> description;
    std::vector<std::size_t> poses;
  };
  std::map<Key, Best> best;
  for (std::size_t index = 0; index < (std::size_t{1} << (2 * turns)); ++index) {
    const ZeroPose pose = at(arm, index);
    const Pattern pattern = pattern_of(pose);
    Best& place = best[{components(pose.home), turns_across(arm, pattern), pattern}];
    std::vector<int> description = description_of(pose, ranks);
    if (place.poses.empty() || description < place.description)
      place = {std::move(description), {index}};
    else if (description == place.description)
      place.poses.push_back(index);
  }
  std::vector<std::vector<std::size_t>> poses;
  for (auto& [unused, place] : best) poses.push_back(std::move(place.poses));
  return poses;
}

/// Returns one of the poses at which the arm looks the same: the one whose links' masses come first in an
/// order that does not depend on the notation.
ZeroPose by_mass(const model::Robot& robot, const AtZero& arm, const std::vector<std::size_t>& poses) {
  std::vector<MassKey> links;
  for (std::size_t i = 0; i < arm.links.size(); ++i)
    links.emplace_back(robot.joints[i].inertia,
                       Placement{to_rotation(*arm.links[i].rotation), arm.links[i].offset});
  std::vector<std::int64_t> first;
  std::size_t best = poses.front();
  for (const std::size_t index : poses) {
    const ZeroPose pose = at(arm, index);
    std::vector<std::int64_t> key;
    for (std::size_t i = 0; i < links.size(); ++i)
      for (const std::int64_t entry : links[i].turned(pose.rotations[i + 1])) key.push_back(entry);
    if (!first.empty() && first <= key) continue;
    first = std::move(key);
    best = index;
  }
  return at(arm, best);
}

}  // namespace

std::vector<Arm> right_angled_models(const model::Robot& robot) {
  const std::optional<AtZero> arm = right_angled(robot);
  if (!arm) return {};
  std::vector<Arm> arms;
  for (const std::vector<std::size_t>& poses : zero_poses(*arm))
    arms.push_back(to_arm(robot, *arm, at(*arm, poses.front())));
  return arms;
}

Arm whatever_notation(const model::Robot& robot) {
  std::vector<Arm> models = right_angled_models(robot);
  return models.empty() ? for_kinematics(robot) : std::move(models.front());
}

std::vector<Arm> whatever_notation_with_links(const model::Robot& robot) {
  const Arm described{for_dynamics(robot), std::vector<exact::Angle>(robot.joints.size())};
  const std::optional<AtZero> behind = right_angled(robot);
  if (!behind || !has_right_links(*behind)) return {described};
  const ZeroPose pose = by_mass(robot, *behind, zero_poses(*behind).front());
  Arm arm = to_arm(robot, *behind, pose);
  if (has_named_constants(arm.robot)) return {described};
  const AtZero in_front = with_offsets_in_front(*behind);
  const bool slides = std::count(in_front.turns.begin(), in_front.turns.end(), false) > 0;
  if (!slides || in_front.offsets == behind->offsets) return {std::move(arm)};
  return {std::move(arm), to_arm(robot, in_front, pose)};
}

}  // namespace qvgen::canonical
