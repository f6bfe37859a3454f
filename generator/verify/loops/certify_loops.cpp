// SPDX-License-Identifier: MIT
#include "verify/loops/certify_loops.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "derive/inverse/names.h"
#include "derive/loops/constraints.h"
#include "exact/named_constant.h"
#include "matrices/decompositions.h"
#include "model/replace.h"
#include "verify/certificate.h"
#include "verify/inverse/execute.h"
#include "verify/loops/mobility.h"

namespace qvgen::verify {
namespace {

namespace names = derive::inverse::names;
using derive::loops::AssemblyPlan;
using derive::loops::Geared;

Values geometry_of(const AssemblyPlan& assembly) {
  Values values;
  for (const auto& [name, value] : model::sample_geometry(assembly.robot)) values[name] = Real(value);
  return values;
}

void put(const model::Joint& joint, const Real& q, Values& values) {
  values[joint.variable] = q;
  values[names::cosine(joint.variable)] = cos(q);
  values[names::sine(joint.variable)] = sin(q);
}

/// Puts the value of a joint that gears lead.
void put_geared(const AssemblyPlan& assembly, const Geared& geared, Values& values) {
  const dag::Function value =
      derive::inverse::lowered(derive::loops::program_of(geared, assembly.robot, assembly.cycles), {"value"});
  put(assembly.robot.joints[geared.joint], outputs(value, values).at("value"), values);
}

dag::Function gaps_of(const AssemblyPlan& assembly) {
  const symbolic::Program program = derive::loops::constraints_of(assembly).gap;
  std::vector<std::string> all;
  for (const auto& output : program.outputs()) all.push_back(output.name);
  return derive::inverse::lowered(program, all);
}

/// The greatest gap of the rows from one to another.
double widest(const dag::Function& gaps, const Values& values, std::size_t from, std::size_t to) {
  const Values found = outputs(gaps, values);
  double worst = 0;
  for (std::size_t i = from; i < to; ++i)
    worst = std::max(worst, std::abs(found.at("gap_" + std::to_string(i)).to_double()));
  return worst;
}

/// How far a row is from a sample. Joints that follow by polynomials of angles are not compared: a sample has
/// other whole turns of these.
double difference(const AssemblyPlan& assembly, const std::vector<Real>& row, const Eigen::VectorXd& q) {
  const model::Robot& robot = assembly.robot;
  const auto by_powers = [&](std::size_t joint) {
    return std::any_of(assembly.led.begin(), assembly.led.end(), [&](const Geared& each) {
      return each.joint == joint && !assembly.cycles[each.cycle].powers.empty();
    });
  };
  double worst = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (by_powers(i)) continue;
    const double gap = row[i].to_double() - q[static_cast<Eigen::Index>(i)];
    const bool turns = robot.joints[i].type == model::JointType::revolute;
    worst = std::max(worst, turns ? std::abs(std::sin(gap / 2)) : std::abs(gap));
  }
  return worst;
}

/// Derivatives of the equations that the plan solves, by the joints that it solves for.
Eigen::MatrixXd solved_part(const LoopNumbers& numbers, const AssemblyPlan& assembly,
                            const Eigen::VectorXd& q) {
  const Eigen::MatrixXd jacobian = numbers.jacobian(q);
  Eigen::MatrixXd by(jacobian.rows(), static_cast<Eigen::Index>(assembly.passive.size()));
  for (std::size_t i = 0; i < assembly.passive.size(); ++i)
    by.col(static_cast<Eigen::Index>(i)) = jacobian.col(static_cast<Eigen::Index>(assembly.passive[i]));
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < assembly.cycles.size(); ++i) {
    const auto rows = static_cast<Eigen::Index>(derive::loops::rows_of(assembly.cycles[i]));
    if (std::find(assembly.redundant.begin(), assembly.redundant.end(), i) != assembly.redundant.end())
      by.middleRows(row, rows).setZero();
    row += rows;
  }
  return by;
}

/// True if given joints hardly hold the others: next to a dead centre, to which Newton's steps are drawn
/// where a rod is out of reach, samples in double have half of their digits.
bool is_blurred(const LoopNumbers& numbers, const AssemblyPlan& assembly, const Eigen::VectorXd& q) {
  constexpr double share = 1e-5;
  const Eigen::MatrixXd by = solved_part(numbers, assembly, q);
  if (by.size() == 0) return false;
  const Eigen::VectorXd values = matrices::singular_values(by);
  return values.minCoeff() < share * values[0];
}

}  // namespace

std::string LoopCertificate::text() const {
  return "Checked in 60 digits at " + std::to_string(inputs) + " inputs: the " + std::to_string(assemblies) +
         " assemblies close all loops to 50 digits, the sampled ones among them.";
}

LoopCertificate certify_loops(const model::Mechanism& mechanism, const AssemblyPlan& assembly,
                              const derive::inverse::LoweredPlan& plan, int inputs) {
  /// Accuracy of samples in double, also where two assemblies are near each other.
  constexpr double sample_accuracy = 1e-6;
  LoopCertificate certificate;
  const LoopNumbers numbers(mechanism);
  const dag::Function gaps = gaps_of(assembly);
  const std::size_t rows = derive::loops::constraints_of(assembly).rows;
  // Chains come first; they are certified as inverse kinematics, and their samples are rounded.
  std::size_t first = 0;
  for (const derive::loops::LoopChain& chain : assembly.chains)
    first += std::min(derive::loops::rows_of(assembly.cycles[chain.cycle]), chain.held().size());
  for (int k = 0; certificate.inputs < inputs; ++k) {
    const auto q = numbers.assembled(static_cast<unsigned>(k + 1));
    if (!q)
      throw std::domain_error(
          "no joint values were found at which all loops close; correct lengths or points");
    const bool blurred = is_blurred(numbers, assembly, *q);
    if (k < 8 * inputs && blurred) continue;
    Values values = geometry_of(assembly);
    std::vector<std::size_t> sampled_joints = assembly.given;
    for (const derive::loops::LoopChain& chain : assembly.chains)
      for (const std::size_t joint : chain.held()) sampled_joints.push_back(joint);
    for (const std::size_t joint : sampled_joints)
      put(assembly.robot.joints[joint], Real((*q)[static_cast<Eigen::Index>(joint)]), values);
    const Values given = values;
    for (const Geared& geared : assembly.geared) put_geared(assembly, geared, values);
    for (const Geared& geared : assembly.led)  // without a step it has its value behind all
      if (!assembly.cycles[geared.cycle].powers.empty())
        put(assembly.robot.joints[geared.joint], Real(0), values);
    bool sampled = false;
    for (const Row& row : execute(plan, values)) {
      Values at = given;
      for (const std::size_t i : assembly.passive) put(assembly.robot.joints[i], row.q[i], at);
      for (const Geared& geared : assembly.geared) put_geared(assembly, geared, at);
      for (const Geared& geared : assembly.led) put_geared(assembly, geared, at);
      if (widest(gaps, at, first, rows) > fifty_digits)
        throw CertificateError("closed loops: an assembly does not close them");
      if (widest(gaps, at, rows, gaps.outputs.size()) > sample_accuracy) continue;  // of redundant loops
      ++certificate.assemblies;
      sampled = sampled || difference(assembly, row.q, *q) < sample_accuracy;
    }
    if (!sampled && blurred && k < 64 * inputs) continue;  // given joints leave it open, as a folded scissor
    if (!sampled) throw CertificateError("closed loops: the sampled assembly is not among those found");
    ++certificate.inputs;
  }
  return certificate;
}

}  // namespace qvgen::verify
