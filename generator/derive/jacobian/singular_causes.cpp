// SPDX-License-Identifier: MIT
#include "derive/jacobian/singular_causes.h"

#include <algorithm>

#include "derive/jacobian/frames.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

using Kind = SingularCause::Kind;

/// "1", "1 and 2", "1, 2 and 3": numbers of joints, from one.
std::string list(const std::vector<std::size_t>& joints) {
  std::string text;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (i > 0) text += i + 1 == joints.size() ? " and " : ", ";
    text += std::to_string(joints[i] + 1);
  }
  return text;
}

std::string axes(const std::vector<std::size_t>& joints) {
  return (joints.size() == 1 ? "the axis of joint " : "the axes of joints ") + list(joints);
}

bool is_zero(const Vector& v) {
  return v.x.expand().is_zero() && v.y.expand().is_zero() && v.z.expand().is_zero();
}

/// Returns the sign of a number, or of a product with parameters, which are lengths and so positive; 0 if
/// that does not tell.
int sign(const ex& value) {
  const ex e = value.expand();
  if (GiNaC::is_a<GiNaC::add>(e)) return 0;
  GiNaC::exmap ones;
  for (auto it = e.preorder_begin(); it != e.preorder_end(); ++it)
    if (GiNaC::is_a<GiNaC::symbol>(*it)) ones[*it] = 1;
  const ex number = e.subs(ones, GiNaC::subs_options::no_pattern);
  if (!GiNaC::is_a<GiNaC::numeric>(number)) return 0;
  return GiNaC::ex_to<GiNaC::numeric>(number).csgn();
}

constexpr const char* stretched = "arm stretched: workspace boundary";
constexpr const char* folded = "arm folded: inner boundary";

}  // namespace

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::shoulder:
      return "shoulder";
    case Kind::elbow:
      return "elbow";
    case Kind::workspace_boundary:
      return "workspace boundary";
    case Kind::inner_boundary:
      return "inner boundary";
    case Kind::wrist:
      return "wrist";
  }
  return {};
}

SingularCauses::SingularCauses(CirclePolynomials& circles, const Linkage& linkage, std::string point)
    : circles_(circles), variables_(linkage.variables), point_(std::move(point)) {
  Program program;
  Frames frames(program, linkage);
  const std::size_t frame = std::min<std::size_t>(1, frames.last());  // free of the first joint's angle
  for (const Frames::Column& column : frames.columns()) {
    const MovingTwist twist = frames.move(column.twist, column.frame, frame);
    for (const Vector& v : {twist.linear.value, twist.angular.value})
      for (const ex& component : {v.x, v.y, v.z}) program.output("", component);
  }
  const auto outputs = program.expanded();
  for (std::size_t i = 0; i < outputs.size(); i += 6) {
    Joint joint;
    joint.linear = {outputs[i].value, outputs[i + 1].value, outputs[i + 2].value};
    joint.angular = {outputs[i + 3].value, outputs[i + 4].value, outputs[i + 5].value};
    joint.slides = is_zero(joint.angular);
    joints_.push_back(joint);
  }
}

bool SingularCauses::vanishes(const ex& factor, const Vector& v) {
  return circles_.divides(factor, v.x) && circles_.divides(factor, v.y) && circles_.divides(factor, v.z);
}

bool SingularCauses::always_parallel(std::size_t i, std::size_t j) const {
  const Vector normal = cross(joints_[i].angular, joints_[j].angular);
  CirclePolynomials circles;
  return circles.polynomial(normal.x).is_zero() && circles.polynomial(normal.y).is_zero() &&
         circles.polynomial(normal.z).is_zero();
}

bool SingularCauses::is_constant(const ex& value) const {
  return std::none_of(variables_.begin(), variables_.end(), [&](const ex& v) { return value.has(v); });
}

/// Difference of the velocities that parallel axes i and j give a point: as long as the distance of the axes.
Vector SingularCauses::between(std::size_t i, std::size_t j) const {
  const bool same = is_zero(joints_[i].angular - joints_[j].angular);
  return same ? joints_[i].linear - joints_[j].linear : joints_[i].linear + joints_[j].linear;
}

