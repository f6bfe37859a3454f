// SPDX-License-Identifier: MIT
// Unknowns that a calibration can find: errors of the arm's geometry, and the frames and surfaces that nobody
// measured. Each is one elementary motion, a turn about or a shift along an axis, at one place of the chain
//
//     tracker | gap 1, joint 1 | gap 2, joint 2 | ... | gap n + 1 (the tool) | target
//
// Gap j leads from joint j - 1 to joint j. In it stand, along u, the common normal of the two axes, along the
// axis of joint j, and along v, perpendicular to both, three shifts and three turns: the four numbers of
// Denavit and Hartenberg (zero, length, offset, twist) and the two that parallel axes need in addition
// (Hayati and Mirmirani 1985).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace qvgen::calibrate {

enum class Kind {
  zero,              ///< of joint j: a turn about its axis, or a shift along it
  length,            ///< of the link before joint j: a shift along u
  offset,            ///< of the link before joint j: a shift along the axis of joint j
  twist,             ///< of the link before joint j: a turn about u
  tilt,              ///< of the axis of joint j: a turn about v
  shift,             ///< of the axis of joint j: along v
  swing,             ///< of a slide: a turn about its own axis
  eccentric_cosine,  ///< first harmonic of a joint's gear, times cos q
  eccentric_sine,    ///< likewise, times sin q
  bend,              ///< of joint j under the weight of what it carries: its greatest bend
  tool_shift,        ///< of the tool's frame, along its x, y or z
  tool_turn,         ///< of the tool's frame, about its x, y or z
  tracker_shift,
  tracker_turn,
  target_shift,
  target_turn,
  surface  ///< a number of a touched plane or sphere, or of the fixed end of a measured distance
};

/// True for errors that change with the posture, which no description holds.
inline bool is_of_posture(Kind kind) {
  return kind == Kind::eccentric_cosine || kind == Kind::eccentric_sine || kind == Kind::bend;
}

struct Parameter {
  Kind kind = Kind::zero;
  std::size_t gap = 0;        ///< 0: tracker; 1 ... n; n + 1: tool; n + 2: target
  std::size_t direction = 0;  ///< 0, 1, 2: u, v, axis, or x, y, z of a frame
  std::size_t object = 0;     ///< which target or surface
  std::string name;           ///< in words
  bool turn = false;          ///< rad, else m
  bool nuisance = false;      ///< belongs to the measurement, not to the arm
};

/// Errors that are looked for.
enum class Errors { zeros, lengths, all };

}  // namespace qvgen::calibrate
