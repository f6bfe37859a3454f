// SPDX-License-Identifier: MIT
// Equations of a weld or a slide in space, joint by joint: a chain written out as one expression would grow
// with a power of its length, and its second derivatives with that of its square. Here every joint turns
// what comes before it, under names; derivatives are cross products, and the bias is that of velocities.
#pragma once

#include "derive/loops/cycle.h"

namespace qvgen::derive::loops {

/// True for a closure whose equations are written so.
bool is_rigid_in_space(const Cycle& cycle);

/// A closure's gaps, m and then rad: the way from the second link's point to the first one's, in the common
/// link's frame (across the line of a slide, in the first link's), and how the first link is turned against
/// the second: twice the tangent of half the angle, times the axis, in its own frame. Names are added to
/// `program`, in the symbols of `Constraints`.
std::vector<GiNaC::ex> gaps_in_space(const model::Robot& robot, const Cycle& cycle,
                                     symbolic::Program& program);
/// Returns the gaps' derivatives by all joints, a list for each gap.
std::vector<std::vector<GiNaC::ex>> jacobian_in_space(const model::Robot& robot, const Cycle& cycle,
                                                      symbolic::Program& program);
/// Returns the part of the gaps' second derivatives by time that rates alone make, where the loop is closed.
std::vector<GiNaC::ex> bias_in_space(const model::Robot& robot, const Cycle& cycle,
                                     symbolic::Program& program);

}  // namespace qvgen::derive::loops
