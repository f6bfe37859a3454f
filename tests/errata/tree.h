// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace qvgen::test::sources {

/// A printed expression as it stands: nothing is simplified or put in order.
struct Tree {
  enum class Kind {
    number,    ///< value
    name,      ///< text: "d4", "N41", "px16", "omega1'" (a dot is a prime)
    angle,     ///< theta of the numbered joints, summed by their signs; half if `value` is 0.5
    function,  ///< text: sin, cos, tan, asin, acos, atan, atan2, sqrt
    sum,
    product,
    quotient,
    power,
    negative,
    either,   ///< the printed sign ± (value 1) or ∓ (value -1)
    cross,    ///< x
    dot,      ///< the inner product
    vector,   ///< < x, y, z >
    bracket,  ///< [s, v], [x, y, z] or [x]
    pair,     ///< (q, p)
    matrix,   ///< `joints` are its rows and columns
    motion    ///< R(z, angle) or T(-y, length) of the tables: text is "Rz" or "T-y"
  };
  Kind kind = Kind::number;
  std::string text = {};
  double value = 0;
  std::vector<int> joints = {};  ///< of an angle: 4, -6 for theta4 - theta6
  std::vector<Tree> parts = {};
  std::string above = {};  ///< frames before a name: {}^{0}_{1}T is T01 with "0" above and "1" below
  std::string below = {};
};

/// How a source writes.
struct Notation {
  std::optional<int> index =
      {};  ///< the letter i stands for this number (at most 8, since i + 1 has one digit)
  /// True if frames before a letter belong to its name: {}^{0}_{1}T is T01, {}^{0}P_{2} is P02. Else they are
  /// passed over.
  bool frames = false;
};

/// Reads what is printed in LaTeX: the sides of an equation, at least one. Throws std::runtime_error that
/// says where it stopped.
std::vector<Tree> read_latex(const std::string& text, const Notation& notation = {});

/// For a terminal: c1, s1 are cosine and sine of theta1, hc1, hs1 of its half, hc(4+6) of half a sum.
std::string plain_text(const Tree& tree);
/// For print, which read_latex reads again.
std::string latex(const Tree& tree);

}  // namespace qvgen::test::sources
