// SPDX-License-Identifier: MIT
// Spheres that a URDF has as collision geometry, on the links of a chain and on what is fixed to them. Links
// behind other moving joints, such as fingers of a gripper, are left out: nobody says where they are.
#pragma once

#include <string>
#include <vector>

#include "description/reader.h"
#include "description/xml/urdf_origin.h"

namespace qvgen::description::xml {

struct UrdfSphere {
  std::size_t joints = 0;  ///< of the chain that move it
  std::vector<UrdfOrigin>
      ways;           ///< from the frame of the link behind these joints to the centre, one after the other
  double radius = 0;  ///< m
};

/// Returns the spheres of a URDF that has been read with these options; none of other text.
std::vector<UrdfSphere> urdf_spheres(const std::string& text, const ReadOptions& options);

}  // namespace qvgen::description::xml
