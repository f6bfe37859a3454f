// SPDX-License-Identifier: MIT
#include "verify/loops/mobility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <tuple>
#include <utility>

#include "dag/evaluate.h"
#include "derive/inverse/lower.h"
#include "derive/inverse/names.h"
#include "derive/loops/named_angles.h"
#include "exact/named_constant.h"
#include "matrices/decompositions.h"
#include "model/private_names.h"
#include "model/replace.h"

namespace qvgen::verify {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
namespace names = derive::inverse::names;

constexpr int most_starts = 400;
constexpr int most_steps = 100;
constexpr int samples = 5;
/// Singular values below this share of the greatest are none.
constexpr double rank_share = 1e-7;

struct Leaves {
  const std::map<std::string, double>& values;
  double constant(const exact::Number& number) const { return number.to_double(); }
  double symbol(const std::string& name) const {
    if (const auto constant = exact::named_value(name)) return cln::double_approx(*constant);
    return values.at(name);
  }
  double sine(const dag::Angle& angle) const { return std::sin(of(angle)); }
  double cosine(const dag::Angle& angle) const { return std::cos(of(angle)); }
  static double root(double x) { return std::sqrt(std::max(x, 0.0)); }
  static double arctangent(double y, double x) { return std::atan2(y, x); }

 private:
  double of(const dag::Angle& angle) const {
    double sum = cln::double_approx(angle.pi) * M_PI;
    for (const auto& [name, coefficient] : angle.terms) sum += cln::double_approx(coefficient) * symbol(name);
    return sum;
  }
};

std::vector<std::string> output_names(const symbolic::Program& program) {
  std::vector<std::string> result;
  for (const auto& output : program.outputs()) result.push_back(output.name);
  return result;
}

dag::Function lowered(const symbolic::Program& program) {
  return derive::inverse::lowered(program, output_names(program));
}

int rank_of(const MatrixXd& matrix) {
  if (matrix.rows() == 0) return 0;
  const VectorXd values = matrices::singular_values(matrix);
  return static_cast<int>((values.array() > rank_share * std::max(values[0], 1e-300)).count());
}

/// Equations that a closure in space would be.
int equations_in_space(model::LoopType type) {
  static constexpr std::array<int, 5> counts{5, 3, 1, 6, 5};  // in the order of the types
  return counts.at(static_cast<std::size_t>(type));
}

/// Loops whose rows do not raise the rank of those before them.
std::vector<std::size_t> redundant_in(const MatrixXd& jacobian, const std::vector<std::size_t>& loop_of_row) {
  std::vector<std::size_t> result;
  int rank = 0;
  for (Eigen::Index row = 0; row < jacobian.rows();) {
    const std::size_t loop = loop_of_row[static_cast<std::size_t>(row)];
    while (row < jacobian.rows() && loop_of_row[static_cast<std::size_t>(row)] == loop) ++row;
    const int with = rank_of(jacobian.topRows(row));
    if (with == rank) result.push_back(loop);
    rank = with;
  }
  return result;
}

std::vector<std::size_t> still_in(const MatrixXd& jacobian) {
  const int rank = rank_of(jacobian);
  const MatrixXd motions = matrices::singular_motions(jacobian).motions.rightCols(jacobian.cols() - rank);
  std::vector<std::size_t> result;
  for (Eigen::Index i = 0; i < motions.rows(); ++i)
    if (motions.cols() == 0 || motions.row(i).norm() < rank_share)
      result.push_back(static_cast<std::size_t>(i));
  return result;
}

/// Joints that move in the motions that the loops allow while others are held.
std::vector<std::size_t> loose_in(const MatrixXd& jacobian, const std::vector<std::size_t>& held) {
  MatrixXd rows = MatrixXd::Zero(jacobian.rows() + static_cast<Eigen::Index>(held.size()), jacobian.cols());
  rows.topRows(jacobian.rows()) = jacobian;
  for (std::size_t i = 0; i < held.size(); ++i)
    rows(jacobian.rows() + static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(held[i])) = 1;
  const std::vector<std::size_t> still = still_in(rows);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < static_cast<std::size_t>(jacobian.cols()); ++i)
    if (!std::binary_search(still.begin(), still.end(), i)) result.push_back(i);
  return result;
}

