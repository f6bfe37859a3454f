// SPDX-License-Identifier: MIT
// The motions along a path, in words and a table for a person.
#pragma once

#include <string>

#include "path/free.h"
#include "path/result.h"

namespace qvgen::cli {

std::string path_text(const path::Result& result, const path::Task& task, const path::Poses& poses,
                      const std::string& robot);

/// One motion where a coordinate is free: how far it goes, and which values it takes.
std::string free_text(const path::FreeMotion& motion, const path::FreeTask& task, const path::Poses& poses,
                      const std::string& robot);

}  // namespace qvgen::cli
