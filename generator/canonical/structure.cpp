// SPDX-License-Identifier: MIT
#include "canonical/structure.h"

#include <algorithm>
#include <cmath>

#include "canonical/arm.h"
#include "canonical/placement.h"
#include "model/evaluate.h"
#include "model/followers.h"

namespace qvgen::canonical {
namespace {

using Axis = std::array<double, 3>;

double dot(const Axis& a, const Axis& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Axis cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Relation relation_of(const cln::cl_R& cosine) {
  constexpr double nothing = 1e-30;  // of values in sixty digits
  if (std::abs(cln::double_approx(cosine)) < nothing) return Relation::perpendicular;
  const bool parallel = std::abs(cln::double_approx(1 - cln::abs(cosine))) < nothing;
  return parallel ? Relation::parallel : Relation::oblique;
}

/// Axes that lie to each other as the structure says, the second joint turned by some angle.
std::array<Axis, 3> some_axes(const Structure& structure) {
  constexpr double oblique = 0.6435011087932844;  // 3, 4, 5
  const auto angle = [&](Relation r) {
    return r == Relation::parallel ? 0 : r == Relation::perpendicular ? M_PI / 2 : oblique;
  };
  const double first = angle(structure.relations[0]), second = angle(structure.relations[1]);
  // Axis 2 is z; the others lean from it, the third in a direction that the relation of the ends, or any
  // turn, gives.
  double heading = 1;
  if (!structure.turns[1] && std::sin(first) * std::sin(second) > 1e-9)
    heading = std::acos(std::clamp((std::cos(angle(structure.ends)) - std::cos(first) * std::cos(second)) /
                                       (std::sin(first) * std::sin(second)),
                                   -1.0, 1.0));
  return {Axis{std::sin(first), 0, std::cos(first)}, Axis{0, 0, 1},
          Axis{std::sin(second) * std::cos(heading), std::sin(second) * std::sin(heading), std::cos(second)}};
}

/// Exchanges joints k and k + 1, which commute; the relations follow from the axes.
std::optional<Structure> exchanged(const Structure& s, std::size_t k) {
  const bool slides = !s.turns[k] && !s.turns[k + 1];
  const bool cylinder = s.turns[k] != s.turns[k + 1] && s.relations[k] == Relation::parallel;
  if (!slides && !cylinder) return std::nullopt;
  Structure result = s;
  std::swap(result.turns[k], result.turns[k + 1]);
  const std::size_t other = 1 - k;
  if (cylinder) {
    // One direction for both: all relations stay, and now the ends have one, or none.
    result.ends = result.turns[1] ? Relation::oblique : s.relations[other];
  } else {
    // Each pair of three fixed directions keeps its relation: the slide that comes next to the third joint
    // brings its own.
    std::swap(result.relations[other], result.ends);
    if (result.turns[1]) result.ends = Relation::oblique;
  }
  return result;
}

}  // namespace

std::optional<Structure> structure_of(const model::Robot& robot) {
  if (robot.joints.size() < 3 || model::has_followers(robot)) return std::nullopt;
  const Arm arm = along_normals(robot);
  Rotation frame = identity();
  std::array<Rotation, 3> frames;
  Structure result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const model::Joint& joint = arm.robot.joints[i];
    for (const auto* displacement : {&joint.before, &joint.after})
      for (const model::Turn& turn : displacement->turns)
        if (!is_known(turn.angle)) return std::nullopt;
    Definitions definitions;
    frame = frame * to_placement(joint.before, definitions).rotation * from_z_to(joint.axis);
    frames[i] = frame;
    frame = frame * transpose(from_z_to(joint.axis)) * to_placement(joint.after, definitions).rotation;
    result.turns[i] = joint.type == model::JointType::revolute;
  }
  const auto relation = [&](std::size_t i, std::size_t k) {
    cln::cl_R cosine = 0;
    for (std::size_t row = 0; row < 3; ++row) cosine = cosine + frames[i][row][2] * frames[k][row][2];
    return relation_of(cosine);
  };
  result.relations = {relation(0, 1), relation(1, 2)};
  if (!result.turns[1]) result.ends = relation(0, 2);
  return result;
}

std::string types_of(const Structure& structure) {
  std::string types;
  for (const bool turn : structure.turns) types += turn ? 'R' : 'P';
  return types;
}

std::string pattern_of(const Structure& structure) {
  const auto name = [](Relation r) {
    return r == Relation::parallel ? "parallel" : r == Relation::perpendicular ? "perpendicular" : "oblique";
  };
  return std::string(name(structure.relations[0])) + ", " + name(structure.relations[1]);
}

std::optional<std::string> code_of(const Structure& s) {
  const bool right_angled =
      std::none_of(s.relations.begin(), s.relations.end(), [](Relation r) { return r == Relation::oblique; });
  if (!right_angled || (s.turns[1] && !s.turns[0] && !s.turns[2]) || !is_useful(s)) return std::nullopt;
  const auto letter = [&](std::size_t end) {
    const std::size_t k = end == 0 ? 0 : 1;
    const bool parallel = s.relations[k] == Relation::parallel;
    if (s.turns[end]) {
      if (s.turns[1]) return parallel ? 'R' : 'N';
      return parallel ? 'C' : 'R';
    }
    const bool other_perpendicular = s.relations[1 - k] == Relation::perpendicular;
    return s.turns[1] && parallel && other_perpendicular ? 'C' : 'S';
  };
  return std::string{letter(0), letter(2)};
}

bool is_useful(const Structure& structure) {
  const auto axes = some_axes(structure);
  const std::array<Axis, 3> levers{Axis{0.3, 0.5, 0.7}, Axis{-0.4, 0.9, 0.2}, Axis{0.8, -0.6, 0.5}};
  std::array<Axis, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) columns[i] = structure.turns[i] ? cross(axes[i], levers[i]) : axes[i];
  return std::abs(dot(columns[0], cross(columns[1], columns[2]))) > 1e-9;
}