std::vector<std::size_t> in_both(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::vector<std::size_t> result;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/// How many equations of a closure, the last ones, are angles.
std::size_t angles_of(const derive::loops::Cycle& cycle) {
  return cycle.directions.size() + (cycle.gear.empty() ? 0 : 1);
}

/// Distance of a rod's ends by its gap, (distance^2 - length^2) / 2 length.
double ends_apart(double length, double gap) { return std::sqrt(std::max(length * (length + 2 * gap), 0.0)); }

std::string count_of(int count, const std::string& of) {
  return std::to_string(count) + " " + of + (count == 1 ? "" : "s");
}

}  // namespace

LoopNumbers::LoopNumbers(const model::Mechanism& mechanism)
    : robot_(derive::loops::with_named_angles(model::with_private_names(mechanism.robot))),
      geometry_(model::sample_geometry(robot_)) {
  const derive::inverse::Scope scope = derive::loops::scope_of(robot_, mechanism.loops);
  const auto cycles = derive::loops::cycles_of(mechanism, robot_, scope);
  const derive::loops::Constraints constraints = derive::loops::constraints_of(robot_, cycles);
  gap_ = lowered(constraints.gap);
  jacobian_ = lowered(constraints.jacobian);
  for (const auto& cycle : cycles) {
    loop_of_row_.insert(loop_of_row_.end(), derive::loops::rows_of(cycle), cycle.number - 1);
    rods_.resize(loop_of_row_.size());
    are_lengths_.resize(loop_of_row_.size() - angles_of(cycle), true);
    are_lengths_.resize(loop_of_row_.size(), false);
    if (cycle.type != model::LoopType::rod) continue;
    if (cycle.length_joint)
      rods_.back().joint = static_cast<Eigen::Index>(*cycle.length_joint);
    else
      rods_.back().length = model::to_double(model::evaluate(
          mechanism.loops.closures[cycle.number - 1].length, model::sample_geometry(mechanism.robot)));
  }
  size_ = 1e-3;
  std::mt19937 random(1);
  for (int sample = 0; sample < 8; ++sample) {
    VectorXd q = VectorXd::Zero(static_cast<Eigen::Index>(robot_.joints.size()));
    for (Eigen::Index i = 0; i < q.size(); ++i)
      if (robot_.joints[static_cast<std::size_t>(i)].type == model::JointType::revolute)
        q[i] = static_cast<double>(random() % 6283) / 1000;
    for (const Rod& rod : rods_)
      if (rod.joint) q[*rod.joint] = 1;
    const VectorXd gap = gaps(q);
    for (Eigen::Index row = 0; row < gap.size(); ++row) {
      if (!are_lengths_[static_cast<std::size_t>(row)]) continue;
      const Rod& rod = rods_[static_cast<std::size_t>(row)];
      const double length = rod_length(row, q), apart = ends_apart(length, gap[row]);
      const double wide = std::abs(gap[row]);  // far more than the distance if the rod is short
      size_ = std::max(size_, rod.joint ? apart : length > 0 ? std::min(wide, apart) : wide);
    }
  }
}

namespace {

std::map<std::string, double> values_at(const model::Robot& robot, const model::Bindings& geometry,
                                        const VectorXd& q) {
  std::map<std::string, double> values;
  for (const auto& [name, value] : geometry) values[name] = model::to_double(value);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const std::string& variable = robot.joints[i].variable;
    const double at = q[static_cast<Eigen::Index>(i)];
    values[variable] = at;
    values[names::cosine(variable)] = std::cos(at);
    values[names::sine(variable)] = std::sin(at);
  }
  return values;
}

}  // namespace

VectorXd LoopNumbers::gaps(const VectorXd& q) const {
  const auto values = values_at(robot_, geometry_, q);
  const std::vector<double> results = dag::evaluate<double>(gap_, Leaves{values});
  return Eigen::Map<const VectorXd>(results.data(), static_cast<Eigen::Index>(results.size()));
}

MatrixXd LoopNumbers::jacobian(const VectorXd& q) const {
  const auto values = values_at(robot_, geometry_, q);
  const std::vector<double> results = dag::evaluate<double>(jacobian_, Leaves{values});
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(results.data(), static_cast<Eigen::Index>(loop_of_row_.size()), q.size());
}

