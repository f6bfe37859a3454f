// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "toolchain/build.h"

namespace qvgen::toolchain {

/// Path of the object of a source in the program's folder of kept objects. Its name is a hash of the command
/// with the compiler's size and time, the source and every header that the source includes from the folders
/// of its options: another content has another object.
std::filesystem::path kept_object(const Program& program, const Source& source);

}  // namespace qvgen::toolchain
