// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <qvgen/batch/choose_lanes.h>
#include <qvgen/batch/inverse_lanes.h>
#include <qvgen/batch/solutions.h>

#define QVGEN_INLINE [[gnu::always_inline]]
#define QVGEN_UNROLLED _Pragma("GCC unroll 16")

namespace qvgen::batch {

/// Rows as they are solved.
struct AsSolved {
  template <class Lane>
  QVGEN_INLINE const Lane& operator()(int /*joint*/, const Lane& value, const Lane& /*given*/) const {
    return value;
  }
};

/// An angle in (-pi, pi] less a phase in the same range, brought back into it (inverse::less_phase).
template <class Lane>
QVGEN_INLINE inline Lane less_phase(const Lane& angle, double phase) {
  const Lane half_turn(3.141592653589793238463);
  const Lane difference = angle - Lane(phase);
  const Lane low = select(difference <= -half_turn, difference + Lane(2.0) * half_turn, difference);
  return select(difference > half_turn, difference - Lane(2.0) * half_turn, low);
}

/// Takes solutions in the order of their branches, one pose a lane, each lane as many as it has: those that
/// exist stand one close behind the other.
///
/// `described(i, value, given)` is what the row says of joint i, `given` the value of the joint that is
/// given.
template <class Lane, int dof, int capacity, class Described>
class LaneSolutions {
 public:
  using Branch = inverse::Branch<Lane>;
  using Truth = inverse::Mask<Lane>;

  QVGEN_INLINE LaneSolutions(const Batch<double>& q, const Described& described, const Lane& given)
      : q_(q.data), stride_(q.stride), described_(described), given_(given) {
    QVGEN_UNROLLED
    for (int s = 0; s < capacity; ++s) labels_[s] = Lane(-1.0);
  }

  /// One row.
  QVGEN_INLINE void append(const Lane (&q)[dof], const Branch& branch, int label) {
    QVGEN_UNROLLED
    for (int s = 0; s < capacity; ++s) {
      if (s > appended_) break;
      const Truth here = branch.exists & (count_ == Lane(s));
      if (any(here)) put(s, here, q, label);
    }
    count(branch, 1);
  }

  /// Two rows that exist or do not exist together.
  QVGEN_INLINE void append(const Lane (&q)[dof], const Lane (&twin)[dof], const Branch& branch, int label) {
    QVGEN_UNROLLED
    for (int s = 0; s < capacity; s += 2) {
      if (s > appended_) break;
      const Truth here = branch.exists & (count_ == Lane(s));
      if (!any(here)) continue;
      put(s, here, q, label);
      put(s + 1, here, twin, label + 1);
    }
    count(branch, 2);
  }

  /// Two rows, each with its own branch.
  QVGEN_INLINE void append(const Lane (&q)[dof], const Branch& branch, const Lane (&other)[dof],
                           const Branch& other_branch, int label) {
    append(q, branch, label);
    append(other, other_branch, label + 1);
  }

  /// Mask of rows that belong to a continuum. Lanes make no choice there.
  QVGEN_INLINE const Truth& chosen() const { return chosen_; }

  /// Leaves of the rows those that are wanted, in their order, once the others are NaN. Returns the lanes
  /// that have to be looked at alone.
  QVGEN_INLINE Truth choose(const WantedSolutions& wanted) {
    return choose_rows<Lane, dof, capacity>(wanted, {q_, static_cast<std::size_t>(Lane::size), stride_},
                                            labels_, count_);
  }

  /// NaN behind the last solution of each lane.
  QVGEN_INLINE void pad() {
    const Lane nothing(std::numeric_limits<double>::quiet_NaN());
    double* to = q_;
    QVGEN_UNROLLED
    for (int s = 0; s < capacity; ++s, to += dof * stride_) {
      const Truth open = count_ <= Lane(s);
      if (!any(open)) continue;
      put(to, open, [&](int) { return nothing; });
      labels_[s] = select(open, Lane(-1.0), labels_[s]);
    }
  }

  /// Counts, status, branches and marks of the poses that the batches begin with.
  QVGEN_INLINE void put_the_rest(const BatchOfSolutions& found) const {
    put_rounded(count_, found.count.data);
    const auto number = [](Status status) { return Lane(static_cast<int>(status)); };
    put_rounded(select(count_ > Lane(0.0), number(Status::solved), number(Status::unreachable)),
                found.status.data);
    if (found.branch.data != nullptr) {
      int* to = found.branch.data;
      QVGEN_UNROLLED
      for (int s = 0; s < capacity; ++s, to += found.branch.stride) put_rounded(labels_[s], to);
    }
    if (found.marks.data != nullptr) put_rounded(Lane(0.0), found.marks.data);
  }

 private:
  QVGEN_INLINE void put(int s, const Truth& here, const Lane (&q)[dof], int label) {
    double* to = q_ + static_cast<std::size_t>(s * dof) * stride_;
    const auto described = [&](int i) { return described_(i, q[i], given_); };
    if (Truth::Unit::stores_chosen_lanes || s < appended_) {
      put(to, here, described);
      labels_[s] = select(here, Lane(label), labels_[s]);
      return;
    }
    // No lane has anything there or beyond: what does not exist is overwritten, by `pad` in the end.
    QVGEN_UNROLLED
    for (int i = 0; i < dof; ++i, to += stride_) described(i).store(to);
    labels_[s] = Lane(label);
  }

  template <class Value>
  QVGEN_INLINE void put(double* to, const Truth& here, const Value& value) const {
    QVGEN_UNROLLED
    for (int i = 0; i < dof; ++i, to += stride_) Truth::Unit::put(here.lanes, value(i).vector(), to);
  }

