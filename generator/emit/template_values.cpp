// SPDX-License-Identifier: MIT
#include "emit/template_values.h"

#include <algorithm>

namespace qvgen::emit {

using nlohmann::json;

json lines_of(const std::vector<std::string>& lines) {
  json list = json::array();
  for (const std::string& line : lines) list.push_back({{"line", line}});
  return list;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

json values_of(const std::vector<Code::Value>& values) {
  json list = json::array();
  for (const Code::Value& value : values)
    list.push_back(
        {{"name", value.name}, {"expression", value.expression}, {"last", &value == &values.back()}});
  return list;
}

json values_of(const Code& code) {
  json values{{"temporaries", values_of(code.temporaries)}, {"outputs", values_of(code.outputs)}};
  values["declarations"] = values["temporaries"];
  values["declarations"].insert(values["declarations"].end(), values["outputs"].begin(),
                                values["outputs"].end());
  return values;
}

json values_of(const ast::Straight& code, const ast::Printer& language) {
  return values_of(code_of(code, language));
}

}  // namespace qvgen::emit
