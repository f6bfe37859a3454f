// SPDX-License-Identifier: MIT
#include "cli/path_report.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/table.h"

namespace qvgen::cli {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr std::size_t most_rows = 100;

/// A path coordinate, to the digits that are right.
std::string place(double s) { return fmt::format("{:.12g}", s); }

std::string joint_name(const path::Task& task, int joint) {
  return joint < 0 ? "" : task.limited().at(static_cast<std::size_t>(joint)).name;
}

/// A joint's value with its unit, degrees or millimetres.
std::string value_of(const path::Task& task, int joint, double value) {
  return task.limited().at(static_cast<std::size_t>(joint)).revolute
             ? fmt::format("{:.2f} deg", value * degrees)
             : fmt::format("{:.2f} mm", value * 1e3);
}

std::string extreme_of(const path::Task& task, const path::Extreme& extreme, const char* per = "") {
  if (!extreme.value) return "-";
  return fmt::format("{}{} {} at {:.6g}", value_of(task, extreme.joint, *extreme.value), per,
                     joint_name(task, extreme.joint), extreme.s);
}

std::string branches_of(const path::Motion& motion) {
  return motion.branches.empty() ? "-" : fmt::format("{}", fmt::join(motion.branches, " > "));
}

/// The least time, or the joint for which there is none: "none: theta2 bears 83.1 of 60 N m at 624".
std::string least_time_of(const path::Task& task, const path::Motion& motion) {
  if (!motion.overload) return motion.least_time ? fmt::format("{:.6g} s", *motion.least_time) : "none";
  const path::Overload& overload = *motion.overload;
  const path::MovingJoint& joint = task.bearing.at(overload.joint);
  const std::string load =
      fmt::format("{:.4g} of {:.4g} {}", overload.force, joint.force, joint.revolute ? "N m" : "N");
  return fmt::format("none: {} bears {} at rest {} {:.6g}", joint.name, load,
                     overload.is_sure ? "at" : "or more near", overload.s);
}

Table table_of(const path::Result& result, const path::Task& task, bool timed) {
  Table table;
  table.names = 11;
  table.rows.push_back(
      {"motion", "from", "to", "branch", "turns", "begins", "ends", "nearest limit", "regularity"});
  if (timed) table.rows.front().insert(table.rows.front().end(), {"largest speed", "acceleration"});
  if (task.least_times) table.rows.front().push_back("least time");
  for (std::size_t i = 0; i < std::min(result.motions.size(), most_rows); ++i) {
    const path::Motion& motion = result.motions[i];
    TableRow row{std::to_string(i + 1),
                 place(motion.begin.s),
                 place(motion.end.s),
                 branches_of(motion),
                 fmt::format("{:g}", motion.representatives),
                 path::words_of(motion.begin, true, task, result),
                 path::words_of(motion.end, false, task, result),
                 extreme_of(task, motion.limit_distance),
                 fmt::format("{:.3g} at {:.6g}", motion.regularity.value.value_or(0), motion.regularity.s)};
    if (timed) {
      row.push_back(extreme_of(task, motion.speed, "/s"));
      row.push_back(extreme_of(task, motion.acceleration, "/s^2"));
    }
    if (task.least_times) row.push_back(least_time_of(task, motion));
    table.rows.push_back(row);
  }
  return table;
}

std::string joints_of(const path::Task& task, const std::vector<double>& q) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < q.size(); ++i)
    words.push_back(fmt::format("{:.4f}", task.joints[i].revolute ? q[i] * degrees : q[i] * 1e3));
  return fmt::format("{}", fmt::join(words, " "));
}

std::string whole_text(const path::Result& result, const path::Task& task) {
  std::string text;
  for (std::size_t i = 0; i < result.motions.size(); ++i)
    if (result.is_whole(result.motions[i]))
      text += fmt::format("  motion {}: {}\n", i + 1, joints_of(task, result.motions[i].begin.q));
  return text.empty() ? "" : "joints that follow the whole path from its start (deg, mm):\n" + text;
}

/// The motion along the whole path that takes the least time.
std::string fastest_text(const path::Result& result) {
  std::size_t best = result.motions.size();
  for (std::size_t i = 0; i < result.motions.size(); ++i) {
    const path::Motion& motion = result.motions[i];
    if (!result.is_whole(motion) || !motion.least_time) continue;
    if (best == result.motions.size() || *motion.least_time < *result.motions[best].least_time) best = i;
  }
  if (best == result.motions.size()) return "";
  return fmt::format("the fastest along the whole path is motion {}: {:.6g} s\n", best + 1,
                     *result.motions[best].least_time);
}

