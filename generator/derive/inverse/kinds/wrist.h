// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/wrist.h>

#include "derive/inverse/kinds/unknown.h"

/// Three revolute joints that give an orientation, in half angles.
namespace qvgen::derive::inverse::kind {

struct Wrist {
  std::vector<std::string> variables;  ///< of the first, the middle and the last joint
  std::vector<int> joints;             ///< their indices; -1 of one that is held
  bool ends_the_plan = true;  ///< angles are the output; otherwise cosines and sines for further steps
  bool seeded = false;        ///< before further steps: where the first angle is free, it is the seed's

 protected:
  template <class Backend>
  auto choice(Backend& b) const {
    return seeded ? b.seed_turn(joints[0]) : b.pair("choice_x", "choice_y");
  }
};

/// Axes at right angles. Inputs: u_x, u_y, v_x, v_y; choice_x, choice_y if further steps
/// follow and the seed does not choose.
struct RightWrist : Wrist {
  static constexpr const char* title = "wrist with right angles, half-angle form";
  bool middle_swapped = false;  ///< middle = 2 atan2(|u|, |v|) instead of 2 atan2(|v|, |u|)

  [[nodiscard]] std::vector<Formula> solution(const std::vector<std::string>& angles) const {
    const std::string ratio = middle_swapped ? "(|u|, |v|)" : "(|v|, |u|)";
    return {{angles[0] + " = arg u + arg v", angles[0] + " = \\arg u + \\arg v"},
            {angles[1] + " = 2*atan2" + ratio, angles[1] + " = 2\\,\\mathrm{atan2}" + ratio},
            {angles[2] + " = arg u - arg v", angles[2] + " = \\arg u - \\arg v"},
            {"or " + angles[0] + " + pi, -" + angles[1] + ", " + angles[2] + " + pi",
             "\\text{or } " + angles[0] + " + \\pi,\\ -" + angles[1] + ",\\ " + angles[2] + " + \\pi"}};
  }

  template <class Backend>
  auto apply(const Unknown& /*of*/, Backend& b) const {
    const auto u = b.pair("u_x", "u_y");
    const auto v = b.pair("v_x", "v_y");
    if (ends_the_plan)
      return b.wrist_branches(
          *this, b.call(
                     "right_wrist", [](auto&&... a) { return qvgen::inverse::right_wrist(a...); }, u, v,
                     b.flag(middle_swapped), b.seed_angle(joints[0]), b.pi(), b.branch()));
    return b.wrist_turns(
        *this, b.call(
                   "right_wrist_turns", [](auto&&... a) { return qvgen::inverse::right_wrist_turns(a...); },
                   u, v, b.flag(middle_swapped), choice(b), b.sign(), b.boundary(), b.branch()));
  }
};

/// Any other axes. Inputs: u_x, u_y, v_x, v_y, cosine_sum, sine_sum, cosine_difference, sine_difference,
/// product, cosine_delta, sine_delta; choice_x, choice_y if further steps
/// follow and the seed does not choose.
struct ObliqueWrist : Wrist {
  static constexpr const char* title = "wrist with oblique axes, half-angle form";

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& angles) {
    return {{"|u|^2 = cosine_sum^2 + product*sin(phi/2)^2, " + angles[1] + " = +-phi - delta",
             "|u|^2 = \\cos^2\\tfrac{\\alpha+\\alpha'}{2} + \\sin\\alpha\\sin\\alpha' "
             "\\sin^2\\tfrac{\\varphi}{2},\\ " +
                 angles[1] + " = \\pm\\varphi - \\delta"}};
  }

  template <class Backend>
  auto apply(const Unknown& /*of*/, Backend& b) const {
    using Shape = qvgen::inverse::WristShape<typename Backend::Number>;
    const auto u = b.pair("u_x", "u_y");
    const auto v = b.pair("v_x", "v_y");
    const auto shape =
        b.template make<Shape>("WristShape", b.input("cosine_sum"), b.input("sine_sum"),
                               b.input("cosine_difference"), b.input("sine_difference"), b.input("product"));
    if (ends_the_plan)
      return b.wrist_angles(
          *this, b.call(
                     "oblique_wrist", [](auto&&... a) { return qvgen::inverse::oblique_wrist(a...); }, u, v,
                     shape, b.sign(), b.seed_angle(joints[0]), b.boundary(), b.pi(), b.branch()));
    return b.wrist_turns(
        *this,
        b.call(
            "oblique_wrist_turns", [](auto&&... a) { return qvgen::inverse::oblique_wrist_turns(a...); }, u,
            v, shape, b.pair("cosine_delta", "sine_delta"), choice(b), b.sign(), b.boundary(), b.branch()));
  }
};

}  // namespace qvgen::derive::inverse::kind
