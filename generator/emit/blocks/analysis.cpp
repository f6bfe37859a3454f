// SPDX-License-Identifier: MIT
#include "emit/blocks/analysis.h"

#include <algorithm>
#include <array>

namespace qvgen::emit::blocks {

using Kind = Expression::Kind;

void for_each(const Expression& expression, const std::function<void(const Expression&)>& act) {
  act(expression);
  for (const Expression& operand : expression.operands) for_each(operand, act);
}

void for_each_statement(const Statements& statements, const std::function<void(const Statement&)>& act) {
  for (const Statement& each : statements) {
    act(each);
    for (const Statements* inner : {&each.first, &each.body, &each.otherwise})
      for_each_statement(*inner, act);
  }
}

void for_each(const Statements& statements, const std::function<void(const Expression&)>& act) {
  for_each_statement(statements, [&](const Statement& each) {
    for (const Expression& value : each.values) for_each(value, act);
  });
}

const Expression& root_of(const Expression& place) {
  switch (place.kind) {
    case Kind::member:
    case Kind::index:
    case Kind::dereference:
    case Kind::address:
    case Kind::binary:
    case Kind::cast:
      return root_of(place.operands[0]);
    default:
      return place;
  }
}

bool is_scalar_pointer(const TypeRef& type) {
  return type->kind == Type::Kind::pointer && is_number(type->of);
}

namespace {

bool is_name(const Expression& e, const std::string& name) { return e.kind == Kind::name && e.text == name; }

/// Learns from one expression how the parameter `name` is used.
void learn(const Expression& e, const std::string& name,
           const std::map<std::string, std::vector<Shape>>& known, Shape& shape) {
  const auto operand_is = [&](std::size_t i) {
    return e.operands.size() > i && is_name(e.operands[i], name);
  };
  if (e.kind == Kind::index && operand_is(0)) shape.many = true;
  if (e.kind == Kind::binary && (operand_is(0) || operand_is(1))) {
    const bool compares = e.text == "==" || e.text == "!=";
    (compares ? shape.optional : shape.many) = true;
  }
  if (e.kind == Kind::conditional && (operand_is(1) || operand_is(2)))
    for (const Expression& other : e.operands)
      if (other.type && other.type->kind == Type::Kind::array) shape.many = true;
  if (e.kind != Kind::call) return;
  const auto callee = known.find(e.text);
  for (std::size_t i = 0; i < e.operands.size(); ++i) {
    if (!operand_is(i)) continue;
    if (callee == known.end()) {
      shape.many = true;  // memcpy and memset
      continue;
    }
    shape.many = shape.many || callee->second[i].many;
    shape.optional = shape.optional || callee->second[i].optional;
  }
}

/// How many joints a function is about: the robot's, or, of a module's own functions, those that the module
/// counts, without outer joints.
int joints_of(const Unit& unit, const Function& function) {
  const Constant* joints = unit.constant(unit.robot + "_dof");
  const std::array<std::string, 2> names{"dof", "dof_of_" + function.module};
  for (const std::string& name : names) {
    const Constant* own = unit.constant(name);
    if (!function.is_public && own != nullptr && own->module == function.module) joints = own;
  }
  return joints != nullptr ? std::stoi(joints->value[0].text) : 0;
}

bool gives_null(const Expression& e) {
  return e.kind == Kind::null ||
         (e.kind == Kind::conditional && (gives_null(e.operands[1]) || gives_null(e.operands[2])));
}

}  // namespace

Shapes::Shapes(const Unit& unit) {
  for (const Function& function : unit.functions) {
    std::vector<Shape>& own = shapes_[function.name];
    for (const Field& parameter : function.parameters) {
      Shape shape;
      shape.size = parameter.type->size;
      const bool is_pointer = parameter.type->kind == Type::Kind::pointer;
      shape.many = is_pointer && shape.size > 0;
      shape.many = shape.many || (is_pointer && parameter.type->of->kind == Type::Kind::array);
      shape.changed = is_pointer && !parameter.type->constant;
      own.push_back(shape);
    }
  }
  for (int round = 0; round < 3; ++round)
    for (const Function& function : unit.functions) {
      std::vector<Shape>& own = shapes_[function.name];
      for (std::size_t i = 0; i < own.size(); ++i) {
        const Field& parameter = function.parameters[i];
        if (parameter.type->kind != Type::Kind::pointer) continue;
        for_each(function.body, [&](const Expression& e) { learn(e, parameter.name, shapes_, own[i]); });
        // Who says how many entries there are says that there are some.
        if (parameter.type->size > 0) own[i].optional = false;
      }
      for_each(function.body, [&](const Expression& e) {
        const auto callee = shapes_.find(e.text);
        if (e.kind != Kind::call || callee == shapes_.end()) return;
        for (std::size_t i = 0; i < e.operands.size(); ++i)
          if (gives_null(e.operands[i])) callee->second[i].optional = true;
      });
    }
  for (const Function& function : unit.functions)
    for (Shape& shape : shapes_[function.name])
      if ((function.is_public || shape.optional) && shape.many && shape.size == 0)
        shape.size = joints_of(unit, function);
}

std::set<std::string> changed_names(const Unit& unit, const Shapes& shapes, const Function& function) {
  std::map<std::string, const Expression*> others;
  for_each_statement(function.body, [&](const Statement& each) {
    if (each.kind == Statement::Kind::declare && each.type->kind == Type::Kind::pointer &&
        !each.values.empty())
      others[each.name] = &each.values[0];
  });
  std::set<std::string> changed;
  const auto change = [&](const Expression& place) {
    const Expression* root = &root_of(place);
    for (auto other = others.find(root->text); other != others.end(); other = others.find(root->text))
      root = &root_of(*other->second);
    changed.insert(root->text);
  };
  for_each(function.body, [&](const Expression& e) {
    if (e.kind == Kind::assign || e.kind == Kind::before || e.kind == Kind::after) change(e.operands[0]);
    if (e.kind != Kind::call) return;
    if (e.text == "memcpy" || e.text == "memset") return change(e.operands[0]);
    if (unit.function(e.text) == nullptr) return;
    const std::vector<Shape>& wanted = shapes.of(e.text);
    for (std::size_t i = 0; i < e.operands.size(); ++i)
      if (wanted[i].changed) change(e.operands[i]);
  });
  return changed;
}

std::set<std::string> used_names(const Unit& unit) {
  std::set<std::string> used;
  const auto use = [&](const Expression& e) {
    if (e.kind == Kind::name || e.kind == Kind::call) used.insert(e.text);
  };
  for (const Function& function : unit.functions) for_each(function.body, use);
  for (const Constant& constant : unit.constants)
    for (const Expression& value : constant.value) for_each(value, use);
  return used;
}

std::string without_robot(const std::string& name, const std::string& robot) {
  const std::string prefix = robot + "_";
  return !robot.empty() && name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : name;
}

bool has_public_twin(const Unit& unit, const std::string& name) {
  const std::string twin = unit.robot + "_" + name;
  return unit.function(twin) != nullptr || unit.constant(twin) != nullptr;
}

TypeRef pointee(const Field& parameter) {
  const TypeRef& type = parameter.type;
  return type->size > 0 ? array_of(type->of, type->size) : type->of;
}

bool returns_last(const Function& function) {
  if (!function.is_public || function.parameters.empty()) return false;
  const Field& last = function.parameters.back();
  return last.type->kind == Type::Kind::pointer && !last.type->constant &&
         (last.name == "result" || last.name == "found" ||
          (last.name == "all" && function.result->kind == Type::Kind::nothing));
}

Extent extent_of(const Expression& size) {
  if (size.kind == Kind::size_of) {
    const TypeRef& type = size.operands[0].type;
    if (type->kind == Type::Kind::array) {
      Expression count{Kind::integer, std::to_string(type->size), {}, basic(Type::Kind::integer)};
      return {false, count};
    }
    return {true, {}};
  }
  Expression count = size.kind == Kind::binary ? size.operands[0] : size;
  if (count.kind == Kind::cast) count = count.operands[0];
  return {false, count};
}

bool has_no_constants(const Structure& structure) {
  return structure.fields.size() == 1 && structure.fields[0].name == "none";
}

bool solves_poses(const Unit& unit) { return unit.function(unit.robot + "_inverse_kinematics") != nullptr; }

bool has_module(const Unit& unit, const std::string& name) {
  return std::find(unit.modules.begin(), unit.modules.end(), name) != unit.modules.end();
}

int joints_with_motors(const Unit& unit) {
  const auto kinds = std::find_if(unit.constants.begin(), unit.constants.end(), [&](const Constant& each) {
    return each.name == unit.robot + "_joint_is_revolute";
  });
  return kinds == unit.constants.end() ? 0 : kinds->type->size;
}

}  // namespace qvgen::emit::blocks
