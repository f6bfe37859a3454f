// SPDX-License-Identifier: MIT
// A URDF with other numbers in it: what is not changed stays as it was byte for byte, with its comments,
// meshes, and links beside the chain.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "description/reader.h"
#include "description/xml/urdf_origin.h"

namespace qvgen::description::xml {

struct UrdfInertia {
  double mass = 0;                  ///< kg
  std::array<double, 3> centre{};   ///< m, in the link's frame
  std::array<double, 6> inertia{};  ///< kg m^2 about the centre, along the link's axes: xx yy zz xy yz xz
};

/// A link on the way from base to tip with the joint that holds it, its numbers as the file has them.
struct UrdfStep {
  std::string joint;
  bool moves = false;       ///< false: fixed, or held by the options
  bool has_offset = false;  ///< it follows another joint at a distance
  UrdfOrigin origin;
  std::array<double, 3> axis{1, 0, 0};  ///< as written, of any length
};

class UrdfEdit {
 public:
  /// Takes a URDF in UTF-8 that has been read with these options. Throws std::runtime_error for other text.
  UrdfEdit(const std::string& text, const ReadOptions& options);
  ~UrdfEdit();

  [[nodiscard]] const std::vector<UrdfStep>& steps() const;
  void set_origin(std::size_t step, const UrdfOrigin& origin);
  void set_axis(std::size_t step, const std::array<double, 3>& axis);
  /// Sets the inertia of a link; those of links that are fixed to it are part of it and are removed.
  void set_inertia(std::size_t step, const UrdfInertia& inertia);
  /// Sets the friction of a joint: Nm s/rad or N s/m, and Nm or N.
  void set_friction(std::size_t step, double viscous, double coulomb);
  /// Adds a link behind the tip, held by a fixed joint; returns its name.
  std::string add_tip(const UrdfOrigin& origin);
  /// Adds lines of a comment at the file's begin, in the robot's element.
  void add_comment(const std::string& lines);
  [[nodiscard]] std::string text() const;

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace qvgen::description::xml
