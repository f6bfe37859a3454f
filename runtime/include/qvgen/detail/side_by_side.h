// SPDX-License-Identifier: MIT
// Sums of columns that stay in registers: so many numbers side by side, any scalar, with the few operations
// that solving linear equations takes. Every place is a constant, so that compilers keep no array in memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <qvgen/simd/lanes.h>

namespace qvgen::detail {

/// Has what was stored read from memory from here on. Compilers that know it from its store would keep it in
/// registers instead, of which there are too few, and store it twice.
template <class Scalar>
[[gnu::always_inline]] inline void settle([[maybe_unused]] const Scalar* stored) {
#if defined(__GNUC__)
  asm volatile("" : : "r"(stored) : "memory");
#endif
}

/// A register of numbers where they are the machine's, else one number.
template <class Scalar>
struct Register {
  using Numbers = Scalar;
  static constexpr int size = 1;
  static Numbers unit(int) { return Scalar(1); }
  static Numbers of(const Scalar& number) { return number; }
  static Numbers load(const Scalar* from) { return *from; }
  static void store(const Numbers& numbers, Scalar* to) { *to = numbers; }
};
template <class Scalar>
struct MachineRegister {
  using Numbers = simd::Lanes<Scalar, simd::Doubles<simd::widest_register / 8>>;
  static constexpr int size = Numbers::size;
  /// One at that place, else zeros.
  [[gnu::always_inline]] static Numbers unit(int place) {
    Numbers numbers(0);
    numbers.set(place, 1);
    return numbers;
  }
  template <class... All>
  [[gnu::always_inline]] static Numbers of(const All&... numbers) {
    return Numbers(numbers...);
  }
  [[gnu::always_inline]] static Numbers load(const Scalar* from) { return Numbers::load(from); }
  [[gnu::always_inline]] static void store(const Numbers& numbers, Scalar* to) { numbers.store(to); }
};
template <>
struct Register<double> : MachineRegister<double> {};
template <>
struct Register<float> : MachineRegister<float> {};

/// Numbers side by side, in registers as long as the compiler has some.
template <class Scalar, class Parts>
class SideBySide;
template <class Scalar, int... part>
class SideBySide<Scalar, std::integer_sequence<int, part...>> {
 public:
  static constexpr int unit_size = Register<Scalar>::size, lanes = sizeof...(part) * unit_size;

  /// Zeros.
  [[gnu::always_inline]] SideBySide() : parts_{(static_cast<void>(part), Numbers(0))...} {}
  [[gnu::always_inline]] explicit SideBySide(const Scalar* from)
      : parts_{Unit::load(from + part * Unit::size)...} {}
  /// The numbers at these places, then zeros.
  template <int... place>
  [[gnu::always_inline]] SideBySide(const Scalar* from, std::integer_sequence<int, place...> places)
      : parts_{gathered<part>(from, places, std::make_integer_sequence<int, Unit::size>())...} {}
  /// One at `place`, else zeros.
  template <int place>
  [[gnu::always_inline]] static SideBySide unit() {
    SideBySide numbers;
    numbers.parts_[place / Unit::size] = Unit::unit(place % Unit::size);
    return numbers;
  }
  [[gnu::always_inline]] void store(Scalar* to) const {
    (Unit::store(parts_[part], to + part * Unit::size), ...);
  }
  /// Stores the first numbers, so many.
  template <int count>
  [[gnu::always_inline]] void store_first(Scalar* to) const {
    constexpr int whole = count / Unit::size;
    ((part < whole ? Unit::store(parts_[part], to + part * Unit::size) : void()), ...);
    if constexpr (count % Unit::size != 0) {
      Scalar rest[Unit::size];
      Unit::store(parts_[whole], rest);
      std::copy(rest, rest + count % Unit::size, to + whole * Unit::size);
    }
  }
  [[gnu::always_inline]] void scale(const Scalar& factor) { ((parts_[part] *= Numbers(factor)), ...); }
  [[gnu::always_inline]] void subtract(const Scalar& factor, const Scalar* from) {
    const Numbers all(factor);
    ((parts_[part] -= all * Unit::load(from + part * Unit::size)), ...);
  }
  /// scale * from - factor * other, where `from` is zero, and is not read, outside of the registers that
  /// `Takes::any(begin, end)` is true for.
  template <class Takes>
  [[gnu::always_inline]] SideBySide(Takes, const Scalar& scale, const Scalar* from, const Scalar& factor,
                                    const Scalar* other)
      : parts_{difference<takes<Takes>(part), part>(scale, from, factor, other)...} {}
  /// Likewise where the numbers are zero outside of those registers.
  template <class Takes>
  [[gnu::always_inline]] void subtract_some(const Scalar& factor, const Scalar* from) {
    const Numbers all(factor);
    (subtract_if<takes<Takes>(part), part>(all, from), ...);
  }
  template <class Takes>
  [[gnu::always_inline]] void store_some(Scalar* to) const {
    ((takes<Takes>(part) ? Unit::store(parts_[part], to + part * Unit::size) : void()), ...);
  }

 private:
  using Unit = Register<Scalar>;
  using Numbers = typename Unit::Numbers;

  template <class Takes>
  static constexpr bool takes(int which) {
    return Takes::any(which * Unit::size, which * Unit::size + Unit::size);
  }
  template <bool takes, int which>
  [[gnu::always_inline]] static Numbers difference(const Scalar& scale, const Scalar* from,
                                                   const Scalar& factor, const Scalar* other) {
    const Numbers second = Unit::load(other + which * Unit::size);
    if constexpr (takes)
      return Numbers(scale) * Unit::load(from + which * Unit::size) - Numbers(factor) * second;
    else
      return Numbers(-factor) * second;
  }

  template <int which, int... place, int... lane>
  [[gnu::always_inline]] static Numbers gathered(const Scalar* from, std::integer_sequence<int, place...>,
                                                 std::integer_sequence<int, lane...>) {
    constexpr std::array<int, sizeof...(place)> places{place...};
    constexpr int first = which * Unit::size, count = sizeof...(place);
    constexpr bool is_run = first + Unit::size <= count &&
                            ((places[std::size_t((first + lane) % count)] == places[first] + lane) && ...);
    if constexpr (is_run)
      return Unit::load(from + places[first]);
    else
      return Unit::of(
          (first + lane < count ? from[places[std::size_t((first + lane) % count)]] : Scalar(0))...);
  }

  template <bool takes, int which>
  [[gnu::always_inline]] void subtract_if(const Numbers& factor, const Scalar* from) {
    if constexpr (takes) parts_[which] -= factor * Unit::load(from + which * Unit::size);
  }

  Numbers parts_[sizeof...(part)];
};

/// Registers for so many numbers.
template <class Scalar, int count>
using RegistersOf = SideBySide<
    Scalar, std::make_integer_sequence<int, (count + Register<Scalar>::size - 1) / Register<Scalar>::size>>;

}  // namespace qvgen::detail
