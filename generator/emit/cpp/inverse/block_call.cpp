// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/block_call.h"

namespace qvgen::emit {

using derive::inverse::Kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

namespace {

std::string preferred(const Dialect& d, const std::string& what) {
  return d.scalar(d.member("t", "preference->" + what));
}

std::string preferred_angle(const Dialect& d, int joint) {
  return preferred(d, "angle[" + std::to_string(joint) + "]");
}

std::string preferred_rotor(const Dialect& d, const std::string& name) {
  return d.rotor(preferred(d, name + ".cosine"), preferred(d, name + ".sine"));
}

/// The row's place of the joint that a step determines.
int place(const LoweredPlan& plan, int joint) { return plan.plan.places[static_cast<std::size_t>(joint)]; }

/// A joint's seed as a turn, or as short as `span` wants it ("brief").
std::string seed_of(const LoweredPlan& plan, int joint, const std::string& kind, const Dialect& d) {
  return preferred_rotor(d, kind + "[" + std::to_string(place(plan, joint)) + "]");
}

std::string spread(const Dialect& d) { return preferred_rotor(d, "spread"); }

std::string of_target(const Dialect& d, const std::string& name) { return d.scalar(d.member("t", name)); }

std::string boundary(const Dialect& d) { return d.reference(d.member("t", "boundary")); }
std::string branch(const Dialect& d) { return d.reference(d.member("w", "branch")); }

}  // namespace

bool ends_plan(const LoweredPlan& plan, const Step& step) {
  return step.is_wrist() && plan.plan.wrist.ends_the_plan;
}

std::string length_place(const Dialect& d, const std::string& unknown) {
  return d.member("w", "length_" + unknown);
}

std::string preferred_turn(const LoweredPlan& plan, int joint, const Dialect& d) {
  return seed_of(plan, joint, "turn", d);
}

std::string preferred_slide(const LoweredPlan& plan, int joint, const Dialect& d) {
  return preferred(d, "slide[" + std::to_string(place(plan, joint)) + "]");
}

namespace {

/// A slide's seed, or what is nearest to it with the joint after it in reach.
std::string slide_choice(const LoweredPlan& plan, const Step& step, const Dialect& d) {
  const std::string value = preferred_slide(plan, step.joint, d);
  if (!step.has_input("inner")) return value;
  const bool between = step.has_input("outer");
  return d.block(between ? "slide_between" : "slide_beyond",
                 {d.rotor("point_x", "point_y"), d.rotor("along_x", "along_y"), "inner",
                  between ? "outer" : of_target(d, "size_square"), value, spread(d)});
}

/// The turn that the seed's angles add up to.
std::string seeds(const LoweredPlan& plan, const Step& step, const Dialect& d) {
  std::string product;
  for (const Step::Seed& seed : step.seeds) {
    const std::string turn = preferred_turn(plan, seed.joint, d);
    const std::string factor = seed.sense > 0 ? turn : d.inverse(turn);
    product = product.empty() ? factor : d.product(product, factor);
  }
  return product;
}

std::string tiny(const Step& step, const Dialect& d) {
  return of_target(d, "tiny" + std::to_string(step.degree));
}

std::string direction(const LoweredPlan& plan, const Step& step, const Dialect& d) {
  const std::string v = d.rotor("x", "y");
  // What a sum of angles shall be is worked out before.
  if (step.joint < 0)
    return d.block("chosen_direction", {v, d.rotor("choice_x", "choice_y"), boundary(d), branch(d)});
  const std::string block = step.unit ? "direction" : step.length_known ? "span_of_length" : "span";
  return d.direction_block(block, step.kind == Kind::opposite,
                           {v, step.length_known ? "length" : "", tiny(step, d),
                            seed_of(plan, step.joint, step.unit ? "turn" : "brief", d),
                            step.unit ? "" : d.reference(length_place(d, step.unknown)), branch(d)});
}

std::string half(const LoweredPlan& plan, const Step& step, const Dialect& d) {
  const std::string turn = d.rotor("cosine", "sine");
  if (!plan.plan.wrist.right) return d.block("half", {turn});
  std::string length;
  for (const std::string& unknown : step.lengths)
    length += (length.empty() ? "" : " * ") + length_place(d, unknown);
  return d.block("half_direction", {turn, length.empty() ? d.spelling().number("1") : length});
}

}  // namespace

std::pair<std::string, std::string> block_call(const LoweredPlan& plan, const Step& step, const Dialect& d) {
  const std::string turn = d.type("Rotor");
  const auto is_of = [&](const std::string& name, const Dialect::Arguments& arguments) {
    return std::pair{turn, d.block(name, arguments)};
  };
  switch (step.kind) {
    case Kind::circle:
      return is_of("circle_angle", {"low", "high", "scale", "sign", boundary(d), branch(d)});
    case Kind::free_circle:
      return is_of("free_circle_angle",
                   {"low", "high", d.rotor("x", "y"), tiny(step, d), preferred_turn(plan, step.joint, d),
                    "sign", boundary(d), branch(d)});
    case Kind::factored:
      return is_of("factored_line_angle",
                   {d.rotor("x", "y"), "rhs", "low", "high", tiny(step, d),
                    preferred_turn(plan, step.joint, d), "sign", boundary(d), branch(d)});
    case Kind::reach:
      return is_of("reachable_direction", {d.rotor("point_x", "point_y"), d.rotor("offset_x", "offset_y"),
                                           "inner", "outer", seeds(plan, step, d)});
    case Kind::opposite:
      return {turn, d.scaled("sign", direction(plan, step, d))};
    case Kind::pair:
      return {turn, direction(plan, step, d)};
    case Kind::half:
      return {turn, half(plan, step, d)};
    case Kind::root:
      return {d.number_type(), d.block("signed_root", {"square", "scale", of_target(d, "tiny1"), "sign",
                                                       boundary(d), branch(d)})};
    case Kind::line: {
      const bool one = step.has_input("divisor");
      const std::string zero = d.spelling().number("0");
      return {d.number_type(),
              d.block("slide_on_line",
                      {one ? d.rotor("divisor", zero) : d.rotor("x", "y"),
                       one ? d.rotor("rhs", zero) : d.rotor("rhs_x", "rhs_y"), of_target(d, "tiny1"),
                       slide_choice(plan, step, d), boundary(d), branch(d)})};
    }
    case Kind::slides:
      return is_of("two_slides",
                   {d.rotor("a", "b"), "k", d.rotor("g", "f"), "gap", of_target(d, "tiny1"),
                    of_target(d, "size_square"), preferred_slide(plan, step.joint, d), spread(d),
                    step.branches == 1 ? d.spelling().number("0") : "sign", boundary(d), branch(d)});
    case Kind::require:
      return {"", d.block("require_zero", {"residual", "scale", of_target(d, "tolerance"), branch(d)})};
    case Kind::conic:
      return {d.type("CircleRoots"),
              d.block("conic_circle",
                      {d.braces("Conic", {"xx", "xy", "yy", "x", "y", "one"}), boundary(d), d.pi()})};
    case Kind::slide_turn:
      return {
          d.type("SlideTurns"),
          d.block("slide_and_turn",
                  {d.braces("SlideAndTurn", {"divisor", "h", "level", "{l_x, l_y}", "mean", "{m_x, m_y}"}),
                   of_target(d, "tiny1"), of_target(d, "size_square"), preferred_slide(plan, step.slide, d),
                   spread(d), boundary(d), d.pi()})};
    case Kind::right_wrist: {
      const std::string swapped = plan.plan.wrist.middle_swapped ? "true" : "false";
      const std::string u = d.rotor("u_x", "u_y"), v = d.rotor("v_x", "v_y");
      if (ends_plan(plan, step))
        return {
            d.type("WristBranches"),
            d.block("right_wrist", {u, v, swapped, preferred_angle(d, place(plan, plan.plan.wrist.joints[0])),
                                    d.pi(), branch(d)})};
      return {d.type("WristTurns"),
              d.block("right_wrist_turns",
                      {u, v, swapped, d.rotor("choice_x", "choice_y"), "sign", boundary(d), branch(d)})};
    }
    case Kind::oblique_wrist: {
      const std::string u = d.rotor("u_x", "u_y"), v = d.rotor("v_x", "v_y");
      const std::string shape = d.braces(
          "WristShape", {"cosine_sum", "sine_sum", "cosine_difference", "sine_difference", "product"});
      if (!ends_plan(plan, step))
        return {d.type("WristTurns"),
                d.block("oblique_wrist_turns",
                        {u, v, shape, d.rotor("cosine_delta", "sine_delta"), d.rotor("choice_x", "choice_y"),
                         "sign", boundary(d), branch(d)})};
      return {d.type("WristAngles"),
              d.block("oblique_wrist",
                      {u, v, shape, "sign", preferred_angle(d, place(plan, plan.plan.wrist.joints[0])),
                       boundary(d), d.pi(), branch(d)})};
    }
    case Kind::polish:
    case Kind::linear:
      return {"", ""};
  }
  return {};
}

}  // namespace qvgen::emit
