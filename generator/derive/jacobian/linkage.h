// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/robot.h"
#include "symbolic/algebra.h"

namespace qvgen::derive {

/// A chain as a list of pivots, each turning all that follows: what Jacobians are derived from.
///
/// Right-angled chains come with all frames parallel at the zero configuration, so that parallel neighbours
/// are seen; in the others each constant rotation is a pivot of its own that no joint moves.
struct Linkage {
  struct Slide {
    std::size_t joint;
    symbolic::Vector axis;  ///< unit, in the frame behind the pivot before it
  };
  /// The way from one pivot to the next: constant offsets and prismatic joints.
  struct Way {
    symbolic::Vector offset;
    std::vector<Slide> slides;
  };
  struct Pivot {
    Way before;             ///< in the frame behind the previous pivot
    symbolic::Vector axis;  ///< unit; the same in front of and behind the pivot
    GiNaC::ex angle;        ///< the joint variable, or the constant angle
    int joint = -1;         ///< index of the joint; -1: constant
  };
  std::vector<Pivot> pivots;
  Way beyond;                        ///< from the last pivot to the tool
  symbolic::Quaternion home;         ///< last frame -> tool frame
  std::vector<GiNaC::ex> variables;  ///< of all joints
};

Linkage linkage(const model::Robot& robot);

/// Returns the robot with its tool moved by (point.x, point.y, point.z), symbols, in its own frame.
model::Robot with_free_tool_point(const model::Robot& robot);

}  // namespace qvgen::derive
