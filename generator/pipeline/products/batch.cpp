// SPDX-License-Identifier: MIT
#include "pipeline/products/batch.h"

#include "emit/cpp/batch_forms.h"
#include "emit/render.h"

namespace qvgen::pipeline {
namespace {

constexpr const char* part = "batch";

}  // namespace

void add_batch(const model::Robot& robot, RobotOutput& output) {
  std::vector<emit::BatchForm> forms;
  for (const std::string& name : functions_in(output.counts))
    if (const auto form = emit::batch_form(name)) forms.push_back(*form);
  if (forms.empty()) {
    output.missing.push_back(
        {part, Missing::Kind::not_derived,
         "name the parts whose batch forms are wanted too: --only kinematics,jacobian,dynamics,batch"});
    return;
  }
  const nlohmann::json values = emit::batch_values(robot.name, forms);
  output.files.push_back(
      {"include/qvgen/robots/" + robot.name + "/batch.h", emit::render("batch.h", values)});
  output.files.push_back({"source/" + robot.name + "/batch.cpp", emit::render("batch.cpp", values)});
}

}  // namespace qvgen::pipeline
