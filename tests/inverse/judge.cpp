// SPDX-License-Identifier: MIT
#include "judge.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

/// The demand is 1e-12 m and rad; of a pose metres away, that share.
double allowed(const Sample& sample) { return 1e-12 * (1 + sample.target.translation().norm()); }

class Judge {
 public:
  Judge(const Case& test, const Sample& sample, const Found& found)
      : test_(test), sample_(sample), found_(found) {}

  Verdict result() {
    verdict_.rows = static_cast<int>(found_.rows.size());
    if (verdict_.rows > test_.robot().info.capacity) blame("more rows than the capacity");
    for (std::size_t i = 0; i < found_.rows.size(); ++i) row(i);
    status();
    if (sample_.expect == Expect::joints && !contains(test_, found_, sample_)) {
      verdict_.told = admits();
      verdict_.missing = !verdict_.told;
      if (!test_.robot().info.by_elimination) blame("the sampled joints are missing");
    }
    return verdict_;
  }

 private:
  void blame(const std::string& what) {
    if (!verdict_.fault.empty()) return;
    std::ostringstream text;
    text.precision(17);
    text << test_.robot().name << ": " << what << "; sampled " << sample_.q.transpose() << "; "
         << found_.rows.size() << " rows";
    for (const Row& r : found_.rows) text << "\n  " << r.q.transpose() << (r.continuum ? " (continuum)" : "");
    verdict_.fault = text.str();
  }

  /// True if the arm has no closed form, and its status says that there may be more solutions.
  [[nodiscard]] bool admits() const {
    return test_.robot().info.by_elimination && found_.status == Status::incomplete;
  }

  void row(std::size_t i) {
    const Row& own = found_.rows[i];
    const Case::Miss miss = test_.miss(own.q, sample_.target);
    verdict_.miss.position = std::max(verdict_.miss.position, miss.position);
    verdict_.miss.orientation = std::max(verdict_.miss.orientation, miss.orientation);
    if (!(miss.largest() < allowed(sample_))) {
      ++verdict_.bad;
      blame("row " + std::to_string(i) + " misses the pose by " + std::to_string(miss.largest() * 1e12) +
            "e-12");
    }
    for (int k = 0; k < test_.dof(); ++k)
      if (test_.revolute(k) && k != test_.robot().info.given_joint && !(own.q[k] > -pi && own.q[k] <= pi))
        blame("an angle outside (-pi, pi]");
    for (std::size_t j = 0; j < i; ++j) {
      if (found_.rows[j].branch >= own.branch) blame("branches out of order");
      if (test_.distance(found_.rows[j].q, own.q) > 1e-9) continue;
      ++verdict_.repeated;
      blame("rows " + std::to_string(j) + " and " + std::to_string(i) + " are the same");
    }
  }

  void status() {
    bool continuum = false;
    for (const Row& r : found_.rows) continuum = continuum || r.continuum;
    const Status status = found_.status;
    // All allowed work was done: there may be other rows, or none. How often is the law of budget_test.cpp.
    if (status == Status::incomplete && found_.effort.used_up && sample_.expect != Expect::invalid) return;
    const bool none = status == Status::unreachable || status == Status::invalid;
    if (found_.rows.empty() != none) blame("status and rows disagree");
    if (!none && !admits() && (status == Status::singular) != continuum)
      blame("status and marks of a continuum disagree");
    if (sample_.expect == Expect::invalid && status != Status::invalid) blame("should be invalid");
    if (sample_.expect != Expect::invalid && status == Status::invalid) blame("should not be invalid");
    if (sample_.expect == Expect::unreachable && status != Status::unreachable)
      blame("should be unreachable");
  }

  const Case& test_;
  const Sample& sample_;
  const Found& found_;
  Verdict verdict_;
};

/// Brings joints to the pose by small steps across the directions in which it does not change.
Eigen::VectorXd projected(const Case& test, const Sample& sample, Eigen::VectorXd q) {
  for (int step = 0; step < 6 && test.miss(q, sample.target).largest() >= allowed(sample); ++step)
    q = test.moved(q, reference::least_squares(test.jacobian(q), test.residual(q, sample.target), 1e-5));
  return q;
}

/// True if a curve of joints that all reach the pose leads from the sample to a row: it is followed in steps.
/// Between two separate solutions there is none: the steps fall back to the first, and a jump is left over at
/// the end.
bool joined(const Case& test, const Sample& sample, const Eigen::VectorXd& row) {
  constexpr int steps = 40;
  const double longest = 4 * test.distance(sample.q, row) / steps;
  Eigen::VectorXd q = sample.q;
  for (int left = steps; left > 0; --left) {
    const Eigen::VectorXd next = projected(test, sample, q + test.difference(q, row) / left);
    if (test.miss(next, sample.target).largest() >= allowed(sample) || test.distance(q, next) > longest)
      return false;
    q = next;
  }
  return test.distance(q, row) < 1e-6;
}

}  // namespace

bool contains(const Case& test, const Found& found, const Sample& sample, double close) {
  bool continuum = false;
  for (const Row& row : found.rows) {
    if (test.distance(sample.q, row.q) < close) return true;
    continuum = continuum || row.continuum;
  }
  if (continuum) {
    const Found seeded = test.robot().solve_from(sample.pose, test.given(sample.q), sample.q);
    if (!seeded.rows.empty() && test.distance(seeded.rows.front().q, sample.q) < close) return true;
  }
  for (const Row& row : found.rows)
    if (joined(test, sample, row.q)) return true;
  return false;
}

Verdict judge(const Case& test, const Sample& sample, const Found& found) {
  return Judge(test, sample, found).result();
}

}  // namespace qvgen::test
