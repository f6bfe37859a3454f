// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "derive/inverse/plan.h"
#include "derive/inverse/screw.h"

namespace qvgen::derive::inverse {

/// Two coordinates in a plane, or a complex number.
struct Flat {
  GiNaC::ex x = 0, y = 0;
};
Flat operator*(const Flat& a, const Flat& b);  ///< complex product
Flat conjugate(const Flat& a);

/// k·x + constant + m·(cos q_c, sin q_c) = 0, x a vector that another joint turns.
struct PairRow {
  Flat k;
  GiNaC::ex constant;
  Flat m;
};

/// Length of a constant plane vector, which may come with either sign, and the unit vector that goes with it.
struct Polar {
  GiNaC::ex length;
  Flat direction;
};
Polar polar(const Flat& v, const Scope& scope);

/// The squares of the lengths that |v + x| may have for a vector v and one x that turns.
struct Ring {
  Polar base, arm;
  bool base_fixed, arm_fixed;  ///< constants of the arm
  GiNaC::ex inner, outer;
};

/// The values t of a slide with inner <= |point + t along|² <= outer: those with which the joint after it can
/// follow.
struct Reach {
  Flat point, along;
  GiNaC::ex inner = 0;
  std::optional<GiNaC::ex> outer;  ///< none: however far
};

/// Appends steps to a plan: every canonical equation in its robust form, and the names of what it gives.
class Builder {
 public:
  /// A value that depends on a given joint's is not a constant of the arm: it may vanish.
  Builder(const model::Robot& robot, Scope& scope, Plan& plan);

  [[nodiscard]] Scope& scope() { return scope_; }
  [[nodiscard]] Plan& plan() { return plan_; }
  /// True if an expression is a constant of the arm: geometry and numbers only.
  [[nodiscard]] bool is_constant(const GiNaC::ex& value) const;

  [[nodiscard]] Ring ring(const Flat& v, const Flat& x0) const;

