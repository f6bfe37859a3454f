// SPDX-License-Identifier: MIT
#pragma once

#include "slide_joints.h"
#include "trigonometric.h"

namespace qvgen::inverse::elimination {
namespace {

/// Two slides: the volume that has to vanish, looked at for each sign of the root by itself. Where it is next
/// to nothing for one sign, whatever the outer angle, that sign's solutions and the other's drown in the
/// rounding of their product; here they are told apart.
template <int width>
class VolumeScan {
  using T = Lanes<width>;

 public:
  explicit VolumeScan(const SlideSystem& s) : s_(s) {
    for (int first = 0; first < count; first += width) {
      Direction at[width];
      for (int i = 0; i < width; ++i) at[i] = angle(first + i);
      look(at, place_ + first);
    }
  }

  /// True if, for one sign, the volume is next to nothing everywhere but not rounding: where it vanishes is
  /// then known to few digits.
  [[nodiscard]] bool nearly_vanishes() const {
    for (const int sign : {0, 1}) {
      double most = 0;
      for (const Place& place : place_)
        if (place.exists) most = std::fmax(most, std::fabs(place.share[sign]));
      if (most > rounding && most < few_digits) return true;
    }
    return false;
  }

  /// Calls take(angle, sign) wherever a solution may be; a stretch of solutions is one place.
  template <class Take>
  void take_places(const Take& take) const {
    for (const int sign : {0, 1}) take_places_of(sign, take);
  }

 private:
  static constexpr int count = 32;
  static constexpr double rounding = 1e-13;
  static constexpr double few_digits = 1e-8;

  /// The share of the volume that the columns would span at right angles, by sign.
  struct Place {
    bool exists;
    double share[2];
  };

  /// Between the angles at which axes of real arms come in line.
  static Direction angle(int i) {
    constexpr Direction offset = {0.9950041652780258, 0.09983341664682815};  // 0.1 rad
    Direction result = offset;
    for (int bit = 0; bit < 5; ++bit)
      if ((i >> bit & 1) != 0) result = sum_of(result, power(bit));
    return result;
  }
  /// 2^bit thirty-seconds of a turn.
  static Direction power(int bit) {
    constexpr Direction powers[5] = {{0.98078528040323044913, 0.19509032201612826785},
                                     {0.92387953251128675613, 0.38268343236508977173},
                                     {0.70710678118654752440, 0.70710678118654752440},
                                     {0, 1},
                                     {-1, 0}};
    return powers[bit];
  }

  void look(const Direction (&at)[width], Place* places) const {
    T cosine, sine;
    for (int i = 0; i < width; ++i) {
      cosine[i] = at[i].cosine;
      sine[i] = at[i].sine;
    }
    const AtOuter<T> outer(s_, cosine, sine);
    const auto volume = outer.volume();
    const T r = root(T(outer.square > 0 ? outer.square : T{}));
    for (int sign = 0; sign < 2; ++sign) {
      const T by = sign == 0 ? r : T(-r);
      T box = spread<T>(1);
      for (int k = 0; k < 3; ++k) {
        T square = spread<T>(k == 0 ? 1 : 0);
        for (int i = 0; i < 3; ++i) {
          const T x = outer.column[k][i].x + by * outer.column[k][i].y;
          square += x * x;
        }
        box = box * square;
      }
      const T share = (volume.x + by * volume.y) / root(box);
      for (int i = 0; i < width; ++i) places[i].share[sign] = share[i];
    }
    for (int i = 0; i < width; ++i)
      places[i].exists = outer.square[i] >= 0 && std::isfinite(places[i].share[0] + places[i].share[1]);
  }

  [[nodiscard]] bool is_zero(int i, int sign) const {
    return place_[i].exists && std::fabs(place_[i].share[sign]) < rounding;
  }

  template <class Take>
  void take_places_of(int sign, const Take& take) const {
    int start = 0;
    while (start < count && is_zero(start, sign)) ++start;
    if (start == count) return take(angle(0), sign);
    int zeros = 0;
    for (int k = 1; k <= count; ++k) {
      const int i = (start + k) % count, before = (start + k - 1) % count;
      if (is_zero(i, sign)) {
        ++zeros;
        continue;
      }
      if (zeros > 0) take(angle((start + k - 1 - zeros / 2) % count), sign);
      if (zeros == 0 && changes(place_[before], place_[i], sign)) take(closed_in(before, i, sign), sign);
      zeros = 0;
    }
  }

  static bool changes(const Place& a, const Place& b, int sign) {
    return a.exists && b.exists && (a.share[sign] < 0) != (b.share[sign] < 0);
  }

  /// Within a change of sign, a few times that of the parts that has it.
  [[nodiscard]] Direction closed_in(int from, int to, int sign) const {
    constexpr int steps = 4;
    Direction low = angle(from), high = angle(to);
    Place at_low = place_[from], at_high = place_[to];
    for (int step = 0; step < steps; ++step) {
      Direction inner[width];
      Place places[width];
      for (int i = 0; i < width; ++i) inner[i] = between(low, high, (i + 1.0) / (width + 1));
      look(inner, places);
      Direction last = low;
      Place at_last = at_low;
      for (int i = 0; i <= width; ++i) {
        const Direction next = i < width ? inner[i] : high;
        const Place at_next = i < width ? places[i] : at_high;
        if (changes(at_last, at_next, sign)) {
          low = last;
          high = next;
          at_low = at_last;
          at_high = at_next;
          break;
        }
        last = next;
        at_last = at_next;
      }
    }
    const double way = at_low.share[sign] - at_high.share[sign];
    return between(low, high, way != 0 ? at_low.share[sign] / way : 0.5);
  }

  static Direction between(const Direction& low, const Direction& high, double share) {
    const double x = low.cosine + share * (high.cosine - low.cosine);
    const double y = low.sine + share * (high.sine - low.sine);
    const double scale = 1 / std::sqrt(x * x + y * y);
    return {x * scale, y * scale};
  }

  const SlideSystem& s_;
  Place place_[count];
};

}  // namespace
}  // namespace qvgen::inverse::elimination
