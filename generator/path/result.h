// SPDX-License-Identifier: MIT
// What following a path has found, as the tool's outputs need it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "path/arm_program.h"

namespace qvgen::path {

/// One end of a motion.
struct MotionEnd {
  double s = 0;
  std::string cause;  ///< path_end, meeting, boundary, flip, limit, unclear
  int partner = -1;   ///< meeting: the other track; limit: the joint
  bool upper = false;
  unsigned free = 0;  ///< flip: bits of joints that are free
  std::vector<double> q;
};

struct Extreme {
  std::optional<double> value;
  double s = 0;
  int joint = -1;
};

/// A tube around a motion, in which it is the only one.
struct Proof {
  std::vector<std::pair<double, double>> gaps;  ///< stretches that are not proven
  double narrowest = 0;                         ///< its least half width, rad or m
};

/// A joint that cannot bear its load at rest, or while it creeps against friction.
struct Overload {
  std::size_t joint = 0;  ///< among all joints
  double s = 0;
  double force = 0;     ///< at rest, N m or N
  bool is_sure = true;  ///< else it may be, nearby
};

struct Motion {
  int track = -1;
  double representatives = 1;
  MotionEnd begin, end;
  std::vector<int> branches;      ///< numbers along it; empty where branches have none
  std::vector<double> crossings;  ///< singular poses passed without a stop
  Extreme limit_distance, regularity, speed, acceleration;
  std::optional<Proof> proof;
  std::optional<double> least_time;                           ///< s
  std::optional<Overload> overload;                           ///< why there is no least time
  std::vector<std::pair<double, std::vector<double>>> curve;  ///< some places, for pictures
  std::vector<double> curve_times;                            ///< s, there; empty without least times
};

/// Stretches on which the proof cannot exclude another motion.
struct CompleteProof {
  std::vector<std::pair<double, double>> gaps;  ///< stretches that are not proven
  int found = 0;                                ///< motions, but for limits, that only the proof has met
  double seconds = 0;
};

struct Change {
  std::size_t motion = 0;
  double s = 0;
  std::optional<double> way;
};

struct Result {
  std::size_t samples = 0;
  double seconds = 0;
  bool full = false, doubtful = false;
  std::vector<Motion> motions;
  std::vector<Change> chain;  ///< the fewest motions that cover the path; empty if none do
  std::vector<std::pair<double, double>> gaps;
  std::optional<CompleteProof> complete;
  [[nodiscard]] double end() const { return static_cast<double>(samples) - 1; }
  [[nodiscard]] bool is_whole(const Motion& motion) const {
    return motion.begin.s <= 0 && motion.end.s >= end();
  }
};

Result result_of(const nlohmann::ordered_json& json);

/// Returns in words why a motion begins or ends: "theta3 at its upper limit".
std::string words_of(const MotionEnd& end, bool is_begin, const Task& task, const Result& result);

/// Draws each joint against the path, as SVG: limits shaded, meetings and flips marked.
std::string picture_of(const Result& result, const Task& task, const std::string& title);

}  // namespace qvgen::path
