// SPDX-License-Identifier: MIT
#include "path/run.h"

#include <stdexcept>

#include "toolchain/process.h"
#include "toolchain/workshop.h"

namespace qvgen::path {

using nlohmann::ordered_json;

std::vector<std::string> functions_of(const pipeline::RobotOutput& output) {
  std::vector<std::string> names;
  const auto targets = output.counts.value("targets", ordered_json::object());
  for (const auto& [name, tasks] : targets.items())
    for (const auto& task : tasks)
      if (task == "pose") names.push_back(name);
  return names;
}

ordered_json run_with_poses(const programs::Program& program, const std::vector<std::string>& words,
                            const Poses& poses) {
  const toolchain::Workshop workshop;
  const auto* bytes = reinterpret_cast<const char*>(poses.samples.data());
  workshop.write("poses", std::string(bytes, poses.samples.size() * sizeof(Sample)));
  std::vector<std::string> all{program.file.string(), (workshop.folder() / "poses").string()};
  all.insert(all.end(), words.begin(), words.end());
  std::string text;
  const toolchain::Outcome outcome = toolchain::run(all, "", [&](std::string_view some) { text += some; });
  if (!outcome.done)
    throw std::runtime_error("the program that follows the path has not finished: " + outcome.said);
  return ordered_json::parse(text);
}

}  // namespace qvgen::path
