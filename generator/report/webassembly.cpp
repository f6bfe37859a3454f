// SPDX-License-Identifier: MIT
#include "report/webassembly.h"

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "pipeline/files.h"
#include "report/html.h"

namespace qvgen::report {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone at the end.
class Workshop {
 public:
  Workshop() {
    std::string name = (fs::temp_directory_path() / "qvgen-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop() {
    std::error_code error;
    fs::remove_all(folder_, error);
  }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    return pipeline::content_of(folder_ / name).value_or("");
  }
  [[nodiscard]] const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

bool is_in_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    if (::access((folders.substr(0, end) + "/" + program).c_str(), X_OK) == 0) return true;
    folders.erase(0, end + 1);
  }
  return false;
}

/// Runs a program in a folder, what it says into a file there.
bool run(const std::vector<std::string>& words, const fs::path& folder, const char* said) {
  const pid_t child = ::fork();
  if (child < 0) return false;
  if (child == 0) {
    std::vector<char*> arguments;
    for (const std::string& word : words)
      arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: exec's type
    arguments.push_back(nullptr);
    if (::chdir(folder.c_str()) == 0 && std::freopen(said, "w", stderr) != nullptr)
      ::execvp(arguments.front(), arguments.data());
    ::_exit(127);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string missing_compiler() {
  for (const char* program : {"clang", "wasm-ld"})
    if (!is_in_path(program))
      return std::string(program) +
             " is not on the machine that wrote it (Debian: apt-get install clang lld)";
  return "";
}

Compiled to_webassembly(const std::map<std::string, std::string>& files) {
  if (const std::string missing = missing_compiler(); !missing.empty()) return {false, "", missing};
  const Workshop workshop;
  std::vector<std::string> call{"clang",
                                "--target=wasm32",
                                "-std=gnu99",
                                "-O2",
                                "-ffreestanding",
                                "-nostdlib",
                                "-ffp-contract=off",
                                "-fno-strict-aliasing",
                                "-mbulk-memory",
                                "-I.",
                                "-Wl,--no-entry",
                                "-Wl,--strip-all",
                                "-o",
                                "module.wasm"};
  workshop.write("math.h", asset("wasm_math.h"));
  workshop.write("string.h", asset("wasm_string.h"));
  for (const auto& [name, content] : files) {
    workshop.write(name, content);
    if (name.ends_with(".c")) call.push_back(name);
  }
  if (!run(call, workshop.folder(), "said"))
    return {false, "", "clang has failed: " + workshop.read("said").substr(0, 2000)};
  return {true, workshop.read("module.wasm"), ""};
}

std::string base64(const std::string& bytes) {
  static constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8U) | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? letters[(group >> (18 - 6 * k)) & 63U] : '=';
  }
  return text;
}

}  // namespace qvgen::report
