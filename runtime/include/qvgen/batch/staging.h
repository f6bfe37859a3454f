// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <qvgen/batch/view.h>

#define QVGEN_INLINE [[gnu::always_inline]]

namespace qvgen::batch {

/// How results get to their rows.
enum class Route {
  direct,    ///< register by register
  staged,    ///< by way of a buffer, from which many configurations of one row are copied, then of the next
  streamed,  ///< the same, past the caches
};

inline constexpr std::size_t cache_line = 64;  ///< bytes

/// Where `rows` rows, one every so many bytes, begin in few of the first cache's sets, as with 1024 numbers a
/// row, the lines that are written push each other out before they are full: staged, unless there is no more
/// than a line of each. Results that no cache holds until they are read are streamed, which spares reading
/// before writing. Chosen for a cache with 64 sets of 8 lines, half of them for what else there is; with
/// another one the results are the same.
QVGEN_INLINE inline Route route(std::size_t rows, std::size_t bytes_a_row, std::size_t count) {
  constexpr std::size_t sets = 64, lines_a_set = 4, beyond_caches = std::size_t(16) << 20;
  constexpr std::size_t few = 16, many = 1024;
  if (count <= few) return Route::direct;
  if (count >= many && rows * bytes_a_row > beyond_caches) return Route::streamed;
  std::uint64_t taken = 0;
  for (std::size_t i = 0; i < rows; ++i) taken |= std::uint64_t(1) << (i * bytes_a_row / cache_line % sets);
  return rows > lines_a_set * std::bitset<sets>(taken).count() ? Route::staged : Route::direct;
}

/// Copies past the caches, whole lines at a time.
QVGEN_INLINE inline void stream(const void* from, std::size_t bytes, void* to) {
#if defined(__SSE2__)
  const auto* source = static_cast<const char*>(from);
  auto* target = static_cast<char*>(to);
  const std::size_t before = (cache_line - reinterpret_cast<std::uintptr_t>(to) % cache_line) % cache_line;
  const std::size_t head = std::min(before, bytes);
  std::memcpy(target, source, head);
  std::size_t done = head;
  for (; done + cache_line <= bytes; done += cache_line)
    for (std::size_t part = done; part < done + cache_line; part += sizeof(__m128i))
      _mm_stream_si128(reinterpret_cast<__m128i*>(target + part),
                       _mm_loadu_si128(reinterpret_cast<const __m128i*>(source + part)));
  std::memcpy(target + done, source + done, bytes - done);
#else
  std::memcpy(to, from, bytes);
#endif
}

/// `rows` rows of results on their way, `block` configurations at a time. `Set`: what the source is compiled
/// for, so that no code for one set stands in for that for another.
template <class Set, class T, std::size_t rows, std::size_t block>
class Staging {
 public:
  QVGEN_INLINE Staging(const Batch<T>& result, std::size_t count)
      : Staging(result, count,
                result.data == nullptr ? Route::direct : route(rows, result.stride * sizeof(T), count)) {}
  QVGEN_INLINE Staging(const Batch<T>& result, std::size_t count, Route route)
      : result_(result), count_(count), route_(route) {}

  /// How many configurations are computed before they have to be moved on.
  [[nodiscard]] QVGEN_INLINE std::size_t part() const { return route_ == Route::direct ? count_ : block; }

  /// Where the results of `count` of them are to be put, from configuration `first` on.
  QVGEN_INLINE Batch<T> place(std::size_t first, std::size_t count) {
    if (route_ == Route::direct) return result_.part(first, count);
    return {buffer_, count, block};
  }

  /// To be called when they stand there.
  QVGEN_INLINE void finish(std::size_t first, std::size_t count) const {
    if (route_ != Route::direct) move(first, count);
  }

 private:
  [[gnu::noinline]] void move(std::size_t first, std::size_t count) const {
    const std::size_t bytes = count * sizeof(T);
    for (std::size_t i = 0; i < rows; ++i) {
      T* const to = result_.data + i * result_.stride + first;
      const T* const from = buffer_ + i * block;
      if (route_ == Route::streamed)
        stream(from, bytes, to);
      else
        std::memcpy(to, from, bytes);
    }
#if defined(__SSE2__)
    if (route_ == Route::streamed) _mm_sfence();
#endif
  }

  Batch<T> result_;
  std::size_t count_;
  Route route_;
  alignas(cache_line) T buffer_[rows * block + (rows == 0 ? 1 : 0)];
};

}  // namespace qvgen::batch

#undef QVGEN_INLINE
