// SPDX-License-Identifier: MIT
#include "map/arm_program.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "emit/render.h"
#include "pipeline/files.h"
#include "pipeline/folder_state.h"
#include "pipeline/pipeline.h"
#include "toolchain/cache.h"
#include "toolchain/workshop.h"

namespace qvgen::map {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The inverse kinematics that is mapped: the first that there is.
struct Function {
  std::string name, suffix, task, given;
};

std::string reason_of(const pipeline::RobotOutput& output) {
  for (const pipeline::Missing& missing : output.missing)
    if (missing.part == "inverse" || missing.part == "jacobian") return missing.reason;
  return "none was derived";
}

Function function_of(const pipeline::RobotOutput& output) {
  const auto targets = output.counts.value("targets", ordered_json::object());
  for (const auto& [name, tasks] : targets.items()) {
    const std::string plain = "inverse_kinematics", near = plain + "_near", given = "_given_";
    if (name.rfind(near, 0) == 0) continue;
    const std::string suffix = name.substr(plain.size());
    return {name, suffix, tasks.front(), suffix.rfind(given, 0) == 0 ? suffix.substr(given.size()) : ""};
  }
  throw std::runtime_error(output.robot +
                           " has no inverse kinematics that could be mapped: " + reason_of(output));
}

void refuse_what_has_no_map(const model::Robot& robot, const Function& function) {
  const std::size_t joints = robot.joints.size();
  if (joints > 7 || !robot.motors.empty())
    throw std::runtime_error(
        fmt::format("{}: {}: there is no map of such arms", robot.name,
                    joints > 7 ? "several joints are given" : "its joints follow motors"));
  if (function.task == "direction" || function.task == "orientation")
    throw std::runtime_error(fmt::format(
        "{}: its inverse kinematics is asked for a {} alone, whose position follows; a map is of positions",
        robot.name, function.task));
  if (function.task == "pose" && joints < 6)
    throw std::runtime_error(fmt::format(
        "{}: its inverse kinematics is asked for whole poses, of which {} joints reach so few that their "
        "share says nothing; write task = \"position\" or another task into its description, if it has one",
        robot.name, joints));
}

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

std::string main_text(const model::Robot& robot, const Function& function,
                      const pipeline::RobotOutput& output) {
  const bool in_batches = function.task == "pose" || function.task == "position";
  const bool has_measures = robot.joints.size() == 6 && output.counts.contains("singularity_measures");
  return emit::render("cpp/map_program.cpp", {{"name", robot.name},
                                              {"function", function.name},
                                              {"info", "inverse_info" + function.suffix},
                                              {"in_batches", in_batches},
                                              {"given", !function.given.empty()},
                                              {"has_measures", has_measures}});
}

/// The widest instruction set that this machine has, and the compiler's options for it.
std::vector<std::pair<std::string, std::vector<std::string>>> lane_forms() {
#if defined(__x86_64__)
  const std::vector<std::string> avx2{"-mavx2", "-mfma"};
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return {{"AVX512", {"-mavx2", "-mfma", "-mavx512f", "-mavx512dq", "-mavx512vl"}}};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return {{"AVX2", avx2}};
#endif
  return {};
}

toolchain::Program program_of(const model::Robot& robot, const pipeline::RobotOutput& output,
                              const fs::path& folder, const toolchain::Runtime& runtime) {
  toolchain::Program program{toolchain::cxx_compiler(), toolchain::options_of_all(runtime), {}, {"-pthread"}};
  program.folder = folder;
  program.options.insert(program.options.end(), {"-I.", "-Iinclude"});
  toolchain::Source plain{"map_program.cpp", {"-ffp-contract=off"}};
  for (const auto& [set, options] : lane_forms()) {
    toolchain::Source lanes{"map_program.cpp", {"-ffp-contract=off", "-DQVGEN_BATCH_" + set}};
    lanes.options.insert(lanes.options.end(), options.begin(), options.end());
    program.sources.push_back(lanes);
    plain.options.push_back("-DQVGEN_BATCH_HAS_" + set);
  }
  program.sources.push_back(plain);
  std::vector<fs::path> generated;
  for (const pipeline::OutputFile& file : output.files)
    for (const char* name : {"inverse.cpp", "inverse_avx2.cpp"})
      if (file.path == "source/" + robot.name + "/" + name) generated.push_back(file.path);
  for (const fs::path& file : generated) program.sources.push_back(toolchain::generated_source(file));
  toolchain::add_runtime(runtime, generated, program);
  return program;
}

ordered_json made(const model::Robot& robot, const fs::path& target, const toolchain::Runtime& runtime,
                  const std::function<void(const std::string&)>& progress) {
  const std::vector<std::string> compiler = toolchain::cxx_compiler();
  if (const std::string missing = toolchain::missing(compiler); !missing.empty())
    throw std::runtime_error("a map is computed by a program that is compiled for the arm, but " + missing);
  progress("deriving " + robot.name);
  const pipeline::RobotOutput output = pipeline::generate({robot}, {"jacobian", "inverse", "batch"}).front();
  const Function function = function_of(output);
  refuse_what_has_no_map(robot, function);
  const toolchain::Workshop workshop;
  for (const pipeline::OutputFile& file : output.files) workshop.write(file.path, file.content);
  const std::string main = main_text(robot, function, output);
  workshop.write("map_program.cpp", main);
  const toolchain::Outcome outcome =
      toolchain::build(program_of(robot, output, workshop.folder(), runtime), target,
                       [&](const std::string& file) { progress("compiled " + file); });
  if (!outcome.done)
    throw std::runtime_error("the program that computes the map cannot be compiled:\n" + outcome.said);
  return {{"fingerprint", pipeline::fingerprint(sources_text(output, main, runtime))},
          {"task", function.task},
          {"given", function.given}};
}

/// Output of the program, cut into blocks.
class Stream {
 public:
  Stream(const Grid& grid, const std::function<void(int, std::vector<Cell>)>& take)
      : grid_(grid), take_(take) {}

