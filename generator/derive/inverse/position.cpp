// SPDX-License-Identifier: MIT
#include "derive/inverse/position.h"

#include <map>
#include <optional>
#include <set>

#include "derive/inverse/block.h"
#include "derive/inverse/elements.h"
#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "derive/inverse/pair_system.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

ex square_of(const ex& value) { return GiNaC::pow(value, 2); }
ex square_of(const Vector& v) { return square_of(v.x) + square_of(v.y) + square_of(v.z); }

class Position {
 public:
  Position(Builder& builder, const Screw& a, const Screw& b, const Screw& c, const Vector& start,
           const Vector& goal)
      : builder_(builder),
        scope_(builder.scope()),
        b_(b),
        a_(block_of(a, -1, goal, scope_)),
        c_(block_of(c, 1, start, scope_)),
        start_(start),
        goal_(goal) {}

  std::string solve() {
    const std::string reason = b_.revolute ? around_axis() : along_axis();
    if (!reason.empty()) return reason;
    middle();
    builder_.polish({a_.screw, b_, c_.screw}, {start_}, {goal_});
    return "";
  }

 private:
  std::string name(const Block& block) const { return block.screw.variable; }

  /// Notes the elements that the latest step compares, if the joints are the first ones and the equation is
  /// one of M_b = N_b.
  void compares(const Elements& elements) {
    const bool in_order = a_.screw.joint >= 0 && a_.screw.joint < b_.joint && b_.joint < c_.screw.joint;
    if (in_order) builder_.plan().steps.back().elements = elements;
  }

  // --- the outer joints when b is revolute
  std::string around_axis() {
    const bool plane_a = a_.depends(b_.axis, scope_);
    const bool plane_c = c_.depends(b_.axis, scope_);
    if (!plane_a && !plane_c) return "the axes of all three joints are parallel: nothing moves along them";
    if (!plane_c) return by_height_then_distance(a_, c_);
    if (!plane_a) return by_height_then_distance(c_, a_);
    const std::optional<Vector> meets_a = common_point(a_.screw);
    const std::optional<Vector> meets_c = common_point(c_.screw);
    if (meets_a && distance_depends(c_, *meets_a)) return by_distance_then_height(c_, a_, *meets_a, meets_c);
    if (meets_c && distance_depends(a_, *meets_c)) return by_distance_then_height(a_, c_, *meets_c, meets_a);
    if (meets_a || meets_c)
      return "a joint turns about a point that it does not move: its angle changes nothing";
    if (!a_.screw.revolute && !c_.screw.revolute) return two_slides();
    if (!a_.screw.revolute) return slide_and_turn(a_, c_);
    if (!c_.screw.revolute) return slide_and_turn(c_, a_);
    return eliminate_one(builder_, a_, c_, [this](const Block& u, const Block& w) {
      return std::array{same_height(b_.axis, u, w, scope_), same_distance(b_.point, u, w, scope_)};
    });
  }

  /// The height along axis b holds `u` alone; then the distance from axis b, in its plane, gives `w`.
  std::string by_height_then_distance(const Block& u, const Block& w) {
    turn_or_slide(u, b_.axis, w.form(b_.axis, scope_).constant,
                  "height along the axis of " + b_.variable + ": the same", within_distances(u, w));
    compares(element_along(b_, b_.axis, scope_));
    keep_flat(u);
    common_square_ =
        builder_.keep("square_" + name(w), square_of(flats_[name(u)].x) + square_of(flats_[name(u)].y));
    return by_distance(w, b_.point, common_square_, true);
  }

  /// The distance from r holds `u` alone; then the height gives `w` (or its own distance from its own point).
  std::string by_distance_then_height(const Block& u, const Block& w, const Vector& r,
                                      const std::optional<Vector>& own) {
    const Vector arm = scope_.clean(point_of(w) - r);
    const ex square = builder_.keep("square_" + name(u), square_of(arm));
    const std::string reason = by_distance(u, r, square, false);
    if (!reason.empty()) return reason;
    // The equation that solves the other joint is then at an end of its range: see turn_by_pair.
    comes_onto_axis_ = u.comes_onto(b_, scope_);
    keep_flat(u);
    if (own && distance_depends(w, *own)) {
      const ex other = builder_.keep("square_" + name(w), square_of(scope_.clean(point_of(u) - *own)));
      by_distance(w, *own, other, false);
    } else {
      const ex height = builder_.keep("height_" + name(w), u.at_value(b_.axis, builder_));
      turn_or_slide(w, b_.axis, height, "height along the axis of " + b_.variable + ": the same");
      compares(element_along(b_, b_.axis, scope_));
    }
    keep_flat(w);
    return "";
  }

