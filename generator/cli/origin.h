// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "description/reader.h"

namespace qvgen::cli {

/// What the options make of a description: one file may give several robots.
std::string origin_options(const description::ReadOptions& options);

/// How its numbers are read.
std::string snap_text(const description::ReadOptions& options);

}  // namespace qvgen::cli
