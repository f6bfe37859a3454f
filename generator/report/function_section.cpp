// SPDX-License-Identifier: MIT
#include "report/function_section.h"

#include "emit/render.h"
#include "pipeline/files.h"
#include "pipeline/output_folder.h"
#include "report/declarations.h"

namespace qvgen::report {
namespace {

using nlohmann::json;

bool is_header(const std::string& path) {
  return path.ends_with(".h") && !path.ends_with("_definitions.h") && path.rfind("include/", 0) == 0;
}

json functions_json(const std::string& header) {
  json list = json::array();
  for (const Declaration& declaration : declarations_in(header)) {
    json comment = json::array();
    for (const std::string& paragraph : declaration.comment)
      comment.push_back({{"line", escaped(paragraph)}});
    list.push_back({{"name", escaped(declaration.name)},
                    {"signature", escaped(declaration.signature)},
                    {"comment", comment}});
  }
  return list;
}

json headers_json(const std::string& robot, const std::filesystem::path& generated) {
  json list = json::array();
  for (const std::string& path : pipeline::files_of_robots(generated, {robot})) {
    const auto text = is_header(path) ? pipeline::content_of(generated / path) : std::nullopt;
    if (!text) continue;
    json functions = functions_json(*text);
    if (!functions.empty())
      list.push_back(
          {{"header", escaped(path.substr(std::string("include/").size()))}, {"functions", functions}});
  }
  return list;
}

}  // namespace

Section function_section(const std::string& robot, const std::filesystem::path& generated,
                         const nlohmann::ordered_json& entry) {
  json values{{"headers", headers_json(robot, generated)}, {"missing", json::array()}};
  if (entry.is_object() && entry.contains("missing"))
    for (const pipeline::Missing& missing : pipeline::missing_from_json(entry.at("missing")))
      values["missing"].push_back({{"part", escaped(missing.part)}, {"reason", escaped(missing.reason)}});
  values["has_missing"] = !values["missing"].empty();
  const bool nothing = values["headers"].empty() && values["missing"].empty();
  return {"functions", "Generated functions",
          nothing ? "<p>Generated code of this robot was not found.</p>\n"
                  : emit::render("report/functions.html", values)};
}

}  // namespace qvgen::report
