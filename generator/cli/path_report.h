// SPDX-License-Identifier: MIT
// The motions along a path, in words and a table for a person.
#pragma once

#include <string>

#include "path/result.h"

namespace qvgen::cli {

std::string path_text(const path::Result& result, const path::Task& task, const path::Poses& poses,
                      const std::string& robot);

}  // namespace qvgen::cli
