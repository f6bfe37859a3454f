// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>

#include "derive/inverse/names.h"
#include "verify/inverse/numeric_backend.h"
#include "verify/inverse/real.h"

namespace qvgen::verify {

namespace names = derive::inverse::names;

using Values = std::map<std::string, Real>;

/// The values below which directions, lengths and their squares are noise, of an arm of this size.
struct Noise {
  Real size_square;

  [[nodiscard]] Real tiny(int degree) const {
    const Real noise = Real(16) * qvgen::inverse::epsilon<Real>();
    const Real square = noise * noise;
    if (degree == 0) return square;
    if (degree == 1) return square * size_square;
    return (degree == 2 ? square : square * square) * size_square * size_square;
  }
};

/// Solves a step's equation in sixty digits: on one branch, which `sign` tells.
class RealBackend : public NumericBackend<Real, RealBackend> {
 public:
  using Branch = qvgen::inverse::Branch<Real>;
  using Boundary = qvgen::inverse::Boundary;
  using Wrist = derive::inverse::kind::Wrist;

  /// `in`: the block's inputs; `known`: what steps leave, to which the results are added.
  RealBackend(const Values& in, Values& known, const Noise& noise, const Real& sign, const Boundary& boundary,
              Branch& branch)
      : in_(in), known_(known), noise_(noise), sign_(sign), boundary_(boundary), branch_(branch) {}

  [[nodiscard]] Real input(const char* name) const { return in_.at(name); }
  [[nodiscard]] Real sign() const { return sign_; }
  [[nodiscard]] Real tiny(int degree) const { return noise_.tiny(degree); }
  [[nodiscard]] Real size_square() const { return noise_.size_square; }
  [[nodiscard]] Real tolerance() const { return Real(qvgen::inverse::default_tolerance); }
  [[nodiscard]] Real pi() const { return Real::pi(); }
  [[nodiscard]] const Boundary& boundary() const { return boundary_; }
  [[nodiscard]] Branch& branch() const { return branch_; }

  [[nodiscard]] Real& length_of(const std::string& unknown) const { return known_[names::length(unknown)]; }
  void signed_length(const std::string& unknown, const Real& sign) const {
    known_[names::result] = sign * length_of(unknown);
  }
  [[nodiscard]] Real product_of_lengths(const std::vector<std::string>& unknowns) const {
    Real product(1);
    for (const std::string& unknown : unknowns) product = product * length_of(unknown);
    return product;
  }

  void nothing() const {}
  void turn(const Rotor& turn) const { set(names::result, turn); }
  void length(const Real& length) const { known_[names::result] = length; }
  void two_lengths(const Rotor& lengths) const {
    known_[names::result_1] = lengths.cosine;
    known_[names::result_2] = lengths.sine;
  }
  void roots(const char* /*type*/, const qvgen::inverse::CircleRoots<Real>& found) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(found.count); ++k)
      roots_.push_back({found.root[k], Real(0), {Real(1), Real(0)}});
  }
  void roots(const char* /*type*/, const qvgen::inverse::SlideTurns<Real>& found) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(found.count); ++k)
      roots_.push_back({found.root[k].turn, found.root[k].slide, {Real(1), Real(0)}});
  }
  void roots(const char* /*type*/, const qvgen::inverse::TurnPairs<Real>& found) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(found.count); ++k)
      roots_.push_back({found.root[k].first, Real(0), found.root[k].second});
  }
  void wrist_turns(const Wrist& wrist, const qvgen::inverse::WristTurns<Real>& turns) const {
    set(wrist.variables[0], turns.first);
    set(wrist.variables[1], turns.middle);
    set(wrist.variables[2], turns.last);
  }
  void wrist_branches(const Wrist& wrist, const qvgen::inverse::WristBranches<Real>& branches) const {
    set(wrist, sign_ > Real(0) ? branches.one : branches.other);
  }
  /// The middle angle counts from where the normals coincide.
  void wrist_angles(const Wrist& wrist, qvgen::inverse::WristAngles<Real> angles) const {
    const Real delta = atan2(input("sine_delta"), input("cosine_delta"));
    angles.middle = qvgen::inverse::wrapped(Real(angles.middle - delta), pi());
    set(wrist, angles);
  }

  /// Root of a step that gives all of them at once: a turn, and the slide or the turn that goes with it.
  struct Root {
    Rotor turn;
    Real slide;
    Rotor second;
  };
  [[nodiscard]] const std::vector<Root>& all_roots() const { return roots_; }

 private:
  void set(const std::string& name, const Rotor& turn) const {
    known_[names::cosine(name)] = turn.cosine;
    known_[names::sine(name)] = turn.sine;
  }
  void set(const Wrist& wrist, const qvgen::inverse::WristAngles<Real>& angles) const {
    const std::array<Real, 3> values = {angles.first, angles.middle, angles.last};
    for (std::size_t i = 0; i < 3; ++i) set(wrist.variables[i], {cos(values[i]), sin(values[i])});
  }

  const Values& in_;
  Values& known_;
  const Noise& noise_;
  Real sign_;
  const Boundary& boundary_;
  Branch& branch_;
  std::vector<Root> roots_;
};

}  // namespace qvgen::verify
