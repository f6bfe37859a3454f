// SPDX-License-Identifier: MIT
#include "toolchain/build.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <thread>

#include "toolchain/kept_objects.h"
#include "toolchain/workshop.h"

namespace qvgen::toolchain {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words operator+(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Shortens the words of a compiler, which may say thousands of lines about one mistake.
std::string shortened(const std::string& said) {
  constexpr std::size_t most = 4000;
  return said.size() <= most ? said : said.substr(0, said.rfind('\n', most)) + "\n...\n";
}

Outcome run_shown(const Words& words, const fs::path& folder) {
  Outcome outcome = run(words, folder);
  if (outcome.done) return outcome;
  std::string command;
  for (const std::string& word : words) command += (command.empty() ? "" : " ") + word;
  return {false, command + "\n" + shortened(outcome.said)};
}

/// Paths of the objects of all sources.
std::vector<fs::path> objects_of(const Program& program, const fs::path& folder) {
  std::vector<fs::path> objects;
  for (const Source& source : program.sources)
    objects.push_back(program.kept.empty() ? folder / (std::to_string(objects.size()) + ".o")
                                           : kept_object(program, source));
  return objects;
}

/// Compiles a source unless its object is there, which appears whole or not at all.
Outcome compile(const Program& program, const Source& source, const fs::path& object,
                const fs::path& temporary) {
  if (fs::exists(object)) return {true, ""};
  const Words output{"-c", source.file.string(), "-o", temporary.string()};
  const Outcome outcome =
      run_shown(program.compiler + program.options + source.options + output, program.folder);
  if (!outcome.done) return outcome;
  fs::create_directories(object.parent_path());
  fs::rename(temporary, object);
  return outcome;
}

/// Outcomes of all sources, in their order; those behind one that has failed may not have been tried.
std::vector<Outcome> compile_all(const Program& program, const std::vector<fs::path>& objects,
                                 const fs::path& folder, const Progress& progress) {
  const std::size_t count = program.sources.size();
  std::vector<Outcome> outcomes(count);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t i = next++; i < count && !failed; i = next++) {
      const Source& source = program.sources[i];
      outcomes[i] = compile(program, source, objects[i], folder / (std::to_string(i) + ".new"));
      if (!outcomes[i].done) failed = true;
      const std::lock_guard<std::mutex> lock(telling);
      if (progress) progress(source.file.filename().string());
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, count); ++i)
    threads.emplace_back(work);
  threads.clear();  // waits for them
  return outcomes;
}

}  // namespace

Words cxx_compiler() {
  const char* named = std::getenv("CXX");
  std::istringstream text(named == nullptr ? "" : named);
  Words words;
  for (std::string word; text >> word;) words.push_back(word);
  return words.empty() ? Words{"c++"} : words;
}

std::string missing(const Words& compiler) {
  if (is_program(compiler.front())) return "";
  return "there is no compiler " + compiler.front() +
         " on this machine (Debian: apt-get install g++; $CXX names another)";
}

Outcome build(const Program& program, const fs::path& target, const Progress& progress) {
  fs::create_directories(fs::absolute(target).parent_path());
  const Workshop workshop(fs::absolute(target).parent_path());  // on the same file system
  const std::vector<fs::path> objects = objects_of(program, workshop.folder());
  const std::vector<Outcome> outcomes = compile_all(program, objects, workshop.folder(), progress);
  for (const Outcome& outcome : outcomes)
    if (!outcome.done && !outcome.said.empty()) return outcome;
  Words linked_files;
  for (const fs::path& object : objects) linked_files.push_back(object.string());
  const fs::path whole = workshop.folder() / "program";
  const Outcome linked = run_shown(
      program.compiler + Words{"-o", whole.string()} + linked_files + program.libraries, program.folder);
  if (linked.done) fs::rename(whole, target);
  return linked;
}

}  // namespace qvgen::toolchain