/// `reach`: as long as the arm between the first axis and the point reaches. Where the factor is the sine or
/// cosine of one joint's angle, its two zeros are told apart: the arm is stretched where it reaches farther.
std::string SingularCauses::stretched_or_folded(const ex& factor, const Vector& reach) const {
  std::string both = std::string(stretched) + "; " + folded;
  const ex circular = GiNaC::is_a<GiNaC::function>(factor) ? factor : -factor;
  const bool sine = GiNaC::is_the_function<GiNaC::sin_SERIAL>(circular);
  if (!sine && !GiNaC::is_the_function<GiNaC::cos_SERIAL>(circular)) return both;
  const ex angle = circular.op(0);
  if (!GiNaC::is_a<GiNaC::symbol>(angle)) return both;
  CirclePolynomials circles;
  const ex square = circles.written_out(dot(reach, reach));
  const ex first = sine ? ex(0) : GiNaC::Pi / 2;
  const ex second = sine ? ex(GiNaC::Pi) : -GiNaC::Pi / 2;
  const ex difference = (square.subs(angle == first) - square.subs(angle == second)).expand();
  const int farther = is_constant(difference) ? sign(difference) : 0;
  if (farther == 0) return both;
  const std::string name = GiNaC::ex_to<GiNaC::symbol>(angle).get_name();
  const std::string values[] = {name + (sine ? " = 0" : " = pi/2"), name + (sine ? " = pi" : " = -pi/2")};
  const int best = farther > 0 ? 0 : 1;
  return values[best] + ", " + stretched + "; " + values[1 - best] + ", " + folded;
}

/// The point has no velocity from that joint. On the first revolute axis that is the shoulder's; where a
/// slide has brought it there, or on another axis, the point is as near to the axis as can be.
SingularCauses::Found SingularCauses::point_on_axis(const ex& factor,
                                                    const std::vector<std::size_t>& joints) {
  std::vector<std::size_t> on;
  for (const std::size_t j : joints) {
    if (!joints_[j].slides && !is_zero(joints_[j].linear) && vanishes(factor, joints_[j].linear))
      on.push_back(j);
  }
  if (on.empty()) return std::nullopt;
  const bool turns = std::any_of(joints.begin(), joints.end(), [&](std::size_t j) {
    return !joints_[j].slides && factor.has(variables_[j]);
  });
  const auto first =
      std::find_if(joints.begin(), joints.end(), [&](std::size_t j) { return !joints_[j].slides; });
  const bool shoulder = turns && on.front() == *first;
  return SingularCause{shoulder ? Kind::shoulder : Kind::inner_boundary, point_ + " on " + axes(on)};
}

/// A slide and a turn move the point along the same line. A slide that the joint carries has come as near to
/// its axis as can be; on a slide that carries the joint, the link stands out as far as can be.
SingularCause SingularCauses::along_a_slide(std::size_t i, std::size_t j) const {
  const bool carried = joints_[j].slides;
  const std::string text = "joint " + std::to_string((carried ? i : j) + 1) + " moves " + point_ +
                           " along the slide of joint " + std::to_string((carried ? j : i) + 1);
  return {carried ? Kind::inner_boundary : Kind::workspace_boundary, text};
}

/// Two joints move the point along the same line: if both turn, the axes and the point lie in one plane, and
/// the point's distance from the first axis does not change with the second joint: it is greatest or least.
SingularCauses::Found SingularCauses::two_in_line(const ex& factor, const std::vector<std::size_t>& joints) {
  for (std::size_t b = 1; b < joints.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const std::size_t i = joints[a];
      const std::size_t j = joints[b];
      const Vector &first = joints_[i].linear, &second = joints_[j].linear;
      if (is_zero(first) || is_zero(second) || !vanishes(factor, cross(first, second))) continue;
      if (joints_[i].slides || joints_[j].slides) return along_a_slide(i, j);
      if (i == 0 && !always_parallel(i, j))
        return SingularCause{Kind::shoulder, point_ + " in the plane of " + axes({i, j})};
      const std::string plane = axes({i, j}) + " and " + point_ + " in one plane; ";
      if (always_parallel(i, j))
        return SingularCause{Kind::elbow, plane + stretched_or_folded(factor, first)};
      return SingularCause{Kind::elbow,
                           plane +
                               "at its greatest distance from the first: workspace boundary; at its "
                               "least: inner boundary"};
    }
  }
  return std::nullopt;
}