  void operator()(std::string_view some) {
    bytes_ += some;
    std::size_t at = 0;
    while (bytes_.size() - at >= 4) {
      std::uint32_t block = 0;
      std::memcpy(&block, bytes_.data() + at, 4);
      if (block >= Grid::blocks) throw std::runtime_error("the program that computes the map talks nonsense");
      const int number = static_cast<int>(block);
      const auto count = static_cast<std::size_t>(grid_.first_of(number + 1) - grid_.first_of(number));
      if (bytes_.size() - at - 4 < count * sizeof(Cell)) break;
      std::vector<Cell> cells(count);
      if (count > 0) std::memcpy(cells.data(), bytes_.data() + at + 4, count * sizeof(Cell));
      take_(number, std::move(cells));
      at += 4 + count * sizeof(Cell);
    }
    bytes_.erase(0, at);
  }

 private:
  const Grid& grid_;
  const std::function<void(int, std::vector<Cell>)>& take_;
  std::string bytes_;
};

}  // namespace

ArmProgram arm_program(const model::Robot& robot, const std::string& key, const toolchain::Runtime& runtime,
                       const std::function<void(const std::string&)>& progress) {
  const auto forms = lane_forms();  // machines that share a cache may have others
  const fs::path folder =
      toolchain::cache_folder() /
      fmt::format("map-{}-{}{}", robot.name, key, forms.empty() ? "" : "-" + forms.front().first);
  fs::create_directories(folder);
  const fs::path program = folder / "program", about = folder / "about.json";
  const pipeline::FolderLock lock(folder);  // of several processes one compiles
  auto known = pipeline::content_of(about);
  if (!known || !fs::exists(program)) {
    fs::remove(about);
    try {
      known = made(robot, program, runtime, progress).dump();
    } catch (...) {
      std::error_code ignored;
      fs::remove(folder, ignored);  // nothing is in it
      throw;
    }
    pipeline::replace_file(about, *known, folder / "about.new");
  }
  const ordered_json json = ordered_json::parse(*known);
  return {program, json.at("fingerprint"), json.at("task"), json.at("given")};
}

void compute(const ArmProgram& program, const Plan& plan, const std::vector<int>& blocks, int threads,
             const std::function<void(int, std::vector<Cell>)>& take) {
  std::vector<std::string> words{program.file.string()};
  const auto& [centre, radius, resolution] = plan.sphere;
  for (const double number : {centre[0], centre[1], centre[2], radius, resolution})
    words.push_back(fmt::format("{:a}", number));
  for (const std::size_t count : {plan.targets, plan.values}) words.push_back(std::to_string(count));
  for (const double number : {plan.lower, plan.upper}) words.push_back(fmt::format("{:a}", number));
  words.push_back(plan.limits ? "1" : "0");
  words.push_back(std::to_string(threads));
  std::string input;
  for (const int block : blocks) input += std::to_string(block) + "\n";
  const Grid grid(plan.sphere);
  std::size_t taken = 0;
  const auto count = [&](int block, std::vector<Cell> cells) {
    ++taken;
    take(block, std::move(cells));
  };
  const std::function<void(int, std::vector<Cell>)> counted = count;
  Stream stream(grid, counted);
  const toolchain::Outcome outcome =
      toolchain::run(words, input, [&](std::string_view some) { stream(some); });
  if (!outcome.done || taken != blocks.size())
    throw std::runtime_error("the program that computes the map has not finished: " + outcome.said);
}

}  // namespace qvgen::map
