// SPDX-License-Identifier: MIT
#include "identify/equations.h"

#include <algorithm>
#include <cmath>

#include "identify/chunks.h"
#include "identify/extra_columns.h"
#include "matrices/decompositions.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index block = static_cast<Index>(Tape::block);
static_assert(chunk % block == 0);

/// Rows that wait, for so many columns: reflections of many rows at once are the cheaper.
Index waiting_rows(Index columns) { return block * std::max<Index>(4, 4 * columns / block); }

/// Fills the inputs of a tape from samples; beyond the last one stands zero.
void fill_inputs(const MotionLog& log, Index first, Index count, std::vector<double>& workspace) {
  const Index joints = log.joints();
  std::fill_n(workspace.begin(), 4 * joints * block, 0.0);
  for (Index i = 0; i < joints; ++i) {
    const auto place = [&](Index kind) { return workspace.data() + (kind * joints + i) * block; };
    for (Index k = 0; k < count; ++k) {
      const double rate = log.qd(first + k, i);
      place(0)[k] = log.q(first + k, i);
      place(1)[k] = rate;
      place(2)[k] = log.qdd(first + k, i);
      place(3)[k] = static_cast<double>((rate > 0) - (rate < 0));
    }
  }
}

/// True for each sample all of whose numbers are finite.
std::vector<bool> finite_samples(const MotionLog& log, Index first, Index count) {
  std::vector<bool> finite(static_cast<std::size_t>(count));
  for (Index k = 0; k < count; ++k)
    finite[static_cast<std::size_t>(k)] = log.q.row(first + k).allFinite() &&
                                          log.qd.row(first + k).allFinite() &&
                                          log.qdd.row(first + k).allFinite();
  return finite;
}

/// Copies a joint's entries of a column of Y.
void fill_column(const ArmRegressor& arm, const MotionLog& log, const std::vector<double>& workspace,
                 Index column, std::size_t joint, Index first, Index count, double* to) {
  if (column >= arm.plain()) return fill_extra(arm, log, column, first, count, to);
  arm.tape.copy(workspace, static_cast<std::size_t>(column) * arm.joints + joint,
                static_cast<std::size_t>(count), to);
}

/// One thread's work on a chunk of samples.
class Chunk {
 public:
  Chunk(const ArmRegressor& arm, const MotionLog& log, const UseOfLog& use)
      : arm_(arm), log_(log), use_(use), workspace_(arm.tape.workspace()) {
    for (const auto& columns : arm.columns) equations_.emplace_back(columns);
  }

  Equations take(Index first, Index last) {
    for (Index at = first; at < last; at += block) add_block(at, std::min(block, last - at));
    return std::move(equations_);
  }

 private:
  void add_block(Index first, Index count) {
    fill_inputs(log_, first, count, workspace_);
    arm_.tape.run(workspace_);
    const std::vector<bool> finite = finite_samples(log_, first, count);
    for (std::size_t joint = 0; joint < arm_.joints; ++joint) add_rows(joint, first, finite);
  }

  void add_rows(std::size_t joint, Index first, const std::vector<bool>& finite) {
    JointEquations& equations = equations_[joint];
    const auto count = static_cast<Index>(finite.size());
    Index used = 0;
    equations.add(count, [&](auto rows) {
      for (Index c = 0; c + 1 < rows.cols(); ++c) {
        const Index column = equations.columns()[static_cast<std::size_t>(c)];
        fill_column(arm_, log_, workspace_, column, joint, first, count, rows.col(c).data());
      }
      rows.col(rows.cols() - 1) = log_.torque.col(static_cast<Index>(joint)).segment(first, count);
      for (Index k = 0; k < count; ++k)
        if (finite[static_cast<std::size_t>(k)] && is_used(joint, first + k))
          ++used;
        else
          rows.row(k).setZero();
    });
    equations.count(used);
  }

  [[nodiscard]] bool is_used(std::size_t joint, Index sample) const {
    const auto i = static_cast<Index>(joint);
    if (!std::isfinite(log_.torque(sample, i)) || !has_extra(arm_, log_, sample, i)) return false;
    return use_.slowest.empty() || std::abs(log_.qd(sample, i)) >= use_.slowest[joint];
  }

  const ArmRegressor& arm_;
  const MotionLog& log_;
  const UseOfLog& use_;
  std::vector<double> workspace_;
  Equations equations_;
};

}  // namespace

JointEquations::JointEquations(std::vector<Index> columns) : columns_(std::move(columns)) {
  const Index n = static_cast<Index>(columns_.size()) + 1;
  rows_.setZero(n + waiting_rows(n), n);
  filled_ = n;
}

void JointEquations::reduce() {
  const Index n = rows_.cols();
  if (filled_ == n) return;
  rows_.topRows(n) = matrices::upper_triangle(rows_.topRows(filled_));
  filled_ = n;
}

MatrixXd JointEquations::triangle() const {
  JointEquations reduced = *this;
  reduced.reduce();
  return reduced.rows_.topRows(rows_.cols());
}

void JointEquations::add(const JointEquations& other) {
  const MatrixXd theirs = other.triangle();
  add(theirs.rows(), [&](auto rows) { rows = theirs; });
  measured_ += other.measured_;
}

Equations equations_of(const ArmRegressor& arm, const MotionLog& log, const UseOfLog& use) {
  Equations all;
  for (const auto& columns : arm.columns) all.emplace_back(columns);
  for (const Equations& part : in_chunks(
           log.samples(), [&](Index first, Index last) { return Chunk(arm, log, use).take(first, last); }))
    add(all, part);
  return all;
}

void add(Equations& all, const Equations& others) {
  for (std::size_t i = 0; i < all.size(); ++i) all[i].add(others[i]);
}

MatrixXd predicted(const ArmRegressor& arm, const MotionLog& log, const Eigen::VectorXd& parameters) {
  MatrixXd torque = MatrixXd::Zero(log.samples(), static_cast<Index>(arm.joints));
  in_chunks(log.samples(), [&](Index first, Index last) {
    std::vector<double> workspace = arm.tape.workspace();
    Eigen::VectorXd column(block);
    for (Index at = first; at < last; at += block) {
      const Index count = std::min(block, last - at);
      fill_inputs(log, at, count, workspace);
      arm.tape.run(workspace);
      for (std::size_t i = 0; i < arm.joints; ++i)
        for (const Index k : arm.columns[i]) {
          fill_column(arm, log, workspace, k, i, at, count, column.data());
          torque.col(static_cast<Index>(i)).segment(at, count) += parameters[k] * column.head(count);
        }
    }
    return 0;
  });
  return torque;
}

}  // namespace qvgen::identify
