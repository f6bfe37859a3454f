// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "description/reader.h"

namespace qvgen::description {
namespace {

std::vector<std::string> texts_of_robots() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    std::ostringstream text;
    text << file.rdbuf();
    texts.push_back(text.str());
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

/// A slip of the keyboard or of the mouse: something deleted, doubled, or put in.
void damage(std::string& text) {
  const std::size_t at = *rc::gen::inRange<std::size_t>(0, text.size());
  const std::size_t length = std::min<std::size_t>(*rc::gen::inRange<std::size_t>(1, 12), text.size() - at);
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, text.substr(at, length));
      break;
    default:
      text.insert(at, *rc::gen::element<std::string>("0", "-", "\"", "[", "]", "x", "theta1", " ", "\n", "(",
                                                     "1/0", "1e300", "nan", "=", "é", "{", "'", "^9"));
  }
}

TEST(Fuzz, DamagedFilesAreReadOrRefusedWithAPlace) {
  const auto texts = texts_of_robots();
  EXPECT_TRUE(rc::check([&] {
    std::string text = *rc::gen::elementOf(texts);
    const int count = *rc::gen::inRange(1, 4);
    for (int i = 0; i < count; ++i) damage(text);
    const ReadResult result = read_text(text, "r.toml");
    const long lines = std::count(text.begin(), text.end(), '\n') + 1;
    RC_ASSERT(result.robot || !result.diagnostics.empty());
    for (const Diagnostic& diagnostic : result.diagnostics) {
      RC_ASSERT(diagnostic.line >= 1 && diagnostic.line <= lines + 1);
      RC_ASSERT(diagnostic.column >= 1);
      RC_ASSERT(!diagnostic.message.empty());
      RC_ASSERT(!diagnostic.hint.empty());
    }
  }));
}

}  // namespace
}  // namespace qvgen::description
