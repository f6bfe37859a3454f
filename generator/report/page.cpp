// SPDX-License-Identifier: MIT
#include "report/page.h"

#include "emit/render.h"

namespace qvgen::report {

using nlohmann::json;

std::string html(const Page& page) {
  json values{{"title", escaped(page.title)}, {"up", page.has_way_up},     {"style", asset("style.css")},
              {"script", page.script},        {"subtitle", json::array()}, {"sections", json::array()}};
  for (const std::string& line : page.subtitle) values["subtitle"].push_back({{"line", escaped(line)}});
  for (const Section& section : page.sections)
    values["sections"].push_back(
        {{"id", section.id}, {"name", escaped(section.title)}, {"body", section.html}});
  values["has_contents"] = page.sections.size() > 1;
  return emit::render("report/page.html", values);
}

}  // namespace qvgen::report
