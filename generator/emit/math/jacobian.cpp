// SPDX-License-Identifier: MIT
#include "emit/math/jacobian.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "canonical/arm.h"
#include "dag/import.h"
#include "derive/jacobian/circle_polynomial.h"
#include "derive/jacobian/definition.h"
#include "derive/jacobian/quantities.h"
#include "derive/jacobian/singularities.h"
#include "derive/kinematics/forward_kinematics.h"
#include "derive/kinematics/position.h"
#include "emit/math/tidy.h"
#include "model/followers.h"
#include "optimise/described.h"
#include "symbolic/model.h"
#include "verify/certificate.h"

namespace qvgen::emit {
namespace {

using namespace symbolic;
using derive::Twist;
using GiNaC::ex;
using Columns = std::vector<Twist>;

constexpr int certificate_points = 3;

class Texts {
 public:
  Texts(const canonical::Arm& arm, Notation notation) : arm_(arm), notation_(notation) {}

  [[nodiscard]] std::string operator()(const dag::Function& function) const {
    const dag::Function described = optimise::in_terms_of_description(function, arm_);
    return text_of(described.graph, described.outputs.front().value);
  }
  [[nodiscard]] std::string operator()(const ex& value) const { return (*this)(tidy(value)); }
  [[nodiscard]] VectorText operator()(const Vector& v) const {
    return {(*this)(v.x), (*this)(v.y), (*this)(v.z)};
  }
  /// Factors in an order of their own: GiNaC's changes from run to run.
  [[nodiscard]] std::string operator()(const derive::CirclePolynomials::Product& product) const {
    bool negative = false;
    const std::string constant = positive(product.constant, 1, negative);
    std::vector<std::string> factors;
    for (const auto& factor : product.factors)
      factors.push_back(positive(factor.value, factor.multiplicity, negative));
    std::sort(factors.begin(), factors.end(), [](const std::string& a, const std::string& b) {
      return std::pair(a.size(), a) < std::pair(b.size(), b);
    });
    if (constant != "1" || factors.empty()) factors.insert(factors.begin(), constant);
    return (negative ? "-" : "") + fmt::format("{}", fmt::join(factors, latex() ? " " : "*"));
  }

 private:
  [[nodiscard]] bool latex() const { return notation_.typeset; }
  [[nodiscard]] std::string text_of(const dag::Graph& graph, dag::Edge value) const {
    const auto name = [this](const std::string& symbol) { return formula(symbol, notation_); };
    return formula(graph, value, notation_, name);
  }
  /// A factor's power without its sign.
  [[nodiscard]] std::string positive(const ex& value, int power, bool& negative) const {
    Program program;
    program.output("factor", value);
    const dag::Function described = optimise::in_terms_of_description(dag::import(program), arm_);
    const dag::Edge edge = described.outputs.front().value;
    negative = negative != (edge.negative && power % 2 != 0);
    std::string text = text_of(described.graph, edge.negative ? -edge : edge);
    if (described.graph.node(edge).op == dag::Op::sum) text = "(" + text + ")";
    if (power == 1) return text;
    return fmt::format("{}^{}", latex() ? "{" + text + "}" : text, power);
  }