  /// Any point that the joint carries along has this one's distance from a point on its own axis.
  Vector point_of(const Block& block) const {
    if (!block.screw.revolute) return block.base;
    return scope_.clean(block.base + block.x0.x * block.screw.first + block.x0.y * block.screw.second);
  }

  /// n·point(u) = rhs for the joint of u; the rhs may hold the other joint's solved value. A slide that its
  /// equation does not see at some pose is free, as far as the joint after it can follow.
  void turn_or_slide(const Block& u, const Vector& n, const ex& rhs, const std::string& equation,
                     const std::optional<Reach>& reach = {}) {
    const Block::Form form = u.form(n, scope_);
    const ex right = scope_.clean(rhs - form.constant);
    if (u.screw.revolute) return builder_.turn_by_line(u.screw, form.coefficients, right, equation);
    builder_.slide_by_line(u.screw, {form.coefficients.x, 0}, {right, 0}, reach, equation);
  }

  /// Components of a vector across axis b.
  Flat across(const Vector& v) const {
    return {scope_.clean(dot(v, b_.first)), scope_.clean(dot(v, b_.second))};
  }
  Flat slope(const Block& slide) const { return across(ex(slide.sign) * slide.screw.axis); }

  /// Values of u at which the other joint finds a point as far from axis b.
  std::optional<Reach> within_distances(const Block& u, const Block& w) const {
    if (u.screw.revolute) return std::nullopt;
    Reach reach{across(u.base - b_.point), slope(u), 0, std::nullopt};
    if (!w.screw.revolute) {
      const Flat beside = across(w.base - b_.point) * conjugate(slope(w));
      reach.inner = square_of(beside.y);
      return reach;
    }
    const Ring ring = builder_.ring(foot_of(w, b_.point), w.x0);
    reach.inner = ring.inner;
    reach.outer = ring.outer;
    return reach;
  }

  /// Values of u at which w can reach u's height along n, across axis b.
  std::optional<Reach> within_heights(const Block& u, const Block& w, const Vector& n) const {
    if (u.screw.revolute || (!w.screw.revolute && sees_always(w, n))) return std::nullopt;
    if (!w.screw.revolute) {
      // Far enough for any slide across; along axis b the slide w cannot make up for u at all.
      const ex far = GiNaC::pow(10, 6) * symbolic::symbol(names::size_square);
      const Flat k = slope(w);
      return Reach{across(u.base - w.base), slope(u), 0, scope_.clean(k.x * k.x + k.y * k.y) * far};
    }
    const Block::Form own = u.form(n, scope_);
    const Block::Form other = w.form(n, scope_);
    const Flat& k = other.coefficients;
    return Reach{{scope_.clean(own.constant - other.constant), 0},
                 {own.coefficients.x, 0},
                 0,
                 scope_.clean(k.x * k.x + k.y * k.y)};
  }

  /// |point(u) - r|² = square, in space or in the plane of axis b.
  std::string by_distance(const Block& u, const Vector& r, const ex& square, bool planar) {
    const Vector arm = scope_.clean(u.base - r);
    const std::string equation = std::string("distance from ") +
                                 (planar ? "the axis" : "a point on the axis") + " of " + b_.variable +
                                 ": the same";
    if (!u.screw.revolute) {
      const ex foot = scope_.clean(-u.sign * dot(u.screw.axis, arm));
      // Squares as they stand: multiplied out they would cancel where the height is small.
      const auto along = [&](const Vector& n) { return square_of(scope_.clean(dot(n, arm))); };
      const ex height =
          planar ? along(cross(b_.axis, u.screw.axis)) : along(u.screw.first) + along(u.screw.second);
      builder_.slide_by_root(u.screw, foot, square, height, equation);
      compares(planar ? elements_across(b_, scope_) : vector_elements(b_));
      return "";
    }
    const Flat v = foot_of(u, r);
    if (scope_.is_zero(v.x) && scope_.is_zero(v.y))
      return "the axes of " + name(u) + " and " + b_.variable + " coincide";
    const ex along = planar ? ex(0) : scope_.clean(dot(u.screw.axis, arm));
    builder_.turn_by_distance(u.screw, u.sign, v, u.x0,
                              scope_.is_zero(along) ? square : ex(square - square_of(along)), equation);
    compares(planar ? elements_across(b_, scope_) : vector_elements(b_));
    return "";
  }

  /// From r to the axis of a revolute joint, across that axis.
  Flat foot_of(const Block& u, const Vector& r) const {
    const Vector arm = scope_.clean(u.base - r);
    return {scope_.clean(dot(u.screw.first, arm)), scope_.clean(dot(u.screw.second, arm))};
  }

