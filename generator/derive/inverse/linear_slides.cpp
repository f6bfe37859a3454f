// SPDX-License-Identifier: MIT
// Arms whose turns are found from the tool's orientation alone: three turns and three slides, or two turns
// and two slides. The slides then are linear equations.
#include <algorithm>
#include <array>

#include "derive/inverse/attempt.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/tool_side.h"
#include "derive/inverse/wrist.h"
#include "derive/inverse/wrist_axes.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

constexpr const char* equation = "the slides carry the tool point the rest of its way";

struct Slide {
  Screw screw;
  std::size_t place;  ///< in the chain
  Vector direction;   ///< as the turns have left it, seen from where the equations are written
};

/// With all turns known, what the slides have to do is linear in them. It is written as it is seen from
/// between two joints of the chain, where the fewest slides are seen turned.
class Slides {
 public:
  Slides(Attempt& attempt, Target& target) : attempt_(attempt), target_(target) {
    const auto& screws = attempt.chain.screws;
    for (std::size_t i = 0; i < screws.size(); ++i)
      if (!screws[i].revolute) slides_.push_back({screws[i], i, {}});
    origin_ = best_origin();
  }

  void solve() {
    rest_ = keep("rest", seen_from_base(origin_) - seen_from_tool(origin_));
    for (Slide& slide : slides_) slide.direction = keep("along_" + slide.screw.variable, direction(slide));
    if (slides_.size() == 2) return by_two();
    if (turns_between(slides_[0].place, slides_[2].place) == 0) return by_value();
    if (turns_between(slides_[0].place, slides_[1].place) == 0)
      return beside_pair(slides_[2], slides_[0], slides_[1]);
    if (turns_between(slides_[1].place, slides_[2].place) == 0)
      return beside_pair(slides_[0], slides_[1], slides_[2]);
    across_middle(slides_[0], slides_[1], slides_[2]);
  }

 private:
  [[nodiscard]] const Scope& scope() const { return attempt_.scope; }
  [[nodiscard]] const std::vector<Screw>& screws() const { return attempt_.chain.screws; }

  [[nodiscard]] long turns_between(std::size_t from, std::size_t to) const {
    const auto at = [&](std::size_t i) { return screws().begin() + static_cast<std::ptrdiff_t>(i); };
    return std::count_if(at(std::min(from, to)), at(std::max(from, to)),
                         [](const Screw& screw) { return screw.revolute; });
  }

  /// The gap before this joint.
  [[nodiscard]] std::size_t best_origin() const {
    const auto turned = [&](std::size_t origin) {
      long sum = 0;
      for (const Slide& slide : slides_) sum += turns_between(origin, slide.place);
      return sum;
    };
    std::size_t best = 0;
    for (std::size_t origin = 1; origin <= screws().size(); ++origin)
      if (turned(origin) < turned(best)) best = origin;
    return best;
  }

  /// Through the known turns of a joint, or back.
  [[nodiscard]] Vector turned(const Screw& screw, const Vector& v, bool back) {
    const Scope::Turn at = attempt_.builder.value(screw);
    return scope().clean(apply(screw, at.cosine, back ? ex(-at.sine) : at.sine, v));
  }

  Vector seen_from_base(std::size_t origin) {
    Vector point = target_.pose().p;
    for (std::size_t i = 0; i < origin; ++i)
      if (screws()[i].revolute)
        point = keep("before_" + screws()[i].variable, turned(screws()[i], point, true));
    return point;
  }

  Vector seen_from_tool(std::size_t origin) {
    Vector point = attempt_.chain.home.p;
    for (std::size_t i = screws().size(); i-- > origin;)
      if (screws()[i].revolute)
        point = keep("behind_" + screws()[i].variable, turned(screws()[i], point, false));
    return point;
  }

  Vector direction(const Slide& slide) {
    Vector v = slide.screw.axis;
    for (std::size_t i = slide.place; i < origin_; ++i)
      if (screws()[i].revolute) v = turned(without_place(screws()[i]), v, true);
    for (std::size_t i = slide.place; i-- > origin_;)
      if (screws()[i].revolute) v = turned(without_place(screws()[i]), v, false);
    return v;
  }

  Vector keep(const std::string& name, const Vector& v) {
    Builder& builder = attempt_.builder;
    return {builder.keep(name + "_x", v.x), builder.keep(name + "_y", v.y), builder.keep(name + "_z", v.z)};
  }

  /// One slide by the component of the rest along n, to which the slides not yet solved are perpendicular.
  void by_component(const Slide& slide, const Vector& n, const ex& divisor) {
    const ex along = scope().clean(dot(slide.direction, n)) / divisor;
    attempt_.builder.slide_by_line(slide.screw, {scope().settled(along), 0},
                                   {scope().clean(dot(rest_, n)) / divisor, 0}, {}, equation);
  }

  /// Subtracts a known slide from what is left for the others.
  void subtract(const Slide& slide) {
    const ex value = attempt_.builder.value(slide.screw).cosine;
    rest_ = keep("rest_" + slide.screw.variable, scope().clean(rest_ - value * slide.direction));
  }

