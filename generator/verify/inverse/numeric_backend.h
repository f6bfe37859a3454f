// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include <qvgen/inverse/angles.h>
#include <qvgen/inverse/near_singular.h>

#include "derive/inverse/kinds/kinds.h"

namespace qvgen::verify {

/// Shared part of backends that carry out the building blocks with numbers (derive/inverse/kinds/kinds.h):
/// the seed's angles and lengths are zero. `Own` adds inputs, tolerances and what becomes of the results.
template <class Scalar, class Own>
class NumericBackend {
 public:
  using Number = Scalar;
  using Rotor = qvgen::inverse::Rotor<Scalar>;

  template <class Block, class... Arguments>
  decltype(auto) call(const char* /*name*/, const Block& block, Arguments&&... arguments) {
    return block(std::forward<Arguments>(arguments)...);
  }
  /// Only the choice of a nearly free direction asks whether the opposite one is another branch.
  template <class Block, class... Arguments>
  decltype(auto) direction(const char* /*name*/, const Block& block, bool /*opposites*/,
                           Arguments&&... arguments) {
    return block(std::forward<Arguments>(arguments)...);
  }
  template <class Struct, class... Members>
  Struct make(const char* /*name*/, const Members&... members) {
    return Struct{members...};
  }
  template <class Check, class... Arguments>
  void condition(const char* /*name*/, const Check& check, Arguments&&... arguments) {
    check(std::forward<Arguments>(arguments)...);
  }

  [[nodiscard]] Scalar number(int value) const { return Scalar(value); }
  [[nodiscard]] bool flag(bool value) const { return value; }
  [[nodiscard]] Rotor rotor(const Scalar& x, const Scalar& y) const { return {x, y}; }
  [[nodiscard]] Rotor nested(const Scalar& x, const Scalar& y) const { return {x, y}; }
  [[nodiscard]] Rotor pair(const char* x, const char* y) const { return {own().input(x), own().input(y)}; }
  [[nodiscard]] Rotor scaled(const Scalar& factor, const Rotor& rotor) const { return factor * rotor; }

  [[nodiscard]] Rotor seed_turn(int /*joint*/) const { return ahead(); }
  [[nodiscard]] Rotor seed_brief(int /*joint*/) const {
    return {Scalar(qvgen::inverse::brief_length), Scalar(0)};
  }
  [[nodiscard]] Scalar seed_slide(int /*joint*/) const { return Scalar(0); }
  [[nodiscard]] Scalar seed_angle(int /*joint*/) const { return Scalar(0); }
  [[nodiscard]] Rotor sum_of_seeds(const std::vector<derive::inverse::kind::Reach::Seed>& /*seeds*/) const {
    return ahead();
  }
  [[nodiscard]] Rotor spread() const { return ahead(); }

 private:
  [[nodiscard]] const Own& own() const { return static_cast<const Own&>(*this); }
  [[nodiscard]] static Rotor ahead() { return {Scalar(1), Scalar(0)}; }
};

}  // namespace qvgen::verify