  bool distance_depends(const Block& u, const Vector& r) const {
    if (!u.screw.revolute) return true;
    const Flat v = foot_of(u, r);
    return !scope_.is_zero(v.x) || !scope_.is_zero(v.y);
  }

  /// Returns the point where axis b meets another revolute axis, if it does.
  std::optional<Vector> common_point(const Screw& other) const {
    if (!other.revolute) return std::nullopt;
    const Vector normal = cross(b_.axis, other.axis);
    const ex size = scope_.clean(dot(normal, normal));
    if (scope_.is_zero(size)) return std::nullopt;
    const Vector between = scope_.clean(other.point - b_.point);
    if (!scope_.is_zero(dot(normal, between))) return std::nullopt;
    const ex along = scope_.clean(dot(cross(between, other.axis), normal)) / size;
    return scope_.clean(b_.point + along * b_.axis);
  }

  // --- plane coordinates about axis b, and joint b itself
  void keep_flat(const Block& u) {
    if (!b_.revolute || kept_.count(name(u)) > 0) return;
    const auto along = [&](const Vector& n) {
      return u.at_value(n, builder_) - scope_.clean(dot(n, b_.point));
    };
    Step& step = builder_.plan().steps.back();
    flats_[name(u)] = {scope_.define(step.after, names::plane(name(u), "x"), along(b_.first)),
                       scope_.define(step.after, names::plane(name(u), "y"), along(b_.second))};
    kept_.insert(name(u));
  }

  void middle() {
    if (!b_.revolute) {
      builder_.slide_by_value(b_, a_.at_value(b_.axis, builder_) - c_.at_value(b_.axis, builder_),
                              "the displacement along " + b_.variable);
      compares(element_along(b_, b_.axis, scope_));
      return;
    }
    keep_flat(a_);
    keep_flat(c_);
    const Flat turn = flats_[name(a_)] * conjugate(flats_[name(c_)]);
    builder_.turn_by_pair(
        b_, turn, "the turn about the axis of " + b_.variable + " from one side's point to the other's",
        common_square_, comes_onto_axis_);
    compares(elements_across(b_, scope_));
  }

  // --- the outer joints when b is prismatic
  std::optional<Vector> blind_direction(const Block& u) const {
    if (!u.screw.revolute) {
      const Vector n = scope_.clean(cross(u.screw.axis, b_.axis));
      if (scope_.is_zero(n)) return std::nullopt;
      return n;
    }
    if (!scope_.is_zero(dot(u.screw.axis, b_.axis))) return std::nullopt;
    return u.screw.axis;
  }

  std::string along_axis() {
    const std::optional<Vector> without_a = blind_direction(a_);
    const std::optional<Vector> without_c = blind_direction(c_);
    const bool c_first = without_a && c_.depends(*without_a, scope_);
    const bool a_first = without_c && a_.depends(*without_c, scope_);
    // A turn that the pose may lose comes after a slide, which is then the free one, in reach of the turn.
    const bool c_may_wait = a_first && c_.screw.revolute && !a_.screw.revolute;
    if (c_first && !(c_may_wait && !sees_always(c_, *without_a)))
      return by_two_planes(c_, a_, *without_a, without_c);
    if (a_first) return by_two_planes(a_, c_, *without_c, without_a);
    if (without_a || without_c)
      return "a plane along " + b_.variable + " is moved by neither of the other joints";
    if (!a_.screw.revolute || !c_.screw.revolute) return "two parallel prismatic joints";
    if (scope_.is_zero(cross(a_.screw.axis, c_.screw.axis)) && scope_.is_zero(cross(a_.screw.axis, b_.axis)))
      return two_link_column();
    return eliminate_one(builder_, a_, c_, [this](const Block& u, const Block& w) {
      return std::array{same_height(b_.first, u, w, scope_), same_height(b_.second, u, w, scope_)};
    });
  }

  std::string by_two_planes(const Block& u, const Block& w, const Vector& without_w,
                            const std::optional<Vector>& without_u) {
    const std::string equation = "perpendicular to " + b_.variable + ", nothing changes";
    const Vector other = scope_.clean(cross(without_w, b_.axis));
    turn_or_slide(u, without_w, w.form(without_w, scope_).constant, equation, within_heights(u, w, other));
    compares(element_along(b_, without_w, scope_));
    if (without_u && w.depends(*without_u, scope_) && sees_always(w, *without_u)) {
      turn_or_slide(w, *without_u, u.form(*without_u, scope_).constant, equation);
      compares(element_along(b_, *without_u, scope_));
      return "";
    }
    if (!w.depends(other, scope_)) return name(w) + " does not move the point across " + b_.variable;
    if (w.screw.revolute || sees_always(w, other)) {
      turn_or_slide(w, other, builder_.keep("height_" + name(w), u.at_value(other, builder_)), equation);
      compares(element_along(b_, other, scope_));
      return "";
    }
    // Both components: each alone would lose the slide at some pose.
    const auto offset = [&](const Vector& n, const char* part) {
      return builder_.keep("height_" + name(w) + part,
                           scope_.clean(u.at_value(n, builder_) - w.form(n, scope_).constant));
    };
    const Flat rhs{offset(b_.first, "_x"), offset(b_.second, "_y")};
    builder_.slide_by_line(w.screw, slope(w), rhs, {}, equation);
    compares(elements_across(b_, scope_));
    return "";
  }

