// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "derive/jacobian/circle_polynomial.h"
#include "derive/jacobian/linkage.h"

namespace qvgen::derive {

/// Name of a factor of the determinant, and what happens where it vanishes.
struct SingularCause {
  enum class Kind { shoulder, elbow, workspace_boundary, inner_boundary, wrist };
  Kind kind = Kind::shoulder;
  std::string meaning;
};
std::string to_string(SingularCause::Kind kind);

/// Finds the cause in the factor's structure: which axes and velocities become parallel, or vanish, wherever
/// it does. "Wherever" is exact: the factor divides each component.
class SingularCauses {
 public:
  /// `point`: what the linkage's tool point is called.
  SingularCauses(CirclePolynomials& circles, const Linkage& linkage, std::string point);

  /// Returns the cause behind a factor of the determinant of these joints' columns.
  SingularCause of(const GiNaC::ex& factor, const std::vector<std::size_t>& joints);
  /// Returns the cause behind a factor that only the last three of six joints enter.
  SingularCause of_wrist(const GiNaC::ex& factor, bool axes_meet);

 private:
  struct Joint {
    bool slides = false;
    symbolic::Vector linear;  ///< column of the Jacobian, in some frame of the linkage
    symbolic::Vector angular;
  };
  using Found = std::optional<SingularCause>;
  bool vanishes(const GiNaC::ex& factor, const symbolic::Vector& v);
  [[nodiscard]] bool always_parallel(std::size_t i, std::size_t j) const;
  Found point_on_axis(const GiNaC::ex& factor, const std::vector<std::size_t>& joints);
  [[nodiscard]] SingularCause along_a_slide(std::size_t i, std::size_t j) const;
  Found two_in_line(const GiNaC::ex& factor, const std::vector<std::size_t>& joints);
  Found parallel_axes_in_plane(const GiNaC::ex& factor, const std::vector<std::size_t>& joints);
  Found point_in_plane_of_axes(const GiNaC::ex& factor, const std::vector<std::size_t>& joints);
  Found along_first_axis(const GiNaC::ex& factor, const std::vector<std::size_t>& joints);
  [[nodiscard]] std::string stretched_or_folded(const GiNaC::ex& factor, const symbolic::Vector& reach) const;
  [[nodiscard]] bool is_constant(const GiNaC::ex& value) const;
  [[nodiscard]] symbolic::Vector between(std::size_t i, std::size_t j) const;

  CirclePolynomials& circles_;
  std::vector<GiNaC::ex> variables_;
  std::string point_;
  std::vector<Joint> joints_;
};

}  // namespace qvgen::derive
