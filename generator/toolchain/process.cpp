// SPDX-License-Identifier: MIT
#include "toolchain/process.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace qvgen::toolchain {
namespace {

/// Both ends of a pipe that no other child inherits.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "no pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(ends_[0]);
    close_input();
  }
  [[nodiscard]] int input() const { return ends_[1]; }
  void close_input() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  /// All until everyone who writes has closed it.
  [[nodiscard]] std::string read_all() const {
    std::string text;
    std::array<char, 4096> some{};
    for (;;) {
      const ssize_t count = ::read(ends_[0], some.data(), some.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(some.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Starts a program whose output goes to a descriptor; zero or an error's number.
int start(const std::vector<std::string>& words, const std::filesystem::path& folder, int output,
          pid_t& child) {
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: exec's type
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_adddup2(&actions, output, stream);
  const int error = ::posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

Outcome run(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  Pipe output;
  pid_t child = 0;
  if (const int error = start(words, folder, output.input(), child); error != 0)
    return {false, words.front() + ": " + std::generic_category().message(error)};
  output.close_input();
  std::string said = output.read_all();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return {false, said};
  return {WIFEXITED(status) && WEXITSTATUS(status) == 0, std::move(said)};
}

bool is_program(const std::string& name) {
  if (name.find('/') != std::string::npos) return ::access(name.c_str(), X_OK) == 0;
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    if (::access((folders.substr(0, end) + "/" + name).c_str(), X_OK) == 0) return true;
    folders.erase(0, end + 1);
  }
  return false;
}

}  // namespace qvgen::toolchain
