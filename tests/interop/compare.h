// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <random>
#include <string>

#include "description/reader.h"
#include "peers.h"
#include "reference/chain.h"

namespace arms {

/// The chain to tool0 as it is read here; what is not a note is a failure of the test.
qvgen::model::Robot read(const std::string& text, const std::string& file,
                         qvgen::description::SnapOptions::Mode snap);
/// Likewise of a file, to a tip of another name, without snapping.
qvgen::model::Robot read_file(const std::filesystem::path& file, const std::string& tip);

/// The robot in numbers, by way of the description that `qvgen import` would write.
reference::Chain chain_of(const qvgen::model::Robot& robot);

/// Pose, Jacobian and dynamics at random joint variables, to `tolerance` of the largest entry.
void compare(const reference::Chain& chain, Peer& peer, std::mt19937& random, double tolerance = 1e-12,
             bool forward_dynamics = true);

}  // namespace arms
