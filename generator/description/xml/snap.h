// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <cln/real.h>

#include "description/xml/decimals.h"

namespace qvgen::description::xml {

/// Reads rounded numbers as what they were before they were rounded, by ReadOptions::snap, and notes each
/// number that it changes with its place and by how much.
///
/// By default a number is changed where it is the exact value rounded or cut to the digits that are written
/// (1.571, 3.141, 0.7071), or nearer than 1e-6 to it (what another program computed). So an angle that was
/// measured, 1.5702, stays what it is.
class Snap {
 public:
  explicit Snap(Context& context) : Snap(context, context.options.snap) {}
  Snap(Context& context, const SnapOptions& options) : context_(&context), options_(options) {}
  /// An angle in radians: a multiple of pi/12, or as written.
  [[nodiscard]] model::Expression angle(const Decimal& radians) const;
  /// A length: 0 if it is a micrometre or less, which no maker can mean, or as written.
  [[nodiscard]] model::Expression length(const Decimal& metres) const;
  [[nodiscard]] model::Vector3 lengths(const std::vector<Decimal>& metres) const;
  /// The unit vector of three numbers that are not all zero: exact cosines of multiples of 15 degrees and
  /// 1/sqrt(3) where those are meant, else exactly the direction that is written.
  [[nodiscard]] model::Vector3 direction(const std::vector<Decimal>& vector) const;
  /// Likewise, without notes.
  [[nodiscard]] model::Vector3 unit(const std::vector<Decimal>& vector) const;
  /// The multiple of pi/12 that is meant by an angle computed from what is written; no note.
  [[nodiscard]] std::optional<model::Expression> part_of_turn(const cln::cl_RA& radians,
                                                              const Decimal& written) const;
  /// Notes that the turns are read instead of the rotation (rows of a matrix), if they differ.
  void note_turns(const Decimal& written, const std::vector<model::Turn>& turns,
                  const std::array<std::array<cln::cl_R, 3>, 3>& rotation) const;

 private:
  [[nodiscard]] bool is_meant(const Decimal& written, const cln::cl_R& exact, int least_places) const;
  [[nodiscard]] std::optional<cln::cl_I> meant_twelfths(const Decimal& radians) const;
  void note(const Decimal& written, const std::string& meant, const cln::cl_R& exact) const;
  [[nodiscard]] std::optional<model::Vector3> known_direction(const std::vector<Decimal>& vector) const;

  Context* context_;
  SnapOptions options_;
};

}  // namespace qvgen::description::xml