  const canonical::Arm& arm_;
  Notation notation_;
};

struct Axis {
  Vector direction;
  Vector point;
};

Vector derivative(const Vector& v, const GiNaC::symbol& by) {
  return {v.x.diff(by), v.y.diff(by), v.z.diff(by)};
}

/// The line of a joint in the base frame: where a slide along it comes to, at rest and by its way.
Axis axis_of(const model::Robot& robot, std::size_t joint) {
  const GiNaC::symbol way = symbol("way along the axis");
  model::Robot front = robot;
  front.joints.resize(joint + 1);
  front.joints.back().type = model::JointType::prismatic;
  front.joints.back().variable = way.get_name();
  front.joints.back().after = {};
  front.tool = {};
  const Vector end = derive::written_out_position(*derive::zero_reference_chain(front));
  const auto at_rest = [&](const ex& value) { return value.subs(way == 0); };
  return {derivative(end, way), {at_rest(end.x), at_rest(end.y), at_rest(end.z)}};
}

ex entry(const Twist& twist, std::size_t row) {
  const Vector& v = row < 3 ? twist.linear : twist.angular;
  return row % 3 == 0 ? v.x : row % 3 == 1 ? v.y : v.z;
}

void certify(const model::Robot& robot, const Columns& columns, const std::string& method) {
  Program program;
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t j = 0; j < columns.size(); ++j)
      program.output(derive::jacobian_entry(row, j), entry(columns[j], row));
  verify::certify(dag::import(program), derive::jacobian_definition(robot), certificate_points,
                  robot.name + ": Jacobian by " + method);
}

/// z_i x (p - p_i), z_i of a joint that turns; z_i, 0 of one that slides.
Columns by_cross_products(const model::Robot& robot, const std::vector<Axis>& axes, const Vector& tool) {
  Columns columns;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Vector& z = axes[i].direction;
    const bool turns = robot.joints[i].type == model::JointType::revolute;
    columns.push_back(turns ? Twist{cross(z, tool - axes[i].point), z} : Twist{z, {}});
  }
  return columns;
}

/// dp/dq_i, and the vector part of 2 (dQ/dq_i) Q^-1.
Columns by_differentiation(const model::Robot& robot, const Vector& tool, const Quaternion& q) {
  Columns columns;
  for (const model::Joint& joint : robot.joints) {
    const GiNaC::symbol variable = symbol(joint.variable);
    const Vector imaginary = derivative({q.x, q.y, q.z}, variable);
    const Quaternion spin =
        Quaternion{q.w.diff(variable), imaginary.x, imaginary.y, imaginary.z} * inverse(q);
    columns.push_back({derivative(tool, variable), ex(2) * Vector{spin.x, spin.y, spin.z}});
  }
  return columns;
}

std::optional<Quaternion> orientation(const model::Robot& robot) {
  const auto pose = derive::closed_form(robot);
  if (!pose) return std::nullopt;
  const auto q = pose->expanded();
  return Quaternion{q[0].value, q[1].value, q[2].value, q[3].value};
}

}  // namespace

JacobianFormulas jacobian_formulas(const model::Robot& described, Notation notation) {
  if (model::has_followers(described))
    throw std::domain_error("a joint follows another: the methods give each joint a rate of its own");
  const canonical::Arm arm = canonical::for_kinematics(described);
  const auto chain = derive::zero_reference_chain(arm.robot);
  const auto q = orientation(arm.robot);
  if (!chain || !q) return {};
  const Vector tool = derive::written_out_position(*chain);
  std::vector<Axis> axes;
  for (std::size_t i = 0; i < arm.robot.joints.size(); ++i) axes.push_back(axis_of(arm.robot, i));
  const Columns columns = by_differentiation(arm.robot, tool, *q);
  certify(arm.robot, columns, "differentiation");
  const Columns crosses = by_cross_products(arm.robot, axes, tool);
  certify(arm.robot, crosses, "cross products");
  const Texts text(arm, notation);
  JacobianFormulas result{{}, text(tool), {}};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    result.joints.push_back({arm.robot.joints[i].type == model::JointType::revolute, text(axes[i].direction),
                             text(axes[i].point)});
    const VectorText v = text(columns[i].linear);  // the shorter ones of the two methods
    const VectorText w = text(crosses[i].angular);
    result.columns.push_back({v[0], v[1], v[2], w[0], w[1], w[2]});
  }
  return result;
}

namespace {

using Square = std::vector<std::vector<ex>>;

/// Inverse times determinant, by cofactors; n = 1, 2 or 3.
Square adjugate(const Square& m) {
  const std::size_t n = m.size();
  Square result(n, std::vector<ex>(n, 1));
  if (n == 2) return {{m[1][1], -m[0][1]}, {-m[1][0], m[0][0]}};
  if (n == 3)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
        result[i][j] = m[r][c] * m[s][d] - m[r][d] * m[s][c];
      }
  return result;
}

