// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emit/inverse/places.h"

namespace qvgen::emit {

/// A joint's seed as a number of the function's type; what a sum of angles shall be is worked out before.
ast::Expression seed_turn(const derive::inverse::LoweredPlan& plan, int joint);
ast::Expression seed_slide(const derive::inverse::LoweredPlan& plan, int joint);

/// Builds the call of the building block that solves a step's equation (derive/inverse/kinds/kinds.h).
class TreeBackend {
 public:
  using Number = ast::Expression;
  using Wrist = derive::inverse::kind::Wrist;
  /// The type of `result`, empty if there is none, and the call that gives it.
  using Call = std::pair<std::string, ast::Expression>;
  using Kind = ast::Expression::Kind;

  explicit TreeBackend(const derive::inverse::LoweredPlan& plan) : plan_(plan) {}

  template <class Block, class... Arguments>
  [[nodiscard]] Number call(const char* name, const Block& /*block*/, const Arguments&... arguments) const {
    return ast::call(Kind::block, name, {arguments...});
  }
  template <class Block, class... Arguments>
  [[nodiscard]] Number direction(const char* name, const Block& /*block*/, bool opposites,
                                 const Arguments&... arguments) const {
    return ast::call(Kind::direction_block, name, {ast::truth(opposites), arguments...});
  }
  template <class Struct, class... Members>
  [[nodiscard]] Number make(const char* name, const Members&... members) const {
    return ast::make(name, {members...});
  }
  template <class Check, class... Arguments>
  [[nodiscard]] Call condition(const char* name, const Check& check, const Arguments&... arguments) const {
    return {"", call(name, check, arguments...)};
  }

  [[nodiscard]] Number input(const char* name) const { return ast::name(name, {"real"}); }
  [[nodiscard]] Number number(int value) const { return ast::real(std::to_string(value)); }
  [[nodiscard]] Number flag(bool value) const { return ast::truth(value); }
  [[nodiscard]] Number rotor(const Number& x, const Number& y) const { return ast::rotor(x, y); }
  [[nodiscard]] Number pair(const char* x, const char* y) const { return ast::rotor(input(x), input(y)); }
  /// A pair within a struct that `make` makes.
  [[nodiscard]] Number nested(const Number& x, const Number& y) const { return ast::pair({x, y}); }
  [[nodiscard]] Number scaled(const Number& factor, const Number& rotor) const {
    return ast::scaled(factor, rotor);
  }

  [[nodiscard]] Number sign() const { return ast::name("sign", {"real"}); }
  [[nodiscard]] Number branch() const { return ast::reference(emit::branch(work())); }
  [[nodiscard]] Number tiny(int degree) const { return of_target("tiny" + std::to_string(degree)); }
  [[nodiscard]] Number tolerance() const { return of_target("tolerance"); }
  [[nodiscard]] Number size_square() const { return of_target("size_square"); }
  [[nodiscard]] Number boundary() const { return ast::reference(ast::member(target(), "boundary")); }
  [[nodiscard]] Number pi() const { return ast::pi(); }
  [[nodiscard]] Number length_of(const std::string& unknown) const {
    return ast::reference(length_place(work(), unknown));
  }
  [[nodiscard]] Number product_of_lengths(const std::vector<std::string>& unknowns) const;

  [[nodiscard]] Number seed_turn(int joint) const { return emit::seed_turn(plan_, joint); }
  [[nodiscard]] Number seed_slide(int joint) const { return emit::seed_slide(plan_, joint); }
  /// As short as `span` wants it.
  [[nodiscard]] Number seed_brief(int joint) const;
  [[nodiscard]] Number seed_angle(int joint) const;
  /// The turn that the seed's angles add up to.
  [[nodiscard]] Number sum_of_seeds(const std::vector<derive::inverse::kind::Reach::Seed>& seeds) const;
  [[nodiscard]] Number spread() const;

  [[nodiscard]] Call nothing() const { return {}; }
  /// A length that a direction keeps is read where it stands, with the branch's sign.
  void signed_length(const std::string& /*unknown*/, const Number& /*sign*/) const {}
  [[nodiscard]] Call turn(const Number& call) const { return {"Rotor", call}; }
  [[nodiscard]] Call two_lengths(const Number& call) const { return turn(call); }
  [[nodiscard]] Call length(const Number& call) const { return {"real", call}; }
  [[nodiscard]] Call roots(const char* type, const Number& call) const { return {type, call}; }
  [[nodiscard]] Call wrist_turns(const Wrist& /*wrist*/, const Number& call) const {
    return {"WristTurns", call};
  }
  [[nodiscard]] Call wrist_branches(const Wrist& /*wrist*/, const Number& call) const {
    return {"WristBranches", call};
  }
  [[nodiscard]] Call wrist_angles(const Wrist& /*wrist*/, const Number& call) const {
    return {"WristAngles", call};
  }

 private:
  [[nodiscard]] static Number of_target(const std::string& name) {
    return ast::convert(ast::member(target(), name));
  }

  const derive::inverse::LoweredPlan& plan_;
};

}  // namespace qvgen::emit
