// SPDX-License-Identifier: MIT
// Programs of one arm differ in their main function, those of several arms share the runtime: objects that
// are made of the same text by the same command are compiled once. The text is found as a compiler finds it,
// but every #include counts, whatever #if is around it: a header too many costs a compilation, none can be
// missed. A compiler of another version is another one.
#include "toolchain/kept_objects.h"

#include <fstream>
#include <optional>
#include <set>

#include "exact/hash.h"

namespace qvgen::toolchain {
namespace {

namespace fs = std::filesystem;

/// The file that a line includes, nothing if it includes none.
std::optional<std::string> included(const std::string& line) {
  const std::size_t sharp = line.find_first_not_of(" \t");
  if (sharp == std::string::npos || line[sharp] != '#') return std::nullopt;
  const std::size_t word = line.find_first_not_of(" \t", sharp + 1);
  if (word == std::string::npos || line.compare(word, 7, "include") != 0) return std::nullopt;
  const std::size_t begin = line.find_first_of("<\"", word + 7);
  if (begin == std::string::npos) return std::nullopt;
  const std::size_t end = line.find_first_of(">\"", begin + 1);
  return end == std::string::npos ? std::nullopt : std::optional(line.substr(begin + 1, end - begin - 1));
}

/// Reads a file and all that it includes, each once; headers in none of the folders are the system's.
class Reader {
 public:
  explicit Reader(std::vector<fs::path> folders) : folders_(std::move(folders)) {}

  void read(const fs::path& file) {
    if (!seen_.insert(file.lexically_normal()).second) return;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
      text_ += line + "\n";
      if (const auto name = included(line)) follow(*name, file.parent_path());
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void follow(const std::string& name, const fs::path& beside) {
    if (fs::is_regular_file(beside / name)) return read(beside / name);
    for (const fs::path& folder : folders_)
      if (fs::is_regular_file(folder / name)) return read(folder / name);
  }

  std::vector<fs::path> folders_;
  std::set<fs::path> seen_;
  std::string text_;
};

/// Size and time of a program, which differ where the machine has another version of it; empty for words that
/// are no programs.
std::string version_of(const std::string& word) {
  const fs::path file = program_path(word);
  std::error_code none;
  const auto size = fs::file_size(file, none);
  if (none) return "";
  const auto time = fs::last_write_time(file, none).time_since_epoch().count();
  return std::to_string(size) + " " + std::to_string(time) + "\n";
}

}  // namespace

fs::path kept_object(const Program& program, const Source& source) {
  std::vector<fs::path> folders;
  for (const std::string& option : program.options)
    if (option.starts_with("-I")) folders.push_back(program.folder / option.substr(2));
  Reader reader(std::move(folders));
  reader.read(program.folder / source.file);
  std::string made_of;
  for (const auto* words : {&program.compiler, &program.options, &source.options})
    for (const std::string& word : *words) made_of += word + "\n";
  for (const std::string& word : program.compiler) made_of += version_of(word);
  return program.kept / (std::to_string(exact::hash(made_of + reader.text())) + ".o");
}

}  // namespace qvgen::toolchain
