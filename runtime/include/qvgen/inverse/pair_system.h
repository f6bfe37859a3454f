// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <qvgen/inverse/angles.h>

namespace qvgen::inverse {

/// k·x + m·y + one = 0 for the unit vectors x and y of two angles.
template <typename Scalar>
struct PairRow {
  Rotor<Scalar> k, m;
  Scalar one;

  [[nodiscard]] Scalar value(const Rotor<Scalar>& x, const Rotor<Scalar>& y) const {
    return k.cosine * x.cosine + k.sine * x.sine + (m.cosine * y.cosine + m.sine * y.sine) + one;
  }
  [[nodiscard]] static Scalar slope(const Rotor<Scalar>& part, const Rotor<Scalar>& x) {
    return part.sine * x.cosine - part.cosine * x.sine;
  }
};

/// The row over the length of its coefficients: rows may compare lengths or directions.
template <typename Scalar>
PairRow<Scalar> scaled(const PairRow<Scalar>& row) {
  using std::sqrt;
  const Scalar square = row.k.cosine * row.k.cosine + row.k.sine * row.k.sine + row.m.cosine * row.m.cosine +
                        row.m.sine * row.m.sine;
  const Scalar scale = Scalar(1) / sqrt(select(square > Scalar(0), square, Scalar(1)));
  return {scale * row.k, scale * row.m, Scalar(scale * row.one)};
}

/// The rotor turned by a small angle t, exact in length: 2 atan(t/2).
template <typename Scalar>
Rotor<Scalar> nudged(const Rotor<Scalar>& x, const Scalar& angle) {
  const Scalar t = angle / Scalar(2);
  const Scalar scale = Scalar(1) / (Scalar(1) + t * t);
  return Rotor<Scalar>{(Scalar(1) - t) * (Scalar(1) + t) * scale, Scalar(2) * t * scale} * x;
}

/// Two angles that solve two rows, improved by Newton steps as long as they help: the roots of a quartic
/// carry nine to eleven digits, this gives back the rest. Without a better pair the values stay as they are.
template <typename Scalar>
std::array<Rotor<Scalar>, 2> polished_pair(const std::array<PairRow<Scalar>, 2>& rows,
                                           std::array<Rotor<Scalar>, 2> values) {
  const std::array<PairRow<Scalar>, 2> r{scaled(rows[0]), scaled(rows[1])};
  Rotor<Scalar>& x = values[0];
  Rotor<Scalar>& y = values[1];
  Scalar e = r[0].value(x, y);
  Scalar f = r[1].value(x, y);
  for (int step = 0; step < 8 && (e != Scalar(0) || f != Scalar(0)); ++step) {
    const Scalar a = PairRow<Scalar>::slope(r[0].k, x), b = PairRow<Scalar>::slope(r[0].m, y);
    const Scalar c = PairRow<Scalar>::slope(r[1].k, x), d = PairRow<Scalar>::slope(r[1].m, y);
    const Scalar determinant = a * d - b * c;
    if (determinant == Scalar(0)) break;
    const Rotor<Scalar> next_x = nudged(x, Scalar((b * f - d * e) / determinant));
    const Rotor<Scalar> next_y = nudged(y, Scalar((c * e - a * f) / determinant));
    const Scalar next_e = r[0].value(next_x, next_y);
    const Scalar next_f = r[1].value(next_x, next_y);
    if (!(next_e * next_e + next_f * next_f < e * e + f * f)) break;
    x = next_x;
    y = next_y;
    e = next_e;
    f = next_f;
  }
  return values;
}

}  // namespace qvgen::inverse
