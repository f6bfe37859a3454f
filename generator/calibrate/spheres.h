// SPDX-License-Identifier: MIT
// Spheres that stand for the bodies of an arm, so that planned postures keep them apart. They come from a
// table
//
//     link, x [mm], y [mm], z [mm], radius [mm]
//     0, 0, 0, 60, 90
//     2, 0, 0, 130, 70
//
// with centres in the frames of the links as the description has them, 0 for the base; or from the collision
// geometry of a URDF.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calibrate/rigid.h"
#include "description/reader.h"
#include "model/robot.h"

namespace qvgen::calibrate {

struct Sphere {
  std::size_t link = 0;  ///< moved by so many joints; 0: the base
  Vec<double> centre{};  ///< m, behind the motion of the last of these joints; of the base in the world
  double radius = 0;     ///< m
};

struct SpheresResult {
  std::vector<Sphere> spheres;
  std::vector<description::Diagnostic> diagnostics;
  bool good = false;
};

/// Reads a table of spheres; lengths whose column states no unit have this one.
SpheresResult read_spheres(const std::filesystem::path& path, const model::Robot& robot, double length_unit);

/// Returns the spheres that a URDF has as collision geometry; none of other text.
std::vector<Sphere> spheres_of_urdf(const std::string& text, const description::ReadOptions& options,
                                    const model::Robot& robot);

}  // namespace qvgen::calibrate
