// SPDX-License-Identifier: MIT
#include "compare/comparison_json.h"

#include <algorithm>

#include "verify/counts_json.h"

namespace qvgen::compare {

using nlohmann::ordered_json;

ordered_json to_json(const Row& row) {
  ordered_json json{{"robot", row.robot},
                    {"level", level_names()[static_cast<std::size_t>(row.level)]},
                    {"formulation", row.formulation},
                    {"result", row.result}};
  json["counts"] = verify::to_json(row.counts);
  json["constants"] = row.constants;
  json["values"] = row.alive;
  json["cost"] = row.cost;
  json["rank"] = row.rank;
  if (row.time)
    json["nanoseconds"] = {{"median", row.time->median},
                           {"lower_quartile", row.time->lower},
                           {"upper_quartile", row.time->upper},
                           {"ratio", row.time->ratio}};
  return json;
}

Row row_from_json(const ordered_json& json) {
  const auto& names = level_names();
  const auto level =
      std::find(names.begin(), names.end(), json.at("level").get<std::string>()) - names.begin();
  return {json.at("robot"),
          json.at("formulation"),
          json.at("result"),
          static_cast<Level>(level),
          verify::counts_from_json(json.at("counts")),
          json.at("constants"),
          json.at("values"),
          json.at("cost"),
          json.at("rank")};
}

}  // namespace qvgen::compare
