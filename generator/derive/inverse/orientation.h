// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/builder.h"

namespace qvgen::derive::inverse {

/// (e_1 ... e_k)^-1 rotation for solved joints, as a quaternion: half angles, parallel neighbours merged into
/// one.
symbolic::Quaternion without_first(Builder& builder, const std::vector<Screw>& joints,
                                   symbolic::Quaternion rotation);
/// rotation (e_1 ... e_k)^-1.
symbolic::Quaternion without_last(Builder& builder, const std::vector<Screw>& joints,
                                  symbolic::Quaternion rotation);

}  // namespace qvgen::derive::inverse
