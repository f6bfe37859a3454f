// SPDX-License-Identifier: MIT
#include "pipeline/images.h"

#include <algorithm>
#include <optional>

#include "emit/cpp/compact_text.h"
#include "emit/render.h"
#include "model/image.h"
#include "pipeline/products/model_header.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

std::string headers_of(const std::string& robot) { return "include/qvgen/robots/" + robot + "/"; }

bool begins_with(const std::string& path, const std::string& folder) { return path.rfind(folder, 0) == 0; }

bool is_of(const std::string& robot, const OutputFile& file) {
  return begins_with(file.path, headers_of(robot)) || begins_with(file.path, "source/" + robot + "/");
}

json image_values(const model::Robot& robot, const model::Image& image) {
  json joints = json::array();
  for (const int sign : image.signs) joints.push_back({{"sign", sign}, {"last", false}});
  joints.back()["last"] = true;
  json mirror = json::array();
  for (const auto& signs : {image.mirror, image.tool})
    for (const int sign : signs) mirror.push_back({{"sign", sign}});
  return {{"name", image.name}, {"of", robot.name}, {"mirror", mirror}, {"joints", joints}};
}

/// True if there is no header of `of` that the image lacks, and no file of another kind.
bool has_all_headers(const std::vector<OutputFile>& image, const std::string& name, const RobotOutput& of) {
  const std::string headers = headers_of(of.robot);
  return std::all_of(of.files.begin(), of.files.end(), [&](const OutputFile& file) {
    if (!begins_with(file.path, headers)) return is_of(of.robot, file);
    const std::string path = headers_of(name) + file.path.substr(headers.size());
    return std::any_of(image.begin(), image.end(), [&](const OutputFile& each) { return each.path == path; });
  });
}

/// Finds images among limbs of the same robots, and gives them to the first limb of their kind. Returns the
/// place of the limb that each robot is an image of, its own for others.
std::vector<std::size_t> find_images(std::vector<Original>& all, const std::vector<std::string>& limb_of) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    places.push_back(i);
    for (std::size_t k = 0; k < i && !limb_of[i].empty() && places[i] == i; ++k) {
      if (places[k] != k || limb_of[k] != limb_of[i]) continue;
      const auto image = model::image_of(all[k].robot, all[i].robot);
      if (!image) continue;
      all[k].images.push_back(*image);
      places[i] = k;
    }
  }
  return places;
}

/// Returns a text about a robot with the names of an image's joints in the place of its own.
std::string about_image(const model::Robot& robot, const model::Image& image, const std::string& text) {
  return emit::with_words(text, [&](const std::string& word) {
    for (std::size_t i = 0; i < robot.joints.size(); ++i)
      if (word == robot.joints[i].variable) return image.variables[i];
    return word;
  });
}

/// Takes an image's files out of the output that they were made in; their counts are those of the other limb.
RobotOutput taken(const model::Robot& image, const Original& original, RobotOutput& of) {
  const auto first = std::stable_partition(of.files.begin(), of.files.end(),
                                           [&](const OutputFile& file) { return !is_of(image.name, file); });
  RobotOutput output{image.name, {first, of.files.end()}, of.counts, of.missing};
  of.files.erase(first, of.files.end());
  const auto own = std::find_if(original.images.begin(), original.images.end(),
                                [&](const model::Image& each) { return each.name == image.name; });
  for (Missing& missing : output.missing) missing.reason = about_image(original.robot, *own, missing.reason);
  generate_model_header(image, output);
  return output;
}

using Outputs = std::vector<std::optional<RobotOutput>>;

/// Derives the robots that have no output yet and are meant.
template <class IsMeant>
void derive_those(const std::vector<Original>& all, const Derive& derive, const IsMeant& is_meant,
                  Outputs& outputs) {
  std::vector<Original> some;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (outputs[i] || !is_meant(i)) continue;
    places.push_back(i);
    some.push_back(all[i]);
  }
  if (some.empty()) return;
  std::vector<RobotOutput> made = derive(some);
  for (std::size_t i = 0; i < made.size(); ++i) outputs[places[i]] = std::move(made[i]);
}

}  // namespace

std::vector<RobotOutput> derived_once(const std::vector<model::Robot>& robots,
                                      const std::vector<std::string>& limb_of, const Derive& derive,
                                      const std::function<void(const std::string&)>& progress) {
  std::vector<Original> all;
  for (const model::Robot& robot : robots) all.push_back({robot});
  const std::vector<std::size_t> originals = find_images(all, limb_of);
  Outputs outputs(all.size());
  const auto is_image = [&](std::size_t i) { return originals[i] != i; };
  derive_those(
      all, derive, [&](std::size_t i) { return !is_image(i); }, outputs);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (is_image(i)) outputs[i] = taken(robots[i], all[originals[i]], *outputs[originals[i]]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_image(i)) continue;
    if (!has_all_headers(outputs[i]->files, robots[i].name, *outputs[originals[i]]))
      outputs[i].reset();
    else if (progress)
      progress(robots[i].name);
  }
  derive_those(
      all, derive, [](std::size_t) { return true; }, outputs);
  std::vector<RobotOutput> result;
  for (std::optional<RobotOutput>& output : outputs) result.push_back(std::move(*output));
  return result;
}

void add_image(const model::Robot& robot, const model::Image& image, const std::string& part,
               bool has_definitions, const json& values, RobotOutput& output) {
  json all = values;
  all.update(image_values(robot, image));
  all["part"] = part;
  const std::string path = headers_of(image.name) + part;
  output.files.push_back({path + ".h", emit::render("cpp/image_" + part + ".h", all)});
  if (has_definitions)
    output.files.push_back({path + "_definitions.h", emit::render("cpp/image_definitions.h", all)});
}

}  // namespace qvgen::pipeline
