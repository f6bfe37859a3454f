// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/mesh.h"
#include "description/xml/mjcf_contents.h"

namespace qvgen::description::xml {

/// Integrals of the meshes that geoms name, each file read once.
class MjcfMeshes {
 public:
  struct Result {
    MeshIntegrals integrals;
    std::string problem;  ///< why there are none; empty: there are
  };
  explicit MjcfMeshes(Context& context) : context_(&context) {}
  [[nodiscard]] const Result& of(const MjcfModel& model, const std::string& name);

 private:
  [[nodiscard]] Result read(const MjcfModel& model, const std::string& name) const;
  [[nodiscard]] Mesh points(const MjcfModel& model, const Element& mesh) const;

  Context* context_;
  std::map<std::pair<const MjcfModel*, std::string>, Result> known_;
};

}  // namespace qvgen::description::xml
