// SPDX-License-Identifier: MIT
#include "path/page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "emit/render.h"
#include "model/followers.h"
#include "path/picture.h"
#include "report/chain.h"
#include "report/live_section.h"
#include "report/page.h"
#include "report/pieces.h"

namespace qvgen::path {
namespace {

using nlohmann::json;

/// Parts of a picture besides the joints that move.
struct Extras {
  std::optional<HeldJoint> held;
  struct Rail {
    std::size_t place;  ///< among a motion's values
    std::size_t axis;   ///< along which the base goes: 0 to 2
  };
  std::vector<Rail> rails;
};

/// A number to a millionth, so that pages stay small.
json rounded(double value) { return std::isfinite(value) ? json(std::round(value * 1e6) / 1e6) : json(); }

json numbers(const std::vector<double>& values) {
  json all = json::array();
  for (const double value : values) all.push_back(rounded(value));
  return all;
}

/// The joints that are drawn, by the joints or motors that a motion has values of.
struct Drawn {
  std::size_t driven;                             ///< how many values there are, with the one that is held
  std::vector<std::vector<model::Share>> joints;  ///< shares of these in each joint
};
Drawn drawn_of(const model::Robot& robot, const report::Chain& chain) {
  Drawn drawn{model::driven_count(robot), {}};
  const std::vector<std::vector<model::Share>> all = model::shares(robot);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!chain.joints[i].follows) drawn.joints.push_back(all[i]);
  return drawn;
}

json joints_of(std::vector<double> q, const Drawn& drawn, const std::optional<std::size_t>& held,
               double value) {
  if (held) q.insert(q.begin() + static_cast<std::ptrdiff_t>(*held), value);
  q.resize(drawn.driven);
  std::vector<double> joints(drawn.joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (const model::Share& share : drawn.joints[i])
      joints[i] += cln::double_approx(share.ratio) * q[share.driven];
  return numbers(joints);
}

/// "motion 2: from 0 to 41, boundary of reach"; ends of the path are not named.
std::string name_of(const Result& result, const Task& task, std::size_t i) {
  const Motion& motion = result.motions[i];
  std::string name = fmt::format("motion {}: from {:.6g} to {:.6g}", i + 1, motion.begin.s, motion.end.s);
  if (motion.end.cause != "path_end") name += ", " + words_of(motion.end, false, task, result);
  if (motion.least_time) name += fmt::format(", {:.4g} s", *motion.least_time);
  return name;
}

std::optional<std::size_t> index_of(const std::optional<HeldJoint>& held,
                                    const std::vector<std::string>& names) {
  if (!held) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), held->name);
  return std::min<std::size_t>(static_cast<std::size_t>(found - names.begin()), names.size() - 1);
}

/// The way of the arm's base from where it stands, m.
json way_of_base(const std::vector<double>& values, const std::vector<Extras::Rail>& rails) {
  std::vector<double> way(3, 0.0);
  for (const Extras::Rail& rail : rails) way[rail.axis] = values[rail.place];
  return numbers(way);
}

std::vector<Extras::Rail> rails_of(const FreeTask& task) {
  std::vector<Extras::Rail> rails;
  std::size_t place = task.joints.size();
  for (const FreeColumn& column : task.columns()) {
    if (column.name.rfind("rail_", 0) == 0)
      rails.push_back({place, static_cast<std::size_t>(column.name.back() - 'x')});
    if (task.joint(column.name) == nullptr) ++place;
  }
  return rails;
}

json motion_data(const Result& result, const Task& task, std::size_t i, const Extras& extras,
                 const Drawn& drawn, const std::optional<std::size_t>& held) {
  const Motion& motion = result.motions[i];
  json data{{"name", name_of(result, task, i)}, {"s", json::array()}, {"q", json::array()}};
  for (const auto& [s, q] : motion.curve) {
    data["s"].push_back(rounded(s));
    data["q"].push_back(joints_of(q, drawn, held, extras.held ? extras.held->value : 0));
    if (!extras.rails.empty()) data["way"].push_back(way_of_base(q, extras.rails));
  }
  if (!motion.curve_times.empty()) data["t"] = numbers(motion.curve_times);
  return data;
}

json data_of(const model::Robot& robot, const Result& result, const Task& task, const Extras& extras) {
  const report::Chain chain = report::chain_of(robot);
  json data{{"arm", report::chain_data(chain)},
            {"end", std::max(1.0, result.end())},
            {"map", {{"left", map_left}, {"width", map_width}, {"top", map_top}}},
            {"motions", json::array()}};
  const auto held = index_of(extras.held, model::variables(robot));
  const Drawn drawn = drawn_of(robot, chain);
  for (std::size_t i = 0; i < std::min(result.motions.size(), most_on_page); ++i)
    data["motions"].push_back(motion_data(result, task, i, extras, drawn, held));
  return data;
}

report::Section arm_section(const model::Robot& robot, const json& data) {
  if (data.at("motions").empty())
    return {"arm", "The arm", report::paragraph("No motion follows any part of the path.")};
  return {"arm", "The arm",
          emit::render("report/path.html", {{"name", report::escaped(robot.name)},
                                            {"end", data.at("end").dump()},
                                            {"data", data.dump()}})};
}

report::Section map_section(const std::string& svg, std::size_t shown, std::size_t all) {
  std::string words =
      "Each joint along the path, a colour for each motion. Limits are shaded; circles are meetings of "
      "branches, crosses wrist flips, bars limits.";
  if (shown < all) words += fmt::format(" The first {} of {} motions are shown.", shown, all);
  return {"map", "The map", "<div id=\"path-map\">" + report::figure(svg, words) + "</div>\n"};
}

std::string page_of(const model::Robot& robot, Result result, const Task& task, const Extras& extras,
                    const std::string& title) {
  const std::size_t all = result.motions.size();
  const json data = data_of(robot, result, task, extras);
  result.motions.resize(std::min(all, most_on_page));
  report::Page page{title, {}, false, {}, report::drawing_script() + report::asset("live_path.js")};
  const auto whole = std::count_if(result.motions.begin(), result.motions.end(),
                                   [&](const Motion& motion) { return result.is_whole(motion); });
  page.subtitle = {fmt::format("{} poses; {} motions, {} of them all the way", result.samples, all, whole)};
  page.sections = {arm_section(robot, data),
                   map_section(picture_of(result, task, title), result.motions.size(), all)};
  return html(page);
}

}  // namespace

std::string page_of(const model::Robot& robot, const Result& result, const Task& task,
                    const std::string& title) {
  return page_of(robot, result, task, {task.held, {}}, title);
}

std::string page_of(const model::Robot& robot, const FreeMotion& motion, const FreeTask& task,
                    const std::string& title) {
  const Shown shown = shown_of(motion, task);
  return page_of(robot, shown.result, shown.panels, {std::nullopt, rails_of(task)}, title);
}

}  // namespace qvgen::path
