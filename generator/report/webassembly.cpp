// SPDX-License-Identifier: MIT
#include "report/webassembly.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "report/html.h"
#include "toolchain/process.h"
#include "toolchain/workshop.h"

namespace qvgen::report {

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
                                "-o",
                                "module.wasm"};
  workshop.write("math.h", asset("wasm_math.h"));
  workshop.write("string.h", asset("wasm_string.h"));
  for (const auto& [name, content] : files) {
    workshop.write(name, content);
    if (name.ends_with(".c")) call.push_back(name);
  }
  if (const toolchain::Outcome outcome = toolchain::run(call, workshop.folder()); !outcome.done)
    return {false, "", "clang has failed: " + outcome.said.substr(0, 2000)};
  return {true, workshop.read("module.wasm"), ""};
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
