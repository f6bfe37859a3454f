// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "derive/jacobian/linkage.h"

namespace qvgen::derive {

/// The linkage with its tool point at the common point of the last three axes: the wrist centre. Nothing
/// unless the last three joints are revolute and their axes meet, whatever the joint values.
std::optional<Linkage> at_wrist_centre(const Linkage& linkage);

/// From the tool point to the wrist centre, in the tool frame; nothing where there is none.
std::optional<symbolic::Vector> wrist_centre(const model::Robot& robot);

/// The linkage with its tool point on the last pivot, where the last axis' column is simplest, or as far from
/// there as prismatic joints beyond it have moved.
Linkage at_last_pivot(const Linkage& linkage);

}  // namespace qvgen::derive
