// SPDX-License-Identifier: MIT
#include "pipeline/parallel.h"

#include <stdexcept>

#include <gtest/gtest.h>
#include <unistd.h>

namespace {

using qvgen::pipeline::in_processes;

TEST(Parallel, KeepsTheOrder) {
  std::size_t reported = 0;
  const auto results = in_processes(
      50, [](std::size_t i) { return std::string(i * 1000, static_cast<char>('a' + i % 26)); },
      [&](std::size_t) { ++reported; });
  ASSERT_EQ(results.size(), 50U);
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_EQ(results[i], std::string(i * 1000, static_cast<char>('a' + i % 26)));
  EXPECT_EQ(reported, 50U);
}

TEST(Parallel, NothingToDo) {
  EXPECT_TRUE(in_processes(0, [](std::size_t) { return ""; }).empty());
}

TEST(Parallel, ErrorsComeBack) {
  const auto work = [](std::size_t i) -> std::string {
    if (i == 3) throw std::runtime_error("robot 3 is broken");
    return "";
  };
  try {
    in_processes(6, work);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "robot 3 is broken");
  }
}

TEST(Parallel, DeadWorkersAreNoticed) {
  const auto work = [](std::size_t i) -> std::string {
    if (i == 2) ::_exit(9);
    return "x";
  };
  EXPECT_THROW(in_processes(5, work), std::runtime_error);
}

}  // namespace
