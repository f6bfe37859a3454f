// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "derive/dynamics/chain.h"

namespace qvgen::derive::dynamics {

/// Which gravity the constants are made of: along the world's -z with a magnitude, or any vector. What is
/// zero in the first costs nothing.
enum class Gravity { down, any };

/// Which of several equivalent descriptions of the same robot a formulation starts from.
struct FrameConvention {
  /// Length that becomes the unit of length: its products cost nothing. Index into unit_candidates().
  std::optional<std::size_t> unit;
  /// Link -> component of the first moment of the link before that a shifted mass makes vanish.
  std::map<std::size_t, std::size_t> masses;
  /// The links' own inertias, nothing regrouped: for what is not the same in base parameters (potential
  /// energy).
  bool standard = false;
  /// All inertias free, whatever the description says; see standard_parameter().
  Inertias inertias = Inertias::described;
  Gravity gravity = Gravity::down;
};

/// A robot whose constants are symbols, ready for a recursion, and what those symbols stand for.
///
/// Arithmetic on constants alone is done once, so every distinct constant of the chain is one symbol "$0",
/// "$1", ...
/// ("free" for the counting rule; no description can use such a name). Zeros, ones and equal or opposite
/// values are recognised by their exact value at a random point, so that the structure of the numbers is used
/// too.
struct Parametrisation {
  Chain chain;      ///< in the graph given to parametrise(); symbols are the constants
  Vector3 gravity;  ///< base acceleration (against gravity) in the frame before link 0, in units of length
  Scalar height;    ///< of that frame against gravity, times gravity, in units of length squared
  Scalar unit, per_unit;    ///< the unit of length and its inverse; one if none was chosen
  dag::Function constants;  ///< outputs "$0", ... in terms of the description's symbols and `gravity_symbol`
};

/// The magnitude, and the components of the acceleration of free fall in the world. For a floating base these
/// are components in the base's own frame, and the fourth is minus their product with the base's position.
inline constexpr const char* gravity_symbol = "gravity";
std::string gravity_component(std::size_t axis);
bool is_constant_symbol(const std::string& name);

/// The lengths that may serve as the unit: nonzero a, b, d of the links.
std::vector<Scalar> unit_candidates(const Chain& chain);

/// The shifts of a mass (see shift_mass) that make sense for a robot: link and component, the offset not
/// zero.
std::vector<std::pair<std::size_t, std::size_t>> mass_shifts(const model::Robot& robot);

Parametrisation parametrise(const model::Robot& robot, const FrameConvention& convention, dag::Graph& graph);

}  // namespace qvgen::derive::dynamics
