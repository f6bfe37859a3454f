// SPDX-License-Identifier: MIT
#include "map/arm_program.h"

#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "emit/render.h"
#include "model/followers.h"
#include "programs/program.h"
#include "toolchain/process.h"

namespace qvgen::map {
namespace {

using nlohmann::ordered_json;

/// The inverse kinematics that is mapped: the first that there is.
struct Function {
  std::string name, suffix, task, given;
};

Function function_of(const pipeline::RobotOutput& output) {
  const auto targets = output.counts.value("targets", ordered_json::object());
  for (const auto& [name, tasks] : targets.items()) {
    const std::string plain = "inverse_kinematics", near = plain + "_near", given = "_given_";
    if (name.rfind(near, 0) == 0) continue;
    const std::string suffix = name.substr(plain.size());
    return {name, suffix, tasks.front(), suffix.rfind(given, 0) == 0 ? suffix.substr(given.size()) : ""};
  }
  throw std::runtime_error(output.robot +
                           " has no inverse kinematics that could be mapped: " + programs::reason_of(output));
}

void refuse_what_has_no_map(const model::Robot& robot, const Function& function) {
  const std::size_t joints = robot.joints.size();
  if (joints > 7 || model::has_followers(robot))
    throw std::runtime_error(
        fmt::format("{}: {}: there is no map of such arms", robot.name,
                    joints > 7 ? "several joints are given" : "its joints follow others, or motors"));
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

std::vector<toolchain::Source> sources_of() {
  std::vector<toolchain::Source> sources;
  toolchain::Source plain{"map_program.cpp", {"-ffp-contract=off"}};
  for (const auto& [set, options] : lane_forms()) {
    toolchain::Source lanes{"map_program.cpp", {"-ffp-contract=off", "-DQVGEN_BATCH_" + set}};
    lanes.options.insert(lanes.options.end(), options.begin(), options.end());
    sources.push_back(lanes);
    plain.options.push_back("-DQVGEN_BATCH_HAS_" + set);
  }
  sources.push_back(plain);
  return sources;
}

programs::Prepared prepared(const model::Robot& robot, const pipeline::RobotOutput& output) {
  const Function function = function_of(output);
  refuse_what_has_no_map(robot, function);
  return {main_text(robot, function, output),
          sources_of(),
          {"-pthread"},
          {{"task", function.task}, {"given", function.given}}};
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
  const programs::Recipe recipe{"map",
                                key + (forms.empty() ? "" : "-" + forms.front().first),
                                {"jacobian", "inverse", "batch"},
                                [&](const pipeline::RobotOutput& output) { return prepared(robot, output); }};
  const programs::Program program = programs::program_for(robot, recipe, runtime, progress);
  const ordered_json& about = program.about;
  return {program.file, about.at("fingerprint"), about.at("task"), about.at("given")};
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
