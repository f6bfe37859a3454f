// SPDX-License-Identifier: MIT
// Contacts of a robot's tips with something that does not give way, chosen at run time: accelerations that
// keep the tips in place, the forces that do so, and the impulses when they meet it. Everything is on the
// stack.
//
//     qvgen::ContactSet<double, robot::velocity_size, 24> contacts;      // at most 24 rows
//     contacts.add(left_foot, qvgen::ContactKind::rigid);                // TipMotion (tip_motion.h)
//     contacts.add(right_foot, qvgen::ContactKind::point);
//     const qvgen::BranchFactorisation mass(robot::mass_matrix(at), robot::mass_matrix_parents);
//     const auto found = contacts.forward_dynamics(mass, torque - bias); // found.qdd, .forces, .status
//
// With M qdd + bias = torque + J^T f and J qdd + (dJ/dt) qd = 0, the forces solve J M^-1 J^T f = r. Where
// contacts repeat one another that matrix is singular: the accelerations are unique still, the forces not.
// Some of the rows that others repeat have no force then, and the result is marked.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/QR>
#include <qvgen/branch_factorisation.h>
#include <qvgen/tip_motion.h>

namespace qvgen {

/// A point keeps its place; a rigid contact keeps the tip's orientation too.
enum class ContactKind { point, rigid };

enum class ContactStatus {
  solved,
  dependent,      ///< contacts repeat one another: accelerations are unique, forces are one choice of many
  contradictory,  ///< no accelerations keep all of them: those given come as near as they can
  invalid         ///< NaN or infinite arguments, or a mass matrix that is not positive; results are zero
};

template <class Scalar, int size, int most_rows>
struct ContactResult {
  /// A number for each row of contacts: force, N, then moment, N m, on the robot, in the world, at the tip.
  using Forces = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, 0, most_rows, 1>;
  Eigen::Matrix<Scalar, size, 1> qdd =
      Eigen::Matrix<Scalar, size, 1>::Zero();  ///< or velocities after impact
  Forces forces;                               ///< or impulses, N s and N m s
  int rank = 0;                                ///< of the rows together
  ContactStatus status = ContactStatus::invalid;
};

template <class Scalar, int size, int most_rows>
class ContactSet {
 public:
  using Vector = Eigen::Matrix<Scalar, size, 1>;
  using Rows = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, 0, most_rows, 1>;
  using Square = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, 0, most_rows, most_rows>;
  using Result = ContactResult<Scalar, size, most_rows>;

  /// Adds a contact, whose tip accelerates as said: not at all. False, and nothing is added, without room.
  bool add(const TipMotion<Scalar, size>& tip, ContactKind kind,
           const Eigen::Matrix<Scalar, 6, 1>& acceleration = Eigen::Matrix<Scalar, 6, 1>::Zero()) {
    const int more = kind == ContactKind::point ? 3 : 6;
    if (rows_ + more > most_rows) return false;
    transposed_.middleCols(rows_, more) = tip.jacobian.topRows(more).transpose();
    wanted_.segment(rows_, more) = (acceleration - tip.bias).head(more);
    rows_ += more;
    return true;
  }
  void clear() { rows_ = 0; }

  [[nodiscard]] int rows() const { return rows_; }
  /// Returns the Jacobian of all contacts, rows x size.
  [[nodiscard]] Eigen::Matrix<Scalar, Eigen::Dynamic, size, 0, most_rows, size> jacobian() const {
    return transposed_.leftCols(rows_).transpose();
  }
  /// Returns what the contacts' accelerations lack at qdd = 0: (dJ/dt) qd less the wanted ones.
  [[nodiscard]] Rows bias() const { return -wanted_.head(rows_); }

  /// Returns accelerations and forces. `mass`: BranchFactorisation of the mass matrix; `force`: torque less
  /// what velocities and gravity take, N or N m.
  template <class Mass>
  [[nodiscard]] Result forward_dynamics(const Mass& mass, const Vector& force) const {
    const Vector free = mass.solve(force);
    return solved(mass, free, wanted_.head(rows_) - transposed_.leftCols(rows_).transpose() * free);
  }

  /// Returns velocities behind an impact, and impulses. `restitution`: 0 the tips stay, 1 they bounce back.
  template <class Mass>
  [[nodiscard]] Result impact(const Mass& mass, const Vector& qd, Scalar restitution = Scalar(0)) const {
    const Rows meeting = transposed_.leftCols(rows_).transpose() * qd;
    return solved(mass, qd, -(Scalar(1) + restitution) * meeting);
  }

  /// Returns the inertia that the contacts feel, (J M^-1 J^T)^-1, rows x rows, symmetric; one of its
  /// generalised inverses where rows are dependent, which `rank` tells.
  template <class Mass>
  [[nodiscard]] Square operational_space_inertia(const Mass& mass, int* rank = nullptr) const {
    const System system(*this, mass);
    if (rank != nullptr) *rank = system.rank();
    return system.inverse();
  }

