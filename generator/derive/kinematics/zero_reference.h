// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/robot.h"
#include "symbolic/algebra.h"

namespace qvgen::derive {

/// The chain with all frames parallel to the world frame at the zero configuration: constant rotations are
/// carried through to the end, so that axes of right-angled arms become coordinate axes.
///
/// tool position = offset_0 + M_1 (offset_1 + M_2 (... M_n tool_offset)), orientation = R_1 ... R_n home.
struct ZeroReferenceChain {
  struct Joint {
    model::JointType type = model::JointType::revolute;
    std::string variable;
    symbolic::Vector offset;  ///< from the previous joint (or the world origin) to this one
    symbolic::Vector axis;    ///< unit
  };
  std::vector<Joint> joints;
  symbolic::Vector tool_offset;
  symbolic::Quaternion home;
};

/// Nothing where a constant rotation is by a symbolic angle: carried along it would only grow.
std::optional<ZeroReferenceChain> zero_reference_chain(const model::Robot& robot);

/// +1 or -1 if b = +-a exactly, else 0.
int parallel(const symbolic::Vector& a, const symbolic::Vector& b);
bool perpendicular(const symbolic::Vector& a, const symbolic::Vector& b);

}  // namespace qvgen::derive
