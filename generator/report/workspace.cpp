// SPDX-License-Identifier: MIT
#include "report/workspace.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "canonical/arm.h"
#include "dag/evaluate.h"
#include "dag/import.h"
#include "derive/jacobian/circle_polynomial.h"
#include "derive/jacobian/wrist.h"
#include "derive/kinematics/position.h"
#include "exact/named_constant.h"
#include "model/followers.h"
#include "optimise/described.h"
#include "passes/pass.h"
#include "report/swept_area.h"
#include "symbolic/model.h"
#include "verify/certificate.h"

namespace qvgen::report {
namespace {

using namespace symbolic;
using GiNaC::ex;

WorkspaceSection none(const std::string& reason) { return {{}, {}, {}, reason}; }

/// The first three joints with the point that they position; an empty chain where there is none. The frames
/// of all joints are parallel at zero, so that what is behind the third joint adds up.
std::optional<derive::ZeroReferenceChain> positioning(const model::Robot& robot) {
  auto chain = derive::zero_reference_chain(robot);
  if (!chain || robot.joints.size() == 3) return chain;
  const auto centre = derive::wrist_centre(robot);
  if (!centre) return std::nullopt;
  chain->tool_offset = chain->tool_offset + rotate(chain->home, *centre);
  for (std::size_t i = 3; i < chain->joints.size(); ++i)
    chain->tool_offset = chain->tool_offset + chain->joints[i].offset;
  chain->joints.resize(3);
  return chain;
}

/// Across the axis and along it, the axis x, y or z or one of their negatives.
std::optional<Vector> along_last(const Vector& p, const Vector& axis) {
  const auto is = [](const ex& value) { return value.is_equal(1) || value.is_equal(-1); };
  if (is(axis.z)) return Vector{p.x, p.y, axis.z * p.z};
  if (is(axis.y)) return Vector{p.z, p.x, axis.y * p.y};
  if (is(axis.x)) return Vector{p.y, p.z, axis.x * p.x};
  return std::nullopt;
}

/// 1/2 d(u^2 + v^2, h)/d(a, b)
ex determinant(const Vector& p, const GiNaC::symbol& a, const GiNaC::symbol& b) {
  const auto half_square = [&](const GiNaC::symbol& by) { return p.x * p.x.diff(by) + p.y * p.y.diff(by); };
  return half_square(a) * p.z.diff(b) - half_square(b) * p.z.diff(a);
}

Program factors_of(const ex& value, const std::vector<ex>& variables) {
  derive::CirclePolynomials circles;
  const ex polynomial = circles.polynomial(value);
  Program factors, product, meant;
  if (polynomial.is_zero()) return factors;
  const auto all = circles.factored(polynomial, variables);
  ex whole = all.constant;
  for (const auto& factor : all.factors) {
    whole *= GiNaC::pow(factor.value, factor.multiplicity);
    factors.output("f", factor.value);
  }
  product.output("determinant", whole);
  meant.output("determinant", value);
  verify::certify(dag::import(product), meant, 3, "factors of the workspace's determinant");
  return factors;
}

}  // namespace

WorkspaceSection workspace_section(const model::Robot& described) {
  if (model::has_followers(described)) return none("a joint follows another");
  const canonical::Arm arm = canonical::for_kinematics(described);
  const auto& joints = arm.robot.joints;
  if (joints.size() != 3 && joints.size() != 6) return none("it has neither three joints nor six");
  if (joints[0].type != model::JointType::revolute)
    return none("its first joint slides: the workspace is no body of revolution");
  auto chain = positioning(arm.robot);
  if (!chain) return none("its last three axes do not meet, or axes are neither parallel nor perpendicular");
  const Vector axis = chain->joints.front().axis;
  chain->joints.erase(chain->joints.begin());  // the section at its zero: all others are turned
  const auto p = along_last(derive::written_out_position(*chain), axis);
  if (!p) return none("its first axis is no coordinate axis");
  const GiNaC::symbol a = symbol(joints[1].variable), b = symbol(joints[2].variable);
  const Program factors = factors_of(determinant(*p, a, b), {a, b});
  if (factors.outputs().empty()) return none("its point has no volume to move in");
  Program place;
  place.output("u", p->x);
  place.output("v", p->y);
  place.output("h", p->z);
  const dag::Function simple = passes::simplify(dag::import(place));
  verify::certify(simple, place, 3, "place in the section");
  return {joints.size() == 3 ? "tool point" : "wrist centre", optimise::in_terms_of_description(simple, arm),
          optimise::in_terms_of_description(dag::import(factors), arm), ""};
}

namespace {

struct NumberLeaves {
  std::map<std::string, double> values;
  static double constant(const exact::Number& n) {
    return cln::double_approx(exact::to_float(n, cln::float_format(20)));
  }
  [[nodiscard]] double symbol(const std::string& name) const {
    const auto named = exact::named_value(name);
    return named ? cln::double_approx(*named) : values.at(name);
  }
  [[nodiscard]] double radians(const dag::Angle& angle) const {
    double sum = cln::double_approx(angle.pi) * std::numbers::pi;
    for (const auto& [name, coefficient] : angle.terms) sum += cln::double_approx(coefficient) * symbol(name);
    return sum;
  }
  [[nodiscard]] double sine(const dag::Angle& angle) const { return std::sin(radians(angle)); }
  [[nodiscard]] double cosine(const dag::Angle& angle) const { return std::cos(radians(angle)); }
  static double root(double x) { return std::sqrt(x); }
  static double arctangent(double y, double x) { return std::atan2(y, x); }
};

struct Range {
  double lower = -std::numbers::pi, upper = std::numbers::pi;
};

std::optional<Range> range_of(const model::Joint& joint, const model::Bindings& values) {
  const bool turns = joint.type == model::JointType::revolute;
  if (!joint.limits) return turns ? std::optional(Range{}) : std::nullopt;
  try {
    const Range range{model::to_double(model::evaluate(joint.limits->lower, values)),
                      model::to_double(model::evaluate(joint.limits->upper, values))};
    const bool bounded = std::isfinite(range.lower) && std::isfinite(range.upper);
    if (!bounded) return turns ? std::optional(Range{}) : std::nullopt;
    return turns && range.upper - range.lower > 2 * std::numbers::pi ? Range{} : range;
  } catch (const model::EvaluationError&) {
    return std::nullopt;
  }
}

/// u, v, h of the values of joints 2 and 3.
class Place {
 public:
  Place(const model::Robot& robot, const WorkspaceSection& section, const model::Bindings& bindings)
      : robot_(robot), section_(section) {
    for (const auto& [name, value] : bindings) leaves_.values[name] = model::to_double(value);
  }
  std::array<double, 3> at(const std::array<double, 2>& q) {
    for (std::size_t i = 0; i < 2; ++i) leaves_.values[robot_.joints[i + 1].variable] = q[i];
    const auto p = dag::evaluate<double>(section_.place, leaves_);
    return {p[0], p[1], p[2]};
  }

