// SPDX-License-Identifier: MIT
#include "programs/program.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "pipeline/files.h"
#include "pipeline/folder_state.h"
#include "pipeline/pipeline.h"
#include "toolchain/cache.h"
#include "toolchain/workshop.h"

namespace qvgen::programs {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// All files that the compiler reads besides the system's, one after the other.
std::string sources_text(const pipeline::RobotOutput& output, const std::string& main,
                         const toolchain::Runtime& runtime) {
  std::string text = main;
  for (const pipeline::OutputFile& file : output.files) text += file.path + "\n" + file.content;
  std::vector<fs::path> folders{runtime.headers.front() / "qvgen"};
  if (!runtime.sources.empty()) folders.push_back(runtime.sources);
  std::vector<fs::path> files;
  for (const fs::path& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      // Those of robots are generated ones, which are not used here.
      if (entry.is_regular_file() && entry.path().string().find("/qvgen/robots") == std::string::npos)
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) text += pipeline::content_of(file).value_or("");
  return text;
}

toolchain::Program compilation(const model::Robot& robot, const pipeline::RobotOutput& output,
                               const Prepared& prepared, const fs::path& folder,
                               const toolchain::Runtime& runtime) {
  toolchain::Program program{toolchain::cxx_compiler(), toolchain::options_of_all(runtime), prepared.sources,
                             prepared.libraries};
  program.folder = folder;
  program.kept = fs::absolute(toolchain::cache_folder()) / "objects";
  program.options.insert(program.options.end(), {"-I.", "-Iinclude"});
  std::vector<fs::path> generated;
  for (const pipeline::OutputFile& file : output.files)
    for (const char* name : {"inverse.cpp", "inverse_avx2.cpp", "arm_angle.cpp", "certified.cpp"})
      if (file.path == "source/" + robot.name + "/" + name) generated.push_back(file.path);
  for (const fs::path& file : generated) program.sources.push_back(toolchain::generated_source(file));
  toolchain::add_runtime(runtime, generated, program);
  return program;
}

ordered_json made(const model::Robot& robot, const Recipe& recipe, const fs::path& target,
                  const toolchain::Runtime& runtime, const Progress& progress) {
  const std::vector<std::string> compiler = toolchain::cxx_compiler();
  if (const std::string missing = toolchain::missing(compiler); !missing.empty())
    throw std::runtime_error(fmt::format("a {} is computed by a program that is compiled for the arm, but {}",
                                         recipe.kind, missing));
  progress("deriving " + robot.name);
  const pipeline::RobotOutput output = pipeline::generate({robot}, recipe.parts).front();
  const Prepared prepared = recipe.prepare(output);
  const toolchain::Workshop workshop;
  for (const pipeline::OutputFile& file : output.files) workshop.write(file.path, file.content);
  workshop.write(recipe.kind + "_program.cpp", prepared.main);
  const toolchain::Outcome outcome =
      toolchain::build(compilation(robot, output, prepared, workshop.folder(), runtime), target,
                       [&](const std::string& file) { progress("compiled " + file); });
  if (!outcome.done)
    throw std::runtime_error(
        fmt::format("the program that computes the {} cannot be compiled:\n{}", recipe.kind, outcome.said));
  ordered_json about = prepared.about;
  about["fingerprint"] = pipeline::fingerprint(sources_text(output, prepared.main, runtime));
  return about;
}

}  // namespace

std::string reason_of(const pipeline::RobotOutput& output) {
  for (const pipeline::Missing& missing : output.missing)
    if (missing.part == "inverse" || missing.part == "jacobian") return missing.reason;
  return "none was derived";
}

Program program_for(const model::Robot& robot, const Recipe& recipe, const toolchain::Runtime& runtime,
                    const Progress& progress) {
  const fs::path folder =
      toolchain::cache_folder() / fmt::format("{}-{}-{}", recipe.kind, robot.name, recipe.key);
  fs::create_directories(folder);
  const fs::path program = folder / "program", about = folder / "about.json";
  const pipeline::FolderLock lock(folder);  // of several processes one compiles
  auto known = pipeline::content_of(about);
  if (!known || !fs::exists(program)) {
    fs::remove(about);
    try {
      known = made(robot, recipe, program, runtime, progress).dump();
    } catch (...) {
      std::error_code ignored;
      fs::remove(folder, ignored);  // nothing is in it
      throw;
    }
    pipeline::replace_file(about, *known, folder / "about.new");
  }
  return {program, ordered_json::parse(*known)};
}

}  // namespace qvgen::programs
