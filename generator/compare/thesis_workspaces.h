// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace qvgen::compare {

/// A row of table 3.17 of the thesis as printed: the joints' types, and the workspace by the joints and by
/// the transformation matrix; empty where the table has a dash.
struct ThesisWorkspace {
  std::string robot;
  std::string types;
  std::string by_joints;
  std::string by_transformation;
};
const std::vector<ThesisWorkspace>& thesis_workspaces();

}  // namespace qvgen::compare
