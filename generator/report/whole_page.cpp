// SPDX-License-Identifier: MIT
#include "report/whole_page.h"

#include <set>

#include <fmt/format.h>

#include "report/drawing.h"
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

}  // namespace

pipeline::RobotOutput whole_page(const WholeRobot& robot) {
  std::vector<Chain> chains;
  for (const model::Robot& limb : robot.limbs) chains.push_back(chain_of(limb));
  const std::string words = fmt::format("{} joints, {} limbs.", joint_count(robot.limbs), robot.limbs.size());
  const std::string svg = drawing(chains, {robot.name + "-whole", robot.name, words});
  Page page{robot.name, {robot.title}, true, {}, ""};
  page.sections.push_back(
      {"robot", "The robot",
       figure(svg, "Turns are cylinders, slides boxes; the tips have frames.") + tree_html(robot.tree)});
  page.sections.push_back({"limbs", "Limbs", links_to(robot.limbs)});
  nlohmann::ordered_json entry{{"title", robot.title},
                               {"joints", words},
                               {"workspace", ""},
                               {"thumbnail", thumbnail(chains, {robot.name + "-small", robot.name, words})},
                               {"compared", nlohmann::ordered_json::object()}};
  return {page_name(robot.name), {{robot.name + ".html", html(page)}}, entry, {}};
}

}  // namespace qvgen::report