 private:
  const model::Robot& robot_;
  const WorkspaceSection& section_;
  NumberLeaves leaves_;
};

constexpr std::size_t steps = 360;  ///< of a joint's range

using Measure = double (*)(const std::array<double, 3>&);
double distance(const std::array<double, 3>& p) { return std::hypot(p[0], p[1], p[2]); }
double radius(const std::array<double, 3>& p) { return std::hypot(p[0], p[1]); }
double height(const std::array<double, 3>& p) { return p[2]; }

/// The least (sign 1) or the most (-1) of a measure within the ranges: the best of the grid, then steps to
/// the better neighbour, ever shorter.
double extreme(Place& place, const std::vector<std::array<double, 2>>& grid,
               const std::array<Range, 3>& ranges, Measure measure, double sign) {
  const auto value = [&](const std::array<double, 2>& q) { return sign * measure(place.at(q)); };
  std::array<double, 2> best = *std::min_element(
      grid.begin(), grid.end(), [&](const auto& a, const auto& b) { return value(a) < value(b); });
  for (double step = 1.0 / steps; step > 1e-12; step /= 2)
    for (bool better = true; better;) {
      better = false;
      for (const auto& [i, j] :
           {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
        std::array<double, 2> next = best;
        for (std::size_t k = 0; k < 2; ++k) {
          const Range& range = ranges[k + 1];
          next[k] = std::clamp(best[k] + (k == 0 ? i : j) * step * (range.upper - range.lower), range.lower,
                               range.upper);
        }
        if (value(next) >= value(best)) continue;
        best = next;
        better = true;
      }
    }
  return sign * value(best);
}

}  // namespace

std::optional<WorkspaceNumbers> workspace_numbers(const model::Robot& described,
                                                  const WorkspaceSection& section) {
  const model::Bindings bindings = model::default_bindings(described);
  std::array<Range, 3> ranges;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto range = range_of(described.joints[i], bindings);
    if (!range) return std::nullopt;
    ranges[i] = *range;
  }
  if (bindings.size() < described.geometry.size()) return std::nullopt;
  Place place(described, section, bindings);
  GridImage image{steps + 1, steps + 1, {}};
  std::vector<std::array<double, 2>> grid;
  for (std::size_t k = 0; k < image.rows * image.columns; ++k) {
    const auto value = [&](const Range& range, std::size_t i) {
      return range.lower + (range.upper - range.lower) * static_cast<double>(i) / steps;
    };
    const std::array<double, 2> q{value(ranges[1], k / image.columns), value(ranges[2], k % image.columns)};
    const auto p = place.at(q);
    image.points.push_back({p[0] * p[0] + p[1] * p[1], p[2]});
    if (k / image.columns % 6 == 0 && k % image.columns % 6 == 0) grid.push_back(q);
  }
  const auto found = [&](Measure measure, double sign) {
    return extreme(place, grid, ranges, measure, sign);
  };
  WorkspaceNumbers numbers{found(distance, -1),
                           found(distance, 1),
                           found(radius, -1),
                           found(radius, 1),
                           found(height, 1),
                           found(height, -1),
                           0};
  // A body of revolution: its volume is half the angle times the area by squares of the radius.
  numbers.volume = (ranges[0].upper - ranges[0].lower) / 2 * swept_area(image);
  return numbers;
}

namespace {

std::vector<std::string> number_lines(WorkspaceNumbers n, bool latex) {
  for (double* x : {&n.nearest, &n.narrowest, &n.lowest, &n.highest})
    if (std::abs(*x) < 1e-6 * n.farthest) *x = 0;
  return {fmt::format("reach from the origin of joint 1: {:.4g} to {:.4g} m", n.nearest, n.farthest),
          fmt::format("from its axis: {:.4g} to {:.4g} m; along it: {:.4g} to {:.4g} m", n.narrowest,
                      n.widest, n.lowest, n.highest),
          fmt::format("volume: {:.3g} {}", n.volume, latex ? "$\\mathrm{m}^3$" : "m^3")};
}

std::string text_of(const dag::Graph& graph, dag::Edge value, emit::Notation notation) {
  const auto name = [notation](const std::string& symbol) { return emit::formula(symbol, notation); };
  return emit::formula(graph, value, notation, name);
}

/// GiNaC's order of factors changes from run to run.
std::vector<std::string> equations(const dag::Function& factors, emit::Notation notation) {
  std::vector<std::string> all;
  for (const dag::Output& output : factors.outputs) {
    const dag::Edge edge = output.value.negative ? -output.value : output.value;
    all.push_back(text_of(factors.graph, edge, notation));
  }
  std::sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
  return all;
}

}  // namespace

std::vector<WorkspacePassage> workspace_passages(const model::Robot& described, emit::Notation notation) {
  const WorkspaceSection section = workspace_section(described);
  if (!section.missing.empty()) return {};
  const bool latex = notation.typeset;
  WorkspacePassage place{
      {"Section of the " + section.point +
           "'s workspace through the axis of joint 1, which turns it about that axis.",
       latex ? "$u$, $v$ across the axis and $h$ along it from the origin of joint 1; radius $r^2 = u^2 + "
               "v^2$:"
             : "u, v across the axis and h along it from the origin of joint 1; radius r, r^2 = u^2 + v^2:"},
      {}};
  for (const dag::Output& output : section.place.outputs)
    place.formulas.push_back(output.name + " = " + text_of(section.place.graph, output.value, notation));
  WorkspacePassage boundary{
      {"Boundary: among the curves of all r, h on which one of these is zero (the factors of the point's "
       "Jacobian),",
       "and the curves on which joint 2 or joint 3 is at a limit:"},
      {}};
  for (const std::string& factor : equations(section.factors, notation))
    boundary.formulas.push_back(factor + " = 0");
  WorkspacePassage numbers{{"No numbers: a symbol has no value, or a slide no limits."}, {}};
  if (const auto found = workspace_numbers(described, section)) {
    numbers.words = {"With the description's values and limits (without limits: one turn):"};
    for (const std::string& line : number_lines(*found, latex)) numbers.words.push_back(line);
  }
  return {place, boundary, numbers};
}

std::vector<std::string> workspace_lines(const model::Robot& described, emit::Notation notation) {
  std::vector<std::string> lines;
  for (const WorkspacePassage& passage : workspace_passages(described, notation)) {
    lines.insert(lines.end(), passage.words.begin(), passage.words.end());
    for (const std::string& formula : passage.formulas)
      lines.push_back(notation.typeset ? "\\[" + formula + "\\]" : formula);
  }
  return lines;
}

}  // namespace qvgen::report
