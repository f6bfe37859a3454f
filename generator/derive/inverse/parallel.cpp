// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "derive/inverse/orientation.h"
#include "derive/inverse/pair_system.h"
#include "derive/inverse/tool_side.h"
#include "derive/inverse/wrist.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

constexpr const char* sum_name = "sum";  ///< the sum of the three parallel joints' angles

bool all_parallel(const std::vector<Screw>& screws, std::size_t k, const Scope& scope) {
  for (const Screw& screw : screws)
    if (!screw.revolute) return false;
  return scope.is_zero(cross(screws[k].axis, screws[k + 1].axis)) &&
         scope.is_zero(cross(screws[k].axis, screws[k + 2].axis));
}

/// The arm read from tool to base: joints in reverse order, axes negated.
std::vector<Screw> mirrored(const std::vector<Screw>& screws) {
  std::vector<Screw> result(screws.rbegin(), screws.rend());
  for (Screw& screw : result) screw = reversed(screw);
  return result;
}

Flat turn_of(const std::string& name) {
  return {symbolic::symbol(names::cosine(name)), symbolic::symbol(names::sine(name))};
}

/// The point of axis b that is nearest to axis a; any point if they are parallel.
Vector nearest_point(const Screw& a, const Screw& b, const Scope& scope) {
  const Vector normal = scope.clean(cross(a.axis, b.axis));
  const ex size = scope.clean(dot(normal, normal));
  if (scope.is_zero(size)) return b.point;
  const Vector between = scope.clean(a.point - b.point);
  return scope.clean(b.point + (scope.clean(dot(cross(between, a.axis), normal)) / size) * b.axis);
}

/// An arm with three parallel joints E, whose turns keep heights and directions along their axes: E e_a e_b =
/// G, and G, the tool's side, depends on the pose and on the sixth joint c alone.
class ParallelAxes {
 public:
  ParallelAxes(Attempt& attempt, std::size_t k)
      : attempt_(attempt),
        builder_(attempt.builder),
        scope_(attempt.scope),
        back_(k >= 2),
        inner_(k == 1 || k == 2),
        target_(attempt.builder, attempt.chain.home) {
    const std::vector<Screw> s = back_ ? mirrored(attempt.chain.screws) : attempt.chain.screws;
    const std::size_t first = inner_ ? 1 : 0;
    three_ = {s[first], s[first + 1], s[first + 2]};
    a_ = s[first + 3];
    b_ = s[inner_ ? 5 : 4];
    c_ = s[inner_ ? 0 : 5];
  }

  std::string solve() {
    const auto centre = meeting_point(a_, b_, scope_);
    if (centre && is_wrist(three_[0], a_, b_, scope_)) {
      by_wrist(*centre);
    } else if (const std::string reason = by_pair(); !reason.empty()) {
      return reason;
    }
    links();
    polish_pose(attempt_, target_);
    return "";
  }

 private:
  [[nodiscard]] const Vector& axis() const { return three_[0].axis; }
  [[nodiscard]] Flat across(const Vector& v) const { return in_frame(three_[0], v, scope_); }
  [[nodiscard]] int sense(const Screw& screw) const {
    return scope_.sample(dot(axis(), screw.axis)) > 0 ? 1 : -1;
  }
  [[nodiscard]] ToolSide tool_side() { return {builder_, target_, three_[0], c_, {back_, inner_}}; }

  // --- axes a and b meet: their common point keeps its height, and the sum of the three makes a wrist with
  // them
  void by_wrist(const Vector& centre) {
    const ToolSide::Image seen = tool_side().point("goal", centre);
    const Block::Form height = seen.form(ToolSide::along, scope_);
    builder_.turn_by_line(c_, height.coefficients, scope_.clean(dot(axis(), centre) - height.constant),
                          height_equation());
    // The centre seen from the three is E centre, and the last of their axes stands off from it by a constant
    // of the arm.
    const Flat there = across_of(seen);
    point_ = {builder_.keep("centre_x", there.x), builder_.keep("centre_y", there.y)};
    offset_ = across(three_[2].point - centre);
    const symbolic::Quaternion whole =
        back_ ? symbolic::inverse(target_.orientation()) : target_.orientation();
    const symbolic::Quaternion rotation =
        inner_ ? without_first(builder_, {c_}, whole) : without_last(builder_, {c_}, whole);
    const Scope::Turn free = free_sum();
    Screw sum = three_[0];
    sum.variable = sum_name;
    sum.joint = -1;
    solve_wrist(builder_, sum, a_, b_, rotation, &free);
  }

