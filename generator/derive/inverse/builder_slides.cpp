// SPDX-License-Identifier: MIT
// Steps that move a slide: by a root, a value, a line, or two equations with another joint.
#include "derive/inverse/builder.h"
#include "derive/inverse/names.h"
#include "derive/inverse/step_values.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;

void Builder::slide_by_root(const Screw& screw, const ex& foot, const ex& square, const ex& height_square,
                            const std::string& equation) {
  Step& step = add(kind::Root{}, &screw, 2, equation);
  step.before.output("square", square - height_square);
  step.before.output("scale", height_square);
  step.degenerate = "the point at the foot of the perpendicular: the two solutions coincide";
  set_length(step, screw, foot + result_length());
  roots_.push_back({symbolic::symbol(screw.variable), foot, square - height_square});
}

ex Builder::root(const std::string& name, const ex& square, const ex& height_square,
                 const std::string& equation) {
  Step& step = add(kind::Root{}, nullptr, 2, equation);
  step.unknown = name;
  step.before.output("square", square - height_square);
  step.before.output("scale", height_square);
  step.degenerate = "the two solutions coincide";
  const ex length = scope_.length(name);
  step.after.output(symbolic::symbol(name), result_length());
  return length;
}

void Builder::slide_by_value(const Screw& screw, const ex& value, const std::string& equation) {
  set_length(add(kind::Linear{}, &screw, 1, equation), screw, value);
}

void Builder::slide_by_line(const Screw& screw, const Flat& along, const Flat& rhs,
                            const std::optional<Reach>& reach, const std::string& equation) {
  const bool flat = !along.y.is_zero();
  if (!flat && is_constant(along.x)) return slide_by_value(screw, rhs.x / along.x, equation);
  kind::Line line{flat};
  using Reached = kind::Line::Reach;
  if (reach) line.reach = reach->outer ? Reached::between : Reached::beyond;
  Step& step = add(line, &screw, 1, equation);
  if (flat) {
    give(step, "", along);
    give(step, "rhs_", rhs);
  } else {
    step.before.output("divisor", along.x);
    step.before.output("rhs", rhs.x);
  }
  if (reach) {
    give(step, "point_", reach->point);
    give(step, "along_", reach->along);
    step.before.output("inner", reach->inner);
    if (reach->outer) step.before.output("outer", *reach->outer);
  }
  step.degenerate = std::string(flat ? "(x, y)" : "divisor") + " = 0, the equation does not see " +
                    screw.variable + ": it is free" +
                    (reach ? " as far as the joint after it can follow" : "");
  set_length(step, screw, result_length());
}

void Builder::slide_beside(const Screw& screw, const Flat& along, const Flat& other, const Flat& rhs,
                           const std::string& equation) {
  Step& step = add(kind::Beside{}, &screw, 1, equation);
  give(step, "", along);
  give(step, "other_", other);
  give(step, "rhs_", rhs);
  step.degenerate = "(x, y) along (other_x, other_y): " + screw.variable + " is free";
  set_length(step, screw, result_length());
}

void Builder::two_slides(const Screw& s, const Screw& t, const Slides& slides, const std::string& equation) {
  const bool equally_inclined = scope_.is_zero(slides.a * slides.a - slides.b * slides.b);
  Step& step = add(kind::Slides{}, &s, equally_inclined ? 1 : 2, equation);
  step.before.output("a", slides.a);
  step.before.output("b", slides.b);
  step.before.output("k", slides.k);
  step.before.output("g", slides.g);
  step.before.output("f", slides.f);
  step.before.output("gap", slides.gap);
  step.degenerate =
      "boundary of reach: the two solutions coincide; a = b or a = -b: one of them is infinitely far away; a "
      "= b = 0: " +
      s.variable + " is free as far as " + t.variable + " can follow";
  set_length(step, s, symbolic::symbol(names::result_1));
  const ex other = scope_.rename(step.after, "offset_" + t.variable, symbolic::symbol(names::result_2));
  slide_by_value(t, other, "the same two equations");
}

void Builder::slide_and_turn(const Screw& slide, const Screw& turn, const SlideAndTurn& equations,
                             const std::string& equation) {
  Step& step = add(kind::SlideTurn{slide.joint}, &turn, 4, equation);
  step.before.output("divisor", equations.divisor);
  step.before.output("h", equations.h);
  step.before.output("level", equations.level);
  give(step, "l_", equations.l);
  step.before.output("mean", equations.mean);
  give(step, "m_", equations.m);
  step.degenerate =
      "boundary of reach: solutions coincide; divisor = 0 and (l_x, l_y) = 0: " + slide.variable +
      " is free as far as " + turn.variable + " can follow";
  set_turn(step, turn, result_turn());
  const ex offset = scope_.rename(step.after, "offset_" + slide.variable, result_length());
  slide_by_value(slide, offset, "the same two equations");
}

}  // namespace qvgen::derive::inverse