/// Three parallel axes in one plane: an elbow whatever follows.
SingularCauses::Found SingularCauses::parallel_axes_in_plane(const ex& factor,
                                                             const std::vector<std::size_t>& joints) {
  for (std::size_t a = 0; a + 2 < joints.size(); ++a) {
    const std::size_t i = joints[a], j = joints[a + 1], k = joints[a + 2];
    if (joints_[i].slides || joints_[j].slides || joints_[k].slides) continue;
    if (!always_parallel(i, j) || !always_parallel(j, k)) continue;
    if (!vanishes(factor, cross(between(i, j), between(j, k)))) continue;
    const std::string plane = axes({i, j, k}) + " in one plane; ";
    return SingularCause{Kind::elbow, plane + stretched_or_folded(factor, between(i, k))};
  }
  return std::nullopt;
}

/// Two parallel axes move the point in a plane across them; another joint adds nothing if its velocity has no
/// component along these axes.
SingularCauses::Found SingularCauses::point_in_plane_of_axes(const ex& factor,
                                                             const std::vector<std::size_t>& joints) {
  for (const std::size_t i : joints) {
    for (std::size_t a = 0; a + 1 < joints.size(); ++a) {
      const std::size_t j = joints[a], k = joints[a + 1];
      if (joints_[i].slides || joints_[j].slides || joints_[k].slides || i == j || i == k) continue;
      if (!always_parallel(j, k) || always_parallel(i, j)) continue;
      if (!circles_.divides(factor, dot(joints_[j].angular, joints_[i].linear))) continue;
      if (i > k) {
        return SingularCause{Kind::workspace_boundary,
                             point_ + " as far along " + axes({j, k}) + " as can be"};
      }
      const std::string plane = point_ + " in the plane of " + axes({i});
      return SingularCause{Kind::shoulder, plane + " that is parallel to " + axes({j, k})};
    }
  }
  return std::nullopt;
}

/// A joint moves the point along the first axis: the point's distance from that axis stands still. For arms
/// whose determinant has rows across the axis alone.
SingularCauses::Found SingularCauses::along_first_axis(const ex& factor,
                                                       const std::vector<std::size_t>& joints) {
  const std::size_t first = joints.front();
  if (joints_[first].slides) return std::nullopt;
  for (const std::size_t j : joints) {
    if (j == first || is_zero(joints_[j].linear)) continue;
    if (!vanishes(factor, cross(joints_[first].angular, joints_[j].linear))) continue;
    return SingularCause{Kind::workspace_boundary, "joint " + std::to_string(j + 1) + " moves " + point_ +
                                                       " along " + axes({first}) +
                                                       ", at its greatest or least distance from it"};
  }
  return std::nullopt;
}

SingularCause SingularCauses::of(const ex& factor, const std::vector<std::size_t>& joints) {
  if (auto found = point_on_axis(factor, joints)) return *found;
  if (auto found = two_in_line(factor, joints)) return *found;
  if (auto found = parallel_axes_in_plane(factor, joints)) return *found;
  if (auto found = point_in_plane_of_axes(factor, joints)) return *found;
  if (auto found = along_first_axis(factor, joints)) return *found;
  // The second joint's angle moves the arm as a whole against the first axis.
  const bool whole = std::any_of(joints.begin(), joints.end(),
                                 [&](std::size_t j) { return j < 2 && factor.has(variables_[j]); });
  return {whole ? Kind::shoulder : Kind::elbow,
          "the joints " + list(joints) + " move " + point_ + " in one plane only"};
}

SingularCause SingularCauses::of_wrist(const ex& factor, bool axes_meet) {
  for (std::size_t i = joints_.size(); i-- > (axes_meet ? 3U : 0U);) {
    for (std::size_t j = i + 1; j < joints_.size(); ++j) {
      if (joints_[i].slides || joints_[j].slides || always_parallel(i, j)) continue;
      if (!vanishes(factor, cross(joints_[i].angular, joints_[j].angular))) continue;
      return {Kind::wrist, axes({i, j}) + (axes_meet ? " in line" : " parallel")};
    }
  }
  return {Kind::wrist, "the axes of the last three joints in one plane"};
}

}  // namespace qvgen::derive