  /// True if the component along n never loses the joint, whatever the pose.
  bool sees_always(const Block& u, const Vector& n) const {
    const Flat& k = u.form(n, scope_).coefficients;
    return builder_.is_constant(k.x) && builder_.is_constant(k.y);
  }

  /// a, b, c parallel, b prismatic: a two-link arm in the plane.
  std::string two_link_column() {
    const ex square = builder_.keep("square_" + name(c_), square_of(a_.x0.x) + square_of(a_.x0.y));
    const Vector arm = scope_.clean(c_.base - a_.screw.point);
    const Flat v{scope_.clean(dot(c_.screw.first, arm)), scope_.clean(dot(c_.screw.second, arm))};
    if (scope_.is_zero(v.x) && scope_.is_zero(v.y))
      return "the axes of " + name(a_) + " and " + name(c_) + " coincide";
    builder_.turn_by_distance(c_.screw, 1, v, c_.x0, square,
                              "distance from the axis of " + name(a_) + ": the same");
    compares(elements_across(a_.screw, scope_));
    const ex x = c_.at_value(a_.screw.first, builder_) - dot(a_.screw.first, a_.screw.point);
    const ex y = c_.at_value(a_.screw.second, builder_) - dot(a_.screw.second, a_.screw.point);
    const Flat turn = conjugate(Flat{scope_.clean(x), scope_.clean(y)} * conjugate(a_.x0));
    builder_.turn_by_pair(a_.screw, turn, "the turn about the axis of " + name(a_));
    compares(elements_across(a_.screw, scope_));
    return "";
  }

  // --- both outer joints at once
  std::string two_slides() {
    const Block::Form a = a_.form(b_.axis, scope_);
    const Block::Form c = c_.form(b_.axis, scope_);
    const Vector g = scope_.clean(a_.base - b_.point);
    const Vector f = scope_.clean(c_.base - b_.point);
    builder_.two_slides(
        a_.screw, c_.screw,
        {a.coefficients.x, c.coefficients.x, scope_.clean(c.constant - a.constant),
         scope_.clean(a_.sign * dot(a_.screw.axis, g)), scope_.clean(c_.sign * dot(c_.screw.axis, f)),
         square_of(g) - square_of(f)},
        "height along the axis of " + b_.variable + " and distance from a point on it: the same");
    return "";
  }

  std::string slide_and_turn(const Block& slide, const Block& turn) {
    const Block::Form s = slide.form(b_.axis, scope_);
    const Block::Form t = turn.form(b_.axis, scope_);
    const Vector g = scope_.clean(slide.base - b_.point);
    const Vector arm = scope_.clean(turn.base - b_.point);
    const Flat& f = turn.form(ex(2) * arm, scope_).coefficients;
    const ex own = square_of(g);
    const ex other = square_of(arm) + square_of(turn.x0.x) + square_of(turn.x0.y);
    builder_.slide_and_turn(
        slide.screw, turn.screw,
        {s.coefficients.x,
         scope_.clean(slide.sign * dot(slide.screw.axis, g)),
         scope_.clean(t.constant - s.constant),
         own - other,
         t.coefficients,
         {-f.x, -f.y}},
        "height along the axis of " + b_.variable + " and distance from a point on it: the same");
    return "";
  }

  Builder& builder_;
  Scope& scope_;
  Screw b_;
  Block a_;
  Block c_;
  Vector start_;
  Vector goal_;
  std::set<std::string> kept_;
  std::map<std::string, Flat> flats_;
  ex common_square_;  ///< of both points' distances from axis b, where the equation of one joint is that they
                      ///< agree
  /// At some poses both points lie on axis b, where an equation has a double root.
  bool comes_onto_axis_ = false;
};

}  // namespace

std::string solve_position(Builder& builder, const Screw& a, const Screw& b, const Screw& c,
                           const Vector& start, const Vector& goal) {
  return Position(builder, a, b, c, start, goal).solve();
}

}  // namespace qvgen::derive::inverse
