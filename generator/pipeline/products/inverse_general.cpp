// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_general.h"

#include <qvgen/inverse/general/solve.h>

#include "emit/cpp/inverse/setup_code.h"
#include "emit/cpp/template_values.h"
#include "emit/render.h"
#include "verify/inverse/certify_rows.h"

namespace qvgen::pipeline {
namespace {

using inverse::general::Setup;

std::vector<std::vector<double>> rows_of(const Setup& setup, const verify::PoseInDoubles& numbers) {
  Pose<double> pose;
  pose.orientation = Eigen::Quaterniond(numbers[0], numbers[1], numbers[2], numbers[3]);
  pose.position << numbers[4], numbers[5], numbers[6];
  inverse::general::Found found;
  inverse::general::solve(setup, pose, inverse::default_tolerance, inverse::zero_preference<6>,
                          inverse::Form::scalar, found);
  std::vector<std::vector<double>> rows;
  for (const auto& row : found) rows.emplace_back(row.q.data(), row.q.data() + row.q.size());
  return rows;
}

}  // namespace

void add_general_inverse(const model::Robot& described, const derive::inverse::GeneralDerivation& derivation,
                         RobotOutput& output) {
  constexpr int certificate_poses = 5;
  const Setup& setup = derivation.setup;
  const auto solver = [&](const verify::PoseInDoubles& pose, const std::vector<double>&) {
    return rows_of(setup, pose);
  };
  const verify::RowCertificate certificate =
      verify::certify_rows(described, {}, setup.chain.size, solver, certificate_poses);
  const nlohmann::json values{{"name", described.name},
                              {"mechanism", emit::lines_of(describe_general(described, derivation))},
                              {"certificate", certificate.text()},
                              {"setup", emit::lines_of(emit::setup_lines(setup))}};
  output.files.push_back(
      {"include/qvgen/robots/" + described.name + "/inverse.h", emit::render("inverse_general.h", values)});
  output.files.push_back(
      {"source/" + described.name + "/inverse.cpp", emit::render("inverse_general.cpp", values)});
  output.counts["targets"] = {{"inverse_kinematics", {"pose"}}, {"inverse_kinematics_near", {"pose"}}};
}

}  // namespace qvgen::pipeline
