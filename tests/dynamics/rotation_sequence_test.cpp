// SPDX-License-Identifier: MIT
#include "derive/dynamics/rotation_sequence.h"

#include <array>

#include <gtest/gtest.h>

#include "exact/constant_angle.h"
#include "exact/point.h"
#include "passes/search/random.h"

namespace qvgen::derive::dynamics {
namespace {

using exact::Number;
using Matrix = std::array<std::array<Number, 3>, 3>;

Matrix matrix_of(const RotationSequence& sequence, const exact::ExactPoint& point) {
  Matrix result{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const ElementaryRotation& turn : sequence) {
    const Number c = point.cosine(turn.angle), s = point.sine(turn.angle);
    const std::size_t i = (turn.axis + 1) % 3, j = (turn.axis + 2) % 3;
    for (auto& row : result) {
      const Number a = row[i], b = row[j];
      row[i] = a * c + b * s;
      row[j] = b * c - a * s;
    }
  }
  return result;
}

exact::Angle quarter(long count) { return {{}, cln::cl_RA(count) / 2}; }
exact::Angle symbol(const std::string& name) { return {{{name, 1}}, 0}; }

TEST(RotationSequence, ReductionKeepsTheRotation) {
  passes::search_detail::Random random(3);
  const exact::ExactPoint point(1);
  for (int round = 0; round < 300; ++round) {
    RotationSequence sequence;
    for (std::uint32_t k = random.below(7); k > 0; --k) {
      const bool free = random.chance(70);
      sequence.push_back({random.chance(128) ? 0U : 2U,
                          free ? symbol("t" + std::to_string(random.below(3))) : quarter(random.below(4))});
    }
    const RotationSequence short_word = reduced(sequence);
    EXPECT_LE(short_word.size(), sequence.size() + 2);
    EXPECT_EQ(matrix_of(short_word, point), matrix_of(sequence, point));
  }
}

/// All 24 rotations of the cube are Rz Rx Rz with nothing left over, however they came about.
TEST(RotationSequence, RightAnglesNeedThreeTurns) {
  passes::search_detail::Random random(4);
  for (int round = 0; round < 300; ++round) {
    RotationSequence sequence;
    for (int k = 0; k < 9; ++k) sequence.push_back({random.chance(128) ? 0U : 2U, quarter(random.below(4))});
    const RotationSequence short_word = reduced(sequence);
    EXPECT_LE(short_word.size(), 3U);
    for (std::size_t i = 0; i + 1 < short_word.size(); ++i)
      EXPECT_NE(short_word[i].axis, short_word[i + 1].axis);
  }
}

TEST(RotationSequence, TakesZToEachAxis) {
  const exact::ExactPoint point(1);
  for (std::size_t k = 0; k < 3; ++k)
    for (const long sign : {1L, -1L}) {
      model::Vector3 axis;
      axis[k] = model::Expression(cln::cl_RA(sign));
      const Matrix m = matrix_of(from_z_to(axis), point);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(m[i][2], Number(i == k ? sign : 0));
    }
}

TEST(RotationSequence, InverseIsTheInverse) {
  const RotationSequence sequence = {{2, symbol("a")}, {0, quarter(1)}, {2, symbol("b")}};
  EXPECT_TRUE(reduced(sequence * inverse(sequence)).empty());
}

/// Rotations between oblique axes are z x z too, with angles that are known by sine and cosine.
TEST(RotationSequence, ConstantRotationsAreRecomposed) {
  passes::search_detail::Random random(5);
  const exact::ExactPoint point(1);
  const Number three = Number(3) / Number(5), four = Number(4) / Number(5);
  const exact::Angle oblique{{{exact::constant_angle({four, three}), 1}}, 0};
  for (int round = 0; round < 100; ++round) {
    RotationSequence sequence;
    for (int k = 0; k < 7; ++k)
      sequence.push_back(
          {random.chance(128) ? 0U : 2U, random.chance(128) ? oblique : quarter(random.below(4))});
    const RotationSequence short_word = recomposed(reduced(sequence));
    EXPECT_LE(short_word.size(), 3U);
    EXPECT_EQ(matrix_of(short_word, point), matrix_of(sequence, point));
  }
}

}  // namespace
}  // namespace qvgen::derive::dynamics