std::vector<Structure> alike(const Structure& structure) {
  std::vector<Structure> all{structure};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const std::size_t k : {0U, 1U}) {
      const auto next = exchanged(all[i], k);
      if (next && std::find(all.begin(), all.end(), *next) == all.end()) all.push_back(*next);
    }
  return all;
}

Structure representative(const Structure& structure) {
  const auto rank = [](const Structure& s) {
    const bool middle = s.turns[0] && !s.turns[1] && s.turns[2];
    const auto parallel = std::count(s.relations.begin(), s.relations.end(), Relation::parallel);
    // A slide beside the turn that it is parallel to, the turn at an end.
    return std::make_pair(middle ? 0 : 1, (code_of(s) ? 0L : 10L) - static_cast<long>(parallel));
  };
  const std::vector<Structure> all = alike(structure);
  return *std::min_element(all.begin(), all.end(),
                           [&](const Structure& a, const Structure& b) { return rank(a) < rank(b); });
}

Workspace workspace_of(const Structure& s) {
  if (!is_useful(s)) return Workspace::none;
  const auto turns = std::count(s.turns.begin(), s.turns.end(), true);
  if (turns == 0) return Workspace::prismatic;
  if (turns == 1) return Workspace::cylindrical;
  const auto parallel = [&](std::size_t i, std::size_t k) {
    if (!s.turns[i] || !s.turns[k]) return true;
    if (k == i + 1) return s.relations[i] == Relation::parallel;
    return s.turns[1] ? true : s.ends == Relation::parallel;
  };
  // Behind a slide along the second joint the ends have a relation of their own; behind a turn the neighbours
  // decide.
  const bool all = parallel(0, 1) && parallel(1, 2) && parallel(0, 2);
  return all ? Workspace::cylindrical : Workspace::spherical;
}

std::string to_string(Workspace workspace) {
  switch (workspace) {
    case Workspace::prismatic:
      return "prismatic";
    case Workspace::cylindrical:
      return "cylindrical";
    case Workspace::spherical:
      return "spherical";
    default:
      return "none";
  }
}

}  // namespace qvgen::canonical
