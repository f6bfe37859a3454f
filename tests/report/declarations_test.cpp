// SPDX-License-Identifier: MIT
#include "report/declarations.h"

#include <gtest/gtest.h>

namespace {

using qvgen::report::declarations_in;

TEST(Declarations, OfAHeaderWithTheirComments) {
  const auto found = declarations_in(R"(#pragma once
namespace qvgen {
/// A type.
struct Type {
  int a;
};
/// Does a thing,
/// in two lines.
///
/// Bounds.
template <class Scalar>
Pose<Scalar> pose(const Type& q,
                  const int n = 3);
int plain();
/// Said at once.
inline int small(int a) {
  return a;
}
extern template Pose<double> pose(const Type&, const int);
}
)");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "pose");
  EXPECT_EQ(found[0].signature, "Pose<Scalar> pose(const Type& q,\n                  const int n = 3)");
  EXPECT_EQ(found[0].comment, (std::vector<std::string>{"Does a thing, in two lines.", "Bounds."}));
  EXPECT_EQ(found[1].name, "small");
  EXPECT_EQ(found[1].signature, "inline int small(int a)");
}

}  // namespace
