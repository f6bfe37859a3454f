// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "toolchain/generated.h"

namespace qvgen::report {

/// Result of a compiler, or why there is none.
struct Compiled {
  bool done = false;
  std::string bytes;
  std::string reason;
};

/// Names what this machine lacks to compile; empty if nothing.
std::string missing_compiler();

/// C sources and headers, by their names, as one WebAssembly module, by clang and wasm-ld of this machine.
Compiled to_webassembly(const std::map<std::string, std::string>& files);

/// Names what this machine lacks besides to compile C++ for WebAssembly; empty if nothing.
std::string missing_cpp_library();

/// calls.cpp of the files, with those sources of the runtime that are in the folders, as one module.
/// `runtime` is null where it is not there to be read.
Compiled cpp_to_webassembly(const std::map<std::string, std::string>& files,
                            const std::vector<std::string>& folders, const toolchain::Runtime* runtime);

std::string base64(const std::string& bytes);

}  // namespace qvgen::report
