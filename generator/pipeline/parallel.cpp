// SPDX-License-Identifier: MIT
#include "pipeline/parallel.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace qvgen::pipeline {
namespace {

// The first letter of a worker's message; a message without one is cut short.
constexpr char done_mark = 'd';
constexpr char failed_mark = 'f';

void write_all(int file, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(file, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) ::_exit(1);
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_address_sanitizer = true;
#elif defined(__has_feature)
constexpr bool has_address_sanitizer = __has_feature(address_sanitizer);
#else
constexpr bool has_address_sanitizer = false;
#endif

// Seconds of a build with sanitizers are longer.
constexpr std::uint64_t slowness = has_address_sanitizer ? 10 : 1;

void limit(decltype(RLIMIT_CPU) what, std::uint64_t value) {
  rlimit bounds{};
  if (::getrlimit(what, &bounds) != 0) return;
  bounds.rlim_cur = std::min<rlim_t>(value, bounds.rlim_max);
  ::setrlimit(what, &bounds);
}

void apply(const Budget& budget) {
  limit(RLIMIT_CPU, slowness * budget.seconds);
  limit(RLIMIT_CORE, 0);
  // The address sanitizer's shadow takes more address space than any machine has memory.
  if (!has_address_sanitizer) limit(RLIMIT_AS, budget.megabytes << 20U);
}

/// Returns a limit that is set, else the default.
std::uint64_t limit_of(decltype(RLIMIT_CPU) what, std::uint64_t otherwise) {
  rlimit bounds{};
  const bool known = ::getrlimit(what, &bounds) == 0 && bounds.rlim_cur != RLIM_INFINITY;
  return known ? bounds.rlim_cur : otherwise;
}

/// Who kills a run means its workers too, which may be at work for minutes.
void die_with(pid_t parent) {
#if defined(__linux__)
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  // The parent may have been killed before it was asked for.
  if (::getppid() != parent) ::_exit(1);
}

std::string out_of_memory(const Budget& budget) {
  return "it takes more than " + std::to_string(budget.megabytes) + " MB of memory";
}

[[noreturn]] void run_worker(int file, std::size_t index, const Budget& budget,
                             const std::function<std::string(std::size_t)>& work) {
  apply(budget);
  std::string message(1, done_mark);
  try {
    message += work(index);
  } catch (const std::bad_alloc&) {
    message = failed_mark + out_of_memory(budget);
  } catch (const std::exception& error) {
    message = failed_mark + std::string(error.what());
  }
  write_all(file, message.data(), message.size());
  ::_exit(0);
}

struct Worker {
  pid_t process = -1;
  int file = -1;
  std::size_t index = 0;
  std::string received;
};

Worker start_worker(std::size_t index, const Budget& budget,
                    const std::function<std::string(std::size_t)>& work) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe for a worker process");
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) {
    const int reason = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    throw std::runtime_error(std::string("cannot start a worker process: ") + std::strerror(reason));
  }
  if (process == 0) {
    ::close(ends[0]);
    die_with(parent);
    run_worker(ends[1], index, budget, work);
  }
  ::close(ends[1]);
  return {process, ends[0], index, {}};
}

std::string death_of(int status, const Budget& budget) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return "it takes more than " + std::to_string(budget.seconds) + " s of processor time";
  const std::string bound = "; it may use " + std::to_string(budget.megabytes) + " MB";
  if (WIFSIGNALED(status))
    return std::string("its process died (") + ::strsignal(WTERMSIG(status)) + ")" + bound;
  return "its process ended too early (code " + std::to_string(WEXITSTATUS(status)) + ")" + bound;
}

Outcome outcome_of(Worker& worker, const Budget& budget) {
  int status = 0;
  while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) continue;
  const bool whole = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !worker.received.empty();
  if (!whole) return {false, death_of(status, budget)};
  const bool done = worker.received.front() == done_mark;
  return {done, worker.received.substr(1)};
}

/// False at the end of the worker's message.
bool read_some(Worker& worker) {
  char buffer[1 << 16];
  const ssize_t size = ::read(worker.file, buffer, sizeof buffer);
  if (size < 0 && errno == EINTR) return true;
  if (size <= 0) return false;
  worker.received.append(buffer, static_cast<std::size_t>(size));
  return true;
}

/// Kills and reaps what is still at work if an error ends the run.
struct Workers {
  std::vector<Worker> list;
  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers() {
    for (const Worker& worker : list) {
      ::kill(worker.process, SIGKILL);
      ::waitpid(worker.process, nullptr, 0);
      ::close(worker.file);
    }
  }
};

}  // namespace

Budget own_budget() {
  const Budget usual;
  return {limit_of(RLIMIT_CPU, slowness * usual.seconds) / slowness,
          limit_of(RLIMIT_AS, usual.megabytes << 20U) >> 20U};
}

int bounded(const std::string& what, const Budget& budget, const std::function<int()>& work) {
  std::fflush(nullptr);  // else both processes would print it
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
  if (child == 0) {
    die_with(parent);
    apply(budget);
    try {
      return work();
    } catch (const std::bad_alloc&) {
      throw std::runtime_error(what + ": " + out_of_memory(budget));
    }
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  if (WTERMSIG(status) == SIGPIPE) ::raise(SIGPIPE);  // whoever read the output has seen enough
  throw std::runtime_error(what + ": " + death_of(status, budget));
}

std::vector<Outcome> in_processes(std::size_t count, const std::function<std::string(std::size_t)>& work,
                                  const Budget& budget, const std::function<void(std::size_t)>& progress) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<Outcome> outcomes(count);
  Workers workers;
  for (std::size_t next = 0; next < count || !workers.list.empty();) {
    while (next < count && workers.list.size() < cores)
      workers.list.push_back(start_worker(next++, budget, work));
    std::vector<pollfd> waiting;
    for (const Worker& worker : workers.list) waiting.push_back({worker.file, POLLIN, 0});
    ::poll(waiting.data(), waiting.size(), -1);
    for (std::size_t i = waiting.size(); i-- > 0;) {
      Worker& worker = workers.list[i];
      if (waiting[i].revents == 0 || read_some(worker)) continue;
      outcomes[worker.index] = outcome_of(worker, budget);
      if (progress) progress(worker.index);
      ::close(worker.file);
      workers.list.erase(workers.list.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  return outcomes;
}

}  // namespace qvgen::pipeline
