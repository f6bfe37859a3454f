// SPDX-License-Identifier: MIT
#include "report/linkage.h"

#include <cmath>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "description/reader.h"

namespace {

using namespace qvgen;
using namespace qvgen::report;

Linkage linkage_in(const std::filesystem::path& file) {
  const description::ReadResult read = description::read_file(file, {});
  return linkage_of({*read.robot, read.tips, read.loops});
}

std::vector<Linkage> known_linkages() {
  std::vector<Linkage> linkages;
  for (const auto& file : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/tests/loops/robots")) {
    if (file.path().extension() != ".toml") continue;
    linkages.push_back(linkage_in(file.path()));
  }
  return linkages;
}

/// Joint values of a picture; its loops need not be closed for that.
std::vector<double> random_values(const Linkage& linkage, std::mt19937& random) {
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> q(linkage.chain.joints.size());
  for (double& each : q) each = value(random);
  return q;
}

double gap_in_picture(const View& view, const Vector& a, const Vector& b) {
  const Point from = view.project(a), to = view.project(b);
  return std::hypot(from[0] - to[0], from[1] - to[1]);
}

/// The direction of all turns, zero if they have none in common.
Vector shared_direction(const Linkage& linkage, const PlacedLinkage& at) {
  Vector shared = Vector::Zero();
  for (std::size_t i = 0; i < at.joints.size(); ++i) {
    if (!linkage.chain.joints[i].revolute) continue;
    if (shared.isZero()) shared = at.joints[i].axis;
    if (shared.cross(at.joints[i].axis).norm() > 1e-9) return Vector::Zero();
  }
  return shared;
}

TEST(LinkagePicture, ShowsPlanarMechanismsInTheirPlane) {
  std::mt19937 random(3);
  int planar = 0;
  for (const Linkage& linkage : known_linkages()) {
    const PlacedLinkage at = placed(linkage, random_values(linkage, random));
    const Vector axis = shared_direction(linkage, at);
    if (axis.isZero()) continue;
    ++planar;
    EXPECT_GT(std::abs(View(sight_of(linkage, at)).toward().dot(axis)), 0.85);
  }
  EXPECT_GE(planar, 4);
}

TEST(LinkagePicture, SymbolsOfJointsThatAreApartDoNotHideEachOther) {
  std::mt19937 random(5);
  for (const Linkage& linkage : known_linkages()) {
    const PlacedLinkage at = placed(linkage, random_values(linkage, random));
    const Sight sight = sight_of(linkage, at);
    const double radius = symbol_radius(at, sight), extent = extent_of(at);
    EXPECT_GT(radius, 0.005 * extent);
    for (const Posture::Joint& a : at.joints)
      for (const Posture::Joint& b : at.joints) {
        const double gap = gap_in_picture(View(sight), a.point, b.point);
        if (gap > 0.03 * extent) {
          EXPECT_GT(gap, 2 * radius) << linkage.chain.joints.front().variable;
        }
      }
  }
}

TEST(LinkagePicture, StandsOnZWhereTurnsShareNoDirection) {
  const Linkage linkage = linkage_in(QVGEN_SOURCE_DIR "/tests/loops/robots/delta.toml");
  const PlacedLinkage at = placed(linkage, std::vector<double>(linkage.chain.joints.size(), 0.3));
  const Sight sight = sight_of(linkage, at);
  EXPECT_EQ(sight.azimuth, Sight{}.azimuth);
  EXPECT_EQ(sight.elevation, Sight{}.elevation);
}

}  // namespace
