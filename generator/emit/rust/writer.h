// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "emit/blocks/analysis.h"

/// Prints functions of a unit in Rust. Pointers become references; another name of a place is written out
/// where it is used, so that no two references lead to one object; an argument that overlaps what the call
/// changes is copied before it. Operators keep their order and grouping, and so every bit.
namespace qvgen::emit::rust {

using Lines = std::vector<std::string>;

/// The numbers of a module of the crate, and where its functions are.
struct Scalar {
  std::string type = "f64";    ///< f64 or f32
  std::string root = "crate";  ///< "crate", or the module of the crate
  bool holds_integers = true;  ///< true if every i32 is such a number, so that Rust converts it by `from`
};

/// Unit, shapes and numbers, which all functions of a robot share in one precision.
struct Context {
  const blocks::Unit& unit;
  const blocks::Shapes& shapes;
  Scalar scalar = {};
};

std::string type_text(const blocks::TypeRef& type, const Context& context);
/// A value of a type all of whose numbers are zero.
std::string zero_text(const blocks::TypeRef& type, const std::string& robot);
/// Type of a parameter: a reference, a slice, an option, or a value.
std::string parameter_text(const blocks::TypeRef& type, const blocks::Shape& shape, const Context& context);

/// Its name in the crate; one of the shared functions makes room for a public one of its name.
std::string function_name(const blocks::Unit& unit, const blocks::Function& function);

class FunctionWriter {
 public:
  FunctionWriter(const Context& context, const blocks::Function& function);
  Lines lines();
  /// A constant's value.
  std::string constant_value(const blocks::Expression& value, const blocks::TypeRef& type);

 private:
  using Expression = blocks::Expression;
  using Statement = blocks::Statement;
  using TypeRef = blocks::TypeRef;
  /// A text and how strongly it binds.
  struct Text {
    std::string text;
    int level;
  };
  /// A place as its variable and the steps to a part of it: ".field" or "[index]".
  struct Path {
    std::string root;
    std::vector<std::string> steps;
  };

  // Heads and statements: statements.cpp.
  std::string head();
  void write(const blocks::Statements& statements, int depth);
  void write(const Statement& statement, int depth);
  void declare(const Statement& statement, int depth);
  void declare_pointer(const Statement& statement, int depth);
  void evaluate(Expression expression, int depth);
  void assign(const Expression& expression, int depth);
  void copy(const Expression& call, int depth);
  void call_for_result(const Expression& call, int depth);
  void choose(const Statement& statement, int depth, const std::string& before);
  void loop_for(const Statement& statement, int depth);
  bool counted(const Statement& statement, int depth);
  void body(const Statement& loop, int depth);
  void give(const Statement& statement, int depth);
  void give_at_end(const Statement& statement);
  void copy_kept(const Expression& call, int depth);
  void line(int depth, const std::string& text);
  /// Takes increments out of an expression; they are written in front of it.
  Expression hoisted(const Expression& expression, int depth);
  std::string condition(const Expression& expression);

  // Expressions: expressions.cpp.
  std::string as(const Expression& expression, const TypeRef& wanted);
  Text value(const Expression& expression);
  std::string within(const Expression& expression, int level, const TypeRef& wanted);
  Text binary(const Expression& expression);
  Text name(const Expression& expression);
  Text literal_as(const Expression& expression, const TypeRef& wanted);
  std::string list(const Expression& expression);
  std::string structure_list(const Expression& expression);
  std::string place(const Expression& expression);
  std::string index(const Expression& expression);
  bool is_optional(const Expression& expression) const;
  bool is_reference(const Expression& pointer) const;
  /// The place that a local pointer is another name of, or nothing.
  const Expression* alias(const Expression& expression) const;

  /// Objects that a call changes, and which of its arguments are copied back.
  struct Changes {
    std::vector<Path> paths;
    std::vector<bool> copies_back;
  };
  /// Statements around a call.
  struct CallText {
    std::string before = {}, behind = {};
  };

  // Calls: calls.cpp.
  std::string library_call(const Expression& expression);
  Changes changes_of(const Expression& call, std::size_t count);
  bool reads(const Expression& argument, const std::vector<Path>& changed);
  std::string prepared(const Expression& argument, const TypeRef& wanted, const blocks::Shape& shape,
                       const Changes& changes, bool copies_back, CallText& text);
  std::string call(const Expression& expression);
  std::string argument(const Expression& expression, const TypeRef& wanted, const blocks::Shape& shape);
  std::string reference(const Expression& expression, const blocks::Shape& shape);
  std::string pointed_place(const Expression& pointer);
  Path path(const Expression& place);
  bool overlap(const Path& a, const Path& b) const;
  std::string copied(const Expression& pointer);

  const Context& context_;
  const blocks::Function& function_;
  const std::string& robot_;
  std::set<std::string> changed_;
  std::map<std::string, Expression> aliases_;
  std::map<std::string, blocks::Shape> parameters_;
  std::set<std::string> counters_;  ///< variables of loops that do not change inside
  std::vector<std::string> steps_;  ///< what a `continue` of each loop does first; empty of none
  bool returns_last_ = false;
  std::map<std::string, std::string> kept_;  ///< places that keep a copy of a variable, by its name
  int names_ = 0;
  Lines lines_;
};

}  // namespace qvgen::emit::rust