/// The rows of the Jacobian, written out in the base frame.
Square square_of(const model::Robot& robot, const std::vector<int>& rows) {
  const Vector tool = derive::written_out_position(*derive::zero_reference_chain(robot));
  std::vector<Axis> axes;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) axes.push_back(axis_of(robot, i));
  const Columns columns = by_cross_products(robot, axes, tool);
  Square square;
  for (const int row : rows) {
    square.emplace_back();
    for (const Twist& column : columns) square.back().push_back(entry(column, static_cast<std::size_t>(row)));
  }
  return square;
}

/// adjugate * square = determinant * 1
void certify_inverse(const Square& adjugate, const Square& square, const ex& determinant) {
  Program product, diagonal;
  for (std::size_t i = 0; i < square.size(); ++i)
    for (std::size_t j = 0; j < square.size(); ++j) {
      ex sum = 0;
      for (std::size_t k = 0; k < square.size(); ++k) sum += adjugate[i][k] * square[k][j];
      product.output("entry", sum);
      diagonal.output("entry", i == j ? determinant : ex(0));
    }
  verify::certify(dag::import(product), diagonal, certificate_points, "inverse of the Jacobian");
}

ex value_of(const derive::CirclePolynomials::Product& product) {
  ex value = product.constant;
  for (const auto& factor : product.factors) value *= GiNaC::pow(factor.value, factor.multiplicity);
  return value;
}

derive::CirclePolynomials::Product product_of(const derive::Singularities& all) {
  derive::CirclePolynomials::Product product{all.constant, {}};
  for (const auto& factor : all.factors) product.factors.push_back({factor.value, factor.multiplicity});
  return product;
}

void certify_determinant(const model::Robot& robot, const std::vector<int>& rows, const ex& value) {
  Program program;
  program.output("determinant", value);
  verify::certify(dag::import(program), derive::determinant_definition(robot, rows), certificate_points,
                  "determinant of the Jacobian");
}

/// As a product of factors that split no further, or as it stands: what is shorter.
std::string shorter(const Texts& text, const model::Robot& robot, const ex& value) {
  const std::string sum = text(tidy_in_sums(value));
  if (!has_whole_angles(value)) return sum;
  std::vector<ex> variables;
  for (const model::Joint& joint : robot.joints) variables.emplace_back(symbol(joint.variable));
  derive::CirclePolynomials circles;
  const ex polynomial = circles.polynomial(value);
  if (polynomial.is_zero()) return "0";
  const auto product = circles.factored(polynomial, variables);
  Program written, meant;
  written.output("entry", value_of(product));
  meant.output("entry", value);
  verify::certify(dag::import(written), meant, certificate_points, "factors of an entry");
  const std::string factors = text(product);
  return factors.size() <= sum.size() ? factors : sum;
}

}  // namespace

SquarePart square_part(const model::Robot& described, Notation notation) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  const derive::Singularities all = derive::singularities(arm.robot);
  if (all.rows.empty()) return {{}, {}, {}, all.not_factored};
  const char* names[] = {"vx", "vy", "vz", "wx", "wy", "wz"};
  const Texts text(arm, notation);
  SquarePart result;
  for (const int row : all.rows) result.rows.emplace_back(names[row]);
  const auto determinant = product_of(all);
  certify_determinant(arm.robot, all.rows, value_of(determinant));
  result.determinant = text(determinant);
  if (all.rows.size() > 3) return result;
  const Square square = square_of(arm.robot, all.rows);
  const Square inverse = adjugate(square);
  certify_inverse(inverse, square, value_of(determinant));
  for (const auto& row : inverse) {
    result.adjugate.emplace_back();
    for (const ex& value : row) result.adjugate.back().push_back(shorter(text, arm.robot, value));
  }
  return result;
}

}  // namespace qvgen::emit