std::optional<VectorXd> LoopNumbers::closed_from(VectorXd q) const {
  for (int step = 0; step < most_steps; ++step) {
    VectorXd off = gaps(q);
    if (!off.allFinite() || off.norm() > 1e6 * size_) return std::nullopt;
    if (off.cwiseAbs().maxCoeff() < 1e-13 * size_) {
      // Gears of a cylinder see the sign of its length: then steps go on from there.
      const VectorXd above = with_lengths_above_zero(q);
      if (gaps(above).cwiseAbs().maxCoeff() < 1e-13 * size_) return above;
      q = above;
      continue;
    }
    MatrixXd by = jacobian(q);
    // The gap of a short rod grows with the square of its ends' distance: it shall not outweigh all others.
    for (Eigen::Index row = 0; row < off.size(); ++row) {
      const double length = rod_length(row, q), share = std::abs(length) / ends_apart(length, off[row]);
      if (!(share < 1) || share == 0) continue;
      off[row] *= share;
      by.row(row) *= share;
    }
    // Damped by the gap: where redundant equations agree on a whole path, they shall not draw along it to its
    // end.
    MatrixXd square = by * by.transpose();
    square.diagonal().array() += off.norm() * size_;
    VectorXd way = by.transpose() * matrices::solve_symmetric(square, off);
    const double longest = way.cwiseAbs().maxCoeff();
    if (longest > 0.5) way *= 0.5 / longest;
    q -= way;
  }
  q = with_lengths_above_zero(q);
  if (gaps(q).cwiseAbs().maxCoeff() < 1e-11 * size_) return q;
  return std::nullopt;
}

VectorXd LoopNumbers::with_lengths_above_zero(VectorXd q) const {
  for (const Rod& rod : rods_)
    if (rod.joint) q[*rod.joint] = std::abs(q[*rod.joint]);
  return q;
}

double LoopNumbers::rod_length(Eigen::Index row, const VectorXd& q) const {
  const Rod& rod = rods_[static_cast<std::size_t>(row)];
  return rod.joint ? q[*rod.joint] : rod.length;
}

std::optional<VectorXd> LoopNumbers::assembled(unsigned seed) const {
  std::mt19937 random(seed);
  // Whole numbers alone are the same on every machine.
  const auto number = [&] { return static_cast<double>(random() % 20001) / 10000 - 1; };
  for (int start = 0; start < most_starts; ++start) {
    VectorXd q(static_cast<Eigen::Index>(robot_.joints.size()));
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const bool turns = robot_.joints[static_cast<std::size_t>(i)].type == model::JointType::revolute;
      q[i] = number() * (turns ? 3.1 : size_);
    }
    if (const auto closed = closed_from(q)) return closed;
  }
  return std::nullopt;
}

namespace {

/// A closed assembly, and what its loops leave. Assemblies may be of several kinds: some do not move, and a
/// scissor's bars may lie on each other.
struct Sample {
  MatrixXd jacobian;
  std::vector<std::size_t> still, loose;
  bool fits;    ///< the driven joints determine it
  bool within;  ///< all joints are within their limits
  int free;

  /// Compares kinds: the greatest one is that of the mechanism.
  [[nodiscard]] auto kind() const { return std::tuple(fits, within, -static_cast<int>(still.size()), free); }
};

bool is_within_limits(const model::Robot& robot, const VectorXd& q) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const auto& limits = robot.joints[i].limits;
    if (!limits || !model::symbols(limits->lower).empty() || !model::symbols(limits->upper).empty()) continue;
    const double lower = model::to_double(model::evaluate(limits->lower)),
                 upper = model::to_double(model::evaluate(limits->upper));
    double at = q[static_cast<Eigen::Index>(i)];
    if (robot.joints[i].type == model::JointType::revolute)  // the turn nearest to the middle of the limits
      at -= 2 * M_PI * std::round((at - (lower + upper) / 2) / (2 * M_PI));
    if (at < lower || at > upper) return false;
  }
  return true;
}

Sample sample_at(const LoopNumbers& numbers, const model::Mechanism& mechanism, const VectorXd& q) {
  const std::vector<std::size_t>& driven = mechanism.loops.actuated;
  Sample sample{numbers.jacobian(q), {}, {}, false, is_within_limits(mechanism.robot, q), 0};
  sample.free = static_cast<int>(q.size()) - rank_of(sample.jacobian);
  sample.still = still_in(sample.jacobian);
  sample.loose = loose_in(sample.jacobian, driven);
  sample.fits = !driven.empty() && sample.free == static_cast<int>(driven.size()) && sample.loose.empty();
  return sample;
}

