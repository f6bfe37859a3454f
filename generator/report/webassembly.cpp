// SPDX-License-Identifier: MIT
#include "report/webassembly.h"

#include <cstdint>
#include <exception>

#include "emit/builtin_templates.h"
#include "report/wasm_runtime.h"
#include "toolchain/process.h"
#include "toolchain/workshop.h"

namespace qvgen::report {
namespace {

Compiled compiled(const std::vector<std::string>& call, const toolchain::Workshop& workshop) {
  if (const toolchain::Outcome outcome = toolchain::run(call, workshop.folder()); !outcome.done)
    return {false, "", call.front() + " has failed: " + outcome.said.substr(0, 2000)};
  return {true, workshop.read("module.wasm"), ""};
}

/// calls.cpp of the files with what all pages share.
Compiled linked(const std::map<std::string, std::string>& files, const WasmRuntime& shared,
                const toolchain::Runtime& runtime) {
  if (!shared.failed.empty()) return {false, "", "clang++ has failed: " + shared.failed.substr(0, 2000)};
  const toolchain::Workshop workshop;
  for (const auto& [name, content] : files) workshop.write(name, content);
  std::vector<std::string> call = wasm_compiler(runtime);
  for (const char* option : {"-I.", "-Iinclude", "-mexec-model=reactor", "-Wl,--strip-all",
                             "-Wl,-z,stack-size=1048576", "-Wl,--stack-first", "-include-pch"})
    call.emplace_back(option);
  call.insert(call.end(),
              {shared.headers.string(), "calls.cpp", shared.object.string(), "-o", "module.wasm"});
  return compiled(call, workshop);
}

}  // namespace

std::string missing_compiler() {
  for (const char* program : {"clang", "wasm-ld"})
    if (!toolchain::is_program(program))
      return std::string(program) +
             " is not on the machine that wrote it (Debian: apt-get install clang lld)";
  return "";
}

Compiled to_webassembly(const std::map<std::string, std::string>& files) {
  if (const std::string missing = missing_compiler(); !missing.empty()) return {false, "", missing};
  const toolchain::Workshop workshop;
  std::vector<std::string> call{"clang",
                                "--target=wasm32",
                                "-std=gnu99",
                                "-Os",  // compiled in two thirds of the time of -O2
                                "-ffreestanding",
                                "-nostdlib",
                                "-ffp-contract=off",
                                "-fno-strict-aliasing",
                                "-mbulk-memory",
                                "-I.",
                                "-Wl,--no-entry",
                                "-Wl,--strip-all",
                                "-Wl,-z,stack-size=1048576",
                                "-Wl,--stack-first",
                                "-o",
                                "module.wasm"};
  for (const char* header : {"math.h", "string.h"})
    workshop.write(header, emit::builtin_templates().at(std::string("wasm/") + header));
  for (const auto& [name, content] : files) {
    workshop.write(name, content);
    if (name.ends_with(".c")) call.push_back(name);
  }
  return compiled(call, workshop);
}

std::string missing_cpp_library() {
  // Asked for a file that it has, clang says the whole path.
  for (const char* file : {"libc.a", "libc++.a"}) {
    const toolchain::Outcome found =
        toolchain::run({"clang++", "--target=wasm32-wasi", std::string("-print-file-name=") + file});
    if (!found.done || found.said.find('/') == std::string::npos)
      return "the C++ library for WebAssembly is not on the machine that wrote it (Debian: apt-get install "
             "wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32)";
  }
  return "";
}

Compiled cpp_to_webassembly(const std::map<std::string, std::string>& files,
                            const std::vector<std::string>& folders, const toolchain::Runtime* runtime) {
  if (const std::string missing = missing_cpp_library(); !missing.empty()) return {false, "", missing};
  if (runtime == nullptr || runtime->sources.empty())
    return {false, "", "the sources of qvgen’s runtime are not on the machine that wrote it"};
  try {
    const WasmRuntime shared = wasm_runtime(folders, *runtime);
    const Compiled first = linked(files, shared, *runtime);
    if (first.done || !shared.failed.empty()) return first;
    forget(shared);
    return linked(files, wasm_runtime(folders, *runtime), *runtime);
  } catch (const std::exception& error) {  // no folder of the machine can be written
    return {false, "", error.what()};
  }
}

std::string base64(const std::string& bytes) {
  static constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8U) | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? letters[(group >> (18 - 6 * k)) & 63U] : '=';
  }
  return text;
}

}  // namespace qvgen::report
