// SPDX-License-Identifier: MIT
#include "pipeline/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <thread>

#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace qvgen::pipeline {
namespace {

/// Precedes every message of a worker.
struct Header {
  std::uint64_t index;
  std::uint64_t length;
  std::uint64_t failed;
};

void write_all(int file, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(file, data, size);
    if (written <= 0) ::_exit(1);
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

[[noreturn]] void run_worker(int file, std::atomic<std::uint64_t>& next, std::size_t count,
                             const std::function<std::string(std::size_t)>& work) {
  for (std::uint64_t index = next++; index < count; index = next++) {
    Header header{index, 0, 0};
    std::string text;
    try {
      text = work(index);
    } catch (const std::exception& error) {
      text = error.what();
      header.failed = 1;
    }
    header.length = text.size();
    write_all(file, reinterpret_cast<const char*>(&header), sizeof header);
    write_all(file, text.data(), text.size());
  }
  ::_exit(0);
}

/// The workers' common counter of the next piece of work.
class SharedCounter {
 public:
  SharedCounter()
      : memory_(::mmap(nullptr, sizeof(std::atomic<std::uint64_t>), PROT_READ | PROT_WRITE,
                       MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::runtime_error("no shared memory for the workers");
    new (memory_) std::atomic<std::uint64_t>(0);
  }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  ~SharedCounter() { ::munmap(memory_, sizeof(std::atomic<std::uint64_t>)); }
  std::atomic<std::uint64_t>& value() { return *static_cast<std::atomic<std::uint64_t>*>(memory_); }

 private:
  void* memory_;
};

struct Worker {
  pid_t process = -1;
  int file = -1;
  std::string received;
};

Worker start_worker(SharedCounter& counter, std::size_t count,
                    const std::function<std::string(std::size_t)>& work) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe for a worker");
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("cannot start a worker");
  if (process == 0) {
    ::close(ends[0]);
    run_worker(ends[1], counter.value(), count, work);
  }
  ::close(ends[1]);
  return {process, ends[0], {}};
}

/// Takes complete messages off a worker's buffer.
template <class Take>
void take_messages(std::string& received, const Take& take) {
  Header header{};
  while (received.size() >= sizeof header) {
    std::memcpy(&header, received.data(), sizeof header);
    if (received.size() < sizeof header + header.length) return;
    take(header, received.substr(sizeof header, header.length));
    received.erase(0, sizeof header + header.length);
  }
}

/// False at the end of the worker's messages.
bool read_some(Worker& worker) {
  char buffer[1 << 16];
  const ssize_t size = ::read(worker.file, buffer, sizeof buffer);
  if (size <= 0) return false;
  worker.received.append(buffer, static_cast<std::size_t>(size));
  return true;
}

}  // namespace

std::vector<std::string> in_processes(std::size_t count, const std::function<std::string(std::size_t)>& work,
                                      const std::function<void(std::size_t)>& progress) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  SharedCounter counter;
  std::vector<Worker> workers;
  for (std::size_t i = 0; i < std::min(cores, count); ++i)
    workers.push_back(start_worker(counter, count, work));

  std::vector<std::string> results(count);
  std::vector<bool> finished(count, false);
  std::string failure;
  const auto take = [&](const Header& header, std::string text) {
    if (header.failed != 0)
      failure = failure.empty() ? text : failure;
    else
      results.at(header.index) = std::move(text);
    finished.at(header.index) = true;
    if (progress) progress(header.index);
  };
  std::size_t open = workers.size();
  while (open > 0) {
    std::vector<pollfd> waiting;
    for (const Worker& worker : workers) waiting.push_back({worker.file, POLLIN, 0});
    ::poll(waiting.data(), waiting.size(), -1);
    for (std::size_t i = 0; i < workers.size(); ++i) {
      if (workers[i].file < 0 || waiting[i].revents == 0) continue;
      if (read_some(workers[i])) {
        take_messages(workers[i].received, take);
      } else {
        ::close(workers[i].file);
        workers[i].file = -1;
        --open;
      }
    }
  }
  for (const Worker& worker : workers) ::waitpid(worker.process, nullptr, 0);
  if (!failure.empty()) throw std::runtime_error(failure);
  if (std::find(finished.begin(), finished.end(), false) != finished.end())
    throw std::runtime_error("a worker process died");
  return results;
}

}  // namespace qvgen::pipeline
