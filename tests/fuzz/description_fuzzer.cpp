// SPDX-License-Identifier: MIT
// The entry of libFuzzer: any bytes as a description. Built by the preset `fuzz`, see README.md of this
// folder.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "answer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_joints = 2;
  qvgen::test::answer({reinterpret_cast<const char*>(data), size}, most_joints);
  return 0;
}