  [[nodiscard]] std::string three() const {
    return three_[0].variable + ", " + three_[1].variable + ", " + three_[2].variable;
  }
  [[nodiscard]] std::string height_equation() const { return "height along the axes of " + three(); }
  [[nodiscard]] std::string tilt_equation() const {
    return "angle of the axis of " + b_.variable + " to the axes of " + three();
  }

  // --- two equations in the angles of a and c
  std::string by_pair() {
    const Vector x = point_on_b();
    ToolSide side = tool_side();
    const ToolSide::Image tilted = side.direction("goal_axis", b_.axis);
    const ToolSide::Image seen = side.point("goal", x);
    const Block tilting = block_of(without_place(a_), 1, b_.axis, scope_);
    const Block moving = block_of(a_, 1, x, scope_);
    const std::string reason =
        solve_pair({row(tilting, tilted), tilt_equation(), 0}, {row(moving, seen), height_equation(), 1});
    if (!reason.empty()) return reason;
    place(moving, seen);
    solve_sum(tilting, tilted);
    solve_b(side);
    return "";
  }

  /// Axes that meet leave each other's angle out of the equation of their common point's height.
  Vector point_on_b() const {
    const auto with_c = inner_ ? std::nullopt : meeting_point(b_, c_, scope_);
    return with_c && !meeting_point(a_, b_, scope_) ? *with_c : nearest_point(a_, b_, scope_);
  }

  struct Equation {
    PairRow row;
    std::string text;
    int degree;
  };

  /// Equates the motion by a with what the tool's side shows, along the axes of the three.
  PairRow row(const Block& a, const ToolSide::Image& image) const {
    const Block::Form own = a.form(axis(), scope_);
    const Block::Form other = image.form(ToolSide::along, scope_);
    return {{-own.coefficients.x, -own.coefficients.y},
            scope_.clean(other.constant - own.constant),
            other.coefficients};
  }

  [[nodiscard]] bool vanishes(const Flat& v) const { return scope_.is_zero(v.x) && scope_.is_zero(v.y); }

  std::string solve_pair(const Equation& tilt, const Equation& height) {
    if (vanishes(tilt.row.k)) return one_by_one(c_, &PairRow::m, tilt, a_, height);
    if (vanishes(height.row.k)) return one_by_one(c_, &PairRow::m, height, a_, tilt);
    if (vanishes(tilt.row.m)) return one_by_one(a_, &PairRow::k, tilt, c_, height);
    if (vanishes(height.row.m)) return one_by_one(a_, &PairRow::k, height, c_, tilt);
    return eliminate(builder_, {a_, 1, {}, {1, 0}}, c_, {tilt.row, height.row});
  }

  /// The first equation holds one angle alone, its part of the row being `own`; the second gives the other.
  std::string one_by_one(const Screw& lone, Flat PairRow::*own, const Equation& first, const Screw& other,
                         const Equation& second) {
    builder_.turn_by_line(lone, first.row.*own, -first.row.constant, first.text, first.degree);
    Flat PairRow::*theirs = own == &PairRow::k ? &PairRow::m : &PairRow::k;
    const Scope::Turn at = builder_.value(lone);
    const Flat known = second.row.*own;
    const ex rhs = builder_.keep("rest_" + other.variable,
                                 -(second.row.constant + known.x * at.cosine + known.y * at.sine));
    builder_.turn_by_line(other, second.row.*theirs, rhs, second.text, second.degree);
    return "";
  }

  /// With a and c known: the point E x, and how far off the last of the three axes then stands.
  void place(const Block& moving, const ToolSide::Image& seen) {
    const auto named = [&](const std::string& name, const Flat& v) {
      return Flat{builder_.keep(name + "_x", v.x), builder_.keep(name + "_y", v.y)};
    };
    point_ = named("centre", across_of(seen));
    const auto off = [&](const Vector& n) { return dot(n, three_[2].point) - moving.at_value(n, builder_); };
    offset_ = named("offset", {scope_.clean(off(three_[0].first)), scope_.clean(off(three_[0].second))});
  }

