// SPDX-License-Identifier: MIT
#include "emit/cpp/template_values.h"

namespace qvgen::emit {

using nlohmann::json;

json lines_of(const std::vector<std::string>& lines) {
  json list = json::array();
  for (const std::string& line : lines) list.push_back({{"line", line}});
  return list;
}

json values_of(const std::vector<Code::Value>& values) {
  json list = json::array();
  for (const Code::Value& value : values)
    list.push_back(
        {{"name", value.name}, {"expression", value.expression}, {"last", &value == &values.back()}});
  return list;
}

}  // namespace qvgen::emit