  QVGEN_INLINE static void put_rounded(const Lane& numbers, void* to) {
    Truth::Unit::put_rounded(numbers.vector(), to);
  }

  QVGEN_INLINE void count(const Branch& branch, int rows) {
    appended_ += rows;
    chosen_ = chosen_ | (branch.exists & branch.continuum);
    count_ = count_ + select(branch.exists, Lane(rows), Lane(0.0));
  }

  double* q_;
  std::size_t stride_;
  const Described& described_;
  const Lane& given_;
  int appended_ = 0;
  Lane count_ = Lane(0.0);
  Truth chosen_ = Truth(false);
  Lane labels_[capacity];
};

/// The last poses of a batch, which do not fill all lanes: beside them stand copies of the first of them.
template <class Lane, int dof, int capacity>
class PaddedPoses {
 public:
  static constexpr std::size_t lanes = Lane::size;

  Batch<const double> poses(const Batch<const double>& from) { return copies(from, 7, numbers_); }
  Batch<const double> given(const Batch<const double>& from) {
    return from.data == nullptr ? from : copies(from, 1, given_);
  }
  WantedSolutions wanted(const WantedSolutions& from) {
    if (from.seeds.data == nullptr) return from;
    return {copies(from.seeds, dof, seeds_), from.lower, from.upper, from.revolute};
  }
  BatchOfSolutions places() {
    return {{q_, lanes}, {count_, lanes}, {status_, lanes}, {branch_, lanes}, {marks_, lanes}};
  }
  void put(const BatchOfSolutions& found, std::size_t count) {
    const auto copy = [&](const auto* from, const auto& to, std::size_t rows) {
      for (std::size_t i = 0; i < rows && to.data != nullptr; ++i)
        for (std::size_t k = 0; k < count; ++k) to(i, k) = from[i * lanes + k];
    };
    copy(q_, found.q, capacity * dof);
    copy(count_, found.count, 1);
    copy(status_, found.status, 1);
    copy(branch_, found.branch, capacity);
    copy(marks_, found.marks, 1);
  }

 private:
  static Batch<const double> copies(const Batch<const double>& from, std::size_t rows, double* to) {
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t lane = 0; lane < lanes; ++lane)
        to[i * lanes + lane] = from(i, lane < from.count ? lane : 0);
    return {to, lanes};
  }

  double numbers_[7 * lanes], given_[lanes], seeds_[dof * lanes], q_[capacity * dof * lanes];
  int count_[lanes], branch_[capacity * lanes];
  Status status_[lanes];
  unsigned marks_[lanes];
};

/// The solutions of as many poses as there are lanes. Returns a bit for each that is doubtful.
template <class Lane, int dof, int capacity, class Described, class Follow>
QVGEN_INLINE inline unsigned solve_lanes(const Batch<const double>& poses, const Batch<const double>& given,
                                         const WantedSolutions& wanted, const BatchOfSolutions& found,
                                         const Described& described, const Follow& follow) {
  const auto row = [&](std::size_t i) { return Lane::load(poses.data + i * poses.stride); };
  const LanePoses<Lane> pose{{row(1), row(2), row(3), row(0)}, {row(4), row(5), row(6)}};
  const Lane joint = given.data == nullptr ? Lane(0.0) : Lane::load(given.data);
  LaneSolutions<Lane, dof, capacity, Described> rows(found.q, described, joint);
  auto doubtful = follow(pose, joint, rows);
  rows.pad();
  if (wanted.seeds.data != nullptr) doubtful = doubtful | rows.choose(wanted);
  rows.put_the_rest(found);
  return bits(doubtful | rows.chosen());
}

/// Up to so many poses are solved sooner one by one than in lanes.
inline constexpr std::size_t few_poses = 2;

/// The solutions of at most 64 poses, one a lane: `follow(poses, given joint, solutions)` appends them and
/// says which lanes are doubtful. Returns a bit for each pose that is, whose solutions are not to be taken,
/// or that is one of the few at the end. Seeds without data: all solutions, by branch.
template <class Lane, int dof, int capacity, class Described, class Follow>
QVGEN_INLINE inline std::uint64_t solve_in_lanes(const Batch<const double>& poses,
                                                 const Batch<const double>& given,
                                                 const WantedSolutions& wanted, const BatchOfSolutions& found,
                                                 const Described& described, const Follow& follow) {
  constexpr std::size_t lanes = Lane::size;
  PaddedPoses<Lane, dof, capacity> padded;
  std::uint64_t doubtful = 0;
  for (std::size_t k = 0; k < poses.count; k += lanes) {
    Batch<const double> here = poses.part(k, lanes), joint = given.part(k, lanes);
    WantedSolutions these = wanted.part(k, lanes);
    const BatchOfSolutions to = found.part(k, lanes);
    const std::size_t count = here.count;
    const std::uint64_t all = (1U << count) - 1;
    if (count <= few_poses && count < lanes) {
      doubtful |= all << k;
      continue;
    }
    const bool is_whole = count == lanes;
    if (!is_whole) here = padded.poses(here), joint = padded.given(joint), these = padded.wanted(these);
    const std::uint64_t some = solve_lanes<Lane, dof, capacity>(
        here, joint, these, is_whole ? to : padded.places(), described, follow);
    if (!is_whole) padded.put(to, count);
    doubtful |= (some & all) << k;
  }
  return doubtful;
}

}  // namespace qvgen::batch

#undef QVGEN_UNROLLED
#undef QVGEN_INLINE
