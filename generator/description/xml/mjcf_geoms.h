// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/mjcf_frames.h"
#include "description/xml/mjcf_meshes.h"
#include "description/xml/solids.h"

namespace qvgen::description::xml {

/// Masses and moments of an MJCF's geoms.
class MjcfGeoms {
 public:
  explicit MjcfGeoms(Context& context)
      : context_(&context), frames_(context, SnapOptions{SnapOptions::off, 0}), meshes_(context) {}
  /// The geom in the body's frame; nothing if it counts for no mass. `known` becomes false where its mass
  /// cannot be told, which is reported.
  [[nodiscard]] std::optional<tree::Body> body(const Placed& placed, bool& known);

 private:
  /// With a mass of 1.
  struct Shape {
    cln::cl_R volume;
    tree::Body body;
  };
  [[nodiscard]] static Shape shape_of(const Solid& solid);
  [[nodiscard]] std::optional<Shape> shape(const Placed& placed, const Element& geom, bool& known);
  [[nodiscard]] std::optional<tree::Vector> size(const Element& geom, std::size_t count) const;
  [[nodiscard]] std::optional<Shape> mesh(const MjcfModel& model, const Element& geom, bool& known);
  [[nodiscard]] std::optional<Shape> fitted(const Shape& mesh, const Element& geom) const;
  [[nodiscard]] std::optional<Shape> between_points(const Element& geom) const;

  Context* context_;
  MjcfFrames frames_;
  MjcfMeshes meshes_;
};

}  // namespace qvgen::description::xml
