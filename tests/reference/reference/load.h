// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "reference/chain.h"
#include "reference/expression.h"

namespace reference {

/// Reads a robot description (generator/robots/README.md) into numbers: joints, Denavit-Hartenberg tables,
/// screws.
///
/// `values` gives symbols, and has precedence over the file's [defaults]. A free inertial parameter or drive
/// (m1, c1x, I1xx, Ia1, ...) without a value is zero. Throws std::runtime_error with a short message for a
/// description that cannot be read; checks nothing beyond that.
Chain load(const std::filesystem::path& file, const Values& values = {});
Chain load_text(const std::string& toml, const Values& values = {});

}  // namespace reference
