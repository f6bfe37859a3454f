// SPDX-License-Identifier: MIT
// Tolerances stand once: blocks in C name those of the runtime, and the tool puts the numbers there.
#include "qvgen/inverse/tolerances.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "emit/c/inverse/blocks.h"
#include "patterns.h"

namespace qvgen::emit {
namespace {

const std::string exponent = R"((^|[^A-Za-z0-9_.])([0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+)";

bool has_number_of_its_own(const std::string& line) {
  return patterns::occurs(line.substr(0, line.find("//")), exponent);
}

TEST(Tolerances, LinesWithNumbersOfTheirOwnAreTold) {
  for (const char* line : {"a < 1e-7", "(1.5e+3)", "-.5E2;", "1e300 // far"})
    EXPECT_TRUE(has_number_of_its_own(line)) << line;
  for (const char* line : {"0x1.8e2p-4 * a", "a1e5", "b; // 1e-7", "6.25 + e2", "two_1e3"})
    EXPECT_FALSE(has_number_of_its_own(line)) << line;
}

TEST(Tolerances, BlocksInCHaveNone) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/templates/c/inverse")) {
    ++files;
    std::ifstream file(entry.path());
    int number = 0;
    for (std::string line; std::getline(file, line);)
      EXPECT_FALSE(++number > 0 && has_number_of_its_own(line))
          << entry.path() << ":" << number
          << ": name it in runtime/include/qvgen/inverse/tolerances.h: " << line;
  }
  EXPECT_GT(files, 10);
}

TEST(Tolerances, NamesBecomeTheRuntimesNumbers) {
  const std::string& blocks = c::inverse_blocks();
  EXPECT_FALSE(patterns::occurs(blocks, "tolerance_[a-z]"));
  const auto beyond = patterns::first(blocks, R"(\.beyond = widened\(digits\(([-0-9e.]+)\), )");
  ASSERT_TRUE(beyond);
  EXPECT_EQ(std::stod(beyond->groups[1]), inverse::tolerance::end_outside);
  const auto range = patterns::first(blocks, R"(return share \+ ([0-9]+) \* allowed;)");
  ASSERT_TRUE(range);
  EXPECT_EQ(std::stod(range->groups[1]), inverse::tolerance::range_per_size);
}

}  // namespace
}  // namespace qvgen::emit
