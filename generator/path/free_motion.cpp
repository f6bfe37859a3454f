// SPDX-License-Identifier: MIT
// The motion along a path that leaves one coordinate free, as JSON and as a picture.
#include "path/free.h"
#include "path/result.h"

namespace qvgen::path {
namespace {

using nlohmann::ordered_json;

/// Joint values, then those of what is free and no joint.
std::vector<double> panels_of(const FreeMotion::Place& place, const FreeTask& task) {
  std::vector<double> values = place.q;
  const std::vector<FreeColumn> columns = task.columns();
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (task.joint(columns[i].name) == nullptr) values.push_back(place.values.at(i));
  return values;
}

Motion motion_of(const FreeMotion& free, const FreeTask& task) {
  Motion motion;
  for (std::size_t i = 0; i < free.places.size(); ++i)
    motion.curve.emplace_back(static_cast<double>(i), panels_of(free.places[i], task));
  motion.begin = {0, "path_end", -1, false, 0, motion.curve.front().second};
  motion.end = {free.followed, "path_end", -1, false, 0, motion.curve.back().second};
  return motion;
}

}  // namespace

ordered_json json_of(const FreeMotion& motion, const FreeTask& task, const std::string& robot) {
  ordered_json json{{"robot", robot}, {"joints", ordered_json::array()}, {"free", ordered_json::array()}};
  for (const MovingJoint& joint : task.joints) json["joints"].push_back(joint.name);
  for (const FreeColumn& column : task.columns()) json["free"].push_back(column.name);
  json["samples"] = motion.samples;
  json["seconds"] = motion.seconds;
  json["followed"] = motion.followed;
  json["cost"] = motion.cost;
  json["motion"] = ordered_json::array();
  for (std::size_t i = 0; i < motion.places.size(); ++i)
    json["motion"].push_back({{"s", i}, {"values", motion.places[i].values}, {"q", motion.places[i].q}});
  return json;
}

Shown shown_of(const FreeMotion& motion, const FreeTask& task) {
  Shown shown;
  Task& panels = shown.panels;
  panels.joints = task.joints;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const FreeColumn& column : task.columns())
    if (task.joint(column.name) == nullptr)
      panels.joints.push_back({column.name, column.turns, {-infinity, infinity}, infinity, 0});
  shown.result.samples = motion.samples;
  if (!motion.places.empty()) shown.result.motions.push_back(motion_of(motion, task));
  return shown;
}

std::string picture_of(const FreeMotion& motion, const FreeTask& task, const std::string& title) {
  const Shown shown = shown_of(motion, task);
  return picture_of(shown.result, shown.panels, title);
}

}  // namespace qvgen::path
