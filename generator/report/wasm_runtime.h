// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "toolchain/generated.h"

namespace qvgen::report {

/// Shared C++ of all pages, compiled for WebAssembly once: sources of the runtime, and the headers that
/// generated code includes as clang keeps them when it has read them.
struct WasmRuntime {
  std::filesystem::path object;
  std::filesystem::path headers;
  std::string failed;  ///< what the compiler said; empty if all is there
};

/// How a source of a page is compiled; what is read and written stands behind it.
std::vector<std::string> wasm_compiler(const toolchain::Runtime& runtime);

/// From the cache if it is there, else compiled into it. `folders` are those of the runtime's sources.
WasmRuntime wasm_runtime(const std::vector<std::string>& folders, const toolchain::Runtime& runtime);

/// Takes it out of the cache: clang refuses headers that have been touched since it has read them.
void forget(const WasmRuntime& kept);

}  // namespace qvgen::report