/// The fewest motions, and where to change from one to the next.
std::string chain_text(const path::Result& result) {
  if (result.chain.empty()) return "";
  std::string text = fmt::format("no motion follows the whole path; {} follow it one after the other:\n",
                                 result.chain.size());
  for (const path::Change& change : result.chain) {
    text += fmt::format("  motion {} from {}", change.motion + 1, place(change.s));
    if (change.way && *change.way > 0)
      text += fmt::format(", to which the farthest joint goes {:.4g} rad or m", *change.way);
    text += "\n";
  }
  return text;
}

std::string stretches_text(const std::vector<std::pair<double, double>>& stretches) {
  constexpr std::size_t most = 12;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(stretches.size(), most); ++i)
    words.push_back(fmt::format("{} to {}", place(stretches[i].first), place(stretches[i].second)));
  const std::string rest =
      stretches.size() > most ? fmt::format(" and {} more", stretches.size() - most) : std::string();
  return fmt::format("{}{}", fmt::join(words, ", "), rest);
}

std::string proof_of(const path::Motion& motion) {
  if (motion.proof->gaps.empty())
    return fmt::format("proven, alone within {:.2g} rad or m", motion.proof->narrowest);
  return "proven but from " + stretches_text(motion.proof->gaps);
}

/// Says whether it is proven that no other motion follows the path.
std::string complete_text(const path::Result& result) {
  if (!result.complete) return "";
  std::string text = "no other motion follows the path, whatever the limits: proven";
  if (!result.complete->gaps.empty()) text += " but from " + stretches_text(result.complete->gaps);
  text += fmt::format(" ({:.2g} s)\n", result.complete->seconds);
  if (result.complete->found > 0)
    text += fmt::format(
        "{} of the motions, but for limits, were met by the proof alone: each lies between two places\n",
        result.complete->found);
  return text;
}

std::string proofs_text(const path::Result& result) {
  std::string text;
  for (std::size_t i = 0; i < std::min(result.motions.size(), most_rows); ++i)
    if (result.motions[i].proof) text += fmt::format("  motion {}: {}\n", i + 1, proof_of(result.motions[i]));
  return text.empty() ? "" : "continuous, and the only motion in a tube around it:\n" + text;
}

std::string gaps_text(const path::Result& result) {
  std::string text;
  for (const auto& [from, to] : result.gaps)
    text += fmt::format("nothing follows the path from {} to {}\n", place(from), place(to));
  return text;
}

/// The values that a free coordinate takes.
std::string span_text(const path::FreeMotion& motion, const path::FreeColumn& column, std::size_t i) {
  const auto [low, high] =
      std::minmax_element(motion.places.begin(), motion.places.end(),
                          [&](const auto& a, const auto& b) { return a.values.at(i) < b.values.at(i); });
  const double unit = column.turns ? degrees : 1e3;
  return fmt::format("{} from {:.4g} to {:.4g} {}\n", column.name, low->values.at(i) * unit,
                     high->values.at(i) * unit, column.turns ? "deg" : "mm");
}

}  // namespace

std::string path_text(const path::Result& result, const path::Task& task, const path::Poses& poses,
                      const std::string& robot) {
  const auto whole = std::count_if(result.motions.begin(), result.motions.end(),
                                   [&](const path::Motion& motion) { return result.is_whole(motion); });
  std::string text = fmt::format("{}: {} poses, {:.4g} m; {} motions, {} of them all the way\n", robot,
                                 result.samples, poses.length(), result.motions.size(), whole);
  if (!result.motions.empty()) text += text_of(table_of(result, task, poses.timed), ReportFormat::table);
  if (result.motions.size() > most_rows)
    text += fmt::format("... and {} more: -o FILE.csv or .json has all\n", result.motions.size() - most_rows);
  text += whole > 0 ? whole_text(result, task) : chain_text(result);
  text += fastest_text(result) + proofs_text(result) + complete_text(result);
  text += gaps_text(result);
  if (result.full) text += "there were more motions than there is room for: some are missing\n";
  if (result.doubtful)
    text += "the inverse kinematics was not sure to have all solutions everywhere: a motion may be missing\n";
  return text;
}

std::string free_text(const path::FreeMotion& motion, const path::FreeTask& task, const path::Poses& poses,
                      const std::string& robot) {
  std::string text =
      fmt::format("{}: {} poses, {:.4g} m, free {}\n", robot, motion.samples, poses.length(), task.names());
  if (motion.places.empty()) return text + "nothing reaches the first pose\n";
  const std::vector<path::FreeColumn> columns = task.columns();
  for (std::size_t i = 0; i < columns.size(); ++i) text += span_text(motion, columns[i], i);
  path::Task joints;
  joints.joints = task.joints;
  text += fmt::format("joints at the start (deg, mm): {}\n", joints_of(joints, motion.places.front().q));
  const double end = static_cast<double>(motion.samples) - 1;
  if (motion.followed >= end) return text + "the motion follows the whole path\n";
  return text +
         fmt::format("no motion was found that goes farther than {} of {}\n", place(motion.followed), end);
}

}  // namespace qvgen::cli