  /// alpha cos q + beta sin q = rhs; `degree` as in kind::Direction.
  void turn_by_line(const Screw& screw, const Flat& coefficients, const GiNaC::ex& rhs,
                    const std::string& equation, int degree = 1);
  /// The angle φ between direction and q: |v + x| = δ, given squares; (cos q, sign sin q) = φ * direction.
  void turn_by_distance(const Screw& screw, int sign, const Flat& v, const Flat& x0, const GiNaC::ex& square,
                        const std::string& equation);
  /// (cos q, sin q) along the direction.
  /// `length`: the direction's, if it is known without a root; `at_double_root`: it vanishes where an
  /// equation before has one.
  void turn_by_pair(const Screw& screw, const Flat& direction, const std::string& equation,
                    const GiNaC::ex& length = 0, bool at_double_root = false);
  /// Appends the step for a sum of angles, which is `choice` where it is free: names cos_NAME, sin_NAME. The
  /// direction is a number.
  Scope::Turn turn_by_pair(const std::string& name, const Flat& direction, const Scope::Turn& choice,
                           const std::string& equation);
  void slide_by_root(const Screw& screw, const GiNaC::ex& foot, const GiNaC::ex& square,
                     const GiNaC::ex& height_square, const std::string& equation);
  /// ±sqrt(square - height_square), a length that belongs to no joint; returns it by its name.
  GiNaC::ex root(const std::string& name, const GiNaC::ex& square, const GiNaC::ex& height_square,
                 const std::string& equation);
  /// t along = rhs in a plane or, y = 0, on a line; `along`, a part of a unit vector, may depend on the pose.
  void slide_by_line(const Screw& screw, const Flat& along, const Flat& rhs,
                     const std::optional<Reach>& reach, const std::string& equation);
  /// t along + s other = rhs in a plane, for another slide s that is found later.
  void slide_beside(const Screw& screw, const Flat& along, const Flat& other, const Flat& rhs,
                    const std::string& equation);
  void slide_by_value(const Screw& screw, const GiNaC::ex& value, const std::string& equation);
  /// a s - b t = k and s² + 2 g s - t² - 2 f t + gap = 0 for two slides, (a, b) parts of unit vectors.
  struct Slides {
    GiNaC::ex a, b, k, g, f, gap;
  };
  void two_slides(const Screw& s, const Screw& t, const Slides& slides, const std::string& equation);
  /// w0 + w1 cos q + ... as a conic: coefficients xx, xy, yy, x, y, one.
  void turn_by_conic(const Screw& screw, const std::array<GiNaC::ex, 6>& conic, const std::string& equation);
  /// divisor t = level + l·u and t² + 2 h t + mean + m·u = 0 for a slide t and a joint's u = (cos q, sin q).
  struct SlideAndTurn {
    GiNaC::ex divisor, h, level, mean;
    Flat l, m;
  };
  void slide_and_turn(const Screw& slide, const Screw& turn, const SlideAndTurn& equations,
                      const std::string& equation);
  /// Two equations linear in (cos u, sin u) of a joint and in (cos v, sin v) of another angle, whose
  /// coefficients are those of kind::TwoTurns: returns v, with names cos_SECOND, sin_SECOND.
  using TwoTurns = std::array<std::array<GiNaC::ex, 9>, 2>;
  Scope::Turn two_turns(const Screw& first, const std::string& second, const TwoTurns& equations,
                        bool at_most_six, const std::string& equation);
  /// The direction of a free angle for which |point + turned offset|² lies in [inner, outer]: names cos_NAME,
  /// sin_NAME.
  Scope::Turn reachable(const std::string& name, const std::vector<kind::Reach::Seed>& seeds,
                        const Flat& point, const Flat& offset, const GiNaC::ex& inner,
                        const GiNaC::ex& outer);
  void require_zero(const GiNaC::ex& residual, const GiNaC::ex& scale, const std::string& equation);
  /// Newton steps on arm start = goal, for one point or several, once all these joints are known.
  void polish(const std::vector<Screw>& arm, const std::vector<symbolic::Vector>& start,
              const std::vector<symbolic::Vector>& goal);
  /// Half of an angle given by cosine and sine: names cos_half_NAME, sin_half_NAME.
  Scope::Turn half(const std::string& name, const GiNaC::ex& cosine, const GiNaC::ex& sine);

  /// Cosine and sine (revolute) or length (prismatic, in .cosine) of a joint that a step has solved.
  [[nodiscard]] Scope::Turn value(const Screw& screw);
  /// A named value computed at the end of the latest step (or with the target, before any step).
  GiNaC::ex keep(const std::string& name, const GiNaC::ex& value);

 private:
  /// A value of the slide that the latest step solved, written with its root, so that a foot which cancels
  /// costs no digits.
  [[nodiscard]] GiNaC::ex without_foot(const GiNaC::ex& value) const;
  /// x² + y² - rhs² for a rhs with a square root in it that was solved before, as two factors without that
  /// root.
  [[nodiscard]] std::optional<Flat> without_root(const Flat& k, const GiNaC::ex& rhs) const;
  /// The unit vector from x0 to an x with |v + x| = δ that needs no root: sides are equal in pairs.
  [[nodiscard]] std::optional<Flat> straight(const Flat& v, const Flat& x0, const GiNaC::ex& square) const;
  Step& add(Kind kind, const Screw* screw, int branches, const std::string& equation);
  void set_turn(Step& step, const Screw& screw, const Flat& cosine_sine);
  void set_length(Step& step, const Screw& screw, const GiNaC::ex& value);

  Scope& scope_;
  Plan& plan_;
  GiNaC::exset constants_;
  GiNaC::exmap named_;  ///< what the names of `keep` stand for
  struct Root {
    GiNaC::ex value, foot, square;  ///< (value - foot)² = square
  };
  std::vector<Root> roots_;
};

}  // namespace qvgen::derive::inverse