  /// E turns axis b as a has left it into the tool's side's.
  void solve_sum(const Block& tilting, const ToolSide::Image& tilted) {
    const Flat from{tilting.at_value(three_[0].first, builder_),
                    tilting.at_value(three_[0].second, builder_)};
    const Flat to{tilted.at(ToolSide::first, builder_), tilted.at(ToolSide::second, builder_)};
    const bool never_free = vanishes(tilting.x0);
    builder_.turn_by_pair(sum_name, to * conjugate(from), never_free ? Scope::Turn{1, 0} : free_sum(),
                          "the turn of the axis of " + b_.variable + " about the axes of " + three());
  }

  /// Solves the rest of the orientation once a, c and the sum are known.
  void solve_b(ToolSide& side) {
    const ToolSide::Image image = side.direction("goal_side", b_.first);
    const Flat in_plane = Flat{image.at(ToolSide::first, builder_), image.at(ToolSide::second, builder_)} *
                          conjugate(turn_of(sum_name));
    const Vector before = image.at(ToolSide::along, builder_) * axis() + in_plane.x * three_[0].first +
                          in_plane.y * three_[0].second;
    const Vector named{builder_.keep("side_x", before.x), builder_.keep("side_y", before.y),
                       builder_.keep("side_z", before.z)};
    const Scope::Turn at = builder_.value(a_);
    const Vector left = apply(without_place(a_), at.cosine, -at.sine, named);
    builder_.turn_by_pair(b_, in_frame(b_, left, scope_), "the rest of the orientation");
  }

  // --- the three parallel joints
  Flat across_of(const ToolSide::Image& seen) {
    const ex x = seen.at(ToolSide::first, builder_);
    const ex y = seen.at(ToolSide::second, builder_);
    return {scope_.clean(x - dot(three_[0].first, three_[0].point)),
            scope_.clean(y - dot(three_[0].second, three_[0].point))};
  }

  /// Returns a sum of the three angles that the two links can reach, for poses with axis b parallel to the
  /// three: there the sum is free.
  Scope::Turn free_sum() {
    const auto length = [&](std::size_t from) {
      const Flat link = across(three_[from + 1].point - three_[from].point);
      return ex(GiNaC::sqrt(scope_.clean(link.x * link.x + link.y * link.y)));
    };
    const ex first = length(0);
    const ex second = length(1);
    std::vector<kind::Reach::Seed> seeds;
    for (const Screw& screw : three_) seeds.push_back({screw.joint, sense(screw)});
    return builder_.reachable(std::string("free_") + sum_name, seeds, point_, offset_,
                              scope_.clean(GiNaC::pow(first - second, 2)),
                              scope_.clean(GiNaC::pow(first + second, 2)));
  }

  void links() {
    const Flat turned = turn_of(sum_name) * offset_;
    const Vector there =
        three_[0].point + (point_.x + turned.x) * three_[0].first + (point_.y + turned.y) * three_[0].second;
    two_link(attempt_, three_[0], three_[1], three_[2].point, there);
    Flat rest = turn_of(sum_name);
    for (const Screw* screw : {&three_[0], &three_[1]}) {
      const Scope::Turn at = builder_.value(*screw);
      rest = rest * Flat{at.cosine, -sense(*screw) * at.sine};
    }
    builder_.turn_by_pair(three_[2], {rest.x, sense(three_[2]) * rest.y},
                          "what the sum of the three leaves for " + three_[2].variable);
  }

  Attempt& attempt_;
  Builder& builder_;
  Scope& scope_;
  bool back_;   ///< the arm is read from the tool to the base
  bool inner_;  ///< c stands before the three, not after b
  Target target_;
  std::array<Screw, 3> three_;
  Screw a_, b_, c_;
  Flat point_, offset_;  ///< across the three: E x of the centre or of a point on b, and from there to the
                         ///< last of the three axes
};

}  // namespace

std::string by_parallel_axes(Attempt& attempt, std::size_t k) {
  if (!all_parallel(attempt.chain.screws, k, attempt.scope))
    return "joints " + attempt.joints(k, 3) + ": their axes are not parallel";
  const std::string reason = ParallelAxes(attempt, k).solve();
  if (!reason.empty()) return "joints " + attempt.joints(k, 3) + " are parallel, but " + reason;
  attempt.plan.structure = "the axes of joints " + attempt.joints(k, 3) + " are parallel";
  return "";
}

}  // namespace qvgen::derive::inverse
