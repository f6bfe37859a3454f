// SPDX-License-Identifier: MIT
#include "pipeline/products/batch.h"

#include <algorithm>

#include "emit/cpp/batch_forms.h"
#include "emit/cpp/scalars.h"
#include "emit/render.h"
#include "pipeline/products/inverse_batch.h"
#include "pipeline/products/jacobian.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

constexpr const char* part = "batch";

/// Returns the values of the inverse velocity, which every robot with Jacobians has: a list of one or none.
json rates_values(const model::Robot& robot, const std::vector<emit::BatchForm>& forms) {
  const bool has_jacobian =
      std::any_of(forms.begin(), forms.end(), [](const auto& form) { return form.name == "jacobian"; });
  if (!has_jacobian) return json::array();
  return json::array({{{"has_wrist", has_wrist_centre(robot)}, {"scalars", emit::scalars()}}});
}

/// The longest functions, by far, have a file of their own: compilers are told otherwise how to order them.
bool is_long(const emit::BatchForm& form) {
  return form.header == "dynamics_derivatives" || form.header == "regressor" ||
         form.header == "regressor_with_drives";
}

/// The forms of one file, and in batch.cpp the inverse velocity.
void add_source(const model::Robot& robot, const std::vector<emit::BatchForm>& all, bool are_long,
                RobotOutput& output) {
  std::vector<emit::BatchForm> forms;
  for (const emit::BatchForm& form : all)
    if (is_long(form) == are_long) forms.push_back(form);
  if (forms.empty()) return;
  json values = emit::batch_values(robot.name, forms);
  values["holder"] = are_long ? "BatchDerivatives" : "BatchForms";
  values["rates"] = rates_values(robot, forms);
  output.files.push_back({"source/" + robot.name + (are_long ? "/batch_derivatives.cpp" : "/batch.cpp"),
                          emit::render("cpp/batch.cpp", values)});
}

}  // namespace

void add_batch(const model::Robot& robot, RobotOutput& output) {
  std::vector<emit::BatchForm> forms;
  for (const std::string& name : functions_in(output.counts))
    if (const auto form = emit::batch_form(name, robot.floating_base.has_value())) forms.push_back(*form);
  const bool has_inverse = !output.counts.value("targets", nlohmann::ordered_json::object()).empty();
  if (forms.empty() && !has_inverse) {
    output.missing.push_back({part, Missing::Kind::not_derived,
                              "name the parts whose batch forms are wanted too: --only "
                              "kinematics,inverse,jacobian,dynamics,batch"});
    return;
  }
  json values = emit::batch_values(robot.name, forms);
  values["rates"] = rates_values(robot, forms);
  values["inverse"] = has_inverse ? inverse_batch_values(robot) : json(false);
  output.files.push_back(
      {"include/qvgen/robots/" + robot.name + "/batch.h", emit::render("cpp/batch.h", values)});
  const std::string sources = "source/" + robot.name + "/";
  add_source(robot, forms, false, output);
  add_source(robot, forms, true, output);
  if (has_inverse)
    output.files.push_back(
        {sources + "inverse_batch.cpp", emit::render("cpp/inverse_batch.cpp", values["inverse"])});
}

}  // namespace qvgen::pipeline
