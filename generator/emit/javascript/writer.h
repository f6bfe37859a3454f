// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "emit/blocks/analysis.h"

/// Prints functions of a unit in JavaScript. Pointers to structs and arrays are the objects themselves, which
/// are copied wherever C copies; a pointer to one number is an object with a member `v`. Operators keep their
/// order and grouping, and so every bit.
namespace qvgen::emit::javascript {

using Lines = std::vector<std::string>;

/// Unit and shapes, which all functions of a robot's module share.
struct Context {
  const blocks::Unit& unit;
  const blocks::Shapes& shapes;
};

/// A new value of a type, all of whose numbers are zero.
std::string zero_text(const blocks::Unit& unit, const blocks::TypeRef& type);

class FunctionWriter {
 public:
  FunctionWriter(const Context& context, const blocks::Function& function);
  Lines lines();
  /// A constant's value.
  std::string constant_value(const blocks::Expression& value, const blocks::TypeRef& type);
  /// Names of the parameters, with the values that they have if they are left out.
  std::vector<std::string> parameters() const;

 private:
  using Expression = blocks::Expression;
  using Statement = blocks::Statement;
  using TypeRef = blocks::TypeRef;
  /// A text and how strongly it binds.
  struct Text {
    std::string text;
    int level;
  };

  // statements.cpp
  void write(const blocks::Statements& statements, int depth);
  void write(const Statement& statement, int depth);
  std::string declared(const Statement& statement);
  void evaluate(Expression expression, int depth);
  std::string effect(const Expression& expression);
  std::string assigned(const Expression& expression);
  std::string copied(const Expression& call);
  void choose(const Statement& statement, int depth, const std::string& before);
  void loop_for(const Statement& statement, int depth);
  void give(const Statement& statement, int depth);
  void line(int depth, const std::string& text);

  // expressions.cpp
  std::string as(const Expression& expression, const TypeRef& wanted);
  std::string fresh(const Expression& expression);
  Text value(const Expression& expression);
  std::string within(const Expression& expression, int level, const TypeRef& wanted);
  Text binary(const Expression& expression);
  std::string name(const Expression& expression);
  std::string list(const Expression& expression);
  std::string place(const Expression& expression);
  std::string call(const Expression& expression);
  std::string argument(const Expression& expression, const TypeRef& wanted, const blocks::Shape& shape);
  std::string box(const Expression& pointer);
  std::string local(const std::string& name) const;
  const Expression* alias(const Expression& expression) const;

  const Context& context_;
  const blocks::Function& function_;
  std::set<std::string> changed_;
  std::set<std::string> called_;    ///< functions that it calls, whose names no variable may have
  std::set<std::string> borrowed_;  ///< parameters that are structs, by value: the caller's objects
  std::map<std::string, Expression> aliases_;
  bool returns_last_ = false;
  Lines lines_;
};

}  // namespace qvgen::emit::javascript
