// SPDX-License-Identifier: MIT
#include "emit/kernels/inverse.h"

#include <sstream>

#include "emit/blocks/analysis.h"
#include "emit/blocks/reached.h"
#include "emit/kernels/device_text.h"
#include "emit/render.h"

namespace qvgen::emit::kernels {
namespace {

bool begins(const std::string& line, const std::string& with) { return line.rfind(with, 0) == 0; }

/// Lines of C with the marks of devices in place of `static`.
std::string marked(const std::string& c) {
  std::istringstream lines(c);
  std::string text;
  for (std::string line; std::getline(lines, line); text += line + "\n") {
    if (begins(line, "static const ") && line.find('(') == std::string::npos)
      line.replace(0, 6, "CONSTANT");
    else if (begins(line, "static "))
      line.replace(0, 6, "DEVICE");
    else if (begins(line, "  static const "))  // OpenCL has none within functions
      line.erase(2, 7);
  }
  return text;
}

/// True if the equations of the robot's C are those of whole poses with no joint given.
bool has_regular_rows(const blocks::Unit& unit, const std::string& source) {
  return blocks::solves_poses(unit) &&
         source.find("\nstatic bool all_regular_rows_of(const Pose* pose, ") != std::string::npos;
}

}  // namespace

std::string inverse_text(const blocks::Unit& unit, const std::string& header, const std::string& source) {
  if (!has_regular_rows(unit, source)) return "";
  const bool is_empty = blocks::has_no_constants(unit.structures.at(unit.robot + "_geometry"));
  const nlohmann::json values{{"name", unit.robot},
                              {"dof", unit.constant(unit.robot + "_dof")->value[0].text},
                              {"has_geometry", !is_empty}};
  const std::string all = device_text(unit.robot, header) + "\n" + device_text(unit.robot, source);
  return marked(blocks::reached_by(render("kernels/regular.c", values), all)) + "\n" +
         render("kernels/inverse", values);
}

}  // namespace qvgen::emit::kernels
