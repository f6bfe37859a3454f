// SPDX-License-Identifier: MIT
#include "toolchain/generated.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace qvgen::toolchain {
namespace {

namespace fs = std::filesystem;

#if defined(__x86_64__)
constexpr bool has_avx2_forms = true;
#else
constexpr bool has_avx2_forms = false;
#endif

fs::path eigen() {
  const char* named = std::getenv("QVGEN_EIGEN");
  const fs::path folder = named == nullptr ? "/usr/include/eigen3" : named;
  if (!fs::exists(folder / "Eigen/Core"))
    throw std::runtime_error("there is no Eigen in " + folder.string() +
                             " (Debian: apt-get install libeigen3-dev; $QVGEN_EIGEN names another folder)");
  return folder;
}

bool mentions(const fs::path& file, const std::string& text) {
  std::ifstream stream(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return content.find(text) != std::string::npos;
}

Source runtime_source(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!has_avx2_forms) return {file};
  if (name == "sine_cosine.cpp" || name == "within.cpp") return {file, {"-DQVGEN_HAS_AVX2_KERNEL"}};
  if (name == "within_avx2.cpp") return {file, {"-mavx2", "-ffp-contract=off"}};
  if (name == "sine_cosine_avx2.cpp") return {file, {"-mavx2", "-mfma", "-ffp-contract=off"}};
  if (name == "pass_avx2.cpp") return {file, {"-mavx2", "-mfma"}};
  if (name == "pass_avx512.cpp") return {file, {"-mavx512f", "-mavx512dq", "-mavx512vl", "-mavx2", "-mfma"}};
  return {file};
}

/// Names of the archives that generated code may need, in the linker's order.
std::vector<std::string> archive_names() {
  std::vector<std::string> names;
  for (const std::string library : {"certified", "arm_angle", "elimination", "inverse", "core"})
    names.push_back("libqvgen_runtime_" + library + ".a");
  return names;
}

fs::path archive_in(const fs::path& folder, const std::string& name) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == name) return entry.path();
  throw std::runtime_error(name + " is not in " + folder.string());
}

/// Archives of a build of the source tree, in one folder of $QVGEN_LIBRARIES, as for the Python module; none
/// if one is missing.
std::vector<fs::path> built_archives() {
  const char* named = std::getenv("QVGEN_LIBRARIES");
  std::istringstream folders(named == nullptr ? "" : named);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::vector<fs::path> archives;
    for (const std::string& name : archive_names())
      if (fs::exists(fs::path(folder) / name)) archives.push_back(fs::absolute(fs::path(folder) / name));
    if (archives.size() == archive_names().size()) return archives;
  }
  return {};
}

}  // namespace

Runtime runtime_of(const fs::path& source_tree) {
  return {{source_tree / "runtime/include", eigen()}, source_tree / "runtime/source", built_archives()};
}

Runtime runtime_in(const fs::path& prefix) {
  if (!fs::exists(prefix / "include/qvgen/pose.h"))
    throw std::runtime_error("qvgen's headers are not in " + (prefix / "include").string() +
                             ", where the tool is installed: install the component runtime too");
  std::vector<fs::path> archives;
  for (const std::string& name : archive_names()) archives.push_back(archive_in(prefix / "lib", name));
  return {{prefix / "include", eigen()}, {}, archives};
}

std::vector<std::string> options_of_all(const Runtime& runtime) {
  std::vector<std::string> options{"-std=c++17", "-O2",        "-DNDEBUG",        "-fno-math-errno",
                                   "-pthread",   "-Wno-psabi", "-DQVGEN_NO_FLOAT"};
  for (const fs::path& folder : runtime.headers) options.push_back("-I" + folder.string());
  return options;
}

Source generated_source(const fs::path& file) {
  const std::string name = file.filename().string();
  if (name.ends_with("_avx2.cpp") && has_avx2_forms)
    return {file, {"-mavx2", "-ffp-contract=off", "-DQVGEN_NO_CONTRACTION"}};
  if (name == "inverse.cpp") return {file, {"-ffp-contract=off", "-DQVGEN_NO_CONTRACTION"}};
  return {file};
}

void add_runtime(const Runtime& runtime, const std::vector<fs::path>& generated, Program& program) {
  if (!runtime.archives.empty()) {
    for (const fs::path& archive : runtime.archives) program.libraries.push_back(archive.string());
    return;
  }
  program.sources.push_back(runtime_source(runtime.sources / "inverse/requested_pose.cpp"));
  for (const std::string part : {"core/sine_cosine", "inverse/within"}) {
    program.sources.push_back(runtime_source(runtime.sources / (part + ".cpp")));
    if (has_avx2_forms) program.sources.push_back(runtime_source(runtime.sources / (part + "_avx2.cpp")));
  }
  for (const std::string folder : {"elimination", "arm_angle", "certified"}) {
    const bool needed = std::any_of(generated.begin(), generated.end(), [&](const fs::path& file) {
      return file.filename() == folder + ".cpp" ||
             mentions(program.folder / file, "#include <qvgen/inverse/" + folder);
    });
    if (!needed) continue;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(runtime.sources / folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
      if (file.extension() == ".cpp") program.sources.push_back(runtime_source(file));
  }
}

}  // namespace qvgen::toolchain
