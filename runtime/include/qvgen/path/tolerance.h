// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <qvgen/path/free_space.h>
#include <qvgen/pose.h>
#include <qvgen/quaternion.h>

/// Effects of free coordinates on the poses of a path: one turns or tilts the tool about its own axes,
/// shifts it, or moves the base on a rail. Shifts come first, along the axes of the pose that was asked for.
/// Then the tool tilts about its own point, by a rotation vector across the axis of the cone, and turns about
/// its own axes, one after the other as they are named.
namespace qvgen::path {

/// The pose with the tool turned about one of its own axes, 0 to 2 for x to z.
inline Pose<double> turned(const Pose<double>& pose, int axis, double angle) {
  Vector3<double> turn = Vector3<double>::Zero();
  turn[axis] = angle;
  return {pose.orientation * from_rotation_vector<double>(turn), pose.position};
}

/// The pose as an arm sees it whose base has travelled along one of its own axes, 0 to 2 for x to z.
inline Pose<double> from_rail(const Pose<double>& pose, int axis, double way) {
  Pose<double> seen = pose;
  seen.position[axis] -= way;
  return seen;
}

/// One free coordinate; the axis is 0 to 2 for x to z.
struct Freedom {
  enum class Kind {
    joint,  ///< a joint of seven, or the arm angle: poses stay
    tool,   ///< a turn about an axis of the tool
    tilt,   ///< a component of a rotation vector, in the tool's frame
    shift,  ///< a way along an axis of the tool
    base,   ///< a way along an axis of the base
    rail    ///< a way of the base along one of its own axes
  };
  Kind kind = Kind::joint;
  int axis = 0;
};

/// All free coordinates, with their ranges.
struct Freedoms {
  std::array<Freedom, most_free> each{};
  FreeSpace space;

  Freedoms() { space.size = 0; }

  /// Returns the pose that the arm has to reach.
  [[nodiscard]] Pose<double> moved(const Pose<double>& pose, const FreeValues& values) const {
    Pose<double> moved = pose;
    Vector3<double> tilt = Vector3<double>::Zero();
    for (int i = 0; i < space.size; ++i) {
      const Freedom& one = each[static_cast<std::size_t>(i)];
      if (one.kind == Freedom::Kind::shift)
        moved.position += pose.orientation * (values[i] * Vector3<double>::Unit(one.axis));
      if (one.kind == Freedom::Kind::base) moved.position[one.axis] += values[i];
      if (one.kind == Freedom::Kind::rail) moved = from_rail(moved, one.axis, values[i]);
      if (one.kind == Freedom::Kind::tilt) tilt[one.axis] = values[i];
    }
    if (space.cone >= 0) moved.orientation = pose.orientation * from_rotation_vector<double>(tilt);
    for (int i = 0; i < space.size; ++i) {
      const Freedom& one = each[static_cast<std::size_t>(i)];
      if (one.kind == Freedom::Kind::tool) moved = turned(moved, one.axis, values[i]);
    }
    return moved;
  }

  /// Returns the value of the joint or arm angle that is free; zero if none is.
  [[nodiscard]] double joint(const FreeValues& values) const {
    for (int i = 0; i < space.size; ++i)
      if (each[static_cast<std::size_t>(i)].kind == Freedom::Kind::joint) return values[i];
    return 0;
  }

  /// Adds a coordinate; false if there is no room.
  bool add(Freedom::Kind kind, int axis, const FreeRange& range) {
    if (space.size >= most_free) return false;
    each[static_cast<std::size_t>(space.size)] = {kind, axis};
    space[space.size++] = range;
    return true;
  }

  /// Adds the tilts of a cone about an axis of the tool, rad; false if there is no room, or a cone already.
  bool add_cone(int axis, double half_angle) {
    if (space.size + 2 > most_free || space.cone >= 0) return false;
    space.cone = space.size;
    space.half_angle = half_angle;
    const FreeRange range{-half_angle, half_angle, false, 5, 1};
    return add(Freedom::Kind::tilt, (axis + 1) % 3, range) && add(Freedom::Kind::tilt, (axis + 2) % 3, range);
  }
};

/// Adds what a name says: tool_x, shift_y, base_z, rail_x, ..., or cone_z, whose half angle is the upper end;
/// any other name is a joint. `range.count` values of it are tried where it is alone. False if there is no
/// room.
inline bool add_named(Freedoms& freedoms, const std::string& name, FreeRange range) {
  const std::size_t mark = name.find('_');
  const std::string what = name.substr(0, mark);
  const int axis = mark == std::string::npos ? 0 : name.back() - 'x';
  if (what == "cone") return freedoms.add_cone(axis, range.upper);
  const bool is_near = what == "shift" || what == "base";
  if (is_near) range.count = std::min(range.count, 3);
  range.farthest = is_near ? 1 : 3;
  const auto kind = what == "tool"    ? Freedom::Kind::tool
                    : what == "shift" ? Freedom::Kind::shift
                    : what == "base"  ? Freedom::Kind::base
                    : what == "rail"  ? Freedom::Kind::rail
                                      : Freedom::Kind::joint;
  return freedoms.add(kind, axis, range);
}

}  // namespace qvgen::path
