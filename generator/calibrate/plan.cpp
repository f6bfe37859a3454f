// SPDX-License-Identifier: MIT
#include "calibrate/plan.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <fmt/format.h>

#include "model/motor_ranges.h"

namespace qvgen::calibrate {
namespace {

constexpr std::size_t candidates = 1000;
/// Random postures that are tried until so many keep the clearance; with fewer than `fewest` a plan would be
/// a poor one.
constexpr std::size_t most_tries = 100 * candidates, fewest = 100;
/// Random values of motors among which one must be within limits of joints that several of them move.
constexpr std::size_t most_draws = 10000;
/// Postures by which spheres are found that meet wherever the arm is.
constexpr std::size_t samples = 200;

/// Returns the bounds of a joint: its limits; without, a whole turn, or a slide as long as a third of the
/// arm.
std::pair<double, double> range_of(const model::Joint& joint, const DoubleValues& values, double reach) {
  if (joint.limits) return {values.number(joint.limits->lower), values.number(joint.limits->upper)};
  if (joint.type == model::JointType::revolute) return {-std::numbers::pi, std::numbers::pi};
  return {0, reach / 3};
}

/// Random postures within the limits, and what a measurement at each would tell.
class Planner {
 public:
  Planner(const model::Robot& robot, const Identifiable& can, const State& state, const DataSet& set,
          Clearance clearance)
      : can_(can), state_(state), set_(set), clearance_(std::move(clearance)) {
    const double reach = reach_of(can.model.geometry);
    const DoubleValues values(robot);
    for (const model::Joint& joint : model::driven_joints(robot))
      ranges_.push_back(range_of(joint, values, reach));
    shared_limits_ = model::shared_limits(robot);
    add_candidates();
    information_ =
        normal_of(can.model, {&set, std::vector<double>(set.rows.size(), 1.0)}, state, can.candidates).matrix;
    for (std::size_t i = 0; i < can.candidates.size(); ++i) {
      // Beforehand an error is known to be below what counts as told at all.
      const double most = can.model.parameters[can.candidates[i]].turn ? most_angle : most_length;
      information_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += 1 / (most * most);
    }
  }

  Plan plan(std::size_t count) {
    Plan result;
    result.before = deviation();
    result.touching = touching_;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t best = most_telling(result.postures);
      result.postures.push_back(postures_[best].q);
      information_ += rows_[best].transpose() * rows_[best];
    }
    result.after = deviation();
    return result;
  }

 private:
  double uniform() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }

  /// Returns motors within their limits, at which joints that several of them move are within theirs.
  std::vector<double> random_posture() {
    for (std::size_t tries = 0; tries < most_draws; ++tries) {
      std::vector<double> q;
      for (const auto& [lower, upper] : ranges_) q.push_back(lower + (upper - lower) * uniform());
      const bool is_inside = std::all_of(shared_limits_.begin(), shared_limits_.end(),
                                         [&](const auto& limits) { return limits.hold(limits.at(q)); });
      if (is_inside) return q;
    }
    throw std::runtime_error(fmt::format(
        "of {} random postures of the motors none is within the limits of '{}' and of the other joints that "
        "several motors move: set limits of the motors",
        most_draws, shared_limits_.front().joint));
  }

  void add_candidates() {
    std::vector<std::vector<double>> tried;
    if (!clearance_.empty()) {
      while (tried.size() < samples) tried.push_back(random_posture());
      touching_ = clearance_.leave_out_constant(tried);
    }
    for (std::size_t tries = 0; tries < most_tries && postures_.size() < candidates; ++tries)
      if (const std::vector<double> q = random_posture(); clearance_.kept_at(q)) add_candidate(q);
    if (postures_.size() < fewest)
      throw std::runtime_error(fmt::format(
          "{} of {} random postures keep the spheres apart: {} meet most often; make these smaller, "
          "or set limits of the joints",
          postures_.size(), most_tries, clearance_.nearest_links(tried)));
  }

