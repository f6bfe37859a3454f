// SPDX-License-Identifier: MIT
#include "report/whole_page.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "emit/render.h"
#include "report/drawing.h"
#include "report/live_section.h"
#include "report/page.h"
#include "report/pages.h"
#include "report/pieces.h"

namespace qvgen::report {
namespace {

std::string links_to(const std::vector<model::Robot>& limbs) {
  std::string items;
  for (const model::Robot& limb : limbs)
    items += fmt::format(
        "<li><a href=\"{0}.html\">{0}</a>: {1} joints; drawn, dragged, and with all its solutions</li>\n",
        escaped(limb.name), limb.joints.size());
  return "<ul>\n" + items + "</ul>\n";
}

std::string tree_html(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += escaped(line) + "\n";
  return "<pre>" + text + "</pre>\n";
}

std::size_t joint_count(const std::vector<model::Robot>& limbs) {
  std::set<std::string> variables;
  for (const model::Robot& limb : limbs)
    for (const model::Joint& joint : limb.joints) variables.insert(joint.variable);
  return variables.size();
}

using nlohmann::json;

/// The joints that have values of their own, by limb and place, each once; and where a limb has its own.
struct AllJoints {
  json list = json::array();
  std::map<std::string, std::size_t> places = {};

  json places_of(const model::Robot& limb, std::size_t index) {
    json result = json::array();
    for (const model::Joint& joint : limb.joints) {
      if (!joint.follows.empty()) continue;
      const auto [place, is_new] = places.emplace(joint.variable, places.size());
      if (is_new) list.push_back({index, result.size()});
      result.push_back(place->second);
    }
    return result;
  }
};

/// The robot to be dragged, by its limbs' functions of C; or what it takes to have that.
Section whole_live_section(const WholeRobot& robot) {
  constexpr std::size_t joints_of_a_pose = 6;
  AllJoints joints;
  json limbs = json::array();
  for (std::size_t i = 0; i < robot.limbs.size(); ++i) {
    const model::Robot& limb = robot.limbs[i];
    const LiveArm arm = live_arm(limb, nullptr);
    if (!arm.lacking.empty()) return still_section(limb.name + ": " + arm.lacking);
    const json places = joints.places_of(limb, i);
    limbs.push_back({{"arm", arm.data},
                     {"tip", limb.name.substr(std::min(limb.name.size(), robot.name.size() + 1))},
                     {"by_position", places.size() < joints_of_a_pose},
                     {"places", places}});
  }
  const json data{{"limbs", limbs}, {"joints", joints.list}, {"floating", robot.floats}};
  return {"interactive", "Interactive view",
          emit::render("report/whole.html",
                       {{"data", data.dump()}, {"name", escaped(robot.name)}, {"floating", robot.floats}})};
}

}  // namespace

pipeline::RobotOutput whole_page(const WholeRobot& robot) {
  std::vector<Chain> chains;
  for (const model::Robot& limb : robot.limbs) chains.push_back(chain_of(limb));
  const std::string words = fmt::format("{} joints, {} limbs.", joint_count(robot.limbs), robot.limbs.size());
  const std::string svg = drawing(chains, {robot.name + "-whole", robot.name, words});
  Page page{robot.name, {robot.title}, true, {}, whole_script()};
  page.sections.push_back(
      {"robot", "The robot",
       figure(svg, "Turns are cylinders, slides boxes; the tips have frames.") + tree_html(robot.tree)});
  page.sections.push_back(whole_live_section(robot));
  page.sections.push_back({"limbs", "Limbs", links_to(robot.limbs)});
  nlohmann::ordered_json entry{{"title", robot.title},
                               {"joints", words},
                               {"workspace", ""},
                               {"thumbnail", thumbnail(chains, {robot.name + "-small", robot.name, words})},
                               {"compared", nlohmann::ordered_json::object()}};
  return {page_name(robot.name), {{robot.name + ".html", html(page)}}, entry, {}};
}

}  // namespace qvgen::report
