// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace qvgen::report {

/// Images of the points of a grid, row by row.
struct GridImage {
  std::size_t rows = 0, columns = 0;
  std::vector<std::array<double, 2>> points;
};

/// The area that the images of a grid's cells cover, counted once however often it is covered: triangles
/// filled into a raster of a million cells.
double swept_area(const GridImage& image);

}  // namespace qvgen::report
