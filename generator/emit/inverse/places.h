// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"
#include "emit/ast/statement.h"

/// Places of values in the functions of the inverse kinematics: t is the target, w (p, ...) what steps
/// leave for later ones, q a row.
namespace qvgen::emit {

ast::Expression target(const std::string& name = "t");
ast::Expression work(const std::string& name = "w", ast::Element number = ast::Element::plain);
/// A field of the geometry that the target has.
ast::Expression geometry(const ast::Expression& target, const std::string& field);
/// The state of a branch, and its marks: exists, doubtful, unsure, continuum.
ast::Expression branch(const ast::Expression& work);
ast::Expression mark(const ast::Expression& work, const std::string& name);
/// A joint's entry of a list that the target's preference has: turn, slide, angle, brief.
ast::Expression preferred(const derive::inverse::LoweredPlan& plan, const ast::Expression& target,
                          const std::string& list, int joint);
/// A joint's place in the row.
ast::Expression joint_place(const derive::inverse::Plan& plan, int joint, const std::string& row = "q");
/// Place of the length of an unknown's direction.
ast::Expression length_place(const ast::Expression& work, const std::string& unknown);

/// Value of a joint that its step leaves in `work`, an angle by its arctangent.
ast::Expression joint_value(const derive::inverse::LoweredPlan& plan, int joint, const ast::Expression& work);
/// Assignments of the joints' values that a step leaves in `work`.
ast::Statements joint_values(const derive::inverse::LoweredPlan& plan, const derive::inverse::Step& step,
                             const ast::Expression& work);

/// Call of a step's function; `sign` is nothing for a step with one branch.
ast::Expression step_call(const derive::inverse::LoweredPlan& plan, std::size_t step,
                          const ast::Expression& target, const ast::Expression& sign,
                          const ast::Expression& work);
/// The roots of a step that is a quartic, and the call that makes one of them work.
ast::Statement quartic_roots(const derive::inverse::LoweredPlan& plan, std::size_t step);
ast::Expression take_root(const derive::inverse::LoweredPlan& plan, std::size_t step, const std::string& root,
                          const ast::Expression& work);

}  // namespace qvgen::emit
