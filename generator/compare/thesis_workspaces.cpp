// SPDX-License-Identifier: MIT
#include "compare/thesis_workspaces.h"

namespace qvgen::compare {

const std::vector<ThesisWorkspace>& thesis_workspaces() {
  static const std::vector<ThesisWorkspace> table{
      {"ss", "PPP", "prismatic", "prismatic"},
      {"sc", "PPR", "", "cylindrical"},
      {"sn", "PPR", "spherical", "spherical"},
      {"cs", "RPP", "cylindrical", "cylindrical"},
      {"cc", "RPR", "cylindrical", "cylindrical"},
      {"cr", "RPR", "spherical", "spherical"},
      {"ns", "RRP", "spherical", "spherical"},
      {"nn", "RRR", "spherical", ""},
      {"nr", "RRR", "revolute", ""},
      {"rc", "RPR", "cylindrical", "spherical"},
      {"rn", "RRR", "spherical", "spherical"},
      {"rr", "RPR", "spherical", "spherical"},
      {"rs", "RRP", "cylindrical", "cylindrical"},
      {"sr", "PRR", "cylindrical", "cylindrical"},
      {"cn", "PRR", "spherical", "spherical"},
      {"nc", "RRP", "spherical", "spherical"},
  };
  return table;
}

}  // namespace qvgen::compare
