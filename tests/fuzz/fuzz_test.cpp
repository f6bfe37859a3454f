// SPDX-License-Identifier: MIT
// Descriptions with slips in them are refused with a place and a reason, or generated.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "answer.h"
#include "mutation.h"
#include "random_description.h"

namespace qvgen::test {
namespace {

/// QVGEN_FUZZ texts, 4000 without it.
int count() {
  const char* wanted = std::getenv("QVGEN_FUZZ");
  return wanted == nullptr ? 4000 : std::atoi(wanted);
}

std::vector<std::string> corpus() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    texts.push_back({std::istreambuf_iterator<char>(file), {}});
  }
  std::sort(texts.begin(), texts.end());
  for (std::uint32_t seed = 0; seed < 100; ++seed) texts.push_back(random_description(seed));
  return texts;
}

TEST(Fuzz, SlipsAreRefusedWithAPlaceOrGenerated) {
  const std::vector<std::string> texts = corpus();
  std::map<Answer, int> answers;
  for (int i = 0; i < count(); ++i) {
    std::mt19937 random(static_cast<std::uint32_t>(i));
    const std::string text = mutated(texts, random);
    try {
      ++answers[answer(text, 2)];
    } catch (const std::exception& error) {
      ADD_FAILURE() << "text " << i << ": " << error.what() << "\n" << text;
    }
  }
  for (const Answer each : {Answer::refused, Answer::read, Answer::generated})
    EXPECT_GT(answers[each], count() / 100) << "answer " << static_cast<int>(each);
}

}  // namespace
}  // namespace qvgen::test
