// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>

#include <Eigen/Geometry>
#include <qvgen/batch/sine_cosine.h>
#include <qvgen/batch/staging.h>
#include <qvgen/pose.h>

namespace qvgen::batch {

/// Numbers that functions compute with: lanes, or single numbers.
template <class Lane>
struct LaneTraits {
  using Number = typename Lane::Number;
  static constexpr int size = Lane::size;
  [[gnu::always_inline]] static Lane load(const Number* from) { return Lane::load(from); }
  [[gnu::always_inline]] static void store(const Lane& value, Number* to) { value.store(to); }
};
template <class T>
struct OneNumber {
  using Number = T;
  static constexpr int size = 1;
  [[gnu::always_inline]] static T load(const T* from) { return *from; }
  [[gnu::always_inline]] static void store(T value, T* to) { *to = value; }
};
template <>
struct LaneTraits<double> : OneNumber<double> {};
template <>
struct LaneTraits<float> : OneNumber<float> {};

/// Registers for two numbers are slower than what single calls do: they spend most on sines and cosines, for
/// which the library has a kernel of its own.
template <class T, class Set>
using LaneOf = std::conditional_t<std::is_same_v<Set, Baseline>, T, Lanes<T, Set>>;

/// Copies numbers into all lanes: `From` holds numbers and nothing else, `To` has lanes in their places
/// (geometries, arrays of constants, vectors).
template <class Lane, class To, class From>
To in_all_lanes(const From& from) {
  using T = typename LaneTraits<Lane>::Number;
  To to;
  if constexpr (sizeof(From) >= sizeof(T)) {
    constexpr std::size_t count = sizeof(From) / sizeof(T);
    static_assert(sizeof(To) == count * sizeof(Lane) && std::is_trivially_destructible_v<To>);
    T numbers[count];
    std::memcpy(numbers, static_cast<const void*>(&from), sizeof numbers);
    Lane lanes[count];
    for (std::size_t i = 0; i < count; ++i) lanes[i] = Lane(numbers[i]);
    std::memcpy(static_cast<void*>(&to), static_cast<const void*>(lanes), sizeof lanes);
  }
  return to;
}

/// `Rows` components of each configuration.
template <class T, int Rows>
struct Input {
  const Batch<const T>& batch;
};

/// Puts results into the rows that begin at `at`, one after the other.
template <class Lane>
class Writer {
 public:
  using T = typename LaneTraits<Lane>::Number;
  [[gnu::always_inline]] Writer(T* at, std::size_t stride) : at_(at), stride_(stride) {}

  [[gnu::always_inline]] void operator()(const Lane& value) {
    LaneTraits<Lane>::store(value, at_);
    at_ += stride_;
  }
  template <int Rows, int Columns>
  [[gnu::always_inline]] void operator()(const Eigen::Matrix<Lane, Rows, Columns>& value) {
    for (int j = 0; j < Columns; ++j)
      for (int i = 0; i < Rows; ++i) (*this)(value(i, j));
  }
  [[gnu::always_inline]] void operator()(const Pose<Lane>& value) {
    (*this)(value.orientation.w());
    (*this)(value.orientation.x());
    (*this)(value.orientation.y());
    (*this)(value.orientation.z());
    (*this)(value.position);
  }
  [[gnu::always_inline]] void operator()(const Eigen::Transform<Lane, 3, Eigen::Isometry>& value) {
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 3; ++i) (*this)(value(i, j));
  }

 private:
  T* at_;
  std::size_t stride_;
};

/// The components at some configurations; of the last ones, which do not fill all lanes, a copy in `padded`,
/// the lanes behind them as the last one. `block` configurations at a time, copied or where they are.
template <class Lane, int Rows, std::size_t block>
class Reader {
 public:
  using T = typename LaneTraits<Lane>::Number;
  [[gnu::always_inline]] Reader(const Input<T, Rows>& input, bool copies)
      : from_(input.batch.data), row_(input.batch.stride), copies_(copies) {}

