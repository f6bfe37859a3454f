// SPDX-License-Identifier: MIT
// Poses that lack solutions without one of the passes of quartic/care.h. They were found by leaving out each
// pass in turn at 20,000 singular poses of every arm.
#include <array>

#include "check.h"

namespace qvgen::test {
namespace {

/// A pose, by joints that reach it, and the rows that there are of it.
struct Singular {
  const char* pass;
  const char* arm;
  std::array<double, 6> q;
  std::size_t rows;
};

constexpr std::array singular_poses{
    Singular{
        "chosen", "parallel_001", {2.5815966453018255, -pi, 0.076581127785509295, 0, -pi / 2, -0.7323929}, 4},
    Singular{"chosen, other", "parallel_001", {0, 1.35e-12, pi, -1.225e-10, -pi / 2, 3.1415926056139525}, 6},
    Singular{"other", "parallel_001", {1.507e-06, -2.1537021755039469, 0, -pi, pi / 2, pi}, 6},
    Singular{"turned",
             "slides_002",
             {3.1415926535859859, -2.6228763603743008, pi / 2, 3.1415926535873404, 5.1902877041674371e-05, 0},
             2},
    Singular{"turned",
             "slides_002",
             {0.87511269360478661, -2.7747095424708439, pi / 2, 1.5036701294309653e-09,
              -8.5428609127998183e-07, -1.288151589437093},
             2},
    Singular{"turned",
             "slides_002",
             {-pi / 2, 0.0004471307326804209, -pi / 2, 3.1415926480487575, 3.1415930212518179,
              2.5359363121580048e-08},
             2},
};

/// An arm of this program by its name, or null.
const InverseUnderTest* arm_of(const std::string& name) {
  for (const InverseUnderTest& each : inverses())
    if (each.name == name) return &each;
  return nullptr;
}

TEST(QuarticPasses, FindWhatOthersLose) {
  int poses = 0;
  for (const Singular& each : singular_poses) {
    const InverseUnderTest* arm = arm_of(each.arm);
    if (arm == nullptr) continue;
    ++poses;
    Case test(*arm);
    const Sample sample = sample_at(test, Eigen::Map<const Eigen::VectorXd>(each.q.data(), 6));
    const Found found = arm->solve(sample.pose, 0, inverse::default_tolerance);
    EXPECT_EQ(found.rows.size(), each.rows) << each.pass;
    EXPECT_EQ(judge(test, sample, found).fault, "") << each.pass;
  }
  EXPECT_GT(poses, 0);
}

}  // namespace
}  // namespace qvgen::test
