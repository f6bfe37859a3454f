// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

namespace qvgen {

/// Many vectors side by side, component by component (structure of arrays): component i of vector k stands at
/// data[i * stride + k], k < count. A view: it owns nothing, asks for no alignment, and stride >= count lets
/// it be a part of a longer one.
template <class T>
struct Batch {
  T* data = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;

  Batch() = default;
  Batch(T* data_, std::size_t count_) : Batch(data_, count_, count_) {}
  Batch(T* data_, std::size_t count_, std::size_t stride_) : data(data_), count(count_), stride(stride_) {}
  /// Converts a view that may be written to one that may be read.
  template <class Other, class = std::enable_if_t<std::is_same_v<T, const Other>>>
  Batch(const Batch<Other>& other) : Batch(other.data, other.count, other.stride) {}  // NOLINT

  T& operator()(std::size_t component, std::size_t k) const { return data[component * stride + k]; }

  /// The vectors first, first + 1, ..., at most `most` of them.
  [[nodiscard]] Batch part(std::size_t first, std::size_t most) const {
    const std::size_t left = first < count ? count - first : 0;
    return {data + (left == 0 ? 0 : first), left < most ? left : most, stride};
  }
};

}  // namespace qvgen
