// SPDX-License-Identifier: MIT
// Images of chains in mirrors: left and right limbs, the four legs of a quadruped.
//
// With M = diag(x, y, z) of signs, an image has every frame of the other chain seen in the mirror: positions
// M p, rotations M R M. A joint turns or slides about the mirrored axis, or against it: then its sign is -1.
// Axes of the tool's frame may be turned over besides: M R T, with signs T of its own.
// A left leg is the image of the right one in the plane x-z, a hind leg that of the front one in the plane
// y-z. What is derived for a chain then holds for its image, by changes of signs alone:
// pose(q) = M pose_of_the_other(signs q) T.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/robot.h"

namespace qvgen::model {

/// A robot that is another one seen in a mirror.
struct Image {
  std::string name;
  std::array<int, 3> mirror;           ///< sign of each coordinate in every frame but the tool's
  std::array<int, 3> tool;             ///< in the tool's frame
  std::vector<int> signs;              ///< of each joint's value
  std::vector<std::string> variables;  ///< of its own joints
};

/// Returns how `robot` is the image of `of`, exactly; nothing if it is not. Joint limits may differ.
/// Chains with symbols, joints that follow others, or requests for their inverse kinematics are no images.
std::optional<Image> image_of(const Robot& of, const Robot& robot);

}  // namespace qvgen::model
