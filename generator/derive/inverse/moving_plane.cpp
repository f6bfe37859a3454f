// SPDX-License-Identifier: MIT
// Arms with three joints in a row that move a plane in itself: parallel turns, or of five joints turns and
// slides across them. Directions and heights along the plane's normal hold two of the other joints; then the
// sum of the three's turns is known, and two of the three place a point in the plane.
#include <algorithm>
#include <optional>

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

/// Finds the first turn of three joints that move in a plane, all other joints of the arm being turns. Six
/// joints with a slide among the three are left to the elimination, which sees all of their singular poses.
std::optional<std::size_t> turn_of_plane(const std::vector<Screw>& screws, std::size_t k,
                                         const Scope& scope) {
  std::optional<std::size_t> turn;
  for (std::size_t i = 0; i < screws.size(); ++i) {
    const bool is_of_plane = i >= k && i < k + 3;
    if (!screws[i].revolute && (!is_of_plane || screws.size() == 6)) return std::nullopt;
    if (screws[i].revolute && is_of_plane && !turn) turn = i;
  }
  if (!turn) return std::nullopt;
  for (std::size_t i = k; i < k + 3; ++i) {
    const Vector& normal = screws[*turn].axis;
    const bool serves = screws[i].revolute ? scope.is_zero(cross(normal, screws[i].axis))
                                           : scope.is_zero(dot(normal, screws[i].axis));
    if (!serves) return std::nullopt;
  }
  return turn;
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

/// An arm with three joints E that move in a plane, and so keep heights and directions along its normal: E
/// e_a e_b = G, and G, the tool's side, depends on the pose and on the sixth joint c alone, if there is one.
class MovingPlane {
 public:
  MovingPlane(Attempt& attempt, std::size_t k)
      : attempt_(attempt),
        builder_(attempt.builder),
        scope_(attempt.scope),
        back_(k >= 2),
        inner_(k == 1 || k == 2),
        target_(attempt.builder, attempt.chain.home) {
    const std::vector<Screw> s = back_ ? mirrored(attempt.chain.screws) : attempt.chain.screws;
    const std::size_t first = inner_ ? 1 : 0;
    three_ = {s[first], s[first + 1], s[first + 2]};
    turn_ = *std::find_if(three_.begin(), three_.end(), [](const Screw& screw) { return screw.revolute; });
    a_ = s[first + 3];
    b_ = s[inner_ ? 5 : 4];
    if (s.size() == 6) c_ = s[inner_ ? 0 : 5];
  }

  std::string solve() {
    const auto centre = meeting_point(a_, b_, scope_);
    if (centre && is_wrist(turn_, a_, b_, scope_)) {
      by_wrist(*centre);
    } else if (!c_) {
      return "the axes of the other two do not meet in a point across them";
    } else if (const std::string reason = by_pair(); !reason.empty()) {
      return reason;
    }
    if (const std::string reason = links(); !reason.empty()) return reason;
    polish_pose(attempt_, target_);
    return "";
  }

 private:
  [[nodiscard]] const Vector& axis() const { return turn_.axis; }
  [[nodiscard]] Flat across(const Vector& v) const { return in_frame(turn_, v, scope_); }
  [[nodiscard]] int sense(const Screw& screw) const {
    return scope_.sample(dot(axis(), screw.axis)) > 0 ? 1 : -1;
  }
  [[nodiscard]] ToolSide tool_side() { return {builder_, target_, turn_, *c_, {back_, inner_}}; }

  // --- axes a and b meet: their common point keeps its height, and the sum of the three makes a wrist with
  // them
  void by_wrist(const Vector& centre) {
    // The centre seen from the three is E centre, and a point of theirs stands off from it by a constant of
    // the arm.
    const Flat there = seen_centre(centre);
    point_ = {builder_.keep("centre_x", there.x), builder_.keep("centre_y", there.y)};
    offset_ = across(reference() - centre);
    const symbolic::Quaternion whole =
        back_ ? symbolic::inverse(target_.orientation()) : target_.orientation();
    const std::vector<Screw> known = c_ ? std::vector<Screw>{*c_} : std::vector<Screw>{};
    const symbolic::Quaternion rotation =
        inner_ ? without_first(builder_, known, whole) : without_last(builder_, known, whole);
    const Scope::Turn free = free_sum();
    Screw sum = turn_;
    sum.variable = sum_name;
    sum.joint = -1;
    solve_wrist(builder_, sum, a_, b_, rotation, &free);
  }

  /// Returns the centre as the pose has it, across the three; its height gives joint c.
  Flat seen_centre(const Vector& centre) {
    if (!c_) return across(scope_.clean(target_.image(centre) - turn_.point));
    const ToolSide::Image seen = tool_side().point("goal", centre);
    const Block::Form height = seen.form(ToolSide::along, scope_);
    builder_.turn_by_line(*c_, height.coefficients, scope_.clean(dot(axis(), centre) - height.constant),
                          height_equation());
    return across_of(seen);
  }

  /// A point of the three: on the axis of the last one if it turns, else on that of the first that does.
  [[nodiscard]] const Vector& reference() const { return three_[2].revolute ? three_[2].point : turn_.point; }

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
    const auto with_c = inner_ ? std::nullopt : meeting_point(b_, *c_, scope_);
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
    if (vanishes(tilt.row.k)) return one_by_one(*c_, &PairRow::m, tilt, a_, height);
    if (vanishes(height.row.k)) return one_by_one(*c_, &PairRow::m, height, a_, tilt);
    if (vanishes(tilt.row.m)) return one_by_one(a_, &PairRow::k, tilt, *c_, height);
    if (vanishes(height.row.m)) return one_by_one(a_, &PairRow::k, height, *c_, tilt);
    return eliminate(builder_, {a_, 1, {}, {1, 0}}, *c_, {tilt.row, height.row});
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
    const auto off = [&](const Vector& n) { return dot(n, reference()) - moving.at_value(n, builder_); };
    offset_ = named("offset", {scope_.clean(off(turn_.first)), scope_.clean(off(turn_.second))});
  }

  /// E turns axis b as a has left it into the tool's side's.
  void solve_sum(const Block& tilting, const ToolSide::Image& tilted) {
    const Flat from{tilting.at_value(turn_.first, builder_), tilting.at_value(turn_.second, builder_)};
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
    const Vector before =
        image.at(ToolSide::along, builder_) * axis() + in_plane.x * turn_.first + in_plane.y * turn_.second;
    const Vector named{builder_.keep("side_x", before.x), builder_.keep("side_y", before.y),
                       builder_.keep("side_z", before.z)};
    const Scope::Turn at = builder_.value(a_);
    const Vector left = apply(without_place(a_), at.cosine, -at.sine, named);
    builder_.turn_by_pair(b_, in_frame(b_, left, scope_), "the rest of the orientation");
  }

  // --- the three joints of the plane
  Flat across_of(const ToolSide::Image& seen) {
    const ex x = seen.at(ToolSide::first, builder_);
    const ex y = seen.at(ToolSide::second, builder_);
    return {scope_.clean(x - dot(turn_.first, turn_.point)),
            scope_.clean(y - dot(turn_.second, turn_.point))};
  }

  /// Returns a sum of the angles that the two links can reach, for poses with axis b parallel to the plane's
  /// normal: there the sum is free.
  Scope::Turn free_sum() {
    std::vector<kind::Reach::Seed> seeds;
    for (const Screw& screw : three_)
      if (screw.revolute) seeds.push_back({screw.joint, sense(screw)});
    const auto [inner, outer] = reached();
    return builder_.reachable(std::string("free_") + sum_name, seeds, point_, offset_, inner, outer);
  }

  /// Squares of the distances from the first joint's axis at which the other two reach a point: between those
  /// of two links, or beyond that of a slide. Where a slide comes first or last, any is tried.
  std::pair<ex, ex> reached() const {
    const ex far = GiNaC::pow(10, 6) * symbolic::symbol(names::size_square);
    const auto& [first, middle, last] = three_;
    if (!first.revolute || !last.revolute) return {0, far};
    if (!middle.revolute) {
      const ex beside = dot(cross(middle.axis, axis()), last.point - first.point);
      return {scope_.clean(GiNaC::pow(scope_.clean(beside), 2)), far};
    }
    const auto length = [&](const Screw& from, const Screw& to) {
      const Flat link = across(to.point - from.point);
      return ex(GiNaC::sqrt(scope_.clean(link.x * link.x + link.y * link.y)));
    };
    const ex one = length(first, middle);
    const ex two = length(middle, last);
    return {scope_.clean(GiNaC::pow(one - two, 2)), scope_.clean(GiNaC::pow(one + two, 2))};
  }

  /// A point of the plane by its coordinates from the axis of the first turn.
  [[nodiscard]] Vector in_space(const Flat& v) const {
    return turn_.point + v.x * turn_.first + v.y * turn_.second;
  }

  /// Two of the joints bring a point of the third one's axis, which that does not move, to its place.
  std::string links() {
    const auto& [first, middle, last] = three_;
    const Flat turned = turn_of(sum_name) * offset_;
    const Flat there{point_.x + turned.x, point_.y + turned.y};
    if (last.revolute) {
      const std::string reason = place_by_two(attempt_, first, middle, last.point, in_space(there));
      if (reason.empty()) turn_by_rest(last);
      return reason;
    }
    if (first.revolute) {
      const Flat back = conjugate(turn_of(sum_name)) * there;
      const std::string reason =
          place_by_two(attempt_, reversed(last), reversed(middle), first.point, in_space({-back.x, -back.y}));
      if (reason.empty()) turn_by_rest(first);
      return reason;
    }
    slide_around(in_space(there) - turn_.point);
    turn_by_rest(middle);
    return "";
  }

  /// Two slides, the last of which the turn between them has turned by the sum, go the rest of the way.
  void slide_around(const Vector& rest) {
    const Flat turned = turn_of(sum_name) * across(three_[2].axis);
    const Vector direction = turned.x * turn_.first + turned.y * turn_.second;
    const std::string equation = "the slides carry the point the rest of its way";
    builder_.slide_by_line(three_[2], in_frame(three_[0], direction, scope_),
                           in_frame(three_[0], rest, scope_), {}, equation);
    const ex value = builder_.value(three_[2]).cosine;
    builder_.slide_by_value(three_[0], dot(three_[0].axis, rest - value * direction), equation);
  }

  /// Turns one of the three by what the others leave of the sum.
  void turn_by_rest(const Screw& turn) {
    Flat rest = turn_of(sum_name);
    for (const Screw& screw : three_) {
      if (!screw.revolute || screw.joint == turn.joint) continue;
      const Scope::Turn at = builder_.value(screw);
      rest = rest * Flat{at.cosine, -sense(screw) * at.sine};
    }
    builder_.turn_by_pair(turn, {rest.x, sense(turn) * rest.y},
                          "what the sum of the three leaves for " + turn.variable);
  }

  Attempt& attempt_;
  Builder& builder_;
  Scope& scope_;
  bool back_;   ///< the arm is read from the tool to the base
  bool inner_;  ///< c stands before the three, not after b
  Target target_;
  std::array<Screw, 3> three_;
  Screw turn_;  ///< the first of the three that turns: its axis is the plane's normal
  Screw a_, b_;
  std::optional<Screw> c_;
  Flat point_, offset_;  ///< across the three: E x of the centre or of a point on b, and from there to the
                         ///< point of reference
};

}  // namespace

std::string by_moving_plane(Attempt& attempt, std::size_t k) {
  const auto& screws = attempt.chain.screws;
  if (!turn_of_plane(screws, k, attempt.scope))
    return "joints " + attempt.joints(k, 3) + ": their axes are not parallel";
  const bool are_turns =
      std::all_of(&screws[k], &screws[k] + 3, [](const Screw& each) { return each.revolute; });
  const std::string reason = MovingPlane(attempt, k).solve();
  if (!reason.empty())
    return "joints " + attempt.joints(k, 3) + (are_turns ? " are parallel, but " : " move in a plane, but ") +
           reason;
  attempt.plan.candidates = screws.size() < 6;
  attempt.plan.structure = are_turns ? "the axes of joints " + attempt.joints(k, 3) + " are parallel"
                                     : "joints " + attempt.joints(k, 3) + " move in a plane";
  return "";
}

}  // namespace qvgen::derive::inverse
