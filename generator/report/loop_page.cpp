// SPDX-License-Identifier: MIT
#include "report/loop_page.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "emit/render.h"
#include "pipeline/loop_lines.h"
#include "pipeline/mechanism_files.h"
#include "report/drawing.h"
#include "report/live_section.h"
#include "report/page.h"
#include "report/pages.h"
#include "report/pieces.h"
#include "report/webassembly.h"
#include "verify/loops/mobility.h"

namespace qvgen::report {
namespace {

using nlohmann::json;

/// Joint values at which the loops close, angles in (-pi, pi]; nothing if none are found from these random
/// ones.
std::optional<std::vector<double>> closed_at(const verify::LoopNumbers& loops, const Chain& chain,
                                             unsigned seed) {
  const auto found = loops.assembled(seed);
  if (!found) return std::nullopt;
  std::vector<double> q(found->data(), found->data() + found->size());
  for (std::size_t i = 0; i < q.size(); ++i)
    if (chain.joints[i].revolute) q[i] = std::remainder(q[i], 2 * std::numbers::pi);
  return q;
}

/// How far joints are out of their ranges, as shares of these, all together.
double beyond_ranges(const Chain& chain, const std::vector<double>& q) {
  double beyond = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto [lower, upper] = range_of(chain, i);
    beyond += std::max({0.0, lower - q[i], q[i] - upper}) / std::max(upper - lower, 1e-9);
  }
  return beyond;
}

/// The closed joint values that are within ranges, or nearest to that, and among these the widest picture;
/// those of an open picture if none are found.
std::vector<double> start_of(const model::Mechanism& mechanism, const Linkage& linkage) {
  constexpr unsigned trials = 40;
  const verify::LoopNumbers loops(mechanism);
  std::vector<double> best = bent_pose(linkage.chain);
  std::pair<double, double> least{std::numeric_limits<double>::infinity(), 0};
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const auto q = closed_at(loops, linkage.chain, seed);
    if (!q) continue;
    const std::pair score{beyond_ranges(linkage.chain, *q), -extent_of(placed(linkage, *q))};
    if (!(score < least)) continue;
    least = score;
    best = *q;
  }
  return best;
}

/// Functions of the mechanism's C that the page's script calls, as far as the header has them.
struct Calls {
  bool assembles = false;
  json tips = json::array();  ///< those with a pose and a Jacobian
};

Calls calls_of(const model::Mechanism& mechanism, const std::string& header) {
  const auto declares = [&](const std::string& function) {
    return header.find(mechanism.robot.name + "_" + function + "(") != std::string::npos;
  };
  Calls calls{declares("assemble"), json::array()};
  for (const model::Frame& tip : mechanism.tips)
    if (declares("jacobian_of_" + tip.name)) calls.tips.push_back({{"tip", tip.name}});
  return calls;
}

/// The C files of the mechanism and of all that it calls, by name.
std::map<std::string, std::string> files_of(const std::vector<pipeline::RobotOutput>& outputs) {
  std::map<std::string, std::string> files;
  for (const pipeline::RobotOutput& output : outputs)
    for (const pipeline::OutputFile& file : output.files)
      files[file.path.substr(file.path.rfind('/') + 1)] = file.content;
  return files;
}

std::string calls_text(const model::Mechanism& mechanism, const Calls& calls) {
  return emit::render("report/live_loop_calls.c", {{"name", mechanism.robot.name},
                                                   {"dof", mechanism.robot.joints.size()},
                                                   {"driven", mechanism.loops.actuated.size()},
                                                   {"geometry_size", mechanism.robot.geometry.size() + 1},
                                                   {"assembles", calls.assembles},
                                                   {"tips", calls.tips}});
}

std::string reason_of(const pipeline::RobotOutput& output) {
  for (const pipeline::Missing& missing : output.missing)
    if (missing.part == "assembly") return missing.reason;
  return "the mechanism has no C functions";
}

/// The linkage to be moved by its functions of C; or what it takes to have that.
Section loop_live_section(const model::Mechanism& mechanism, const Linkage& linkage,
                          const std::vector<double>& start) {
  if (const std::string missing = missing_compiler(); !missing.empty()) return still_section(missing);
  const std::vector<pipeline::RobotOutput> outputs =
      pipeline::mechanism_in_c(mechanism, {"kinematics", "jacobian", "inverse"}, {});
  std::map<std::string, std::string> files = files_of(outputs);
  const auto header = files.find("qvgen_" + mechanism.robot.name + "_loops.h");
  if (header == files.end()) return still_section(reason_of(outputs.front()));
  const Calls calls = calls_of(mechanism, header->second);
  files["calls.c"] = calls_text(mechanism, calls);
  const Compiled compiled = to_webassembly(files);
  if (!compiled.done) return still_section(compiled.reason);
  json data = linkage_data(linkage, start);
  data["module"] = base64(compiled.bytes);
  return {"interactive", "Interactive view",
          emit::render("report/loops.html", {{"data", data.dump()},
                                             {"name", escaped(mechanism.robot.name)},
                                             {"assembles", calls.assembles}})};
}

std::string derivation_html(const pipeline::LoopLines& loops) {
  std::string text;
  for (const std::string& line : loops.lines) text += escaped(line) + "\n";
  return "<pre>" + text + "</pre>\n" + (loops.problems.empty() ? "" : bullets(loops.problems));
}

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

/// The mechanism on a base that stands still.
model::Mechanism standing(model::Mechanism mechanism) {
  mechanism.robot.floating_base.reset();
  return mechanism;
}

}  // namespace

pipeline::RobotOutput loop_page(const model::Mechanism& described) {
  const model::Mechanism mechanism = standing(described);
  const model::Robot& robot = mechanism.robot;
  const Linkage linkage = linkage_of(mechanism);
  const std::vector<double> start = start_of(mechanism, linkage);
  const std::string words = counted(robot.joints.size(), "joint") + ", " +
                            counted(mechanism.loops.closures.size(), "loop") + ", " +
                            counted(mechanism.loops.actuated.size(), "motor") + ".";
  Page page{robot.name, {robot.title}, true, {}, loop_script()};
  page.sections.push_back({"robot", "The mechanism",
                           figure(drawing(linkage, start, {robot.name + "-loops", robot.name, words}),
                                  "Turns are cylinders, slides boxes, ends of closures dots; the tips have "
                                  "frames.")});
  page.sections.push_back(loop_live_section(mechanism, linkage, start));
  page.sections.push_back(
      {"assemblies", "Assemblies", derivation_html(pipeline::loop_lines(mechanism, true))});
  nlohmann::ordered_json entry{
      {"title", robot.title},
      {"joints", words},
      {"workspace", ""},
      {"thumbnail", thumbnail(linkage, start, {robot.name + "-small", robot.name, words})},
      {"compared", nlohmann::ordered_json::object()}};
  return {page_name(robot.name), {{robot.name + ".html", html(page)}}, entry, {}};
}

}  // namespace qvgen::report
