// SPDX-License-Identifier: MIT
#include "toolchain/process.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <exception>
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
  [[nodiscard]] int output() const { return ends_[0]; }
  /// All until everyone who writes has closed it.
  void read_all(const std::function<void(std::string_view)>& take) const {
    std::array<char, 65536> some{};
    for (;;) {
      const ssize_t count = ::read(ends_[0], some.data(), some.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return;
      take({some.data(), static_cast<std::size_t>(count)});
    }
  }
  void write_all(const std::string& text) const {
    if (::write(ends_[1], text.data(), text.size()) != static_cast<ssize_t>(text.size()))
      throw std::system_error(errno, std::generic_category(), "a program takes no input");
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Streams that a program is started with; -1 leaves it ours.
struct Streams {
  int input = -1, output = -1, error = -1;
};

/// Zero or an error's number.
int start(const std::vector<std::string>& words, const std::filesystem::path& folder, const Streams& streams,
          pid_t& child) {
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: exec's type
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  if (streams.input < 0)
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  else
    ::posix_spawn_file_actions_adddup2(&actions, streams.input, STDIN_FILENO);
  if (streams.output >= 0) ::posix_spawn_file_actions_adddup2(&actions, streams.output, STDOUT_FILENO);
  if (streams.error >= 0) ::posix_spawn_file_actions_adddup2(&actions, streams.error, STDERR_FILENO);
  const int error = ::posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  return error;
}

Outcome not_started(const std::vector<std::string>& words, int error) {
  return {false, words.front() + ": " + std::generic_category().message(error)};
}

/// How it ended, if not well.
std::string wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return "it was lost";
  if (WIFSIGNALED(status)) return "it was ended by signal " + std::to_string(WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? "" : "its exit code is " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Outcome run(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  Pipe output;
  pid_t child = 0;
  if (const int error = start(words, folder, {-1, output.input(), output.input()}, child); error != 0)
    return not_started(words, error);
  output.close_input();
  std::string said;
  output.read_all([&](std::string_view some) { said += some; });
  return {wait_for(child).empty(), std::move(said)};
}

Outcome run(const std::vector<std::string>& words, const std::string& input,
            const std::function<void(std::string_view)>& take) {
  pid_t child = 0;
  std::exception_ptr thrown;
  {
    Pipe in, out;
    in.write_all(input);  // the pipe holds it
    if (const int error = start(words, ".", {in.output(), out.input()}, child); error != 0)
      return not_started(words, error);
    in.close_input();
    out.close_input();
    try {
      out.read_all(take);
    } catch (...) {
      thrown = std::current_exception();
    }
  }  // closes the pipes: whoever still writes has nobody who reads
  const std::string end = wait_for(child);
  if (thrown) std::rethrow_exception(thrown);
  return {end.empty(), end};
}

std::filesystem::path program_path(const std::string& name) {
  if (name.find('/') != std::string::npos) return ::access(name.c_str(), X_OK) == 0 ? name : "";
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const std::string file = folders.substr(0, end) + "/" + name;
    if (::access(file.c_str(), X_OK) == 0) return file;
    folders.erase(0, end + 1);
  }
  return {};
}

bool is_program(const std::string& name) { return !program_path(name).empty(); }

}  // namespace qvgen::toolchain
