// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/ast/expression.h"

namespace qvgen::emit::ast {

struct Statement {
  enum class Kind {
    declare,        ///< a variable `name` of `type`; of its first value, if there is one
    declare_array,  ///< an array `name` of values of `type`; the value is its size
    declare_row,    ///< an array of joint values; the value is its size
    assign,         ///< the last value goes to all places before it
    evaluate,       ///< a call
    guard,          ///< a statement that is done if the value holds, on the same line
    choose,         ///< statements that are done if the value holds
    loop,           ///< rounds with a variable `name` from 0; the value is how many
    leave_loop,     ///< no further rounds
    next_round,     ///< the next round
    give,           ///< returns the value, if there is one
    scope,          ///< names that end with it
    gap,            ///< an empty line, in languages that write one
    take_nearer,  ///< takes the other branch if it is nearer to the seed: other, its distance, work, distance
    nearest_root  ///< takes the root nearest to the seed; `name` numbers it: take, distance, branches
  };

  Kind kind = Kind::evaluate;
  std::string name = {};
  Type type = {};
  Expressions values = {};
  std::vector<Statement> body = {};
  // Flags of declarations and loops.
  bool constant = false;
  bool deduced = false;  ///< the value says the type, in languages in which it can
  bool alias = false;    ///< another name for the value, in languages that have references
  bool zeroed = false;
  bool unrolled = false;  ///< a loop whose rounds compilers shall write out
};
using Statements = std::vector<Statement>;

Statement declare(const Type& type, const std::string& name);
Statement constant(const Type& type, const std::string& name, const Expression& value);
/// Declares a variable whose type the value says.
Statement deduced(const Type& type, const std::string& name, const Expression& value);
Statement array(const Type& type, const std::string& name, int size);
Statement row(const std::string& name, int size, Element number = Element::plain);
Statement assign(const Expression& place, const Expression& value);
Statement evaluate(const Expression& call);
Statement guard(const Expression& condition, const Statement& then);
Statement choose(const Expression& condition, const Statements& body);
Statement loop(const std::string& variable, const Expression& rounds, const Statements& body = {});
Statement leave_loop();
Statement next_round();
Statement give(const Expression& value = {});
Statement scope(const Statements& body);
Statement gap();

void append(Statements& statements, const Statements& more);

/// True if a statement or one in its body names a variable.
bool mentions(const Statements& statements, const std::string& name);

/// Newton's steps: names of triples that have been computed before (behind each _x, _y, _z), and the joints'
/// values that are moved.
struct Polish {
  std::vector<bool> revolute;
  std::vector<std::string> axes, points, start, goal;
  Expressions from, seed;
  Statements back;  ///< takes the joints' values back
  Expression size_square;
};

/// A function of the generated file. Its role says how a language writes its head.
struct Function {
  enum class Role {
    solve,  ///< a step with one value, or with one for each sign
    roots,  ///< all values of a step that is a quartic
    take,   ///< makes one of them work
    polish  ///< Newton's steps
  };
  struct Parameter {
    Type type;
    std::string name;
    bool changed = false;
  };

  Role role = Role::solve;
  std::vector<std::string> comment = {};
  Type result = {};
  std::string name = {};
  std::vector<Parameter> parameters = {};
  Statements body = {};
  Polish task = {};  ///< of a polish step, behind the body
};

}  // namespace qvgen::emit::ast
