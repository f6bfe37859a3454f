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
  streamed,  ///< by way of a buffer, past the caches
};

inline constexpr std::size_t cache_line = 64;  ///< bytes

/// True if rows, one every so many bytes, begin in so few sets of the first cache, as with 1024 numbers a
/// row, that more than so many lines of a set are in use at a time: beyond 8 they push each other out before
/// they are full or read. For a cache with 64 sets; with another one the results are the same.
QVGEN_INLINE inline bool share_sets(std::size_t rows, std::size_t bytes_a_row, std::size_t lines_a_set) {
  constexpr std::size_t sets = 64;
  std::uint64_t taken = 0;
  for (std::size_t i = 0; i < rows; ++i) taken |= std::uint64_t(1) << (i * bytes_a_row / cache_line % sets);
  return rows > lines_a_set * std::bitset<sets>(taken).count();
}

/// Up to so many configurations are no more than a line or two of each row.
inline constexpr std::size_t few_configurations = 16;

/// How results are to go. Staged where rows share sets, half of whose lines are for what else there is.
/// Streamed where no cache holds the results until they are read, which spares reading before writing.
QVGEN_INLINE inline Route route(std::size_t rows, std::size_t bytes_a_row, std::size_t count) {
  constexpr std::size_t many = 1024, beyond_caches = std::size_t(16) << 20;
  if (count <= few_configurations) return Route::direct;
  if (count >= many && rows * bytes_a_row > beyond_caches) return Route::streamed;
  return share_sets(rows, bytes_a_row, 4) ? Route::staged : Route::direct;
}

/// Copies past the caches, whole lines at a time.
QVGEN_INLINE inline void stream(const void* from, std::size_t bytes, void* to) {
#if defined(__SSE2__)
  const auto* source = static_cast<const char*>(from);
  auto* target = static_cast<char*>(to);
  const std::size_t before = (cache_line - reinterpret_cast<std::uintptr_t>(to) % cache_line) % cache_line;
  const std::size_t head = std::min(before, bytes);
  if (head != 0) std::memcpy(target, source, head);
  std::size_t done = head;
  for (; done + cache_line <= bytes; done += cache_line)
    for (std::size_t part = done; part < done + cache_line; part += sizeof(__m128i))
      _mm_stream_si128(reinterpret_cast<__m128i*>(target + part),
                       _mm_loadu_si128(reinterpret_cast<const __m128i*>(source + part)));
  if (done != bytes) std::memcpy(target + done, source + done, bytes - done);
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

  [[nodiscard]] QVGEN_INLINE bool is_direct() const { return route_ == Route::direct; }

  /// Returns where the results of configurations first, first + 1, ... go. Without staging that is the batch
  /// itself; else room for one block.
  QVGEN_INLINE Batch<T> place(std::size_t first, std::size_t count) {
    if (is_direct()) return result_.part(first, count);
    return {buffer_ + line, count, line + block};
  }

  /// To be called when they stand there. All parts but the last are whole blocks.
  QVGEN_INLINE void finish(std::size_t first, std::size_t count) {
    if (!is_direct()) move(first, count);
  }

 private:
  static constexpr std::size_t line = cache_line / sizeof(T);

  [[gnu::noinline]] void move(std::size_t first, std::size_t count) {
    const bool is_last = first + count == count_;
    for (std::size_t i = 0; i < rows; ++i) {
      T* const to = result_.data + i * result_.stride + first;
      T* const from = buffer_ + i * (line + block) + line;
      if (route_ == Route::streamed)
        stream_lines(from, count, to, first == 0, is_last);
      else
        std::memcpy(to, from, count * sizeof(T));
    }
#if defined(__SSE2__)
    if (route_ == Route::streamed && is_last) _mm_sfence();
#endif
  }

  /// Only whole lines of a row, but its first and last: what begins a line waits in front of the next block.
  static void stream_lines(T* from, std::size_t count, T* to, bool is_first, bool is_last) {
    const std::size_t before = is_first ? 0 : in_line(to), after = is_last ? 0 : in_line(to + count);
    stream(from - before, (before + count - after) * sizeof(T), to - before);
    if (after != 0) std::memcpy(from - after, from + count - after, after * sizeof(T));
  }
  /// How many numbers of its line stand in front of a place.
  static std::size_t in_line(const T* place) {
    return reinterpret_cast<std::uintptr_t>(place) % cache_line / sizeof(T);
  }

  Batch<T> result_;
  std::size_t count_;
  Route route_;
  // In front of every row the beginning of a line that has not been streamed yet.
  alignas(cache_line) T buffer_[rows * (line + block) + (rows == 0 ? 1 : 0)];
};

}  // namespace qvgen::batch

#undef QVGEN_INLINE
