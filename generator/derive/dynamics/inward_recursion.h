// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "derive/dynamics/parametrisation.h"
#include "derive/dynamics/suggestions.h"

namespace qvgen::derive::dynamics {

/// Force and moment (about the frame's origin) that belong to one coordinate, on their way inward.
struct Column {
  std::size_t coordinate = 0;
  bool slides = false;
  Vector3 force, moment;
  std::optional<Vector3> outer_moment,
      outer_force = {};              ///< before the joint behind, for parallel neighbours
  std::size_t outer_link = no_link;  ///< the link of that joint
};

/// Takes what is known in a link's frame to the frame of the link before, with other ways to do it suggested.
class InwardRecursion {
 public:
  InwardRecursion(const Parametrisation& p, dag::Graph& graph, Suggestions& suggest)
      : p_(p), graph_(graph), suggest_(suggest) {}

  void transform_to_parent(std::size_t link, Column& column);
  PseudoInertia transform_to_parent(std::size_t link, const PseudoInertia& inertia);

  /// The link's offset along its axis, the variable of a prismatic joint included.
  Scalar shift_of(const Link& link) const;
  Scalar symbol(const std::string& name) const { return {graph_, graph_.symbol(name)}; }

 private:
  [[nodiscard]] bool is_parallel(std::size_t link) const;
  void offer_parallel(std::size_t link, const Column& column, const Circle& first);
  PseudoInertia turned_about_z(const PseudoInertia& inertia, const Circle& by);
  void offer(const PseudoInertia& inertia);

  const Parametrisation& p_;
  dag::Graph& graph_;
  Suggestions& suggest_;
};

/// The column's part of the generalised force of one way of the link. In units of length, forces come out too
/// large by one: once for each sliding joint of the pair.
Scalar entry(const Parametrisation& p, const Way& way, const Column& column);

/// Force and moment on a composite body for unit acceleration in one way of its link.
Column column_of(const Way& way, const PseudoInertia& composite);

}  // namespace qvgen::derive::dynamics