  /// All three in directions that no turn changes.
  void by_value() {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector n = cross(slides_[(i + 1) % 3].direction, slides_[(i + 2) % 3].direction);
      const ex along = scope().clean(dot(slides_[i].direction, n));
      attempt_.builder.slide_by_value(slides_[i].screw, scope().clean(dot(rest_, n)) / along, equation);
    }
  }

  /// Two slides span a plane that no turn between them changes: first the other one, out of that plane.
  void beside_pair(const Slide& other, const Slide& one, const Slide& two) {
    by_component(other, scope().clean(cross(one.direction, two.direction)), GiNaC::sqrt(square_of(one, two)));
    subtract(other);
    pair(one, two);
  }

  /// Solves two slides that no turn between them changes.
  void pair(const Slide& one, const Slide& two) {
    const ex square = square_of(one, two);
    const Vector n = scope().clean(cross(one.direction, two.direction));
    const Vector across_two = scope().clean(cross(two.direction, n));
    const Vector across_one = scope().clean(cross(n, one.direction));
    attempt_.builder.slide_by_value(one.screw, scope().clean(dot(rest_, across_two)) / square, equation);
    attempt_.builder.slide_by_value(two.screw, scope().clean(dot(rest_, across_one)) / square, equation);
  }

  /// Returns the squared sine of the angle between two slides with no turn between them.
  [[nodiscard]] ex square_of(const Slide& one, const Slide& two) const {
    const Vector normal = scope().clean(cross(one.screw.axis, two.screw.axis));
    return scope().clean(dot(normal, normal));
  }

  /// Solves two slides alone. No turn changes the first one's direction, across which the other one is seen.
  void by_two() {
    const Slide &first = slides_[0], &last = slides_[1];
    if (turns_between(first.place, last.place) == 0) return pair(first, last);
    attempt_.builder.slide_by_line(last.screw, in_frame(first.screw, last.direction, scope()),
                                   in_frame(first.screw, rest_, scope()), {}, equation);
    subtract(last);
    attempt_.builder.slide_by_value(first.screw, scope().clean(dot(rest_, first.screw.axis)), equation);
  }

  /// Turns between all of them: across the one in the middle, whose direction is constant, stand the others.
  void across_middle(const Slide& first, const Slide& middle, const Slide& last) {
    const auto across = [&](const Vector& v) { return in_frame(middle.screw, v, scope()); };
    const Flat other = across(last.direction);
    attempt_.builder.slide_beside(first.screw, across(first.direction), other, across(rest_), equation);
    subtract(first);
    attempt_.builder.slide_by_line(last.screw, other, across(rest_), {}, equation);
    subtract(last);
    attempt_.builder.slide_by_value(middle.screw, scope().clean(dot(rest_, middle.screw.axis)), equation);
  }

  Attempt& attempt_;
  Target& target_;
  std::vector<Slide> slides_;
  std::size_t origin_ = 0;
  Vector rest_;
};

/// The places of the joints that turn.
std::vector<std::size_t> turns_of(const Attempt& attempt) {
  std::vector<std::size_t> turns;
  for (std::size_t i = 0; i < attempt.chain.screws.size(); ++i)
    if (attempt.chain.screws[i].revolute) turns.push_back(i);
  return turns;
}

/// Turns two joints by the orientation R = e1 e2, which takes axis 2 to where the first turn alone takes it.
void turn_two(Attempt& attempt, Target& target, const Screw& first, const Screw& second) {
  Scope& scope = attempt.scope;
  const auto named = [&](const std::string& name, const Vector& v) {
    return scope.define(attempt.plan.target, name, scope.clean(v));
  };
  const Vector goal = named("goal_axis", target.direction_image(second.axis));
  const Vector seen = named("seen_axis", target.direction_source(first.axis));
  attempt.builder.turn_by_pair(first,
                               in_frame(first, goal, scope) * conjugate(in_frame(first, second.axis, scope)),
                               "the axis of " + second.variable + " as the pose has it");
  attempt.builder.turn_by_pair(second,
                               in_frame(second, first.axis, scope) * conjugate(in_frame(second, seen, scope)),
                               "the axis of " + first.variable + " as the tool sees it");
}

}  // namespace

std::string by_three_slides(Attempt& attempt) {
  const std::vector<std::size_t> turns = turns_of(attempt);
  if (turns.size() != 3)
    return "not three joints slide: the orientation does not depend on three joints alone";
  const auto turning = wrist_axes(attempt, {turns[0], turns[1], turns[2]});
  if (!turning) return "three joints slide, but the others turn about axes that are parallel or no numbers";
  Target target(attempt.builder, attempt.chain.home);
  const auto& [first, middle, last] = turning->axes;
  solve_wrist_of_seed(attempt.builder, first, middle, last, turning->seen(target.orientation()));
  Slides(attempt, target).solve();
  polish_pose(attempt, target);
  attempt.plan.structure = "three joints turn the tool, and what three slides then have to do is linear";
  return "";
}

std::string by_two_slides(Attempt& attempt) {
  const std::vector<std::size_t> turns = turns_of(attempt);
  if (turns.size() != 2 || attempt.chain.screws.size() != 4) return "not two of four joints slide";
  const auto& screws = attempt.chain.screws;
  const Screw &first = screws[turns[0]], &second = screws[turns[1]];
  if (attempt.scope.is_zero(cross(first.axis, second.axis)))
    return "two joints slide, but the others turn about parallel axes";
  if (const std::string reason = dependent_joints(attempt, {0, 1, 2, 3}, false); !reason.empty())
    return reason;
  Target target(attempt.builder, attempt.chain.home);
  attempt.plan.candidates = true;
  turn_two(attempt, target, first, second);
  Slides(attempt, target).solve();
  polish_pose(attempt, target);
  attempt.plan.structure = "two joints turn the tool, and what two slides then have to do is linear";
  return "";
}

}  // namespace qvgen::derive::inverse
