// SPDX-License-Identifier: MIT
#include <filesystem>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <qvgen/map/grid.h>

#include "description/reader.h"
#include "map/sphere.h"

namespace qvgen::map {
namespace {

TEST(Grid, HasTheCellsWhoseCentresAreInTheSphere) {
  for (const double radius : {0.05, 0.1, 0.34999, 0.5, 1.23}) {
    const Grid grid({{0.1, -0.2, 0.3}, radius, 0.1});
    std::set<std::array<std::int64_t, 3>> expected;
    for (std::int64_t i = -15; i <= 15; ++i)
      for (std::int64_t j = -15; j <= 15; ++j)
        for (std::int64_t k = -15; k <= 15; ++k)
          if (0.1 * std::sqrt(static_cast<double>(i * i + j * j + k * k)) <= radius * (1 + 1e-12))
            expected.insert({i, j, k});
    std::set<std::array<std::int64_t, 3>> found;
    for (std::uint64_t n = 0; n < grid.cells(); ++n) found.insert(grid.cell(n));
    EXPECT_EQ(found, expected) << radius;
    EXPECT_EQ(grid.cells(), expected.size()) << radius;
  }
}

TEST(Grid, NumbersItsCellsInOneOrder) {
  const Grid grid({{0, 0, 0}, 1, 0.13});
  for (std::uint64_t n = 1; n < grid.cells(); ++n) EXPECT_LT(grid.cell(n - 1), grid.cell(n));
  const auto place = Grid({{0.5, 0.25, 2}, 1, 0.25}).position(0);
  EXPECT_EQ(place, (std::array<double, 3>{-0.5, 0.25, 2}));
}

TEST(Grid, DealsAllCellsIntoBlocks) {
  for (const double resolution : {2.0, 0.4, 0.11, 0.01}) {
    const Grid grid({{0, 0, 0}, 1, resolution});
    EXPECT_EQ(grid.first_of(0), 0U);
    EXPECT_EQ(grid.first_of(Grid::blocks), grid.cells());
    for (int block = 0; block < Grid::blocks; ++block) {
      const std::uint64_t count = grid.first_of(block + 1) - grid.first_of(block);
      EXPECT_LE(count, grid.cells() / Grid::blocks + 1);
      EXPECT_GE(count, grid.cells() / Grid::blocks);
    }
  }
}

/// Random joint values of an arm, its slides within limits.
std::vector<double> some_joints(const report::Chain& chain, std::mt19937& engine) {
  std::vector<double> q;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const auto [lower, upper] = report::range_of(chain, i);
    q.push_back(std::uniform_real_distribution<double>(lower, upper)(engine));
  }
  return q;
}

TEST(Sphere, IsNeverLeft) {
  for (const auto& file : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (file.path().extension() != ".toml") continue;
    const auto read = description::read_file(file.path(), {});
    ASSERT_TRUE(read.robot) << file.path();
    report::Chain chain = report::chain_of(*read.robot);
    for (report::ChainJoint& joint : chain.joints)
      if (!joint.revolute) joint.limits.emplace(-0.1, 0.5);
    const Sphere sphere = sphere_of(chain, {});
    const report::Vector centre(sphere.centre[0], sphere.centre[1], sphere.centre[2]);
    double most = 0;
    std::mt19937 engine(5);
    for (int n = 0; n < 20000; ++n) {
      const report::Vector tool =
          report::posture_of(chain, report::following(chain, some_joints(chain, engine))).tool.translation();
      most = std::max(most, (tool - centre).norm());
    }
    EXPECT_LE(most, sphere.radius) << file.path();
    EXPECT_GT(most, 0.55 * sphere.radius) << file.path() << ": the bound is too wide";
  }
}

TEST(Sphere, IsWhatGeometrySays) {
  const auto read = description::read_file(QVGEN_SOURCE_DIR "/generator/robots/nr.toml", {});
  const Sphere sphere = sphere_of(report::chain_of(*read.robot), {});
  EXPECT_NEAR(sphere.radius, std::hypot(0.2, 0.4 + 0.25), 1e-6);
  EXPECT_NEAR(sphere.centre[2], 0.5, 1e-6);
  EXPECT_EQ(sphere_of(report::chain_of(*read.robot), 3.0).radius, 3);
}

TEST(Sphere, NeedsLimitsOfSlides) {
  const auto read = description::read_file(QVGEN_SOURCE_DIR "/generator/robots/stanford.toml", {});
  const report::Chain chain = report::chain_of(*read.robot);
  EXPECT_THROW(sphere_of(chain, {}), std::runtime_error);
  EXPECT_EQ(sphere_of(chain, 0.5).radius, 0.5);
}

}  // namespace
}  // namespace qvgen::map
