// SPDX-License-Identifier: MIT
// Edges of the panels that picture.cpp draws. Scripts mark a place of the path there.
#pragma once

namespace qvgen::path {

/// Left edge and width of the panels, and the top of the first, in the units of the SVG.
inline constexpr double map_left = 70, map_width = 760, map_top = 50;

}  // namespace qvgen::path
