// SPDX-License-Identifier: MIT
// Sums of columns that stay in registers: so many numbers side by side, any scalar, with the few operations
// that solving linear equations takes. Every place is a constant, so that compilers keep no array in memory.
#pragma once

#include <algorithm>
#include <utility>

#include <qvgen/simd/lanes.h>

namespace qvgen::detail {

/// A register of numbers where they are the machine's, else one number.
template <class Scalar>
struct Register {
  using Numbers = Scalar;
  static constexpr int size = 1;
  static Numbers unit(int) { return Scalar(1); }
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
  static constexpr int lanes = sizeof...(part) * Register<Scalar>::size;

  /// Zeros.
  [[gnu::always_inline]] SideBySide() : parts_{(static_cast<void>(part), Numbers(0))...} {}
  [[gnu::always_inline]] explicit SideBySide(const Scalar* from)
      : parts_{Unit::load(from + part * Unit::size)...} {}
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
  /// Likewise where the numbers are zero outside of the registers that `Takes::any(begin, end)` is true for.
  template <class Takes>
  [[gnu::always_inline]] void subtract_some(const Scalar& factor, const Scalar* from) {
    const Numbers all(factor);
    (subtract_if<Takes::any(part * Unit::size, part * Unit::size + Unit::size), part>(all, from), ...);
  }

 private:
  using Unit = Register<Scalar>;
  using Numbers = typename Unit::Numbers;

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