  void add_candidate(const std::vector<double>& q) {
    const std::size_t number = postures_.size();
    Measurement each;
    each.q = q;
    each.target = number % can_.setup.targets;
    each.surface = can_.setup.surfaces > 0 ? number % can_.setup.surfaces : 0;
    each.pose = identity(1.0);
    each.sigma = set_.rows.empty() ? usual_sigma : set_.rows.front().sigma;
    each.sigma_angle = set_.rows.empty() ? usual_sigma_angle : set_.rows.front().sigma_angle;
    const Residual residual = residual_of(can_.model, can_.setup.data, state_, each);
    const Eigen::VectorXd weights = deviations(can_.setup.data, each).cwiseInverse();
    Eigen::MatrixXd rows(weights.size(), static_cast<Eigen::Index>(can_.candidates.size()));
    for (std::size_t k = 0; k < can_.candidates.size(); ++k)
      rows.col(static_cast<Eigen::Index>(k)) =
          residual.derivative.col(static_cast<Eigen::Index>(can_.candidates[k])).cwiseProduct(weights);
    rows_.push_back(std::move(rows));
    postures_.push_back(std::move(each));
  }

  /// Returns det(1 + J H^-1 J^T) of each candidate.
  [[nodiscard]] std::vector<double> gains() const {
    const Eigen::LLT<Eigen::MatrixXd> solver(information_);
    std::vector<double> result;
    for (const Eigen::MatrixXd& rows : rows_) {
      const Eigen::MatrixXd half = solver.matrixL().solve(rows.transpose());
      result.push_back(
          (Eigen::MatrixXd::Identity(half.cols(), half.cols()) + half.transpose() * half).determinant());
    }
    return result;
  }

  /// Returns the candidate that tells most of those that the last posture leads to.
  [[nodiscard]] std::size_t most_telling(const std::vector<std::vector<double>>& planned) const {
    const std::vector<double> gain = gains();
    std::vector<std::size_t> order(gain.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return gain[a] > gain[b]; });
    if (planned.empty() || clearance_.empty()) return order.front();
    const auto found = std::find_if(order.begin(), order.end(), [&](std::size_t i) {
      return clearance_.kept_between(planned.back(), postures_[i].q);
    });
    if (found != order.end()) return *found;
    throw std::runtime_error(
        fmt::format("no straight motion of the joints leads on from the posture {} without a meeting: "
                    "plan fewer, or make the spheres smaller",
                    planned.size()));
  }

  /// Returns the expected deviation of what is measured first, a position or a distance, over all candidates.
  [[nodiscard]] double deviation() const {
    const Eigen::LLT<Eigen::MatrixXd> solver(information_);
    double sum = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Eigen::MatrixXd heads =
          rows_[i].topRows(std::min<Eigen::Index>(3, rows_[i].rows())) * postures_[i].sigma;
      sum += solver.matrixL().solve(heads.transpose()).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(rows_.size()));
  }

  const Identifiable& can_;
  const State& state_;
  const DataSet& set_;
  Clearance clearance_;
  std::vector<std::string> touching_;
  std::mt19937_64 random_{1};
  std::vector<std::pair<double, double>> ranges_;
  std::vector<model::SharedLimits> shared_limits_;
  std::vector<Measurement> postures_;
  std::vector<Eigen::MatrixXd> rows_;
  Eigen::MatrixXd information_;
};

}  // namespace

Plan plan(const model::Robot& robot, const Identifiable& can, const State& state, const DataSet& set,
          std::size_t count, Clearance clearance) {
  return Planner(robot, can, state, set, std::move(clearance)).plan(count);
}

State state_without_data(const Identifiable& can) {
  const Vec<double> off_all_axes{0.07, 0.04, 0.1};
  const Rigid<double> target = can.setup.target_known ? identity(1.0) : shift(off_all_axes, 1.0);
  return {std::vector<double>(can.model.parameters.size(), 0.0), {identity(1.0), {target}}, {}};
}

std::string table_of(const model::Robot& robot, const Plan& plan) {
  std::vector<bool> turns;
  std::string text;
  for (const model::Joint& joint : model::driven_joints(robot)) {
    turns.push_back(joint.type == model::JointType::revolute);
    text +=
        fmt::format("{}q{} [{}]", turns.size() > 1 ? ", " : "", turns.size(), turns.back() ? "deg" : "mm");
  }
  for (const std::vector<double>& q : plan.postures) {
    text += "\n";
    for (std::size_t i = 0; i < q.size(); ++i)
      text += fmt::format("{}{:.3f}", i > 0 ? ", " : "", q[i] * (turns[i] ? 180 / std::numbers::pi : 1e3));
  }
  return text + "\n";
}

}  // namespace qvgen::calibrate
