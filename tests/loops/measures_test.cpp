// SPDX-License-Identifier: MIT
// Measures of both kinds of singularity, where two assemblies meet and vanish: from the motors the passive
// joints can move there, from the platform's place the motors can. The law needs no Jacobian.
#include <algorithm>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "compiled_loops.h"
#include "reference/loops.h"

namespace qvgen::test::loops {
namespace {

/// One way through the loops of a mechanism, with the measure of its own kind and that of the other.
class Way {
 public:
  Way(const Compiled& compiled, const std::string& robot, const std::string& function, Eigen::Index dof)
      : compiled_(&compiled), robot_(robot), function_(robot + "_" + function), dof_(dof) {}

  [[nodiscard]] std::vector<Row> rows(const VectorXd& given) const {
    return compiled_->solve(function_, given, dof_).rows;
  }
  [[nodiscard]] double least(const std::string& measure, const VectorXd& given) const {
    const auto call = compiled_->get<double(const double*, const double*)>(robot_ + "_" + measure);
    double least = 1e300;
    for (const Row& row : rows(given)) least = std::min(least, call(row.q.data(), nullptr));
    return least;
  }

 private:
  const Compiled* compiled_;
  std::string robot_, function_;
  Eigen::Index dof_;
};

/// Walks until there are fewer assemblies; returns the last place before that, if the walk comes there.
std::optional<VectorXd> end_of(const Way& way, const VectorXd& begin, const VectorXd& step) {
  const std::size_t count = way.rows(begin).size();
  double inside = 0, outside = 1;
  while (way.rows(begin + outside * step).size() >= count)
    if (outside += 1; outside > 400) return std::nullopt;
  inside = outside - 1;
  for (int half = 0; half < 60; ++half) {
    const double middle = (inside + outside) / 2;
    (way.rows(begin + middle * step).size() >= count ? inside : outside) = middle;
  }
  return begin + inside * step;
}

void expect_zero_at_ends(const std::string& robot, const std::string& function, const std::string& measure,
                         const std::string& other) {
  SCOPED_TRACE(robot + " " + function);
  const Folder folder;
  const std::filesystem::path file = folder.path / (robot + ".toml");
  std::filesystem::copy(std::filesystem::path(QVGEN_LOOP_ROBOTS) / (robot + ".toml"), file);
  const reference::LoopMechanism mechanism = reference::load_loops(file);
  const auto dof = static_cast<Eigen::Index>(mechanism.chain.joints.size());
  const Compiled compiled(file, "assembly");
  const Way way(compiled, robot, function, dof);
  const auto& given = function == "assemble" ? mechanism.driven : mechanism.outputs;
  std::mt19937 random(3);
  int ends = 0, others = 0;
  for (const VectorXd& q : reference::assemblies(mechanism, VectorXd::Zero(dof), {}, 40, 7)) {
    const VectorXd begin = q(given);
    const VectorXd step = VectorXd::NullaryExpr(
        begin.size(), [&] { return std::uniform_real_distribution<double>(-0.02, 0.02)(random); });
    if (way.rows(begin).empty() || way.least(measure, begin) < 1e-2) continue;
    const auto end = end_of(way, begin, step);
    if (!end) continue;
    EXPECT_LT(way.least(measure, *end), 1e-4);
    ++ends;
    others += way.least(other, *end) > 1e-3 ? 1 : 0;
  }
  EXPECT_GE(ends, 5);
  EXPECT_GE(2 * others, ends) << "the other measure is of another kind";
}

TEST(Measures, OfThePlatformVanishWhereWorkingModesMeet) {
  expect_zero_at_ends("delta", "assemble_from_outputs", "platform_measure", "drive_measure");
  expect_zero_at_ends("planar_3rrr", "assemble_from_outputs", "platform_measure", "drive_measure");
}

TEST(Measures, OfDrivesVanishWhereAssembliesMeet) {
  expect_zero_at_ends("delta", "assemble", "drive_measure", "platform_measure");
}

}  // namespace
}  // namespace qvgen::test::loops
