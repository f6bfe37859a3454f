// SPDX-License-Identifier: MIT
#include "model/image.h"

#include <algorithm>

#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::model {
namespace {

using Signs = std::array<int, 3>;

/// A copy first, then images in one plane, in two, in three.
constexpr std::array<Signs, 8> mirrors{
    {{1, 1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, -1}}};

/// Numbers may be written in several ways: 90 deg, and pi/2.
bool is_signed(const Expression& image, int sign, const Expression& of) {
  return vanishes(evaluate(sign > 0 ? subtract(image, of) : add(image, of)));
}

/// True if a vector is another, seen in the mirror, times the sign.
bool is_seen(const Vector3& image, const Signs& mirror, int sign, const Vector3& of) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!is_signed(image[i], sign * mirror[i], of[i])) return false;
  return true;
}

/// Axes of turns are seen in the other sense if the mirror changes right and left.
int sense(const Signs& mirror) { return mirror[0] * mirror[1] * mirror[2]; }

bool is_seen(const Turn& image, const Signs& mirror, const Turn& of) {
  for (const int sign : {1, -1})
    if (is_seen(image.axis, mirror, sign * sense(mirror), of.axis) && is_signed(image.angle, sign, of.angle))
      return true;
  return false;
}

bool is_seen(const Displacement& image, const Signs& mirror, const Displacement& of) {
  return is_seen(image.translation, mirror, 1, of.translation) &&
         std::equal(image.turns.begin(), image.turns.end(), of.turns.begin(), of.turns.end(),
                    [&](const Turn& a, const Turn& b) { return is_seen(a, mirror, b); });
}

/// Returns the signs of coordinates in the frame that a displacement leads to; nothing if it is not the
/// image.
std::optional<Signs> seen_behind(const Displacement& image, const Signs& mirror, const Displacement& of) {
  if (!is_seen(image.translation, mirror, 1, of.translation)) return std::nullopt;
  Signs signs{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 axis = rotate(image.turns, unit_vector(i)), other = rotate(of.turns, unit_vector(i));
    for (const int sign : {1, -1})
      if (is_seen(axis, mirror, sign, other)) signs[i] = sign;
    if (signs[i] == 0) return std::nullopt;
  }
  return signs;
}

/// Returns the sign of a joint's values that are seen as the other's; 0 if it is not the joint's image.
int sign_of(const Joint& image, const Signs& mirror, const Joint& of) {
  if (image.type != of.type || !is_seen(image.before, mirror, of.before) ||
      !is_seen(image.after, mirror, of.after))
    return 0;
  const int seen = image.type == JointType::revolute ? sense(mirror) : 1;
  for (const int sign : {1, -1})
    if (is_seen(image.axis, mirror, sign * seen, of.axis)) return sign;
  return 0;
}

bool is_plain(const Robot& robot) {
  const InverseRequest& asked = robot.inverse;
  return robot.geometry.empty() && robot.definitions.empty() && robot.motors.empty() && robot.ideal.empty() &&
         !robot.floating_base && !asked.task && !asked.tool_axis && asked.given.empty() &&
         !asked.every_given && std::all_of(robot.joints.begin(), robot.joints.end(), [](const Joint& joint) {
           return joint.follows.empty();
         });
}

std::optional<Image> image_in(const Signs& mirror, const Robot& of, const Robot& robot) {
  const auto tool = seen_behind(robot.tool, mirror, of.tool);
  if (!tool || !is_seen(robot.base, mirror, of.base)) return std::nullopt;
  Image image{robot.name, mirror, *tool, {}, {}};
  for (std::size_t i = 0; i < of.joints.size(); ++i) {
    const int sign = sign_of(robot.joints[i], mirror, of.joints[i]);
    if (sign == 0) return std::nullopt;
    image.signs.push_back(sign);
    image.variables.push_back(robot.joints[i].variable);
  }
  return image;
}

}  // namespace

std::optional<Image> image_of(const Robot& of, const Robot& robot) {
  if (!is_plain(of) || !is_plain(robot) || of.joints.size() != robot.joints.size() ||
      of.on_request != robot.on_request)
    return std::nullopt;
  for (const Signs& mirror : mirrors)
    if (auto image = image_in(mirror, of, robot)) return image;
  return std::nullopt;
}

}  // namespace qvgen::model
