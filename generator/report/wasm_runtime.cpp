// SPDX-License-Identifier: MIT
#include "report/wasm_runtime.h"

#include <algorithm>

#include "pipeline/files.h"
#include "pipeline/folder_state.h"
#include "toolchain/cache.h"
#include "toolchain/process.h"

namespace qvgen::report {
namespace {

namespace fs = std::filesystem;
using toolchain::Outcome;
using toolchain::Runtime;

/// Files with that end in a folder, sorted, relative to `root`; a folder that is not there has none.
std::vector<std::string> files_in(const fs::path& root, const fs::path& folder, const std::string& end) {
  std::vector<std::string> names;
  if (!fs::is_directory(root / folder)) return names;
  for (const auto& entry : fs::directory_iterator(root / folder))
    if (entry.path().extension() == end) names.push_back((folder / entry.path().filename()).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string includes_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += "#include <" + name + ">\n";
  return text;
}

/// All sources as one, so that headers are read once.
std::string sources_text(const std::vector<std::string>& folders, const Runtime& runtime) {
  std::vector<std::string> names{"core/sine_cosine.cpp", "inverse/requested_pose.cpp", "inverse/within.cpp"};
  for (const std::string& folder : folders)
    for (const std::string& name : files_in(runtime.sources, folder, ".cpp")) names.push_back(name);
  return includes_of(names);
}

/// The headers by the folders' names: qvgen/inverse/arm_angle.h, qvgen/inverse/elimination/*.h.
std::string headers_text(const std::vector<std::string>& folders, const Runtime& runtime) {
  std::vector<std::string> names{"qvgen/inverse/requested_pose.h", "qvgen/inverse/seed.h"};
  for (const std::string& folder : folders) {
    const fs::path inverse = "qvgen/inverse";
    if (const fs::path one = inverse / (folder + ".h"); fs::exists(runtime.headers.front() / one))
      names.push_back(one.string());
    for (const std::string& name : files_in(runtime.headers.front(), inverse / folder, ".h"))
      names.push_back(name);
  }
  return includes_of(names);
}

/// Returns the key of all that the compiler reads: what is in the runtime, and versions of the rest.
std::string key_of(const std::string& headers, const std::string& sources, const Runtime& runtime) {
  std::string text = headers + sources + toolchain::run({"clang++", "--version"}).said;
  for (const std::string& word : wasm_compiler(runtime)) text += word + "\n";
  std::vector<fs::path> files{runtime.headers.back() / "Eigen/src/Core/util/Macros.h"};
  for (const fs::path& folder : {runtime.headers.front() / "qvgen", runtime.sources})
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) text += file.string() + pipeline::content_of(file).value_or("");
  return pipeline::fingerprint(text);
}

Outcome compiled(const fs::path& folder, const Runtime& runtime, const std::vector<std::string>& words) {
  std::vector<std::string> call = wasm_compiler(runtime);
  call.insert(call.end(), words.begin(), words.end());
  return toolchain::run(call, folder);
}

}  // namespace

std::vector<std::string> wasm_compiler(const Runtime& runtime) {
  std::vector<std::string> call{"clang++",
                                "--target=wasm32-wasi",
                                "-std=c++17",
                                "-O1",
                                "-DNDEBUG",
                                "-DEIGEN_DONT_VECTORIZE",
                                "-DQVGEN_NO_CONTRACTION",
                                "-ffp-contract=off",
                                "-fno-exceptions",
                                "-fno-rtti",
                                "-mbulk-memory"};
  for (const fs::path& folder : runtime.headers) call.push_back("-I" + folder.string());
  call.push_back("-I" + runtime.sources.string());
  return call;
}

WasmRuntime wasm_runtime(const std::vector<std::string>& folders, const Runtime& runtime) {
  const std::string headers = headers_text(folders, runtime), sources = sources_text(folders, runtime);
  std::string name = "wasm";
  for (const std::string& folder : folders) name += "-" + folder;
  const fs::path folder = toolchain::cache_folder() / (name + "-" + key_of(headers, sources, runtime));
  fs::create_directories(folder);
  const pipeline::FolderLock lock(folder);  // of several processes one compiles
  WasmRuntime kept{folder / "runtime.o", folder / "headers.pch", ""};
  if (fs::exists(kept.object)) return kept;  // written last
  pipeline::replace_file(folder / "headers.h", headers, folder / "headers.new");
  pipeline::replace_file(folder / "sources.cpp", sources, folder / "sources.new");
  Outcome outcome = compiled(
      folder, runtime, {"-x", "c++-header", "-fpch-instantiate-templates", "headers.h", "-o", "headers.pch"});
  if (outcome.done)
    outcome =
        compiled(folder, runtime, {"-include-pch", "headers.pch", "-c", "sources.cpp", "-o", "runtime.new"});
  if (outcome.done)
    fs::rename(folder / "runtime.new", kept.object);
  else
    kept.failed = outcome.said;
  return kept;
}

void forget(const WasmRuntime& kept) {
  std::error_code ignored;
  fs::remove(kept.object, ignored);
}

}  // namespace qvgen::report
