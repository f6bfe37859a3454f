// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/html.h"

namespace qvgen::report {

struct Page {
  std::string title;
  std::vector<std::string> subtitle;
  bool has_way_up = true;  ///< a link to the index
  std::vector<Section> sections;
  std::string script;
};
std::string html(const Page& page);

}  // namespace qvgen::report