/// Assemblies of the mechanism's kind.
std::vector<Sample> samples_of(const LoopNumbers& numbers, const model::Mechanism& mechanism) {
  std::vector<Sample> found;
  for (unsigned seed = 1; seed <= samples; ++seed) {
    const auto q = numbers.assembled(seed);
    if (!q) break;
    found.push_back(sample_at(numbers, mechanism, *q));
  }
  const auto less = [](const Sample& a, const Sample& b) { return a.kind() < b.kind(); };
  const auto best = std::max_element(found.begin(), found.end(), less);
  if (best == found.end()) return found;
  std::erase_if(found, [kind = best->kind()](const Sample& each) { return each.kind() != kind; });
  return found;
}

}  // namespace

std::vector<MatrixXd> jacobians_of(const model::Mechanism& mechanism) {
  std::vector<MatrixXd> result;
  for (Sample& sample : samples_of(LoopNumbers(mechanism), mechanism))
    result.push_back(std::move(sample.jacobian));
  return result;
}

Mobility mobility_of(const model::Mechanism& mechanism) {
  Mobility result;
  const LoopNumbers numbers(mechanism);
  result.joints = static_cast<int>(mechanism.robot.joints.size());
  result.gruebler = result.joints - static_cast<int>(mechanism.loops.gears.size());
  for (const model::Loop& loop : mechanism.loops.closures) result.gruebler -= equations_in_space(loop.type);
  result.in_planes = result.joints - static_cast<int>(numbers.loop_of_row().size());
  for (const Sample& sample : samples_of(numbers, mechanism)) {
    const auto redundant = redundant_in(sample.jacobian, numbers.loop_of_row());
    const bool is_first = !result.assembled;
    result.free = sample.free;
    result.redundant = is_first ? redundant : in_both(result.redundant, redundant);
    result.still = is_first ? sample.still : in_both(result.still, sample.still);
    result.loose = is_first ? sample.loose : in_both(result.loose, sample.loose);
    result.assembled = true;
  }
  return result;
}

namespace {

/// Why Gruebler's formula, which counts equations, does not tell how many freedoms there are.
std::string reason_of(const Mobility& mobility) {
  std::vector<std::string> reasons;
  if (mobility.in_planes != mobility.gruebler) reasons.push_back("that axes are parallel");
  if (mobility.in_planes != mobility.free) {
    std::string loops;
    for (const std::size_t loop : mobility.redundant)
      loops += (loops.empty() ? "" : ", ") + std::to_string(loop + 1);
    reasons.push_back(loops.empty()
                          ? "that equations of the loops agree, as their lengths or axes are special"
                          : "that loop " + loops + " holds nothing more");
  }
  return reasons.size() == 2 ? reasons[0] + ", and " + reasons[1] : reasons.front();
}

/// Gears are counted behind all loops.
std::string redundant_text(std::size_t loop, const model::Mechanism& mechanism) {
  const model::Loops& loops = mechanism.loops;
  if (loop < loops.closures.size())
    return "loop " + std::to_string(loop + 1) + " is redundant: the loops before it hold all that it holds";
  const std::size_t joint = loops.gears[loop - loops.closures.size()].joint;
  return "that " + mechanism.robot.joints[joint].variable + " follows is redundant: loops hold it so anyway";
}

}  // namespace

std::vector<std::string> text_of(const Mobility& mobility, const model::Mechanism& mechanism) {
  if (!mobility.assembled)
    return {
        "the loops cannot be closed together: no joint values were found at which all of them are; "
        "correct lengths or points"};
  std::vector<std::string> lines;
  const int driven = static_cast<int>(mechanism.loops.actuated.size());
  std::string count = count_of(mobility.free, "freedom") + ", " + std::to_string(driven) + " driven";
  if (mobility.gruebler != mobility.free)
    count += "; Gruebler's formula counts " + std::to_string(mobility.gruebler) + ", since it does not see " +
             reason_of(mobility);
  lines.push_back(count);
  for (const std::size_t loop : mobility.redundant) lines.push_back(redundant_text(loop, mechanism));
  for (const std::size_t joint : mobility.still)
    lines.push_back("joint " + mechanism.robot.joints[joint].variable + " never moves");
  return lines;
}

}  // namespace qvgen::verify
