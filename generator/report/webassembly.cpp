// SPDX-License-Identifier: MIT
#include "report/webassembly.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "report/html.h"
#include "toolchain/process.h"
#include "toolchain/workshop.h"

namespace qvgen::report {
namespace {

Compiled compiled(const std::vector<std::string>& call, const toolchain::Workshop& workshop) {
  if (const toolchain::Outcome outcome = toolchain::run(call, workshop.folder()); !outcome.done)
    return {false, "", call.front() + " has failed: " + outcome.said.substr(0, 2000)};
  return {true, workshop.read("module.wasm"), ""};
}

/// One source that includes all sources of the folders, then the page's calls.
std::string everything(const std::vector<std::string>& folders, const toolchain::Runtime& runtime) {
  std::vector<std::string> names{"sine_cosine.cpp"};
  for (const std::string& folder : folders)
    for (const auto& entry : std::filesystem::directory_iterator(runtime.sources / folder))
      if (entry.path().extension() == ".cpp")
        names.push_back(folder + "/" + entry.path().filename().string());
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += "#include \"" + name + "\"\n";
  return text + "#include \"calls.cpp\"\n";
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
                                "-O2",
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
  workshop.write("math.h", asset("wasm_math.h"));
  workshop.write("string.h", asset("wasm_string.h"));
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
  const toolchain::Workshop workshop;
  for (const auto& [name, content] : files) workshop.write(name, content);
  workshop.write("everything.cpp", everything(folders, *runtime));
  std::vector<std::string> call{"clang++", "--target=wasm32-wasi", "-mexec-model=reactor", "-std=c++17"};
  for (const char* option :
       {"-O1", "-DNDEBUG", "-DEIGEN_DONT_VECTORIZE", "-DQVGEN_NO_CONTRACTION", "-ffp-contract=off",
        "-fno-exceptions", "-fno-rtti", "-mbulk-memory", "-Wl,--strip-all", "-Wl,-z,stack-size=1048576",
        "-Wl,--stack-first", "-I.", "-Iinclude"})
    call.emplace_back(option);
  for (const auto& folder : runtime->headers) call.push_back("-I" + folder.string());
  call.insert(call.end(), {"-I" + runtime->sources.string(), "-o", "module.wasm", "everything.cpp"});
  return compiled(call, workshop);
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
