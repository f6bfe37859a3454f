// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "description/reader.h"

namespace qvgen::cli {

/// Returns the options that tell robots of one description apart: one file may give several robots.
std::string origin_options(const description::ReadOptions& options);

/// How its numbers are read.
std::string snap_text(const description::ReadOptions& options);

}  // namespace qvgen::cli
