// SPDX-License-Identifier: MIT
#include "pipeline/pipeline.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "emit/render.h"
#include "pipeline/parallel.h"
#include "pipeline/products/product.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// Includes the headers that the products have made for this robot: not every robot has every part.
OutputFile umbrella_header(const model::Robot& robot, const std::vector<OutputFile>& files) {
  json parts = json::array();
  for (const Product& product : all_products()) {
    const std::string header = "include/qvgen/robots/" + robot.name + "/" + product.part + ".h";
    const auto is_header = [&](const OutputFile& file) { return file.path == header; };
    if (std::any_of(files.begin(), files.end(), is_header)) parts.push_back({{"part", product.part}});
  }
  return {"include/qvgen/robots/" + robot.name + ".h",
          emit::render("robot.h", {{"name", robot.name}, {"parts", parts}})};
}

void check_parts(const Parts& parts) {
  for (const std::string& part : parts) {
    const auto is_it = [&](const Product& product) { return product.part == part; };
    if (std::any_of(all_products().begin(), all_products().end(), is_it)) continue;
    std::string known;
    for (const Product& product : all_products()) known += (known.empty() ? "" : ", ") + product.part;
    throw std::invalid_argument("no part " + part + "; there are " + known);
  }
}

/// Every part rests on the model header.
bool is_wanted(const Product& product, const Parts& parts) {
  return parts.empty() || product.part == all_products().front().part ||
         std::find(parts.begin(), parts.end(), product.part) != parts.end();
}

}  // namespace

RobotOutput generate_robot(const model::Robot& robot, const Parts& parts) {
  RobotOutput output{robot.name, {}, ordered_json::object(), {}};
  try {
    for (const Product& product : all_products())
      if (is_wanted(product, parts)) product.generate(robot, output);
  } catch (const std::exception& error) {
    throw std::runtime_error(robot.name + ": " + error.what());
  }
  output.files.push_back(umbrella_header(robot, output.files));
  return output;
}

std::vector<OutputFile> generate(const std::vector<model::Robot>& robots, const Parts& parts,
                                 const ordered_json& earlier,
                                 const std::function<void(const std::string&)>& progress,
                                 std::vector<std::string>* missing) {
  check_parts(parts);
  const auto work = [&](std::size_t i) { return to_text(generate_robot(robots[i], parts)); };
  const auto done = [&](std::size_t i) {
    if (progress) progress(robots[i].name);
  };
  std::vector<OutputFile> files;
  std::map<std::string, ordered_json> entries;
  for (const auto& [robot, entry] : earlier.items()) entries[robot] = entry;
  for (const std::string& text : in_processes(robots.size(), work, done)) {
    RobotOutput output = robot_output_from_text(text);
    entries[output.robot] = output.counts;
    for (const std::string& reason : output.missing)
      if (missing != nullptr) missing->push_back(output.robot + ": " + reason);
    files.insert(files.end(), output.files.begin(), output.files.end());
  }
  ordered_json all = ordered_json::object();
  for (const auto& [robot, entry] : entries) all[robot] = entry;
  files.push_back({"operation_counts.json", all.dump(1) + "\n"});
  files.push_back({"README.md", emit::render("generated_readme.md", json::object())});
  return files;
}

}  // namespace qvgen::pipeline