  /// Configurations are counted from this one on.
  [[gnu::always_inline]] void begin(std::size_t first, std::size_t count) {
    data_ = from_ + first;
    stride_ = row_;
    if (!copies_) return;
    for (std::size_t i = 0; i < Rows; ++i)
      std::memcpy(copy_ + i * block, data_ + i * row_, count * sizeof(T));
    data_ = copy_;
    stride_ = block;
  }

  [[gnu::always_inline]] Eigen::Matrix<Lane, Rows, 1> read(std::size_t k, std::size_t valid) {
    const T* from = data_ + k;
    std::size_t stride = stride_;
    if (valid < static_cast<std::size_t>(LaneTraits<Lane>::size)) {
      for (int i = 0; i < Rows; ++i)
        for (int lane = 0; lane < LaneTraits<Lane>::size; ++lane)
          padded_[i * LaneTraits<Lane>::size + lane] =
              from[static_cast<std::size_t>(i) * stride_ +
                   std::min(static_cast<std::size_t>(lane), valid - 1)];
      from = padded_;
      stride = static_cast<std::size_t>(LaneTraits<Lane>::size);
    }
    Eigen::Matrix<Lane, Rows, 1> values;
    for (int i = 0; i < Rows; ++i)
      values(i) = LaneTraits<Lane>::load(from + static_cast<std::size_t>(i) * stride);
    return values;
  }

 private:
  const T* from_;
  std::size_t row_;
  bool copies_;
  const T* data_ = nullptr;
  std::size_t stride_ = 0;
  alignas(cache_line) T copy_[Rows * block];
  T padded_[Rows * LaneTraits<Lane>::size];
};

/// Copies rows of `stride` numbers into a batch.
template <class T>
void put(const T* from, std::size_t stride, std::size_t rows, const Batch<T>& result) {
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < result.count; ++k) result(i, k) = from[i * stride + k];
}

/// How many configurations stand in a buffer: whole cache lines, as many of up to 64 as 64 KiB hold.
template <class Lane>
constexpr std::size_t staged_configurations(std::size_t rows) {
  using T = typename LaneTraits<Lane>::Number;
  constexpr std::size_t buffer = 64 << 10, most = 64;
  std::size_t block = std::max<std::size_t>(cache_line / sizeof(T), LaneTraits<Lane>::size);
  while (block < most && 2 * block * rows * sizeof(T) <= buffer) block *= 2;
  return block;
}

/// For as many configurations as all batches have: gives `body` a writer and the inputs of as many of them as
/// there are lanes. Results have `ResultRows` components. No heap.
template <class Lane, int ResultRows, class Body, int... Rows>
[[gnu::always_inline]] inline void run(const Batch<typename LaneTraits<Lane>::Number>& result,
                                       const Body& body,
                                       const Input<typename LaneTraits<Lane>::Number, Rows>&... inputs) {
  using T = typename LaneTraits<Lane>::Number;
  constexpr std::size_t lanes = LaneTraits<Lane>::size;
  const std::size_t count = std::min({result.count, inputs.batch.count...});
  T last[ResultRows * lanes + 1];
  constexpr std::size_t rows = ResultRows, block = staged_configurations<Lane>(rows);
  Staging<Lane, T, rows, block> staging(result, count);
  const bool copies = count > few_configurations &&
                      (share_sets((std::size_t(Rows) + ...), inputs.batch.stride * sizeof(T), 8) || ...);
  const std::size_t most = copies || !staging.is_direct() ? block : count;
  const auto all = [&](auto&&... readers) {
    for (std::size_t first = 0; first < count; first += most) {
      const Batch<T> place = staging.place(first, std::min(most, count - first));
      T* const data = place.data;
      const std::size_t stride = place.stride, end = place.count;
      (readers.begin(first, end), ...);
      for (std::size_t k = 0; k < end; k += lanes) {
        const std::size_t valid = std::min(end - k, lanes);
        const bool is_whole = valid == lanes;
        Writer<Lane> writer(is_whole ? data + k : last, is_whole ? stride : lanes);
        body(writer, readers.read(k, valid)...);
        if (!is_whole) put(last, lanes, rows, Batch<T>(data + k, valid, stride));
      }
      staging.finish(first, end);
    }
  };
  all(Reader<Lane, Rows, block>(inputs, copies)...);
}

}  // namespace qvgen::batch
