// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <qvgen/batch/machine.h>
#include <qvgen/batch/view.h>
#include <qvgen/pose.h>

/// Laws of every batch form, for any robot and function.
namespace qvgen::batch_laws {

// The rows that a single call's result has.
template <class T>
void append(std::vector<T>& rows, T value) {
  rows.push_back(value);
}
template <class T, int Rows, int Columns>
void append(std::vector<T>& rows, const Eigen::Matrix<T, Rows, Columns>& value) {
  rows.insert(rows.end(), value.data(), value.data() + value.size());
}
template <class T>
void append(std::vector<T>& rows, const Pose<T>& value) {
  const auto& turn = value.orientation;
  rows.insert(rows.end(), {turn.w(), turn.x(), turn.y(), turn.z()});
  append(rows, value.position);
}
template <class T>
void append(std::vector<T>& rows, const Eigen::Transform<T, 3, Eigen::Isometry>& value) {
  append<T, 3, 4>(rows, value.affine());
}

template <class T>
bool same_bits(T a, T b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

/// The geometry with numbers for symbols to which the description gives none.
template <class T, class Geometry>
Geometry with_numbers(Geometry g) {
  if constexpr (sizeof(Geometry) >= sizeof(T)) {
    std::array<T, sizeof(Geometry) / sizeof(T)> numbers;
    std::memcpy(numbers.data(), &g, sizeof g);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (std::isnan(numbers[i])) numbers[i] = T(0.3) + T(0.07) * static_cast<T>(i);
    std::memcpy(static_cast<void*>(&g), numbers.data(), sizeof g);
  }
  return g;
}

/// An owned batch, one number behind every row and `margin` numbers in front of the first.
template <class T>
class Owned {
 public:
  Owned(std::size_t rows, std::size_t count, std::size_t stride, T value)
      : count_(count), stride_(stride), numbers_(margin + rows * stride, value) {}
  operator Batch<T>() { return {numbers_.data() + margin, count_, stride_}; }              // NOLINT
  operator Batch<const T>() const { return {numbers_.data() + margin, count_, stride_}; }  // NOLINT
  T& operator()(std::size_t row, std::size_t k) { return numbers_[margin + row * stride_ + k]; }
  std::vector<T>& numbers() { return numbers_; }
  static constexpr std::size_t margin = 1;

 private:
  std::size_t count_, stride_;
  std::vector<T> numbers_;
};

/// Layout of a batch's configurations, and its name.
struct Case {
  std::size_t count = 0;
  std::size_t stride = 0;
  bool wild = false;  ///< with NaN, infinite and very large numbers here and there
};

inline std::vector<Case> cases() {
  std::vector<Case> list;
  for (std::size_t count = 0; count <= 17; ++count) list.push_back({count, count + count % 4, false});
  list.push_back({33, 40, true});
  list.push_back({100, 100, false});
  // Rows whose beginnings share a set of the cache (qvgen/batch/staging.h).
  list.push_back({83, 512, true});
  return list;
}

template <class T>
Owned<T> inputs(std::size_t rows, const Case& at, std::mt19937& random) {
  Owned<T> result(rows, at.count, at.stride, T(0));
  std::uniform_real_distribution<double> number(-3, 3);
  for (T& each : result.numbers()) each = static_cast<T>(number(random));
  if (!at.wild || at.count == 0) return result;
  const double limit = std::numeric_limits<double>::infinity();
  const double odd[] = {std::nan(""), limit, -limit, 1e9, -3e12, 0.0, -0.0, 1e-30, -8e5};
  for (std::size_t k = 0; k < at.count; k += 3)
    result(random() % rows, k) = static_cast<T>(odd[random() % (sizeof odd / sizeof *odd)]);
  return result;
}

/// How far a float may be from a single call's, in units of epsilon times the largest component: sines differ
/// by an ulp. Accelerations differ by that times the condition of the mass matrix, some hundreds here.
constexpr double usual_bound = 64;
constexpr double bound_of_accelerations = 64 * 300;

/// `form(inputs..., result, set)` has what `single(columns...)` has, for every configuration and nowhere
/// else. `rows`: of each input. `terms`: how large what cancels in the results may be, if larger than these.
template <class T, class Form, class Single>
void expect_single_calls(const std::vector<std::size_t>& rows, const Form& form, const Single& single,
                         double float_bound = usual_bound, double terms = 0) {
  std::mt19937 random(7);
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!batch::machine_has(set)) continue;
    for (const Case& at : cases()) {
      std::vector<Owned<T>> given;
      for (const std::size_t each : rows) given.push_back(inputs<T>(each, at, random));
      const T untouched = T(-12345);
      std::vector<std::vector<T>> expected;
      for (std::size_t k = 0; k < at.count; ++k) {
        std::vector<std::vector<T>> columns;
        for (std::size_t i = 0; i < rows.size(); ++i) {
          columns.emplace_back();
          for (std::size_t row = 0; row < rows[i]; ++row) columns.back().push_back(given[i](row, k));
        }
        expected.push_back(single(columns));
      }
      const std::size_t results = at.count == 0 ? 1 : expected.front().size();
      Owned<T> result(results, at.count, at.stride, untouched);
      form(given, Batch<T>(result), set);

      const bool is_exact = std::is_same_v<T, double> || set == InstructionSet::baseline;
      std::vector<T> wanted(result.numbers().size(), untouched);
      for (std::size_t k = 0; k < at.count; ++k) {
        T largest = static_cast<T>(terms);
        for (const T each : expected[k])
          if (std::isfinite(each)) largest = std::max(largest, std::abs(each));
        const T bound =
            is_exact ? T(0) : static_cast<T>(float_bound) * std::numeric_limits<T>::epsilon() * largest;
        for (std::size_t row = 0; row < results; ++row) {
          const T is = result(row, k), should = expected[k][row];
          const bool both_odd = !is_exact && !std::isfinite(is) && !std::isfinite(should);
          EXPECT_TRUE(same_bits(is, should) || both_odd || std::abs(is - should) <= bound)
              << "set " << static_cast<int>(set) << ", " << at.count << " configurations, row " << row
              << " of " << k << ": " << is << " instead of " << should;
          wanted[Owned<T>::margin + row * at.stride + k] = is;
        }
      }
      EXPECT_EQ(0, std::memcmp(wanted.data(), result.numbers().data(), wanted.size() * sizeof(T)))
          << "something else was written";
      if (testing::Test::HasFailure()) return;
    }
  }
}

}  // namespace qvgen::batch_laws
