// SPDX-License-Identifier: MIT
#include "verify/counts_json.h"

namespace qvgen::verify {

using nlohmann::ordered_json;

ordered_json to_json(const dag::OperationCounts& c) {
  return {{"mul", c.multiplications}, {"add", c.additions},       {"div", c.divisions},
          {"sqrt", c.roots},          {"sincos", c.sine_cosines}, {"atan2", c.arctangents}};
}

dag::OperationCounts counts_from_json(const ordered_json& json) {
  return {json.at("mul"),  json.at("add"),    json.at("div"),
          json.at("sqrt"), json.at("sincos"), json.at("atan2")};
}

std::string describe(const dag::OperationCounts& counts) {
  std::string text;
  const auto append = [&](int number, const char* one, const char* many) {
    if (number == 0) return;
    text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + (number == 1 ? one : many);
  };
  append(counts.multiplications, "multiplication", "multiplications");
  append(counts.additions, "addition", "additions");
  append(counts.divisions, "division", "divisions");
  append(counts.roots, "square root", "square roots");
  append(counts.sine_cosines, "sine/cosine pair", "sine/cosine pairs");
  append(counts.arctangents, "arctangent", "arctangents");
  return text.empty() ? "no operations" : text;
}

}  // namespace qvgen::verify
