// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "description/tree/rigid.h"

/// Triangles of an STL, OBJ or MSH file, and the mass and moments of what they enclose, by MuJoCo's rules.
namespace qvgen::description::xml {

using Point = std::array<double, 3>;

struct Mesh {
  std::vector<Point> points;  ///< rounded to 32 bits, as MuJoCo has them
  std::vector<std::array<std::size_t, 3>> triangles;
  std::string problem;  ///< why there are none; empty: there are
};

/// Larger files are refused.
inline constexpr std::size_t max_mesh_size = 200'000'000;

/// Reads a binary or ASCII STL, an OBJ or MuJoCo's own MSH file, chosen by its extension.
Mesh read_mesh(const std::filesystem::path& path);
Mesh read_stl(const std::string& text);
Mesh read_obj(const std::string& text);
Mesh read_msh(const std::string& text);

/// The triangles around all points of a mesh, outwards; the mesh's own do not count.
Mesh convex_hull(const Mesh& mesh);

/// How the volume is counted: `legacy` takes that of every triangle's pyramid as positive (MuJoCo's default,
/// which forgives triangles that face the wrong way), `exact` with its sign, `shell` the surface.
enum class MeshInertia { legacy, exact, shell };

/// Volume (or surface) with centre and tensor for a density of 1.
struct MeshIntegrals {
  double volume = 0;
  Point centre{};
  std::array<Point, 3> inertia{};  ///< about the centre
};
MeshIntegrals integrals(const Mesh& mesh, MeshInertia inertia);

}  // namespace qvgen::description::xml
