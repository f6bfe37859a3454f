// SPDX-License-Identifier: MIT
#include "pipeline/products/batch.h"

#include "emit/cpp/batch_forms.h"
#include "emit/render.h"
#include "pipeline/products/inverse_batch.h"

namespace qvgen::pipeline {
namespace {

constexpr const char* part = "batch";

}  // namespace

void add_batch(const model::Robot& robot, RobotOutput& output) {
  std::vector<emit::BatchForm> forms;
  for (const std::string& name : functions_in(output.counts))
    if (const auto form = emit::batch_form(name)) forms.push_back(*form);
  const bool has_inverse = !output.counts.value("targets", nlohmann::ordered_json::object()).empty();
  if (forms.empty() && !has_inverse) {
    output.missing.push_back({part, Missing::Kind::not_derived,
                              "name the parts whose batch forms are wanted too: --only "
                              "kinematics,inverse,jacobian,dynamics,batch"});
    return;
  }
  nlohmann::json values = emit::batch_values(robot.name, forms);
  values["inverse"] = has_inverse ? inverse_batch_values(robot) : nlohmann::json(false);
  output.files.push_back(
      {"include/qvgen/robots/" + robot.name + "/batch.h", emit::render("batch.h", values)});
  const std::string sources = "source/" + robot.name + "/";
  if (!forms.empty()) output.files.push_back({sources + "batch.cpp", emit::render("batch.cpp", values)});
  if (has_inverse)
    output.files.push_back(
        {sources + "inverse_batch.cpp", emit::render("inverse_batch.cpp", values["inverse"])});
}

}  // namespace qvgen::pipeline
