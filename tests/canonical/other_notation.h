// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>

#include <nlohmann/json.hpp>

#include "model/robot.h"

namespace qvgen::test {

/// A chain of one to seven joints, turns and slides, whose axes and frames are at right angles; lengths are
/// zero, numbers, or symbols.
model::Robot random_right_angled_robot(std::mt19937& random);

/// The arm with an inertia and a drive for each link, in numbers or in symbols of its own.
enum class InertiasIn { numbers, symbols };
model::Robot with_random_inertias(model::Robot robot, InertiasIn kind, std::mt19937& random);

/// The arm with symbols for all inertias of its links in the frames that it has, and no drives.
model::Robot with_free_inertias(model::Robot robot);

/// Writes an arm as somebody else would: zeros of turns elsewhere by right angles, axes reversed, link frames
/// in other places and turned by right angles, inertias seen from those.
model::Robot in_another_notation(const model::Robot& robot, std::mt19937& random);

/// Returns the operation counts of a robot as they are committed; `freshness` of the tests says that they are
/// the tool's.
nlohmann::json committed_counts(const std::string& robot);

/// True in long runs, which set QVGEN_ARMS; other runs take one robot for each kind.
bool is_long_run();

}  // namespace qvgen::test
