// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "emit/blocks/types.h"

/// Properties that C says only by the way in which names are used: a pointer is an array, may be NULL, or is
/// changed through; a variable changes. Languages whose types say so read them here.
namespace qvgen::emit::blocks {

/// How a function uses one of its parameters.
struct Shape {
  bool many = false;      ///< an array
  bool optional = false;  ///< NULL is among its values
  bool changed = false;   ///< what it points at is written
  int size = 0;           ///< entries of the array, 0 if they are not known
};

class Shapes {
 public:
  /// Arrays that say no size and may be NULL, or are a public function's, have an entry for each joint; those
  /// of a module's own functions for each joint that the module counts.
  explicit Shapes(const Unit& unit);
  [[nodiscard]] const std::vector<Shape>& of(const std::string& function) const {
    return shapes_.at(function);
  }

 private:
  std::map<std::string, std::vector<Shape>> shapes_;
};

/// Calls a function for every expression of the statements, outer ones first.
void for_each(const Statements& statements, const std::function<void(const Expression&)>& act);
void for_each(const Expression& expression, const std::function<void(const Expression&)>& act);
void for_each_statement(const Statements& statements, const std::function<void(const Statement&)>& act);

/// Variables and parameters of a function that are assigned, or whose parts are, through other names too.
std::set<std::string> changed_names(const Unit& unit, const Shapes& shapes, const Function& function);

/// The variable that a place is a part of.
const Expression& root_of(const Expression& place);

/// True if a name is read anywhere in the unit.
std::set<std::string> used_names(const Unit& unit);

/// "ur5_lower_limits" -> "lower_limits".
std::string without_robot(const std::string& name, const std::string& robot);
/// True if a shared function or constant has the name of a public one, but for the robot's.
bool has_public_twin(const Unit& unit, const std::string& name);

/// True if a public function's last parameter is its result, which languages that can return it.
bool returns_last(const Function& function);
/// True if the robot has inverse kinematics of poses, without given joints.
bool solves_poses(const Unit& unit);
/// True if the unit has a module of that name.
bool has_module(const Unit& unit, const std::string& name);
/// Returns how many joints follow motors in the inverse kinematics; 0 if none does.
int joints_with_motors(const Unit& unit);
/// The type that a pointer parameter leads to, an array with its size.
TypeRef pointee(const Field& parameter);

/// True for a structure of which C has one byte, as all its constants are numbers in the code.
bool has_no_constants(const Structure& structure);

/// True for types that a pointer leads to a number of.
bool is_scalar_pointer(const TypeRef& type);

/// How many entries memcpy and memset handle, by their last argument: a number, or an expression; `whole` if
/// the argument is the size of an object.
struct Extent {
  bool whole = false;
  Expression count = {};
};
Extent extent_of(const Expression& size);

}  // namespace qvgen::emit::blocks
