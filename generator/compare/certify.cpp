// SPDX-License-Identifier: MIT
#include "compare/certify.h"

#include <cln/float.h>
#include <cln/real.h>

#include "dag/evaluate.h"
#include "dag/rebuild.h"
#include "derive/dynamics/formulation.h"
#include "derive/dynamics/plain_recursion.h"
#include "derive/jacobian/quantities.h"
#include "derive/kinematics/forward_kinematics.h"
#include "exact/constant_angle.h"
#include "exact/named_constant.h"
#include "exact/point.h"
#include "symbolic/evaluate.h"
#include "verify/certificate.h"

namespace qvgen::compare {
namespace {

constexpr std::uint64_t points = 2;

/// The outputs w x y z px py pz as r11 ... r33 px py pz (thesis 1.3).
dag::Function as_transform(dag::Function pose) {
  dag::Graph& graph = pose.graph;
  const auto part = [&](std::size_t i) { return pose.outputs.at(i).value; };
  const dag::Edge two = graph.constant(2);
  const auto times = [&](std::size_t i, std::size_t k) { return graph.product({two, part(i), part(k)}); };
  std::vector<dag::Output> outputs;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t third = 3 - i - k;
      dag::Edge entry;
      if (i == k) {
        const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
        entry = graph.sum({graph.constant(1), -times(j + 1, j + 1), -times(l + 1, l + 1)});
      } else {
        const dag::Edge spin = times(0, third + 1);
        entry = graph.sum({times(i + 1, k + 1), (i + 1) % 3 == k ? -spin : spin});
      }
      outputs.push_back({"r" + std::to_string(i + 1) + std::to_string(k + 1), entry});
    }
  for (std::size_t i = 4; i < 7; ++i) outputs.push_back(pose.outputs[i]);
  pose.outputs = outputs;
  return pose;
}

/// A random point in decimals.
struct DecimalPoint {
  exact::ExactPoint random;
  cln::float_format_t digits = cln::float_format(75);

  [[nodiscard]] cln::cl_R constant(const exact::Number& number) const {
    cln::cl_R sum = 0;
    for (const auto& [radicand, coefficient] : number.terms())
      sum = sum + coefficient * cln::sqrt(cln::cl_float(radicand, digits));
    return sum;
  }
  [[nodiscard]] cln::cl_R symbol(const std::string& name) const {
    const auto known = exact::named_value(name);
    return known ? cln::cl_R(*known) : constant(random.symbol(name));
  }
  [[nodiscard]] cln::cl_R radians(const dag::Angle& angle) const {
    cln::cl_R sum = angle.pi * cln::pi(digits);
    for (const auto& [name, coefficient] : angle.terms) {
      const auto constant = exact::radians(dag::Angle{{{name, 1}}, 0});
      sum = sum + coefficient * (constant ? cln::cl_R(*constant) : symbol(name));
    }
    return cln::cl_float(sum, digits);
  }
  [[nodiscard]] cln::cl_R sine(const dag::Angle& angle) const { return cln::sin(radians(angle)); }
  [[nodiscard]] cln::cl_R cosine(const dag::Angle& angle) const { return cln::cos(radians(angle)); }
  [[nodiscard]] cln::cl_R root(const cln::cl_R& value) const { return cln::sqrt(cln::abs(value)); }
  [[nodiscard]] cln::cl_R arctangent(const cln::cl_R& y, const cln::cl_R& x) const { return cln::atan(x, y); }
};

/// Angles of axes are known to 40 digits.
constexpr double tolerance = 1e-34;

}  // namespace

dag::Function with_entries(const dag::Function& function, const dag::Function& entries) {
  if (entries.outputs.empty()) return function;
  // The meanings stand in the function's own graph: each symbol becomes its meaning, which is free of such
  // symbols.
  std::map<std::string, dag::Edge> meanings;
  dag::Function result = function;
  for (const dag::Output& entry : entries.outputs) meanings.emplace(entry.name, entry.value);
  const std::uint32_t size = function.graph.size();
  std::vector<dag::Edge> becomes(size);
  for (std::uint32_t id = 0; id < size; ++id) {
    const dag::Node node = function.graph.node(id);
    const auto meaning =
        node.op == dag::Op::symbol ? meanings.find(function.graph.symbol_of(node)) : meanings.end();
    std::vector<dag::Edge> operands;
    for (const dag::Edge operand : node.operands)
      operands.push_back(operand.negative ? -becomes[operand.node] : becomes[operand.node]);
    becomes[id] = meaning != meanings.end() ? meaning->second
                                            : dag::copy_node(function.graph, node, operands, result.graph);
  }
  for (dag::Output& output : result.outputs)
    output.value = output.value.negative ? -becomes[output.value.node] : becomes[output.value.node];
  return result;
}

namespace {

Definition values_of(const symbolic::Program& program) {
  Definition definition;
  for (const auto& output : program.outputs()) definition.outputs.push_back(output.name);
  for (std::uint64_t k = 1; k <= points; ++k)
    definition.values.push_back(symbolic::evaluate(program, exact::ExactPoint(k)));
  return definition;
}

Definition plain_recursion(const model::Robot& robot) {
  Definition definition;
  for (std::size_t i = 1; i <= robot.joints.size(); ++i)
    definition.outputs.push_back("tau" + std::to_string(i));
  for (std::uint64_t k = 1; k <= points; ++k) {
    const exact::ExactPoint point(k);
    const derive::dynamics::PlainRecursion plain(robot, point);
    definition.values.push_back(plain.inverse_dynamics(plain.rates(), plain.accelerations(),
                                                       point.symbol(derive::dynamics::gravity_symbol)));
  }
  return definition;
}

}  // namespace

Definition definition_of(What what, const model::Robot& robot) {
  if (what == What::forward) return values_of(derive::plain_transform(robot));
  return what == What::jacobian ? values_of(derive::jacobian_definition(robot)) : plain_recursion(robot);
}

void certify(const dag::Function& function, const Definition& definition, const std::string& name) {
  const bool is_quaternion = function.outputs.front().name == "w";
  const dag::Function& compared = is_quaternion ? as_transform(function) : function;
  for (std::size_t k = 0; k < definition.values.size(); ++k) {
    const auto values = dag::evaluate<exact::Number>(compared, exact::ExactPoint(k + 1));
    for (std::size_t i = 0; i < definition.outputs.size(); ++i) {
      if (compared.outputs.at(i).name != definition.outputs[i])
        throw verify::CertificateError(name + ": outputs are not those of the definition");
      if (!exact::agree(values[i], definition.values[k][i]))
        throw verify::CertificateError(name + ": output " + definition.outputs[i] +
                                       " differs from its definition");
    }
  }
}

void certify_same(const dag::Function& folded, const dag::Function& certified, const std::string& name) {
  for (std::uint64_t k = 1; k <= points; ++k) {
    const DecimalPoint point{exact::ExactPoint(k)};
    const auto found = dag::evaluate<cln::cl_R>(folded, point),
               wanted = dag::evaluate<cln::cl_R>(certified, point);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double off = cln::double_approx(cln::abs(found.at(i) - wanted[i]));
      if (!(off <= tolerance * (1 + std::abs(cln::double_approx(wanted[i])))))
        throw verify::CertificateError(name + ": output " + certified.outputs[i].name +
                                       " is not what it was before constants were folded");
    }
  }
}

}  // namespace qvgen::compare
