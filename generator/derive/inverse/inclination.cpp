// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/block.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/in_plane.h"
#include "derive/inverse/tool_side.h"
#include "symbolic/model.h"

/// A position and an inclination, by five joints e0 e1 e2 e3 e4. The first turns the whole arm about z, the
/// next three move it in one plane across their common axis y, the last rolls the tool.
///
/// The pose is taken for its position p and for z as the tool sees it, which the first joint does not change:
/// s = e4^-1 Rot(y, -sum) z. Its height along y holds e4 alone, and then its direction across y is the sum.
/// With both known the others place the tool point (in_plane.h).
namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::dot;
using symbolic::Vector;

namespace {

class Inclination {
 public:
  explicit Inclination(Attempt& attempt)
      : builder_(attempt.builder),
        scope_(attempt.scope),
        base_(attempt.chain.screws[0]),
        last_(attempt.chain.screws[3]),
        roll_(attempt.chain.screws[4]),
        tool_(attempt.chain.home.p),
        target_(attempt.builder, attempt.chain.home) {}

  void solve_roll() {
    seen_ = scope_.define(builder_.plan().target, "seen", scope_.clean(target_.direction_source(base_.axis)));
    const Block::Form height = rolled().form(last_.axis, scope_);
    builder_.turn_by_line(roll_, height.coefficients,
                          scope_.clean(dot(last_.axis, base_.axis) - height.constant),
                          "angle of the first axis to the axis of " + last_.variable + ", seen by the tool");
  }

  /// Cosine and sine of the sum of the turns in the plane.
  Scope::Turn solve_sum() {
    const Block block = rolled();
    const Flat now{block.at_value(last_.first, builder_), block.at_value(last_.second, builder_)};
    return builder_.turn_by_pair("sum", in_frame(last_, base_.axis, scope_) * conjugate(now),
                                 Scope::Turn{1, 0},
                                 "direction of the first axis across the axis of " + last_.variable);
  }

  /// The vector from axis 3 to the tool point as the sum and the roll have turned it.
  Vector beyond(const Scope::Turn& sum) {
    const Block block = block_of(roll_, 1, tool_, scope_);
    const auto from_axis = [&](const Vector& n) {
      return block.at_value(n, builder_) - scope_.clean(dot(n, last_.point));
    };
    const Flat turned = Flat{sum.cosine, sum.sine} * Flat{from_axis(last_.first), from_axis(last_.second)};
    const Vector all = from_axis(last_.axis) * last_.axis + turned.x * last_.first + turned.y * last_.second;
    return {builder_.keep("beyond_x", all.x), builder_.keep("beyond_y", all.y),
            builder_.keep("beyond_z", all.z)};
  }

  [[nodiscard]] const Vector& goal() const { return target_.pose().p; }

 private:
  /// The first axis as the tool sees it, turned by the roll.
  [[nodiscard]] Block rolled() const { return block_of(without_place(roll_), 1, seen_, scope_); }

  Builder& builder_;
  Scope& scope_;
  const Screw &base_, &last_, &roll_;
  Vector tool_;
  Target target_;
  Vector seen_;
};

}  // namespace

std::string by_inclination(Attempt& attempt) {
  if (std::string missing = missing_plane(attempt); !missing.empty()) return missing;
  const auto& screws = attempt.chain.screws;
  if (!screws[4].revolute) return "the last of the five joints that are solved for has to turn";
  if (std::string dependent = dependent_joints_of_inclination(attempt); !dependent.empty()) return dependent;
  Inclination inclination(attempt);
  inclination.solve_roll();
  const Scope::Turn sum = inclination.solve_sum();
  const std::string reason =
      place_in_plane(attempt, {sum.cosine, sum.sine}, inclination.beyond(sum), inclination.goal());
  if (!reason.empty()) return reason;
  attempt.plan.structure = "joints " + attempt.joints(1, 3) + " move in one plane: the inclination tells " +
                           screws[4].variable + " and where the axis of " + screws[3].variable +
                           " is, the others place it";
  return "";
}

}  // namespace qvgen::derive::inverse
