// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace qvgen::report {

/// What a compiler made of sources, or why not.
struct Compiled {
  bool done = false;
  std::string bytes;
  std::string reason;
};

/// What this machine lacks to compile; empty if nothing.
std::string missing_compiler();

/// C sources and headers, by their names, as one WebAssembly module, by clang and wasm-ld of this machine.
Compiled to_webassembly(const std::map<std::string, std::string>& files);

std::string base64(const std::string& bytes);

}  // namespace qvgen::report
