// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "derive/inverse/lower.h"
#include "emit/cpp/inverse/dialect.h"

namespace qvgen::emit {

/// Returns the place of the length of an unknown's direction.
std::string length_place(const Dialect& d, const std::string& unknown);

/// A joint's seed; what a sum of angles shall be is worked out before.
std::string preferred_turn(const derive::inverse::LoweredPlan& plan, int joint, const Dialect& d);
std::string preferred_slide(const derive::inverse::LoweredPlan& plan, int joint, const Dialect& d);

/// Writes down the call of the building block that solves a step's equation (derive/inverse/kinds/kinds.h).
/// Numbers, turns and what is made of them are source text.
class TextBackend {
 public:
  using Number = std::string;
  using Wrist = derive::inverse::kind::Wrist;
  /// The type of `result`, empty if there is none, and the call that gives it.
  using Call = std::pair<std::string, std::string>;

  TextBackend(const derive::inverse::LoweredPlan& plan, const Dialect& dialect) : plan_(plan), d_(dialect) {}

  template <class Block, class... Arguments>
  [[nodiscard]] std::string call(const char* name, const Block& /*block*/,
                                 const Arguments&... arguments) const {
    return d_.block(name, {arguments...});
  }
  template <class Block, class... Arguments>
  [[nodiscard]] std::string direction(const char* name, const Block& /*block*/, bool opposites,
                                      const Arguments&... arguments) const {
    return d_.direction_block(name, opposites, {arguments...});
  }
  template <class Struct, class... Members>
  [[nodiscard]] std::string make(const char* name, const Members&... members) const {
    return d_.braces(name, {members...});
  }
  template <class Check, class... Arguments>
  [[nodiscard]] Call condition(const char* name, const Check& check, const Arguments&... arguments) const {
    return {"", call(name, check, arguments...)};
  }

  [[nodiscard]] std::string input(const char* name) const { return name; }
  [[nodiscard]] std::string number(int value) const { return d_.spelling().number(std::to_string(value)); }
  [[nodiscard]] std::string flag(bool value) const { return value ? "true" : "false"; }
  [[nodiscard]] std::string rotor(const std::string& x, const std::string& y) const { return d_.rotor(x, y); }
  [[nodiscard]] std::string pair(const char* x, const char* y) const { return d_.rotor(x, y); }
  /// A pair within the braces of `make`.
  [[nodiscard]] std::string nested(const std::string& x, const std::string& y) const {
    return "{" + x + ", " + y + "}";
  }
  [[nodiscard]] std::string scaled(const std::string& factor, const std::string& rotor) const {
    return d_.scaled(factor, rotor);
  }

  [[nodiscard]] std::string sign() const { return "sign"; }
  [[nodiscard]] std::string branch() const { return d_.reference(d_.member("w", "branch")); }
  [[nodiscard]] std::string tiny(int degree) const { return of_target("tiny" + std::to_string(degree)); }
  [[nodiscard]] std::string tolerance() const { return of_target("tolerance"); }
  [[nodiscard]] std::string size_square() const { return of_target("size_square"); }
  [[nodiscard]] std::string boundary() const { return d_.reference(d_.member("t", "boundary")); }
  [[nodiscard]] std::string pi() const { return d_.pi(); }
  [[nodiscard]] std::string length_of(const std::string& unknown) const {
    return d_.reference(length_place(d_, unknown));
  }
  [[nodiscard]] std::string product_of_lengths(const std::vector<std::string>& unknowns) const;

  [[nodiscard]] std::string seed_turn(int joint) const { return preferred_turn(plan_, joint, d_); }
  [[nodiscard]] std::string seed_slide(int joint) const { return preferred_slide(plan_, joint, d_); }
  /// As short as `span` wants it.
  [[nodiscard]] std::string seed_brief(int joint) const;
  [[nodiscard]] std::string seed_angle(int joint) const;
  /// The turn that the seed's angles add up to.
  [[nodiscard]] std::string sum_of_seeds(const std::vector<derive::inverse::kind::Reach::Seed>& seeds) const;
  [[nodiscard]] std::string spread() const;

  [[nodiscard]] Call nothing() const { return {"", ""}; }
  /// A length that a direction keeps is read where it stands, with the branch's sign.
  void signed_length(const std::string& /*unknown*/, const std::string& /*sign*/) const {}
  [[nodiscard]] Call turn(const std::string& call) const { return {d_.type("Rotor"), call}; }
  [[nodiscard]] Call two_lengths(const std::string& call) const { return turn(call); }
  [[nodiscard]] Call length(const std::string& call) const { return {d_.number_type(), call}; }
  [[nodiscard]] Call roots(const char* type, const std::string& call) const { return {d_.type(type), call}; }
  [[nodiscard]] Call wrist_turns(const Wrist& /*wrist*/, const std::string& call) const {
    return {d_.type("WristTurns"), call};
  }
  [[nodiscard]] Call wrist_branches(const Wrist& /*wrist*/, const std::string& call) const {
    return {d_.type("WristBranches"), call};
  }
  [[nodiscard]] Call wrist_angles(const Wrist& /*wrist*/, const std::string& call) const {
    return {d_.type("WristAngles"), call};
  }

 private:
  [[nodiscard]] std::string of_target(const std::string& name) const {
    return d_.scalar(d_.member("t", name));
  }

  const derive::inverse::LoweredPlan& plan_;
  const Dialect& d_;
};

}  // namespace qvgen::emit
