// SPDX-License-Identifier: MIT
#pragma once

#include "slide_scan.h"

namespace qvgen::inverse::elimination {
namespace {

/// One lane of joint values.
template <class T>
JointPairs lane(const JointLanes<T>& q, int i) {
  JointPairs result;
  for (int j = 0; j < joints; ++j) {
    result.cosine[j] = q.cosine[j][i];
    result.sine[j] = q.sine[j][i];
  }
  return result;
}

/// Two slides: where steps to solutions may begin besides the polynomial's simple roots. Calls offer(joints).
template <int width, class Offer>
class SlideStarts {
  using T = Lanes<width>;

 public:
  SlideStarts(const Elimination& e, const SlideSystem& s, double size, const Offer& offer)
      : e_(e), s_(s), size_(size), offer_(offer) {}

  /// Offers the joints of the other sign where two roots are not told apart, since each sign of the root may
  /// have one: in lanes chosen by `of`, the sign that leaves the larger volume, if that is small too.
  template <class Of>
  void offer_other_sign(const T& cosine, const T& sine, int count, const Of& of) const {
    constexpr double small = 0.05;
    Taken taken;
    taken.other = true;
    JointLanes<T> start;
    const Left<T> left = substituted(cosine, sine, taken, start);
    for (int i = 0; i < count; ++i)
      if (of(i) && std::fabs(left.volume[i]) < small * left.box[i]) offer_(lane(start, i));
  }

  /// The outer angles at which the axes of a and c come nearest to being in line: the polynomial has roots
  /// there that rounding hides.
  void offer_in_line() const {
    constexpr double in_line = 1e-6;  // the square of the sine between them
    const Lanes<4> cosines = {1, 0, -1, 0}, sines = {0, 1, 0, -1};
    const Lanes<4> n = AtOuter<Lanes<4>>(s_, cosines, sines).between;
    const double mean = (n[0] + n[2]) / 2, x = (n[0] - n[2]) / 2, y = (n[1] - n[3]) / 2;
    const double most = std::sqrt(x * x + y * y);
    if (!(most > 1e-9)) return;
    for (const double side : {1.0, -1.0}) {
      const double nearest = mean + side * most, square = 1 - nearest * nearest;
      if (square > in_line) continue;
      offer_in_line_at({side * x / most, side * y / most}, std::sqrt(std::fabs(square)));
    }
  }

  /// Offers each sign by itself if the polynomial drowns in rounding. Returns true if the starts are known to
  /// few digits even so.
  [[nodiscard]] bool offer_each_sign() const {
    const VolumeScan<width> scan(s_);
    scan.take_places([this](const Direction& angle, int sign) {
      offer_at(angle, sign == 0 ? 1 : -1, {1, 0});
    });
    return scan.nearly_vanishes();
  }

 private:
  /// The volume where a and c are in line: a constant, and shares of the cosine and the sine of a.
  struct Turning {
    double constant = 0, even = 0, odd = 0;
    double box = 0;  ///< see `Left`
    [[nodiscard]] double amplitude() const { return std::sqrt(even * even + odd * odd); }
  };

  static constexpr double half_root_3 = 0.86602540378443865;
  static constexpr Direction thirds[3] = {{1, 0}, {-0.5, half_root_3}, {-0.5, -half_root_3}};

  Left<T> substituted(const T& cosine, const T& sine, const Taken& taken, JointLanes<T>& start) const {
    return substitute_slides(e_, s_, size_, cosine, sine, taken, start);
  }
  Left<T> substituted(const Direction& angle, double sign, const Direction& a, JointLanes<T>& start) const {
    const Taken taken{sign, false, a.cosine, a.sine};
    return substituted(spread<T>(angle.cosine), spread<T>(angle.sine), taken, start);
  }

  void offer_at(const Direction& angle, double sign, const Direction& a) const {
    JointLanes<T> start;
    substituted(angle, sign, a, start);
    offer_(lane(start, 0));
  }

  /// `off`: the sine between the axes.
  void offer_in_line_at(const Direction& angle, double off) const {
    constexpr double not_there = -1e-3, one_root = 1e-12;
    JointLanes<T> start;
    const double square = substituted(angle, 1, {1, 0}, start).square[0];
    if (square < not_there) return;
    offer_turns(angle, 1, off);
    if (square > one_root) offer_turns(angle, -1, off);
  }

  [[nodiscard]] Turning turning(const Direction& angle, double sign) const {
    Turning result;
    for (const Direction& by : thirds) {
      JointLanes<T> start;
      const Left<T> left = substituted(angle, sign, by, start);
      result.box = std::fmax(result.box, left.box[0]);
      result.constant += left.volume[0] / 3;
      result.even += left.volume[0] * by.cosine * 2 / 3;
      result.odd += left.volume[0] * by.sine * 2 / 3;
    }
    return result;
  }

  /// Steps begin where the volume vanishes: anywhere if it does everywhere, and at six places besides if it
  /// is so small that these are not certain.
  void offer_turns(const Direction& angle, double sign, double off) const {
    constexpr double rounding = 1e-12, certain = 1e-7;
    const Turning volume = turning(angle, sign);
    const double most = volume.amplitude();
    const double largest = std::fmax(std::fabs(volume.constant), most);
    if (!(largest > rounding * volume.box)) return offer_at(angle, sign, {1, 0});
    if (!(largest > std::fmax(certain, 30 * off) * volume.box))
      for (const double turn : {1.0, -1.0})
        for (const Direction& by : thirds) offer_at(angle, sign, {turn * by.cosine, turn * by.sine});
    if (std::fabs(volume.constant) > 1.1 * most) return;
    const Direction middle = {volume.even / most, volume.odd / most};
    const double c = std::fmax(-1.0, std::fmin(1.0, -volume.constant / most)), s = std::sqrt(1 - c * c);
    offer_at(angle, sign, sum_of(middle, {c, s}));
    if (s > 0) offer_at(angle, sign, sum_of(middle, {c, -s}));
  }

  const Elimination& e_;
  const SlideSystem& s_;
  double size_;
  const Offer& offer_;
};

}  // namespace
}  // namespace qvgen::inverse::elimination
