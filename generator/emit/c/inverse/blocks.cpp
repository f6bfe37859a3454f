// SPDX-License-Identifier: MIT
#include "emit/c/inverse/blocks.h"

#include "emit/blocks/runtime/runtime.h"
#include "emit/builtin_templates.h"
#include "emit/c/single_precision.h"

namespace qvgen::emit::c {
namespace {

/// Templates that headers of the runtime call, and those headers, in their order.
constexpr const char* before[] = {"c/inverse/01_branches.c", "c/inverse/02_angles.c"};
constexpr const char* headers[] = {"angles.h",       "roots.h",          "slides.h", "cubic.h",
                                   "conic_circle.h", "slide_and_turn.h", "wrist.h"};

std::string joined() {
  const auto& templates = builtin_templates();
  blocks::runtime::Reader reader;
  std::string result;
  for (const char* name : before) {
    const std::string& text = templates.at(name);
    reader.read_c({name, "inverse", false, in_double_precision(text)});
    result += text + "\n";
  }
  for (const char* name : headers)
    result += reader.in_c({name, "inverse", false, templates.at("runtime/" + std::string(name))});
  for (const auto& [name, text] : templates)
    if (name > before[1] && name.rfind("c/inverse/", 0) == 0) result += text + "\n";
  return result;
}

}  // namespace

const std::string& inverse_blocks() {
  static const std::string blocks = joined();
  return blocks;
}

}  // namespace qvgen::emit::c
