// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "dag/graph.h"

namespace qvgen::emit {

/// Rational numbers as exact fractions, or where they have an end as decimals (0.4318).
enum class Numbers { exact, decimal };

/// How formulas are written.
struct Notation {
  bool typeset = false;  ///< LaTeX
  Numbers numbers = Numbers::decimal;

  static const Notation text;
  static const Notation latex;
  [[nodiscard]] Notation with(Numbers wanted) const { return {typeset, wanted}; }
};
inline constexpr Notation Notation::text{false, Numbers::decimal};
inline constexpr Notation Notation::latex{true, Numbers::decimal};

/// A value in mathematical notation, sums of products as they stand in the graph: "cos((theta4 +
/// theta6)/2)*..." or LaTeX with \bar\theta_4 for the half angle of theta4, the thesis's notation.
std::string formula(const dag::Graph& graph, dag::Edge value, Notation notation);
/// Writes a formula with the caller's names for the symbols.
std::string formula(const dag::Graph& graph, dag::Edge value, Notation notation,
                    const std::function<std::string(const std::string&)>& name);

/// An angle in that notation.
std::string formula(const dag::Angle& angle, Notation notation);

/// A name: theta4 becomes \theta_4 in LaTeX.
std::string formula(const std::string& name, Notation notation);

}  // namespace qvgen::emit