 private:
  /// J M^-1 J^T, its rows and columns scaled to ones on the diagonal, and decomposed.
  class System {
   public:
    using Columns = Eigen::Matrix<Scalar, size, Eigen::Dynamic, 0, size, most_rows>;

    template <class Mass>
    System(const ContactSet& set, const Mass& mass) : solved_(size, set.rows_), scale_(set.rows_) {
      for (int i = 0; i < set.rows_; ++i) solved_.col(i) = mass.solve(set.transposed_.col(i));
      matrix_ = set.transposed_.leftCols(set.rows_).transpose() * solved_;
      using std::sqrt;
      for (int i = 0; i < set.rows_; ++i)
        scale_[i] = matrix_(i, i) > Scalar(0) ? Scalar(1) / sqrt(matrix_(i, i)) : Scalar(0);
      const Square scaled = scale_.asDiagonal() * matrix_ * scale_.asDiagonal();
      decomposition_.setThreshold(Scalar(1000) * std::numeric_limits<Scalar>::epsilon());
      decomposition_.compute(scaled);
    }
    [[nodiscard]] int rank() const { return static_cast<int>(decomposition_.rank()); }
    [[nodiscard]] Rows forces(const Rows& right) const {
      const Rows scaled = scale_.cwiseProduct(right);
      return scale_.cwiseProduct(basic_solution(scaled));
    }
    /// Returns the accelerations that forces make.
    [[nodiscard]] Vector effect(const Rows& forces) const { return solved_ * forces; }
    /// Returns how far the contacts stay from what is wanted, as a share of it.
    [[nodiscard]] Scalar defect(const Rows& forces, const Rows& right) const {
      const Rows rest = scale_.cwiseProduct(Rows(matrix_ * forces - right));
      const Scalar wanted = scale_.cwiseProduct(right).norm();
      return wanted > Scalar(0) ? rest.norm() / wanted : rest.norm();
    }
    /// X with A X A = A makes X A X^T, which is symmetric.
    [[nodiscard]] Square inverse() const {
      Square one(matrix_.rows(), matrix_.cols());
      for (Eigen::Index k = 0; k < one.cols(); ++k) one.col(k) = forces(Rows::Unit(one.rows(), k));
      const Square half = one * matrix_;
      return half * one.transpose();
    }

   private:
    /// Least squares by as many columns as the rank says; Eigen's own solution takes all that are not zero.
    /// The reflections one by one, as Eigen has them for so few rows; its way for many takes long to compile.
    [[nodiscard]] Rows basic_solution(Rows right) const {
      const Eigen::Index rank = decomposition_.rank(), count = right.size();
      const Square& qr = decomposition_.matrixQR();
      Scalar workspace;
      for (Eigen::Index k = 0; k < rank; ++k)
        right.tail(count - k).applyHouseholderOnTheLeft(qr.col(k).tail(count - k - 1),
                                                        decomposition_.hCoeffs()[k], &workspace);
      right.tail(count - rank).setZero();
      qr.topLeftCorner(rank, rank).template triangularView<Eigen::Upper>().solveInPlace(right.head(rank));
      return decomposition_.colsPermutation() * right;
    }

    Columns solved_;
    Square matrix_;
    Rows scale_;
    Eigen::ColPivHouseholderQR<Square> decomposition_;
  };

  template <class Mass>
  [[nodiscard]] Result solved(const Mass& mass, const Vector& before, const Rows& right) const {
    Result result;
    result.forces = Rows::Zero(rows_);
    if (!mass.is_positive() || !before.allFinite() || !right.allFinite()) return result;
    result.qdd = before;
    result.status = ContactStatus::solved;
    if (rows_ == 0) return result;
    const System system(*this, mass);
    const Rows forces = system.forces(right);
    const Vector qdd = before + system.effect(forces);
    if (!qdd.allFinite()) return {Vector::Zero(), result.forces, 0, ContactStatus::invalid};
    using std::sqrt;
    const bool fits = system.defect(forces, right) <= sqrt(std::numeric_limits<Scalar>::epsilon());
    const bool is_full = system.rank() == rows_;
    return {qdd, forces, system.rank(),
            !fits     ? ContactStatus::contradictory
            : is_full ? ContactStatus::solved
                      : ContactStatus::dependent};
  }

  Eigen::Matrix<Scalar, size, most_rows> transposed_ = Eigen::Matrix<Scalar, size, most_rows>::Zero();
  Eigen::Matrix<Scalar, most_rows, 1> wanted_ = Eigen::Matrix<Scalar, most_rows, 1>::Zero();
  int rows_ = 0;
};

}  // namespace qvgen
