// SPDX-License-Identifier: MIT
#include "pipeline/parallel.h"

#include <csignal>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using qvgen::pipeline::in_processes;

TEST(Parallel, KeepsTheOrder) {
  std::size_t reported = 0;
  const auto results = in_processes(
      50, [](std::size_t i) { return std::string(i * 1000, static_cast<char>('a' + i % 26)); }, {},
      [&](std::size_t) { ++reported; });
  ASSERT_EQ(results.size(), 50U);
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_EQ(results[i].text, std::string(i * 1000, static_cast<char>('a' + i % 26)));
  EXPECT_EQ(reported, 50U);
}

TEST(Parallel, NothingToDo) {
  EXPECT_TRUE(in_processes(0, [](std::size_t) { return ""; }).empty());
}

TEST(Parallel, ErrorsComeBackAndCostOneAlone) {
  const auto work = [](std::size_t i) -> std::string {
    if (i == 3) throw std::runtime_error("robot 3 is broken");
    return "";
  };
  const auto results = in_processes(6, work);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(results[i].done, i != 3);
  EXPECT_EQ(results[3].text, "robot 3 is broken");
}

TEST(Parallel, ADeadWorkerCostsItsOwnWork) {
  const auto work = [](std::size_t i) -> std::string {
    if (i == 2) ::_exit(9);
    if (i == 3) std::abort();
    return "x";
  };
  const auto results = in_processes(5, work);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(results[i].done, i != 2 && i != 3);
  EXPECT_NE(results[2].text.find("code 9"), std::string::npos) << results[2].text;
  EXPECT_NE(results[3].text.find("Abort"), std::string::npos) << results[3].text;
}

/// Runs `bounded`; the child, which goes on as the program, ends here.
int code_of(const qvgen::pipeline::Budget& budget, const std::function<int()>& work) {
  const pid_t parent = ::getpid();
  int code = 99;
  try {
    code = qvgen::pipeline::bounded("the work", budget, work);
  } catch (const std::exception&) {
    if (::getpid() == parent) throw;
  }
  if (::getpid() != parent) ::_exit(code);
  return code;
}

std::string words_of(const qvgen::pipeline::Budget& budget, const std::function<int()>& work) {
  try {
    return "code " + std::to_string(code_of(budget, work));
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(Bounded, CodesAndExceptionsAreThoseOfTheWork) {
  EXPECT_EQ(code_of({}, [] { return 0; }), 0);
  EXPECT_EQ(code_of({}, [] { return 3; }), 3);
  EXPECT_EQ(code_of({}, []() -> int { throw std::runtime_error("wrong"); }), 99);
}

TEST(Bounded, WhatTakesTooLongEndsWithItsName) {
  const auto forever = []() -> int {
    for (volatile bool go_on = true; go_on;) continue;
    return 0;
  };
  EXPECT_EQ(words_of({1, 1024}, forever), "the work: it takes more than 1 s of processor time");
  EXPECT_NE(words_of({}, []() -> int { std::abort(); }).find("the work: its process died (Aborted)"),
            std::string::npos);
}

/// Every process that is at work holds the end of a pipe open, from whose other end nothing comes before all
/// are gone.
TEST(Parallel, WorkersDieWithTheirParent) {
  int held[2];
  int started[2];
  ASSERT_EQ(::pipe(held), 0);
  ASSERT_EQ(::pipe(started), 0);
  const pid_t run = ::fork();
  ASSERT_GE(run, 0);
  if (run == 0) {
    const auto outer = [&](std::size_t) {
      in_processes(1, [&](std::size_t) -> std::string {
        if (::write(started[1], "x", 1) == 1) ::sleep(300);
        return "x";
      });
      return std::string();
    };
    in_processes(1, outer);
    ::_exit(0);
  }
  ::close(held[1]);
  char letter = 0;
  ASSERT_EQ(::read(started[0], &letter, 1), 1);
  ::kill(run, SIGKILL);
  ::waitpid(run, nullptr, 0);
  pollfd end{held[0], POLLIN, 0};
  EXPECT_EQ(::poll(&end, 1, 20000), 1) << "still at work 20 s later";
  ::close(held[0]);
  ::close(started[0]);
  ::close(started[1]);
}

TEST(Parallel, ABudgetOfTimeIsKept) {
  const auto work = [](std::size_t i) -> std::string {
    for (volatile std::size_t k = 0; i == 0;) k = k + 1;
    return "x";
  };
  const auto results = in_processes(2, work, {1, 4096});
  EXPECT_FALSE(results[0].done);
  EXPECT_NE(results[0].text.find("more than 1 s"), std::string::npos) << results[0].text;
  EXPECT_TRUE(results[1].done);
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(Parallel, ABudgetOfMemoryIsKept) {
  const auto work = [](std::size_t) { return std::string(std::size_t{1} << 31U, 'x').substr(0, 1); };
  const auto results = in_processes(1, work, {60, 1024});
  EXPECT_FALSE(results[0].done);
}
#endif

}  // namespace
