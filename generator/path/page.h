// SPDX-License-Identifier: MIT
// A page on which an arm moves along a path: the arm as the report's live page draws it, with the motion to
// be chosen, a slider along the path, and the map of all motions below it. One file that needs no network.
#pragma once

#include <string>

#include "model/robot.h"
#include "path/free.h"
#include "path/result.h"

namespace qvgen::path {

/// Motions that a page shows at most; a note says how many there are.
inline constexpr std::size_t most_on_page = 60;

/// Returns the page of all motions along a path.
std::string page_of(const model::Robot& robot, const Result& result, const Task& task,
                    const std::string& title);

/// Returns the page of the best motion where coordinates are free.
std::string page_of(const model::Robot& robot, const FreeMotion& motion, const FreeTask& task,
                    const std::string& title);

}  // namespace qvgen::path
