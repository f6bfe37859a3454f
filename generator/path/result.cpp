// SPDX-License-Identifier: MIT
#include "path/result.h"

#include <fmt/format.h>

namespace qvgen::path {
namespace {

using nlohmann::ordered_json;

MotionEnd end_of(const ordered_json& json) {
  return {json.at("s"),     json.at("cause"), json.at("partner"),
          json.at("upper"), json.at("free"),  json.at("q").get<std::vector<double>>()};
}

std::optional<double> number_of(const ordered_json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

Extreme extreme_of(const ordered_json& json) {
  return {number_of(json.at("value")), json.at("s"), json.at("joint")};
}

std::vector<std::pair<double, double>> stretches_of(const ordered_json& json) {
  std::vector<std::pair<double, double>> stretches;
  for (const auto& stretch : json) stretches.emplace_back(stretch.at(0), stretch.at(1));
  return stretches;
}

Motion motion_of(const ordered_json& json) {
  Motion motion;
  motion.track = json.at("track");
  motion.representatives = json.at("representatives");
  motion.begin = end_of(json.at("begin"));
  motion.end = end_of(json.at("end"));
  int branch = json.at("branches").front();
  if (branch >= 0) motion.branches.push_back(branch);
  for (const auto& crossing : json.at("crossings")) {
    motion.crossings.push_back(crossing.at("s"));
    if (crossing.at("behind").get<int>() >= 0) motion.branches.push_back(crossing.at("behind"));
  }
  if (json.contains("proof")) {
    motion.proof.emplace();
    motion.proof->gaps = stretches_of(json.at("proof").at("gaps"));
    motion.proof->narrowest = json.at("proof").at("narrowest");
  }
  if (json.contains("least_time")) motion.least_time = number_of(json.at("least_time"));
  if (json.contains("overload")) {
    const ordered_json& overload = json.at("overload");
    motion.overload =
        Overload{overload.at("joint"), overload.at("s"), overload.at("force"), overload.at("sure")};
  }
  motion.limit_distance = extreme_of(json.at("limit_distance"));
  motion.regularity = extreme_of(json.at("regularity"));
  motion.speed = extreme_of(json.at("speed"));
  motion.acceleration = extreme_of(json.at("acceleration"));
  for (const auto& place : json.at("curve")) {
    motion.curve.emplace_back(place.at(0), place.at(1).get<std::vector<double>>());
    if (motion.least_time) motion.curve_times.push_back(place.at(2));
  }
  return motion;
}

std::string joints_of(unsigned free, const Task& task) {
  std::string names;
  const std::vector<std::string> turning = task.turning();
  for (std::size_t i = 0; i < turning.size(); ++i)
    if ((free >> i & 1U) != 0) names += (names.empty() ? "" : ", ") + turning[i];
  return names;
}

/// The motion on a track that has an end there, counted from 1; 0 without.
std::size_t motion_on(const Result& result, int track, double s) {
  for (std::size_t i = 0; i < result.motions.size(); ++i) {
    const Motion& motion = result.motions[i];
    if (motion.track == track && (motion.begin.s == s || motion.end.s == s)) return i + 1;
  }
  return 0;
}

/// A flip of the last three joints alone is the wrist's.
bool is_wrist(unsigned free) { return (free & 7U) == 0; }

}  // namespace

Result result_of(const ordered_json& json) {
  Result result;
  result.samples = json.at("samples");
  result.seconds = json.at("seconds");
  result.full = json.at("full");
  result.doubtful = json.at("doubtful");
  for (const auto& motion : json.at("motions")) result.motions.push_back(motion_of(motion));
  for (const auto& change : json.at("chain"))
    result.chain.push_back({change.at("motion"), change.at("s"), number_of(change.at("way"))});
  result.gaps = stretches_of(json.at("gaps"));
  if (json.contains("complete")) {
    const ordered_json& complete = json.at("complete");
    result.complete =
        CompleteProof{stretches_of(complete.at("gaps")), complete.at("found"), complete.at("seconds")};
  }
  return result;
}

std::string words_of(const MotionEnd& end, bool is_begin, const Task& task, const Result& result) {
  if (end.cause == "path_end") return is_begin ? "start" : "end";
  if (end.cause == "limit")
    return fmt::format("{} at its {} limit", task.limited().at(static_cast<std::size_t>(end.partner)).name,
                       end.upper ? "upper" : "lower");
  if (end.cause == "boundary") return "boundary of reach";
  if (end.cause == "flip")
    return fmt::format("{} ({} free)", is_wrist(end.free) ? "wrist flip" : "singular",
                       joints_of(end.free, task));
  if (end.cause == "unclear") return "unclear";
  const std::size_t other = motion_on(result, end.partner, end.s);
  return other > 0 ? fmt::format("meets motion {}", other) : "meets a branch beyond limits";
}

}  // namespace qvgen::path
