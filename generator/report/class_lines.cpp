// SPDX-License-Identifier: MIT
#include "report/class_lines.h"

#include <algorithm>

#include "canonical/structure.h"
#include "compare/thesis_times.h"
#include "compare/thesis_workspaces.h"

namespace qvgen::report {
namespace {

using namespace canonical;

template <class Row>
const Row* row_of(const std::vector<Row>& table, const std::string& robot) {
  const auto place =
      std::find_if(table.begin(), table.end(), [&](const Row& row) { return row.robot == robot; });
  return place == table.end() ? nullptr : &*place;
}

void append_printed(const std::string& robot, const Structure& structure, std::vector<std::string>& lines) {
  const std::string workspace = to_string(workspace_of(structure));
  const auto compare = [&](const std::string& where, const std::string& printed, const std::string& derived) {
    if (printed != derived)
      lines.push_back(where + " of the thesis: " + (printed.empty() ? "a dash" : printed) + ", not " +
                      derived);
  };
  if (const auto* row = row_of(compare::thesis_workspaces(), robot)) {
    compare("table 3.17", row->types, types_of(structure));
    compare("table 3.17, by the joints,", row->by_joints, workspace);
    compare("table 3.17, by the transformation,", row->by_transformation, workspace);
  }
  if (const auto* row = row_of(compare::thesis_times(), robot))
    compare("table 3.18", row->workspace, workspace);
}

}  // namespace

std::vector<std::string> class_lines(const model::Robot& robot) {
  const auto structure = structure_of(robot);
  if (!structure) return {};
  const auto code = code_of(*structure);
  const bool useful = is_useful(*structure);
  const Structure kept = representative(*structure);
  std::vector<std::string> lines{
      "joints 1 to 3: " + types_of(*structure) + ", axes " + pattern_of(*structure),
      "code: " + code.value_or("none"),
      std::string("useful: ") +
          (useful ? "yes, they move a point in all three directions" : "no, not in all three directions")};
  if (useful && kept == *structure) lines.push_back("distinct: yes");
  if (useful && !(kept == *structure))
    lines.push_back("distinct: no, a slide and what is parallel to it exchanged it is " +
                    code_of(kept).value_or("without a code") + " (" + types_of(kept) + ")");
  lines.push_back("workspace: " + to_string(workspace_of(*structure)));
  append_printed(robot.name, *structure, lines);
  return lines;
}

}  // namespace qvgen::report
